//! A number that a fit may change: between its bounds, by a number without bounds.

use crate::error::Range;

/// The ratio of the bounds, or their distance, beyond which equal steps are equal ratios.
const WIDE: f64 = 100.0;

/// How close to a bound, in parts of the way between both, a number counts as being there.
const END: f64 = 1e-6;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Free {
    pub(super) path: String,
    pub(super) range: Range,
    pub(super) start: f64,
}

/// On which scale equal steps are alike.
enum Scale {
    Even,
    /// Equal ratios, of a number whose bounds are far apart.
    Ratios,
    /// Equal ratios of 1 plus the distance from the lower bound, which is 0 or below.
    RatiosFromOne,
}

impl Free {
    const fn scale(&self) -> Scale {
        let Range { lower, upper } = self.range;
        if lower > 0.0 && upper / lower > WIDE {
            Scale::Ratios
        } else if upper - lower > WIDE {
            Scale::RatiosFromOne
        } else {
            Scale::Even
        }
    }

    /// The number without bounds that stands for the start. At a bound it would be infinite: a start
    /// there moves inside.
    pub(super) fn unbounded_start(&self) -> f64 {
        let part = self.part(self.start).clamp(1e-3, 1.0 - 1e-3);
        (part / (1.0 - part)).ln()
    }

    /// How far on the way from the lower to the upper bound a value lies.
    fn part(&self, value: f64) -> f64 {
        let Range { lower, upper } = self.range;
        match self.scale() {
            Scale::Even => (value - lower) / (upper - lower),
            Scale::Ratios => (value / lower).ln() / (upper / lower).ln(),
            Scale::RatiosFromOne => (value - lower).ln_1p() / (upper - lower).ln_1p(),
        }
    }

    /// The value that a number without bounds stands for, and its derivative by that number.
    pub(super) fn value_and_slope(&self, unbounded: f64) -> (f64, f64) {
        let Range { lower, upper } = self.range;
        let part = 1.0 / (1.0 + (-unbounded).exp());
        let slope = part * (1.0 - part);
        let (value, slope) = match self.scale() {
            Scale::Even => (lower + (upper - lower) * part, (upper - lower) * slope),
            Scale::Ratios => {
                let whole = (upper / lower).ln();
                let value = lower * (whole * part).exp();
                (value, value * whole * slope)
            }
            Scale::RatiosFromOne => {
                let whole = (upper - lower).ln_1p();
                let above = (whole * part).exp_m1();
                (lower + above, (1.0 + above) * whole * slope)
            }
        };
        (value.clamp(lower, upper), slope)
    }

    pub(super) fn is_at_bound(&self, value: f64) -> bool {
        let part = self.part(value);
        !(END..=1.0 - END).contains(&part)
    }
}

#[cfg(test)]
mod tests {
    use super::Free;
    use crate::error::Range;

    #[test]
    fn values_stay_in_the_range_and_have_their_slopes() {
        for (lower, upper, start) in
            [(0.0, 1.0, 0.3), (1e-8, 1e4, 0.3), (-2.0, 5.0, 0.0), (0.0, 1e8, 30.0)]
        {
            let free = Free { path: String::new(), range: Range { lower, upper }, start };
            let at = |x: f64| free.value_and_slope(x).0;
            assert!((at(free.unbounded_start()) - start).abs() < 1e-12 * (1.0 + start));
            for x in [-800.0, -30.0, -3.0, -0.1, 0.4, 5.0, 40.0, 800.0] {
                let (value, slope) = free.value_and_slope(x);
                assert!((lower..=upper).contains(&value), "{value}");
                let step = 1e-6;
                let difference = (at(x + step) - at(x - step)) / (2.0 * step);
                assert!(
                    (slope - difference).abs() <= 1e-8 * (upper - lower).min(1.0 + value.abs())
                );
            }
            assert!(free.is_at_bound(at(-40.0)) && free.is_at_bound(at(40.0)));
        }
    }
}
