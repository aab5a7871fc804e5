//! Sine, cosine, tangent: x = n π/2 + r with |r| ≤ π/4, polynomials in r², and the quadrant n.

use super::{ROUND, ROUND_WIDE};

/// A little more than π/4: how far n, rounded from x·2/π in `f32`, leaves r for |x| ≤ 10⁴.
const LIMIT: f32 = 0.7865;

/// The angle in −π/4..π/4, what it exceeds the exact one by, and the number of quarter turns, in the low two bits.
///
/// π/2 comes in parts of up to 11 bits, whose products with n are exact up to |x| = 10⁴. Beyond,
/// the angle loses its meaning by and by but stays in its range.
#[inline(always)]
fn reduce(x: f32) -> (f32, f32, u32) {
    let shifted = x * core::f32::consts::FRAC_2_PI + ROUND;
    let n = shifted - ROUND;
    let (high, low) = ((x - n * 1.5703125) - n * 0.0004837513, n * 7.5495336e-8);
    let r = high - low;
    let excess = n * 2.563344e-12 + (low - (high - r));
    // At most 3·10⁻⁸ where the angle has a meaning.
    let excess = if excess.abs() < 1e-6 { excess } else { 0.0 };
    let r = if r > LIMIT { LIMIT } else { r };
    let r = if r < -LIMIT { -LIMIT } else { r };
    (r, excess, shifted.to_bits())
}

/// Sine and cosine of an angle and a quadrant, and what is to be taken from the sine and added to the cosine
/// for the angle's excess.
#[inline(always)]
fn in_quadrant(r: f32, excess: [f32; 2], quadrant: u32) -> (f32, f32) {
    let z = r * r;
    let sin = r - (excess[0] + r * z * polynomial!(z; 0.16666655, -0.008332187, 0.00019517838));
    let tail = z * z * polynomial!(z; 0.041666646, -0.001388731, 2.4432322e-5);
    let cos = 1.0 - (0.5 * z - (tail + excess[1]));
    let swap = quadrant & 1 == 1;
    let (sin, cos) = (if swap { cos } else { sin }, if swap { sin } else { cos });
    let sin_sign = (quadrant & 2) << 30;
    let cos_sign = (quadrant.wrapping_add(1) & 2) << 30;
    let sin = f32::from_bits(sin.to_bits() ^ sin_sign);
    (sin, f32::from_bits(cos.to_bits() ^ cos_sign))
}

#[inline(always)]
pub(in crate::real) fn sin_cos(x: f32) -> (f32, f32) {
    let (r, excess, quadrant) = reduce(x);
    // The first is +0 at both zeros, so that the sine keeps the sign.
    in_quadrant(r, [excess, r * excess], quadrant)
}

/// Of whole turns: quarters are counted without rounding.
#[inline(always)]
pub(in crate::real) fn sin_cos_turns(x: f32) -> (f32, f32) {
    // The spacing of numbers around a quarter of `ROUND` is a quarter.
    let shifted = x + 0.25 * ROUND;
    let r = x - (shifted - 0.25 * ROUND);
    let r = if r > 0.125 { 0.125 } else { r };
    let r = if r < -0.125 { -0.125 } else { r };
    // Adding −0 is adding nothing.
    in_quadrant(r * core::f32::consts::TAU, [-0.0; 2], shifted.to_bits())
}

#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the one rounding of the result")]
pub(in crate::real) fn tan(x: f32) -> f32 {
    let wide = f64::from(x);
    let shifted = wide * core::f64::consts::FRAC_2_PI + ROUND_WIDE;
    let n = shifted - ROUND_WIDE;
    let r = (wide - n * 1.5707963267341256) - n * 6.077100506506192e-11;
    let limit = f64::from(LIMIT);
    let r = if r > limit { limit } else { r };
    let r = if r < -limit { -limit } else { r };
    let z = r * r;
    let sin = r + r
        * z
        * polynomial!(
            z;
            -0.16666666640588118, 0.008333329280517292, -0.00019839304413983198,
            2.7180464615829433e-6
        );
    let cos = 1.0
        - (0.5 * z
            - z * z
                * polynomial!(
                    z;
                    0.041666645554656226, -0.0013887309875643776, 2.443241392208045e-5
                ));
    let odd = shifted.to_bits() & 1 == 1;
    let numerator = if odd { -cos } else { sin };
    let denominator = if odd { sin } else { cos };
    let y = (numerator / denominator) as f32;
    if x == 0.0 { x } else { y }
}
