//! The elementary functions of `f64`.

mod arc;
mod error_function;
mod exponential;
mod logarithm;
mod power;
mod root;
mod trigonometric;

pub(in crate::real) use arc::{acos, angle_squared, asin, atan2};
pub(in crate::real) use error_function::{erf, erf_inv, erfc};
pub(in crate::real) use exponential::{decay, exp, exp_m1};
pub(in crate::real) use logarithm::{ln, ln_1p};
pub(in crate::real) use power::{power_of_part, powf};
pub(in crate::real) use root::{rsqrt, sqrt};
pub(in crate::real) use trigonometric::{sin_cos, sin_cos_turns, tan};

/// 1.5·2⁵²: a number below 2⁵¹ added to it is rounded to an integer, which then stands in the low
/// bits of the sum.
const ROUND: f64 = 6755399441055744.0;

/// The largest integer not above.
#[inline(always)]
pub(in crate::real) fn floor(x: f64) -> f64 {
    const WHOLE: f64 = 4503599627370496.0; // 2⁵²: from here on every number is an integer
    let shift = WHOLE.copysign(x);
    let nearest = (x + shift) - shift;
    let below = if nearest > x { nearest - 1.0 } else { nearest };
    if x.abs() < WHOLE { below.copysign(x) } else { x }
}

/// The leading 26 bits: a product of two such heads is exact.
#[inline(always)]
fn head(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & !0x07ff_ffff)
}

/// `y`·2ᵖ⁻²⁰⁴⁶ in two factors: the first product is exact, the second rounds once if it is
/// subnormal.
#[inline(always)]
fn scale(y: f64, power: u64) -> f64 {
    let half = power >> 1;
    y * f64::from_bits(half << 52) * f64::from_bits(power.wrapping_sub(half) << 52)
}
