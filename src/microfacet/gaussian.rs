use core::f64::consts::{FRAC_PI_2, PI, TAU};

use super::distribution::Distribution;
use crate::error::{ParameterError, range};
use crate::quadrature::integrate;
use crate::real::{Real, Vector};
use crate::sampling::uniform;

/// The normal distribution of the angle between the facets and the surface, as Torrance and
/// Sparrow took it.
///
/// ```text
/// D = c exp(−(α/m)²),  1/c = π ∫₀^{π/2} exp(−α²/m²) sin 2α dα
/// ```
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | α | | angle between h and the normal, radians | 0 … π/2 |
/// | m | `roughness` | angle at which D has fallen to 1/e, radians | 10⁻⁸ … 10⁴ |
///
/// Normalised, ∫ D cosα dω = 1: c is computed, with a relative error below 10⁻¹⁴ in `f64`. For
/// small m it is (1 + 2m²/3)/(π m²), for large m it tends to 1/π, the constant D. The papers leave
/// c to be chosen. Not shape invariant: there is no closed form of Smith's shadowing.
///
/// A normal is drawn by inverting the distribution function of α², four steps of Newton's method
/// over the same quadrature. What is left is an error of the distribution function below 10⁻¹³ in
/// `f64` and 2·10⁻⁶ in `f32`.
///
/// K. E. Torrance, E. M. Sparrow, "Theory for off-specular reflection from roughened surfaces",
/// JOSA 57(9), 1967, [doi:10.1364/JOSA.57.001105](https://doi.org/10.1364/JOSA.57.001105), with
/// b exp(−c²α²), α in degrees, c = 0.05, that is m = 20° = 0.349.
///
/// ```
/// use brdf::{Distribution, Gaussian};
/// use glam::DVec3;
///
/// let gaussian = Gaussian::new(0.5_f64)?;
/// assert!((gaussian.density(DVec3::Z) - 1.49991401846).abs() < 1e-10); // c
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaussian<T = f32> {
    roughness: T,
    peak: T,
}

impl<T: Real> Gaussian<T> {
    /// The distribution with the given 1/e-angle in radians.
    ///
    /// # Errors
    /// If `roughness` is not in 10⁻⁸ … 10⁴.
    pub fn new(roughness: T) -> Result<Self, ParameterError> {
        ParameterError::check("roughness", range::ROUGHNESS, |lower, upper| {
            roughness.outside(lower, upper)
        })?;
        let whole = facets(roughness, T::lit(0.0), last(roughness)) * roughness.squared();
        Ok(Self { roughness, peak: T::lit(1.0) / (T::lit(PI) * whole) })
    }

    /// The angle in radians at which D has fallen to 1/e.
    #[must_use]
    pub fn roughness(&self) -> T {
        self.roughness
    }
}

/// The angle, as a multiple of m, up to which facets count: beyond 7m lies less than 10⁻²¹ of them.
#[inline(always)]
fn last<T: Real>(roughness: T) -> T {
    (T::lit(FRAC_PI_2) / roughness).min(T::lit(7.0))
}

/// The facets between two angles that are given as multiples x = α/m, in units of m²:
/// ∫ exp(−x²) sin(2mx)/m dx. The units keep tiny m from underflow.
#[inline]
fn facets<T: Real>(roughness: T, from: T, to: T) -> T {
    let double = roughness + roughness;
    let sum = integrate(from, to, |x: T| (-x.squared()).exp() * (double * x).sin());
    sum / roughness
}

impl<T: Real> Distribution<T> for Gaussian<T> {
    #[inline]
    fn density(&self, h: T::Vec3) -> T {
        let zero = T::lit(0.0);
        let above = h.z().gt(zero);
        let sin = (h.x().squared() + h.y().squared()).min(T::max_finite()).sqrt();
        let angle = sin.atan2(T::select(above, h.z(), T::lit(1.0)));
        // From 10⁴ on the exponential is zero in every number; the bound keeps it from infinity.
        let exponent = (angle / self.roughness).squared().min(T::lit(1e4));
        T::select(above, self.peak * (-exponent).exp(), zero)
    }

