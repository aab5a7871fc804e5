//! ln x, ln(1 + x) and powers: x = 2ⁿ(1 + f) with √½ ≤ 1 + f < √2, and the series of
//! ln(1 + f) = 2 artanh s in s = f/(2 + f), |s| ≤ 0.172.

use super::exp2_wide;

const LN_2_HIGH: f32 = 0.693145751953125;
const LN_2_LOW: f32 = 1.4286068e-6;
const SQRT_HALF_BITS: u32 = 0x3f35_04f3;

/// The mantissa in √½..√2 and the exponent of a positive normal number.
#[inline(always)]
fn split(x: f32) -> (f32, i32) {
    let bits = x.to_bits().wrapping_add(1.0_f32.to_bits() - SQRT_HALF_BITS);
    let mantissa = f32::from_bits((bits & 0x007f_ffff) + SQRT_HALF_BITS);
    #[allow(clippy::cast_possible_wrap, reason = "the shift leaves nine bits")]
    let exponent = (bits >> 23) as i32 - 127;
    (mantissa, exponent)
}

/// [`split`] also for subnormal numbers.
#[inline(always)]
fn split_any(x: f32) -> (f32, i32) {
    let subnormal = x < f32::MIN_POSITIVE;
    let (mantissa, exponent) = split(if subnormal { x * 16777216.0 } else { x });
    (mantissa, if subnormal { exponent - 24 } else { exponent })
}

/// n ln 2 + ln(1 + f).
#[inline(always)]
#[allow(clippy::cast_precision_loss, reason = "exponents are small")]
fn sum(f: f32, n: i32) -> f32 {
    let n = n as f32;
    let s = f / (2.0 + f);
    let z = s * s;
    let tail = z * polynomial!(z; 0.66666776, 0.39977568, 0.29871076);
    // ln(1 + f) = f − f²/2 + s(f²/2 + tail): the large term f is exact.
    let half = 0.5 * f * f;
    n * LN_2_HIGH + (f - (half - (s * (half + tail) + n * LN_2_LOW)))
}

/// The logarithm `y` computed for `x`, or the limit where `x` is not positive and finite.
#[inline(always)]
fn with_limits(x: f32, y: f32) -> f32 {
    let y = if x < f32::INFINITY { y } else { x };
    let limit = if x == 0.0 { f32::NEG_INFINITY } else { f32::NAN };
    if x > 0.0 { y } else { limit }
}

#[inline(always)]
pub(in crate::real) fn ln(x: f32) -> f32 {
    let (mantissa, n) = split_any(x);
    with_limits(x, sum(mantissa - 1.0, n))
}

#[inline(always)]
pub(in crate::real) fn ln_1p(x: f32) -> f32 {
    let u = 1.0 + x;
    // What the sum lost, exactly: u + lost = 1 + x.
    let part = u - x;
    let lost = (x - (u - part)) + (1.0 - part);
    let (mantissa, n) = split(u);
    #[allow(clippy::cast_sign_loss, reason = "1 + x is at least 2^-24, so n is in -24..=128")]
    let scale = f32::from_bits(((128 - n) as u32) << 23); // 2¹⁻ⁿ, 0 for n = 128
    let y = with_limits(u, sum((mantissa - 1.0) + 0.5 * lost * scale, n));
    if x.abs() < 1e-10 { x } else { y }
}

#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the one rounding of the result")]
pub(in crate::real) fn powf(x: f32, exponent: f32) -> f32 {
    let (mantissa, n) = split_any(x);
    let m = f64::from(mantissa);
    let s = (m - 1.0) / (m + 1.0);
    let log2 = f64::from(n)
        + s * polynomial!(
            s * s;
            2.8853900817900864, 0.9617966733417975, 0.5770835849651513, 0.4116727189977767,
            0.34073010658534336
        );
    // Beyond these the result is infinity or 0 already; a NaN passes.
    let e = f64::from(exponent) * log2;
    let e = if e > 130.0 { 130.0 } else { e };
    let e = if e < -160.0 { -160.0 } else { e };
    let y = exp2_wide(e) as f32;
    // The ends of the base: 0 and infinity have no logarithm, negative numbers no power.
    let grows = (x == 0.0) == (exponent < 0.0);
    let end = if grows { f32::INFINITY } else { 0.0 };
    let inside = if x > 0.0 { y } else { f32::NAN };
    let at_end = (x == 0.0) | (x == f32::INFINITY);
    let y = if at_end { end } else { inside };
    if exponent == 0.0 { 1.0 } else { y }
}
