//! eˣ, eˣ − 1 and 2⁻ˣ: x = n ln 2 + r with |r| ≤ ln 2 / 2, a polynomial in r, and 2ⁿ by its bits.

use super::{ROUND, scale};

const LOG2_E: f64 = core::f64::consts::LOG2_E;
/// ln 2 in two parts; the first has 41 bits, so that its product with n is exact.
const LN_2_HIGH: f64 = 0.693147180559663;
const LN_2_LOW: f64 = 2.8235290563031577e-13;

/// (eʳ − 1 − r)/r², within 2⁻⁵⁶ of eʳ.
#[inline(always)]
fn remainder(r: f64) -> f64 {
    polynomial!(
        r;
        0.500000000000001, 0.1666666666666536, 0.041666666666529524, 0.008333333334217437,
        0.0013888888944746734, 0.00019841267866556214, 2.4801491295778628e-5,
        2.755909943995078e-6, 2.7631050439653185e-7, 2.450988269808159e-8
    )
}

/// eʳ − 1 and n + 2046, where `high` + `low` = n ln 2 + r. For |`high`| ≤ 1000.
#[inline(always)]
pub(super) fn parts(high: f64, low: f64) -> (f64, u64) {
    let shifted = high * LOG2_E + ROUND;
    let n = shifted - ROUND;
    let r = (high - n * LN_2_HIGH) - (n * LN_2_LOW - low);
    (r + r * r * remainder(r), shifted.to_bits().wrapping_sub(ROUND.to_bits() - 2046))
}

#[inline(always)]
pub(in crate::real) fn exp(x: f64) -> f64 {
    // Beyond these the result is infinity or 0 already; a NaN passes.
    let x = if x > 711.0 { 711.0 } else { x };
    let x = if x < -747.0 { -747.0 } else { x };
    let (y, power) = parts(x, 0.0);
    scale(1.0 + y, power)
}

/// 2⁻ˣ times a factor, for x ≥ 0.
#[inline(always)]
pub(in crate::real) fn decay(x: f64, factor: f64) -> f64 {
    const LARGEST: f64 = 1080.0; // a power that is zero
    let x = if x < LARGEST { x } else { LARGEST };
    let shifted = ROUND - x;
    let r = ((ROUND - shifted) - x) * core::f64::consts::LN_2;
    let power = shifted.to_bits().wrapping_sub(ROUND.to_bits() - 2046);
    scale(1.0 + (r + r * r * remainder(r)), power) * factor
}

#[inline(always)]
pub(in crate::real) fn exp_m1(x: f64) -> f64 {
    let bounded = if x > 710.0 { 710.0 } else { x };
    let bounded = if bounded < -60.0 { -60.0 } else { bounded };
    let shifted = bounded * LOG2_E + ROUND;
    let n = shifted - ROUND;
    let high = bounded - n * LN_2_HIGH;
    let low = n * LN_2_LOW;
    let r = high - low;
    let rest = r * r * remainder(r) + ((high - r) - low);
    // Half of 2ⁿ(1 + r + rest) − 1, so that n = 1024 does not overflow; `error` is what the sum
    // of the two large terms loses.
    let power = shifted.to_bits().wrapping_sub(ROUND.to_bits() - 1022);
    let scale = f64::from_bits(power << 52);
    let (a, b) = (scale - 0.5, scale * r);
    let sum = a + b;
    let error = b - (sum - a);
    let y = sum + (error + scale * rest);
    let y = y + y;
    if x.abs() < 1e-20 { x } else { y }
}