    #[inline]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        let [u, turn] = uniform(u);
        let (sin, cos) = self.angle(u).sin_cos();
        let (sin_phi, cos_phi) = (turn * T::lit(TAU)).sin_cos();
        // The number nearest to π/2 may lie above it.
        Vector::new(sin * cos_phi, sin * sin_phi, cos.max(T::lit(0.0)))
    }
}

impl<T: Real> Gaussian<T> {
    /// The angle up to which the part `u` of the facets lies.
    ///
    /// The unknown is t = α²/m², whose density exp(−t) sin(2α)/(2α) is nearly exponential. The
    /// smaller of the two parts is followed, so that each end keeps its digits. Above the median
    /// Newton's method needs a straight line: the logarithm of the part for narrow distributions,
    /// the square root for wide ones, which end at π/2 in a parabola.
    #[inline]
    fn angle(&self, u: T) -> T {
        let (zero, one, two, tiny) = (T::lit(0.0), T::lit(1.0), T::lit(2.0), T::lit(1e-37));
        let m = self.roughness;
        let scale = self.peak * T::lit(PI) * m.squared();
        let end = last(m);
        let last = end.squared();
        let lower_half = u.lt(T::lit(0.5));
        let narrow = m.lt(T::lit(0.3));
        let part = T::select(lower_half, u, one - u).max(tiny);

        // An exponential cut off at the last angle. Its rate takes in the fall of sin(2α)/(2α).
        let rate = one + T::lit(0.9) * m.squared();
        let inside = -(-rate * last).exp_m1();
        let first = -(-part * inside).ln_1p();
        let second = -((one - inside) + inside * part).ln();
        let mut t = T::select(lower_half, first, second) / rate;

        for _ in 0..4 {
            t = t.clamp(zero, last);
            let x = t.sqrt();
            let from = T::select(lower_half, zero, x);
            let to = T::select(lower_half, x, end);
            let facets = (facets(m, from, to) * scale).max(tiny);
            let double = (m * (x + x)).max(tiny);
            let density = (-t).exp() * (double.sin() / double) * scale;
            let straight = T::select(
                narrow,
                facets * (facets / part).ln(),
                two * (facets - (facets * part).sqrt()),
            );
            t = t + T::select(lower_half, part - facets, straight) / density.max(tiny);
        }
        m * t.clamp(zero, last).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest error of the distribution function: relative below the median, absolute above.
    fn worst_inversion<T: Real + Into<f64>>(epsilon: f64) -> f64 {
        let mut worst = 0.0_f64;
        for i in 0..=48 {
            for m in [10.0_f64.powf(-8.0 + 12.0 * f64::from(i) / 48.0), 0.1 + f64::from(i) / 24.0] {
                let gaussian = Gaussian::new(T::lit(m)).unwrap();
                let m = gaussian.roughness.into();
                let whole = facets(m, 0.0, last(m));
                for j in 0..40 {
                    let part = f64::from(j) / 40.0;
                    for u in [part, 1e-30_f64.powf(part), 1.0 - epsilon.powf(part)] {
                        let u = T::lit(u.max(1e-30));
                        let got = facets(m, 0.0, gaussian.angle(u).into() / m) / whole;
                        let u: f64 = u.into();
                        let scale = if u < 0.5 { u } else { 1.0 };
                        worst = worst.max((got - u).abs() / scale);
                    }
                }
            }
        }
        worst
    }

    #[test]
    fn angles_invert_their_distribution_function() {
        let double = worst_inversion::<f64>(1e-16);
        assert!(double < 1e-13, "{double:e}");
        let single = worst_inversion::<f32>(6e-8);
        assert!(single < 2e-6, "{single:e}");
    }
}
