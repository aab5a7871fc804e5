//! The elementary functions of `f32`.
//!
//! Arithmetic is `f32` where 1.5 units in the last place can be had that way, and `f64` inside
//! where a formula would lose more: powers, tangent, arc sine, error functions.

mod arc;
mod error_function;
mod exponential;
mod logarithm;
mod mean_magnitude;
mod power;
mod root;
mod trigonometric;

pub(in crate::real) use arc::{acos, angle_squared, asin, atan2};
pub(in crate::real) use error_function::{erf, erf_inv, erfc, erfcx, ierfc};
pub(in crate::real) use exponential::{decay, exp, exp_m1};
pub(in crate::real) use logarithm::{ln, ln_1p, powf};
pub(in crate::real) use mean_magnitude::mean_magnitude;
pub(in crate::real) use power::power_of_part;
pub(in crate::real) use root::{rsqrt, sqrt};
pub(in crate::real) use trigonometric::{sin_cos, sin_cos_turns, tan};

/// 1.5·2²³: a number below 2²² added to it is rounded to an integer, which then stands in the low
/// bits of the sum.
const ROUND: f32 = 12582912.0;
/// The same for `f64`: 1.5·2⁵².
const ROUND_WIDE: f64 = 6755399441055744.0;

/// The largest integer not above.
#[inline(always)]
pub(in crate::real) fn floor(x: f32) -> f32 {
    const WHOLE: f32 = 8388608.0; // 2²³: from here on every number is an integer
    let shift = WHOLE.copysign(x);
    let nearest = (x + shift) - shift;
    let below = if nearest > x { nearest - 1.0 } else { nearest };
    if x.abs() < WHOLE { below.copysign(x) } else { x }
}

/// `y`·2ⁿ for `shifted` = n + [`ROUND`] with n in −160..=130, or 0.
#[inline(always)]
fn exp2_scale(y: f32, shifted: f32, zero: bool) -> f32 {
    // 2ⁿ in two factors: the first product is exact, the second rounds once if it is subnormal.
    let power = shifted.to_bits().wrapping_sub(ROUND.to_bits() - 254);
    let half = power >> 1;
    // Below the smallest number the second factor is zero: a product that underflows is slow.
    let rest = if zero { 0 } else { power.wrapping_sub(half) << 23 };
    y * f32::from_bits(half << 23) * f32::from_bits(rest)
}

/// 2ᵉ to 2⁻²⁹ of its size, for |e| ≤ 1000.
#[inline(always)]
fn exp2_wide(e: f64) -> f64 {
    let shifted = e + ROUND_WIDE;
    let r = e - (shifted - ROUND_WIDE);
    let power = shifted.to_bits().wrapping_sub(ROUND_WIDE.to_bits() - 1023);
    polynomial!(
        r;
        1.0000000005631373, 0.6931472060362519, 0.24022646844074738, 0.05550328125060941,
        0.00961849192484846, 0.0013400195169349755, 0.00015345559383835014
    ) * f64::from_bits(power << 52)
}
