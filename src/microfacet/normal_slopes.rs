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
    let whole = two * cos + sin * largest.ierfc();
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
        below / (2.0 * cos + sin * Real::ierfc(cos / sin))
    }

    #[test]
    fn visible_slopes_invert_their_distribution_function() {
        let double = worst_inversion::<f64>(1e-16);
        assert!(double < 2e-13, "{double:e}");
        let single = worst_inversion::<f32>(6e-8);
        assert!(single < 4e-7, "{single:e}");
    }
}
