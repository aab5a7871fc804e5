//! Zeros and dips of functions of one number.

/// A number and the value there.
pub type Point = (f64, f64);

/// Looks for a value that is not positive between the outer two of three points, of which the
/// middle one is least and all are positive. Answers the least point found: golden sections, until
/// the value is not positive or the three are so alike that it will not be.
pub fn dip(mut value: impl FnMut(f64) -> f64, [mut low, mut least, mut high]: [Point; 3]) -> Point {
    for _ in 0..64 {
        let spread = low.1.max(high.1) - least.1;
        if least.1 <= 0.0 || spread < 1e-4 * least.1 || high.0 - low.0 < 1e-13 {
            break;
        }
        let below = least.0 - low.0 > high.0 - least.0;
        let far = if below { low } else { high };
        let at = least.0 + 0.381966 * (far.0 - least.0);
        let here = (at, value(at));
        if here.1 < least.1 {
            *(if below { &mut high } else { &mut low }) = least;
            least = here;
        } else {
            *(if below { &mut low } else { &mut high }) = here;
        }
    }
    least
}

/// Where a value becomes positive or ceases to be between two points of which one is: steps of
/// false position (Illinois), every third a bisection, so that a jump is found as well.
pub fn crossing(mut value: impl FnMut(f64) -> f64, mut from: Point, mut to: Point) -> f64 {
    let positive = from.1 > 0.0;
    for step in 1..=120 {
        if (to.0 - from.0).abs() < 1e-12 {
            break;
        }
        let mut at = 0.5 * (from.0 + to.0);
        if step % 3 != 0 {
            let secant = from.0 + (to.0 - from.0) * (from.1 / (from.1 - to.1));
            if (secant - from.0) * (secant - to.0) < 0.0 {
                at = secant;
            }
        }
        let here = value(at);
        if (here > 0.0) == positive {
            from = (at, here);
            to.1 *= 0.5;
        } else {
            to = (at, here);
            from.1 *= 0.5;
        }
    }
    0.5 * (from.0 + to.0)
}
