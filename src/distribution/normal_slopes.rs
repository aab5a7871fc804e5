//! Slopes of a surface of roughness 1 that are normally distributed, exp(−x² − y²)/π: what
//! Beckmann's distribution is made of.

use core::f64::consts::FRAC_2_SQRT_PI;

use crate::real::{Real, Vector, iterate};
use crate::sampling::uniform;

/// Two independent slopes with density exp(−x² − y²)/π: tan²θ = −ln(1 − u₀).
#[inline(always)]
pub(super) fn slopes<T: Real>(u: [T; 2]) -> (T, T) {
    let [u, turn] = uniform(u);
    // A uniform number of f64 below 1 leaves at least 2⁻⁵³; the bound keeps 1 itself finite.
    let tan_squared = -(-u).ln_1p();
    let tan = tan_squared.min(T::lit(40.0)).sqrt();
    let (sin, cos) = turn.sin_cos_turns();
    (tan * cos, tan * sin)
}

/// Slopes with the density of those that face `s`, a direction above the surface of roughness 1. Its
/// length does not matter.
#[inline(always)]
pub(super) fn visible_slopes<T: Real>(s: T::Vec3, u: [T; 2]) -> (T, T) {
    let (x, y) = slopes(u);
    let (u, one) = (uniform(u), T::one());
    let across_squared = s.x().squared() + s.y().squared();
    // Seen from the normal all slopes count alike, and there is no azimuth to turn them to. Roots and
    // quotients, not reciprocal roots: a call is done sooner with them.
    let tilted = across_squared.gt(T::lit(1e-36));
    let across_squared = T::select(tilted, across_squared, one);
    let along_s = across_squared.sqrt();
    let length = (across_squared + s.z().squared()).sqrt();
    let (inverse_across, inverse_length) = (one / along_s, one / length);
    let (cos_phi, sin_phi) = (s.x() * inverse_across, s.y() * inverse_across);
    let (cos, sin) = (s.z() * inverse_length, along_s * inverse_length);
    let along = visible_slope(cos, sin, length * inverse_across, u[0]);
    let across = (u[1] * T::lit(2.0) - one).erf_inv();
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
/// is `u`, by steps of Householder's method of third order, two in `f32` and four in `f64`. What is
/// left is an error of C below 2·10⁻¹³ in `f64` and 4·10⁻⁷ in `f32`, relative to `u` (1 + 2x²).
#[inline(always)]
fn visible_slope<T: Real>(cos: T, sin: T, inverse_sin: T, u: T) -> T {
    let one = T::one();
    // Slope −∞ belongs to u = 0. Probability 10⁻³⁷ is what every number can represent.
    let u = u.max(T::lit(1e-37));
    // The largest slope, of u = 1, is approached: there C is flat.
    let rest = (one - u).max(T::lit(0.25 * T::SPACING));
    let largest = cos * inverse_sin;
    let beyond = sin * largest.ierfc();
    let whole = cos + cos + beyond;
    let (part, rest) = (u * whole, rest * whole);
    let equation = Equation { cos, sin, inverse_sin, part, rest: rest - beyond };
    // C ends in a parabola. It is steepest if exp(−x²) is 1: x cannot be closer to the end; and flattest if x is
    // at the end, where x is close to it: x cannot be further from it.
    let to_end = (rest * inverse_sin * T::lit(SQRT_PI)).sqrt();
    let flattest = (largest.squared().min(T::lit(80.0)) * T::lit(0.5)).exp();
    let least = T::select(u.gt(T::lit(0.9)), largest - to_end * flattest, -T::max_finite());
    let first = first_guess(cos, sin, u).max(least).min(largest - T::lit(1.2) * to_end).held();
    let x = if T::SPACING > 1e-9 {
        iterate::<2, _>(
            first,
            #[inline(always)]
            |x| equation.step(x),
        )
    } else {
        iterate::<4, _>(
            first,
            #[inline(always)]
            |x| equation.step(x),
        )
    };
    x.as_solution_of(|x| {
        let facing = equation.cos - x * equation.sin;
        (equation.difference(x), facing * T::lit(FRAC_2_SQRT_PI))
    })
}

/// The equation K(x) = `part` of a slope, in which K is also 2 cos − `rest`.
struct Equation<T> {
    cos: T,
    sin: T,
    inverse_sin: T,
    part: T,
    rest: T,
}

impl<T: Real> Equation<T> {
    /// (K(x) − `part`) exp(x²), with one exponential and nothing that underflows.
    #[inline(always)]
    fn difference(&self, x: T) -> T {
        let below = x.lt(T::zero());
        let tail = self.cos * x.abs().erfcx();
        let missing = T::select(below, -self.part, self.rest) * x.squared().exp();
        let at_zero = self.sin * T::lit(FRAC_1_SQRT_PI);
        missing + (T::select(below, tail, -tail) + at_zero)
    }

    /// One step of Householder's method of third order.
    #[inline(always)]
    fn step(&self, x: T) -> T {
        let (half, one) = (T::lit(0.5), T::one());
        // The least `u` belongs to −9.23.
        let x = x.max(T::lit(-9.3));
        let facing = (self.cos - x * self.sin).max(T::lit(1e-20));
        let inverse_facing = one / facing;
        let difference = self.difference(x);
        // Near the end the difference is all rounding. No step that way can be longer.
        let newton = (difference * (T::lit(0.5 * SQRT_PI) * inverse_facing))
            .max(-half * facing * self.inverse_sin);
        // The quotients −K″/(2K′) and K‴/(6K′) of derivatives.
        let inverse_distance = self.sin * inverse_facing;
        let second = x + half * inverse_distance;
        let third = x * (x + inverse_distance) * T::lit(2.0 / 3.0) - T::lit(1.0 / 3.0);
        let bent = newton * second;
        x - newton * (one + bent) / (one + (bent + bent) + third * newton.squared())
    }
}

/// A slope within 0.2 of the one that belongs to `u`, or 0.5 where `u` is within 10⁻³ of 1.
///
/// Two slopes that wait for `u` alone are those of a viewer at the normal and at grazing, q = erf⁻¹(2u − 1), here to
/// 0.01 from −ln(4u(1 − u)), and g = −√(−ln u). Between them lies the mean (q R cos + g sin)/(R cos + sin), whose R
/// is nearly 1: a polynomial in q and sin, by least squares.
#[inline(always)]
fn first_guess<T: Real>(cos: T, sin: T, u: T) -> T {
    let (zero, one) = (T::zero(), T::one());
    let ln = -(T::lit(4.0) * u * (one - u).max(T::lit(0.25 * T::SPACING))).ln();
    let squared = ln * (T::lit(0.785) + T::lit(0.1) * ln) / (one + T::lit(0.1) * ln);
    let q = squared.max(zero).sqrt().copysign(u - T::lit(0.5));
    let g = -(-u.ln()).max(zero).sqrt();
    let square = q.squared();
    let of_q =
        |[a, b, c, d]: [f64; 4]| (T::lit(a) + T::lit(b) * q) + square * (T::lit(c) + T::lit(d) * q);
    let [flat, first, second] = FIRST.map(of_q);
    let weight = cos * (flat + sin * (first + sin * second)).max(T::lit(0.1));
    (q * weight + g * sin) / (weight + sin)
}

/// R of [`first_guess`]: for each power of sin the powers of q.
const FIRST: [[f64; 4]; 3] = [
    [5.5103521, -1.4050210, -0.0069938941, 0.0257336887],
    [-8.9858984, 2.1615853, 0.1278306868, -0.0702791299],
    [4.5099801, -1.0753769, -0.0963845352, 0.0477180555],
];

const FRAC_1_SQRT_PI: f64 = 0.5 * FRAC_2_SQRT_PI;
const SQRT_PI: f64 = 2.0 / FRAC_2_SQRT_PI;

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
                        let x = visible_slope(cos, sin, T::one() / sin, u).into();
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
    fn the_length_of_the_viewer_does_not_matter() {
        for cot in [1e-20_f32, 0.1, 1.0, 3.0, 1e8] {
            for u in [0.0, 1e-37, 1e-20, 0.1, 0.7, 0.9] {
                let slopes = [1e-8, 1.0, 1e4].map(|length| {
                    let s = glam::Vec3::new(0.6 * length, 0.8 * length, cot * length);
                    visible_slopes::<f32>(s, [u, 0.25])
                });
                for (x, y) in slopes {
                    let off = (x - slopes[1].0).abs().max((y - slopes[1].1).abs());
                    assert!(off < 1e-5, "{off:e} at {cot:e}, {u:e}");
                }
            }
        }
    }

    #[test]
    fn visible_slopes_invert_their_distribution_function() {
        let double = worst_inversion::<f64>(1e-16);
        assert!(double < 2e-13, "{double:e}");
        let single = worst_inversion::<f32>(6e-8);
        assert!(single < 4e-7, "{single:e}");
    }
}
