use core::f64::consts::{FRAC_PI_2, PI};

use super::gaussian_tilts::Tilts;
use super::traits::Distribution;
use crate::parameter::model;
use crate::real::{Real, Vector};
use crate::sampling::uniform;

model! {
    /// The normal distribution of the angle between the facets and the surface, as Torrance and
    /// Sparrow took it.
    ///
    /// # Formula
    /// ```text
    /// D = c exp(−(θ_h/α)²),  1/c = π ∫₀^{π/2} exp(−θ_h²/α²) sin 2θ_h dθ_h
    /// ```
    parameters {
        roughness: T, ROUGHNESS, "α", "angle at which D has fallen to 1/e, radians";
    }
    constants {
        let (distributed, integral) = Tilts::new(T::lit(FRAC_PI_2) / roughness);
        /// c.
        c: T = T::lit(4.0 / (PI * PI * PI)) / integral;
        /// 1/α².
        steepness: T = T::one() / roughness.squared();
        /// The distribution function of θ_h².
        tilts: Tilts<T> = distributed;
    }
    /// | θ_h | | angle between h and the normal, radians | 0 … π/2 |
    ///
    /// # Energy
    /// Normalised, ∫ D cosθ_h dω = 1: c is computed, with a relative error below 10⁻¹⁴ in `f64`. For
    /// small α it is (1 + 2α²/3)/(π α²), for large α it tends to 1/π, the constant D. The papers leave
    /// c to be chosen. Not shape invariant: there is no closed form of Smith's shadowing.
    ///
    /// # Sampling
    /// A normal is drawn by inverting the distribution function of θ_h², four steps of Newton's method on
    /// a closed form. What is left is an error of the distribution function below
    /// 10⁻¹³ in `f64` and 2·10⁻⁶ in `f32`.
    ///
    /// # Sources
    /// K. E. Torrance, E. M. Sparrow, "Theory for off-specular reflection from roughened surfaces",
    /// JOSA 57(9), 1967, [doi:10.1364/JOSA.57.001105](https://doi.org/10.1364/JOSA.57.001105), with
    /// b exp(−c²θ_h²), θ_h in degrees, c = 0.05, that is α = 20° = 0.349.
    ///
    /// ```
    /// use brdf::{Distribution, Gaussian};
    /// use glam::DVec3;
    ///
    /// let gaussian = Gaussian::new(0.5_f64)?;
    /// assert!((gaussian.density(DVec3::Z) - 1.49991401846).abs() < 1e-10); // c
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct Gaussian<T = f32>;

    /// The distribution with the given 1/e-angle in radians.
    pub fn new;
}

impl<T: Real> Distribution<T> for Gaussian<T> {
    #[inline(always)]
    fn density(&self, h: T::Vec3) -> T {
        let zero = T::zero();
        let above = h.z().gt(zero);
        let (one, cos) = (T::one(), T::select(above, h.z(), T::one()));
        // 1 − cosθ_h with all digits: from sin² near the normal, and near the horizon from the cosine
        // alone, which the rounding of the length of h does not reach there.
        let from_sine = (h.x().squared() + h.y().squared()) / (one + cos);
        let versine = T::select(cos.lt(T::lit(0.5)), one - cos, from_sine);
        let exponent = versine.at_most(one).angle_squared() * self.steepness;
        (self.c * (-exponent).exp()).only_where(above)
    }

    #[inline(always)]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        let [u, turn] = uniform(u);
        let (sin, cos) = (self.roughness * self.tilts.angle(u)).sin_cos();
        let (sin_phi, cos_phi) = turn.sin_cos_turns();
        // The number nearest to π/2 may lie above it.
        Vector::new(sin * cos_phi, sin * sin_phi, cos.max(T::zero()))
    }
}
