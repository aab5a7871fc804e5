//! ln x and ln(1 + x): x = 2ⁿ(1 + f) with √½ ≤ 1 + f < √2, and the series of
//! ln(1 + f) = 2 artanh s in s = f/(2 + f), |s| ≤ 0.172.

const LN_2_HIGH: f64 = 0.693147180559663;
const LN_2_LOW: f64 = 2.8235290563031577e-13;
const SQRT_HALF_BITS: u64 = 0x3fe6_a09e_667f_3bcd;

/// The mantissa in √½..√2 and the exponent + 1023 of a positive normal number.
#[inline(always)]
fn split(x: f64) -> (f64, u64) {
    let bits = x.to_bits().wrapping_add(1.0_f64.to_bits() - SQRT_HALF_BITS);
    let mantissa = f64::from_bits((bits & 0x000f_ffff_ffff_ffff) + SQRT_HALF_BITS);
    (mantissa, bits >> 52)
}

/// The exponent, from what [`split`] gives. Set as the low bits of 2⁵²: few instruction sets
/// convert 64-bit integers.
#[inline(always)]
fn exponent(biased: u64) -> f64 {
    const WHOLE: f64 = 4503599627370496.0; // 2⁵²
    f64::from_bits(biased | WHOLE.to_bits()) - (WHOLE + 1023.0)
}

/// The mantissa in √½..√2 and the exponent of a positive number.
#[inline(always)]
pub(super) fn split_any(x: f64) -> (f64, f64) {
    let subnormal = x < f64::MIN_POSITIVE;
    let (mantissa, biased) = split(if subnormal { x * 18014398509481984.0 } else { x });
    let n = exponent(biased);
    (mantissa, if subnormal { n - 54.0 } else { n })
}

/// n ln 2 + ln(1 + f).
#[inline(always)]
fn sum(f: f64, n: f64) -> f64 {
    let s = f / (2.0 + f);
    let z = s * s;
    let tail = z * polynomial!(
        z;
        0.6666666666666734, 0.39999999999416, 0.28571428742104327, 0.2222219860101163,
        0.18183562946905538, 0.15314084122149957, 0.14795630718842456
    );
    // ln(1 + f) = f − f²/2 + s(f²/2 + tail): the large term f is exact.
    let half = 0.5 * f * f;
    n * LN_2_HIGH + (f - (half - (s * (half + tail) + n * LN_2_LOW)))
}

/// The logarithm `y` computed for `x`, or the limit where `x` is not positive and finite.
#[inline(always)]
fn with_limits(x: f64, y: f64) -> f64 {
    let y = if x < f64::INFINITY { y } else { x };
    let limit = if x == 0.0 { f64::NEG_INFINITY } else { f64::NAN };
    if x > 0.0 { y } else { limit }
}

#[inline(always)]
pub(in crate::real) fn ln(x: f64) -> f64 {
    let (mantissa, n) = split_any(x);
    with_limits(x, sum(mantissa - 1.0, n))
}

#[inline(always)]
pub(in crate::real) fn ln_1p(x: f64) -> f64 {
    let u = 1.0 + x;
    // What the sum lost, exactly: u + lost = 1 + x.
    let part = u - x;
    let lost = (x - (u - part)) + (1.0 - part);
    let (mantissa, biased) = split(u);
    let scale = f64::from_bits(2047_u64.wrapping_sub(biased) << 52); // 2¹⁻ⁿ, 0 for n = 1024
    let y = with_limits(u, sum((mantissa - 1.0) + 0.5 * lost * scale, exponent(biased)));
    if x.abs() < 1e-20 { x } else { y }
}

/// ln(x/(x + rest)) for a normal quotient.
#[inline(always)]
pub(super) fn ln_of_part(x: f64, rest: f64) -> f64 {
    let whole = x + rest;
    let (mantissa, biased) = split(x / whole);
    // Near 1 what is missing there has digits, also where the quotient has none.
    let (near, far) = (-rest / whole, mantissa - 1.0);
    sum(if biased == 1023 { near } else { far }, exponent(biased))
}
