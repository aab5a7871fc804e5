use core::f64::consts::FRAC_1_PI;

use super::traits::Distribution;
use crate::error::{ParameterError, Range};
use crate::parameter::model;
use crate::real::{Real, Vector};
use crate::sampling::{ln_of_rest, uniform};

model! {
    /// A power of the cosine: the distribution behind the lobes of Phong and Blinn.
    ///
    /// # Formula
    /// ```text
    /// D = (n + 2)/(2π) cosⁿθ_h
    /// ```
    parameters {
        exponent: T, EXPONENT, "n", "sharpness; 0 makes D constant, large n a mirror";
    }
    /// | θ_h | | angle between h and the normal | 0 … π/2 |
    ///
    /// # Energy
    /// Normalised, ∫ D cosθ_h dω = 1. Blinn's own D₁ is the same power with maximum 1 instead, see
    /// [`Blinn1977`](crate::Blinn1977). cosⁿθ_h is computed as (cos²θ_h/(cos²θ_h + sin²θ_h))^(n/2),
    /// which keeps its digits close to the normal, where large exponents live.
    ///
    /// # Sources
    /// J. F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977,
    /// [doi:10.1145/563858.563893](https://doi.org/10.1145/563858.563893); normalised as in B. Walter
    /// et al., "Microfacet models for refraction through rough surfaces", EGSR 2007, eq. 30.
    ///
    /// ```
    /// use brdf::{Blinn, Distribution};
    /// use glam::DVec3;
    ///
    /// let blinn = Blinn::new(10.0_f64)?;
    /// assert!((blinn.density(DVec3::Z) - 1.9098593171).abs() < 1e-10); // (n + 2)/(2π)
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct Blinn<T = f32>;

    /// The distribution with the given exponent.
    pub fn new;
}

impl<T: Real> Blinn<T> {
    /// The distribution that peaks as high as Beckmann's of roughness α: n = 2/α² − 2. For small α
    /// the two agree everywhere.
    ///
    /// ```
    /// use brdf::{Beckmann, Blinn, Distribution};
    /// use glam::DVec3;
    ///
    /// let (blinn, beckmann) = (Blinn::from_roughness(0.01_f64)?, Beckmann::new(0.01)?);
    /// let h = DVec3::new(0.01, 0.0, 1.0).normalize();
    /// assert!((blinn.density(h) / beckmann.density(h) - 1.0).abs() < 2e-4);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// If `roughness` is not in 0.00015 … 1; beyond 1 the exponent would be negative.
    pub fn from_roughness(roughness: T) -> Result<Self, ParameterError> {
        Range::new(1.5e-4, 1.0).check("roughness", roughness)?;
        let one = T::one();
        let cos_squared = (one - roughness) * (one + roughness);
        Self::new(T::lit(2.0) * cos_squared / roughness.squared())
    }
}

impl<T: Real> Distribution<T> for Blinn<T> {
    #[inline(always)]
    fn density(&self, h: T::Vec3) -> T {
        self.density_along(h)
    }

    #[inline(always)]
    fn density_along(&self, m: T::Vec3) -> T {
        // Squares that no number holds belong to no direction, or to one that grazes so much that
        // the power is 0; the bounds keep both in the range of the power.
        let (least, largest) = (T::lit(4.0) / T::max_finite(), T::lit(0.25) * T::max_finite());
        let along = m.z().squared().max(least).min(largest);
        let across = (m.x().squared() + m.y().squared()).min(largest);
        let peak = (self.exponent + T::lit(2.0)) * T::lit(0.5 * FRAC_1_PI);
        let power = along.power_of_part(across, self.exponent * T::lit(0.5));
        (peak * power).only_where(m.z().gt(T::zero()))
    }

    #[inline(always)]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        let [u, turn] = uniform(u);
        // cosθ = (1 − u₀)^(1/(n + 2)) through its logarithm, which gives sinθ all its digits.
        let ln_cos = ln_of_rest(u) / (self.exponent + T::lit(2.0));
        let sin = (-(ln_cos + ln_cos).exp_m1()).max(T::zero()).sqrt();
        let (sin_phi, cos_phi) = turn.sin_cos_turns();
        Vector::new(sin * cos_phi, sin * sin_phi, ln_cos.exp())
    }
}
