//! Slopes of a surface of roughness 1 that are normally distributed, exp(−x² − y²)/π: what
//! Beckmann's distribution is made of.

use core::f64::consts::{FRAC_2_SQRT_PI, TAU};

use crate::real::{Real, Vector, iterate};
use crate::sampling::uniform;

/// Two independent slopes with density exp(−x² − y²)/π: tan²θ = −ln(1 − u₀).
#[inline(always)]
pub(super) fn slopes<T: Real>(u: [T; 2]) -> (T, T) {
    let [u, turn] = uniform(u);
    // A uniform number of f64 below 1 leaves at least 2⁻⁵³; the bound keeps 1 itself finite.
    let tan_squared = -(-u).ln_1p();
    let tan = tan_squared.min(T::lit(40.0)).sqrt();
    let (sin, cos) = (turn * T::lit(TAU)).sin_cos();
    (tan * cos, tan * sin)
}

/// Slopes with the density of those that face `s`, a direction above the surface of roughness 1.
#[inline(always)]
pub(super) fn visible_slopes<T: Real>(s: T::Vec3, u: [T; 2]) -> (T, T) {
    let (u, one) = (uniform(u), T::lit(1.0));
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

/// The slope x ≤ cos/sin towards a viewer at angle (cos, sin) whose distribution function
///
/// ```text
/// C(x) = K(x)/K(cos/sin),  K(x) = cos erfc(−x) + sin exp(−x²)/√π
/// ```
///
/// is `u`, by four steps of Newton's method: on ln C where `u` is small, on √(1 − C) where it is
/// large. Both are close to straight lines, the second because C ends in a parabola. What is left
/// is an error of C below 2·10⁻¹³ in `f64` and 4·10⁻⁷ in `f32`, relative to `u` (1 + 2x²).
#[inline(always)]
fn visible_slope<T: Real>(cos: T, sin: T, u: T) -> T {
    let (zero, one, two) = (T::lit(0.0), T::lit(1.0), T::lit(2.0));
    // Slope −∞ belongs to u = 0. Probability 10⁻³⁷ is what every number can represent.
    let u = u.max(T::lit(1e-37));
    let small = u.lt(T::lit(0.5));
    let largest = (cos / sin).min(T::lit(40.0));
    let whole = two * cos + sin * ierfc(largest);
    let (part, rest) = (u * whole, (one - u) * whole);
    let parabola = T::lit(FRAC_1_SQRT_PI) / sin;
    // The viewer's cosine only moves the slope up: this is the solution at grazing.
    let smallest = -(-u.ln()).max(zero).sqrt();
    let first = T::select(u.lt(T::lit(0.01)), smallest, first_guess(cos, sin, largest, u));
    let x = iterate::<4, _>(
        first,
        #[inline(always)]
        |x| {
            let x = x.clamp(smallest, largest);
            let gauss = (-x.squared()).exp();
            let below = cos * (-x).erfc() + sin * gauss * T::lit(FRAC_1_SQRT_PI);
            let facing = cos - x * sin;
            // Near the upper end the difference is all rounding; the parabola there bounds it.
            let bound = facing.squared() * T::select(x.gt(zero), gauss, one) * parabola;
            let above = (whole - below).max(zero).min(bound);
            let density = facing * gauss * T::lit(2.0 * FRAC_1_SQRT_PI);
            let small_step = below * (part / below).ln();
            let large_step = two * (above - (above * rest).sqrt());
            x + T::select(small, small_step, large_step) / density.max(T::lit(1e-37))
        },
    );
    x.clamp(smallest, largest)
}

/// A slope within 0.3 of the one with distribution function `u`: one power law in erf x for each
/// angle, the fit of Wenzel Jakob's "An improved visible normal sampling routine for the Beckmann
/// distribution", 2014.
#[inline(always)]
fn first_guess<T: Real>(cos: T, sin: T, largest: T, u: T) -> T {
    let one = T::lit(1.0);
    let theta = sin.atan2(cos);
    let power = one + theta * (T::lit(-0.876) + theta * (T::lit(0.4265) + theta * T::lit(-0.0594)));
    let erf = largest.erf();
    (erf - (one + erf) * (one - u).powf(power)).erf_inv()
}

const FRAC_1_SQRT_PI: f64 = 0.5 * FRAC_2_SQRT_PI;

/// The integral of erfc from ν ≥ 0 to infinity, exp(−ν²)/√π − ν erfc ν, with a relative error
/// of 7·10⁻¹⁶ plus that of the exponential, in the tail too, where the difference cancels.
///
/// The polynomial is the Chebyshev interpolation of (1 + ν)² exp(ν²) ierfc ν in
/// (ν − 3)/(ν + 3), which runs from −1 to 1, computed with 60 digits.
#[inline(always)]
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest error of the distribution function, relative to `u` and to the 1 + 2x² with
    /// which it answers to the rounding of x, over viewers from the normal to grazing.
    fn worst_inversion<T: Real + Into<f64>>(epsilon: f64) -> f64 {
        let mut worst = 0.0_f64;
        for i in 0..200 {
            let part = f64::from(i) / 200.0;
            for cot in [10.0_f64.powf(28.0 * part - 20.0), 4.5 * part] {
                let (cos, sin): (T, T) =
                    (T::lit(cot / cot.hypot(1.0)), T::lit(1.0 / cot.hypot(1.0)));
                for j in 0..200 {
                    let part = f64::from(j) / 200.0;
                    for u in [part, 1e-37_f64.powf(part), 1.0 - epsilon.powf(part)] {
                        let u = T::lit(u);
                        let x = visible_slope(cos, sin, u).into();
                        let got = distribution_function(cos.into(), sin.into(), x);
                        let error = (got / u.into().max(1e-37) - 1.0).abs();
                        worst = worst.max(error / (1.0 + 2.0 * x * x));
                    }
                }
            }
        }
        worst
    }

    fn distribution_function(cos: f64, sin: f64, x: f64) -> f64 {
        let below = cos * Real::erfc(-x) + sin * Real::exp(-x * x) * FRAC_1_SQRT_PI;
        below / (2.0 * cos + sin * ierfc(cos / sin))
    }

    #[test]
    fn visible_slopes_invert_their_distribution_function() {
        let double = worst_inversion::<f64>(1e-16);
        assert!(double < 2e-13, "{double:e}");
        let single = worst_inversion::<f32>(6e-8);
        assert!(single < 4e-7, "{single:e}");
    }

    #[test]
    fn ierfc_is_the_difference_it_replaces() {
        for i in 0..=60 {
            let nu = 0.05 * f64::from(i);
            let difference = Real::exp(-nu * nu) * FRAC_1_SQRT_PI - nu * Real::erfc(nu);
            // The difference loses a factor of 2ν² of its digits.
            let allowed = 1e-15 * (1.0 + 2.0 * nu * nu);
            assert!((ierfc(nu) / difference - 1.0).abs() < allowed, "{nu}");
        }
        // The first terms of the asymptotic series, where the next is below 10⁻¹³.
        for nu in [24.5_f64, 26.0] {
            let z = 1.0 / (4.0 * nu * nu);
            let series =
                1.0 + z * (-6.0 + z * (60.0 + z * (-840.0 + z * (15120.0 - z * 332640.0))));
            let want = Real::exp(-nu * nu) * FRAC_1_SQRT_PI * 2.0 * z * series;
            assert!((ierfc(nu) / want - 1.0).abs() < 1e-13, "{nu}");
        }
    }
}
