//! eˣ, eˣ − 1 and 2⁻ˣ: x = n ln 2 + r with |r| ≤ ln 2 / 2, a polynomial in r, and 2ⁿ by its bits.

use super::{ROUND, exp2_scale};

const LOG2_E: f32 = core::f32::consts::LOG2_E;
/// ln 2 in two parts; the first has 16 bits, so that its product with n is exact.
const LN_2_HIGH: f32 = 0.693145751953125;
const LN_2_LOW: f32 = 1.4286068e-6;

/// (eʳ − 1 − r)/r², within 2⁻²⁸ of eʳ.
#[inline(always)]
fn remainder(r: f32) -> f32 {
    polynomial!(r; 0.49999994, 0.16666515, 0.041668084, 0.008369369, 0.0013841367)
}

#[inline(always)]
pub(in crate::real) fn exp(x: f32) -> f32 {
    // Beyond these the result is infinity or 0 already; a NaN passes.
    let x = if x > 90.0 { 90.0 } else { x };
    let x = if x < -105.0 { -105.0 } else { x };
    let shifted = x * LOG2_E + ROUND;
    let n = shifted - ROUND;
    let r = (x - n * LN_2_HIGH) - n * LN_2_LOW;
    let y = 1.0 + (r + r * r * remainder(r));
    exp2_scale(y, shifted, x < -104.0)
}

/// 2⁻ˣ times a factor, for x ≥ 0. The polynomial is 2ʳ within 3·10⁻⁹ of its size for |r| ≤ ½, made by
/// linear programming on 801 points, coefficients rounded one after the other.
///
/// The power is lifted, so that it has all its digits where the product has, and a product that would
/// underflow is zero before it is put back, since such numbers are slow.
#[inline(always)]
pub(in crate::real) fn decay(x: f32, factor: f32) -> f32 {
    const LIFT: u32 = 48;
    const BACK: f32 = 1.0 / (1_u64 << LIFT) as f32;
    const LEAST: f32 = f32::MIN_POSITIVE * (1_u64 << LIFT) as f32;
    const LARGEST: f32 = (127 + LIFT) as f32; // lifted, a power with the exponent of zero
    let x = if x < LARGEST { x } else { LARGEST };
    let shifted = ROUND - x;
    let r = (ROUND - shifted) - x;
    let power = shifted.to_bits().wrapping_sub(ROUND.to_bits() - (127 + LIFT));
    let y = polynomial!(r; 1.0, core::f32::consts::LN_2, 0.24022648, 0.0555036, 0.009618506, 0.0013390806, 0.00015326471);
    let lifted = y * f32::from_bits(power << 23) * factor;
    lifted * if lifted < LEAST { 0.0 } else { BACK }
}

#[inline(always)]
pub(in crate::real) fn exp_m1(x: f32) -> f32 {
    let bounded = if x > 89.0 { 89.0 } else { x };
    let bounded = if bounded < -30.0 { -30.0 } else { bounded };
    let shifted = bounded * LOG2_E + ROUND;
    let n = shifted - ROUND;
    let high = bounded - n * LN_2_HIGH;
    let low = n * LN_2_LOW;
    let r = high - low;
    let rest = r * r * remainder(r) + ((high - r) - low);
    // Half of 2ⁿ(1 + r + rest) − 1, so that n = 128 does not overflow; `error` is what the sum
    // of the two large terms loses.
    let power = shifted.to_bits().wrapping_sub(ROUND.to_bits() - 126);
    let scale = f32::from_bits(power << 23);
    let (a, b) = (scale - 0.5, scale * r);
    let sum = a + b;
    let error = b - (sum - a);
    let y = sum + (error + scale * rest);
    let y = y + y;
    if x.abs() < 1e-10 { x } else { y }
}
