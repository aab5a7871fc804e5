//! Powers of a part: (x/(x + y))ⁿ = 2^(n log₂ …), in base 2 from beginning to end.

use super::{ROUND, exp2_scale};

/// log₂(x/(x + rest)): with x 2ᵏ/(x + rest) in 0.66 … 1.51, the series of log₂ = 2/ln 2 artanh s in
/// s = (x 2ᵏ − (x + rest))/(x 2ᵏ + (x + rest)), |s| ≤ 0.2004.
#[inline(always)]
fn log2_of_part(x: f32, rest: f32) -> f32 {
    let whole = x + rest;
    // The bits of a positive number are its logarithm, to 0.0861 and in units of 2⁻²³.
    let half = 1 << 22;
    let k = whole.to_bits().wrapping_sub(x.to_bits()).wrapping_add(half) >> 23;
    let scaled = f32::from_bits(x.to_bits().wrapping_add(k << 23));
    // The large terms cancel exactly; for k = 0 only what is missing remains.
    let difference = (scaled - x) - rest;
    let s = difference / (scaled + whole);
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_wrap, reason = "k is at most 255")]
    let k = k as i32 as f32;
    s * polynomial!(s * s; 2.88539, 0.9618172, 0.5753532, 0.45688754) - k
}

#[inline(always)]
pub(in crate::real) fn power_of_part(x: f32, rest: f32, exponent: f32) -> f32 {
    let e = exponent * log2_of_part(x, rest);
    // Below, the result is 0 already.
    let e = if e > -152.0 { e } else { -152.0 };
    let shifted = e + ROUND;
    let r = e - (shifted - ROUND);
    // 2ʳ, within 2⁻²⁸ of its size.
    let y = 1.0
        + r * polynomial!(
            r;
            core::f32::consts::LN_2, 0.24022648, 0.055503596, 0.009618499, 0.0013390972, 0.00015329332
        );
    exp2_scale(y, shifted, e < -151.0)
}
