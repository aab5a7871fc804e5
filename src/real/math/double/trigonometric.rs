//! Sine, cosine, tangent: x = n π/2 + r with |r| ≤ π/4, polynomials in r², and the quadrant n.

use super::{ROUND, head};

/// A little more than π/4: how far n, rounded from x·2/π, leaves r for |x| ≤ 10⁶.
const LIMIT: f64 = 0.785399;

/// The angle in −π/4..π/4, what it exceeds the exact one by, and the number of quarter turns, in the low two bits.
///
/// π/2 comes in parts of 33 bits, whose products with n are exact up to |x| = 10⁶. Beyond, the
/// angle loses its meaning by and by but stays in its range.
#[inline(always)]
fn reduce(x: f64) -> (f64, f64, u64) {
    let shifted = x * core::f64::consts::FRAC_2_PI + ROUND;
    let n = shifted - ROUND;
    let (high, low) = (x - n * 1.5707963267341256, n * 6.077100506303966e-11);
    let r = high - low;
    let excess = n * 2.0222662487959506e-21 + (low - (high - r));
    // At most 2·10⁻¹⁵ where the angle has a meaning.
    let excess = if excess.abs() < 1e-10 { excess } else { 0.0 };
    let r = if r > LIMIT { LIMIT } else { r };
    let r = if r < -LIMIT { -LIMIT } else { r };
    (r, excess, shifted.to_bits())
}

/// r − sin(r − excess), which is +0 at both zeros so that the sine keeps the sign, and
/// cos(r − excess) − 1, from `excess` and r times it.
#[inline(always)]
fn tails(r: f64, excess: [f64; 2]) -> (f64, f64) {
    let z = r * r;
    let sin = polynomial!(
        z;
        0.1666666666666663, -0.00833333333332184, 0.00019841269829358913, -2.7557313538669635e-6,
        2.5050734415655738e-8, -1.589543489853602e-10
    );
    let cos = polynomial!(
        z;
        0.041666666666666595, -0.0013888888888873307, 2.4801587288964847e-5,
        -2.7557314202955546e-7, 2.0875703122147364e-9, -1.1358616103411586e-11
    );
    (excess[0] + r * z * sin, (z * z * cos + excess[1]) - 0.5 * z)
}

#[inline(always)]
fn in_quadrant(r: f64, excess: [f64; 2], quadrant: u64) -> (f64, f64) {
    let (sin_tail, cos_tail) = tails(r, excess);
    let (sin, cos) = (r - sin_tail, 1.0 + cos_tail);
    let swap = quadrant & 1 == 1;
    let (sin, cos) = (if swap { cos } else { sin }, if swap { sin } else { cos });
    let sin_sign = (quadrant & 2) << 62;
    let cos_sign = (quadrant.wrapping_add(1) & 2) << 62;
    let sin = f64::from_bits(sin.to_bits() ^ sin_sign);
    (sin, f64::from_bits(cos.to_bits() ^ cos_sign))
}

#[inline(always)]
pub(in crate::real) fn sin_cos(x: f64) -> (f64, f64) {
    let (r, excess, quadrant) = reduce(x);
    in_quadrant(r, [excess, r * excess], quadrant)
}

/// Of whole turns: quarters are counted without rounding.
#[inline(always)]
pub(in crate::real) fn sin_cos_turns(x: f64) -> (f64, f64) {
    // The spacing of numbers around a quarter of `ROUND` is a quarter.
    let shifted = x + 0.25 * ROUND;
    let r = x - (shifted - 0.25 * ROUND);
    let r = if r > 0.125 { 0.125 } else { r };
    let r = if r < -0.125 { -0.125 } else { r };
    // Adding −0 is adding nothing.
    in_quadrant(r * core::f64::consts::TAU, [-0.0; 2], shifted.to_bits())
}

#[inline(always)]
pub(in crate::real) fn tan(x: f64) -> f64 {
    let (r, excess, quadrant) = reduce(x);
    let (sin_tail, cos_tail) = tails(r, [excess, r * excess]);
    // Sine and cosine, each with what its sum lost.
    let (sin, cos) = (r - sin_tail, 1.0 + cos_tail);
    let (sin_low, cos_low) = ((r - sin) - sin_tail, (1.0 - cos) + cos_tail);
    let odd = quadrant & 1 == 1;
    let (a, a_low) = (if odd { -cos } else { sin }, if odd { -cos_low } else { sin_low });
    let (b, b_low) = (if odd { sin } else { cos }, if odd { sin_low } else { cos_low });
    // The quotient, corrected by its exact remainder.
    let quotient = a / b;
    let (q_head, b_head) = (head(quotient), head(b));
    let q_rest = quotient - q_head;
    let product = q_head * b_head;
    let remainder = (a - product) - (q_head * (b - b_head) + q_rest * b);
    let y = quotient + (remainder + (a_low - quotient * b_low)) / b;
    if x == 0.0 { x } else { y }
}
