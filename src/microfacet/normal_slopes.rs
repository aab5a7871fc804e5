//! Slopes of a surface of roughness 1 that are normally distributed, exp(−x² − y²)/π: what
//! Beckmann's distribution is made of.

use core::f64::consts::{FRAC_2_SQRT_PI, TAU};

use crate::real::{Real, Vector};

/// Two independent slopes with density exp(−x² − y²)/π: tan²θ = −ln(1 − u₀).
#[inline(always)]
pub(super) fn slopes<T: Real>(u: [T; 2]) -> (T, T) {
    // A uniform number of f64 below 1 leaves at least 2⁻⁵³; the bound keeps 1 itself finite.
    let tan_squared = -(-u[0].clamp(T::lit(0.0), T::lit(1.0))).ln_1p();
    let tan = tan_squared.min(T::lit(40.0)).sqrt();
    let (sin, cos) = (u[1] * T::lit(TAU)).sin_cos();
    (tan * cos, tan * sin)
}

/// Slopes with the density of those that face `s`, a direction above the surface of roughness 1.
#[inline]
pub(super) fn visible_slopes<T: Real>(s: T::Vec3, u: [T; 2]) -> (T, T) {
    let one = T::lit(1.0);
    let sin_squared = s.x().squared() + s.y().squared();
    // Seen from the normal all slopes count alike, and there is no azimuth to turn them to.
    let tilted = sin_squared.gt(T::lit(1e-36));
    let sin = T::select(tilted, sin_squared, one).sqrt();
    let (cos_phi, sin_phi) = (s.x() / sin, s.y() / sin);
    let along = visible_slope(s.z(), sin, u[0]);
    let across = (u[1] * T::lit(2.0) - one).erf_inv();
    let (x, y) = slopes(u);
    (
        T::select(tilted, along * cos_phi - across * sin_phi, x),
        T::select(tilted, along * sin_phi + across * cos_phi, y),
    )
}

/// The slope x in the direction of a viewer at angle (cos, sin): the distribution function
/// cos erfc(−x) + sin exp(−x²)/√π, divided by its value at x = cos/sin, inverted.
#[inline]
fn visible_slope<T: Real>(cos: T, sin: T, u: T) -> T {
    let part = T::lit(0.5 * FRAC_2_SQRT_PI) * sin;
    let largest = (cos / sin).min(T::lit(40.0));
    let target = u.max(T::lit(1e-37)) * (cos * T::lit(2.0) + sin * ierfc(largest));
    let mut x = -(-(u.max(T::lit(1e-37))).ln()).max(T::lit(0.0)).sqrt();
    for _ in 0..12 {
        let gauss = (-x.squared()).exp();
        let below = cos * (-x).erfc() + part * gauss;
        let slope = (cos - x * sin) * gauss * T::lit(FRAC_2_SQRT_PI);
        x = (x - below * (below / target).ln() / slope.max(T::lit(1e-37))).min(largest);
    }
    x
}

/// The integral of erfc from ν ≥ 0 to infinity, exp(−ν²)/√π − ν erfc ν, with a relative error
/// of 7·10⁻¹⁶ plus that of the exponential, in the tail too, where the difference cancels.
///
/// The polynomial is the Chebyshev interpolation of (1 + ν)² exp(ν²) ierfc ν in
/// (ν − 3)/(ν + 3), which runs from −1 to 1, computed with 60 digits.
#[inline]
pub(super) fn ierfc<T: Real>(nu: T) -> T {
    // exp(−40²) is zero in every number; the bound keeps infinity out of the quotient.
    let nu = nu.min(T::lit(40.0));
    let t = (nu - T::lit(3.0)) / (nu + T::lit(3.0));
    let mut polynomial = T::lit(IERFC[IERFC.len() - 1]);
    for &coefficient in IERFC[..IERFC.len() - 1].iter().rev() {
        polynomial = polynomial * t + T::lit(coefficient);
    }
    (-nu.squared()).exp() * polynomial / (T::lit(1.0) + nu).squared()
}

const IERFC: [f64; 25] = [
    0.43497808005738303,
    -0.21996539117550237,
    0.054264794784573,
    0.05451007980598061,
    -0.06948519976404241,
    0.03290912185493064,
    -0.00010455855890709797,
    -0.008775245175071018,
    0.0041741888057270525,
    0.0001950131147005132,
    -0.0008012323667662196,
    0.0001027543611657003,
    0.00013805714589913842,
    -2.8232300787708312e-05,
    -2.668554218554301e-05,
    5.079262811461616e-06,
    5.830478972288471e-06,
    -5.759833901604646e-07,
    -1.3225254993661134e-06,
    -2.144251244802458e-08,
    2.756879269193618e-07,
    2.5848802237235974e-08,
    -4.4501370924781884e-08,
    -4.058066627398352e-09,
    3.959107435392204e-09,
];
