use super::term::{Fresnel, incident_cosine};
use crate::parameter::model;
use crate::real::{Color, Real};

model! {
    /// Schlick's polynomial in place of Fresnel's equations.
    ///
    /// # Formula
    /// ```text
    /// F = F₀ + (1 − F₀)(1 − u)⁵    average F₀ + (1 − F₀)/21
    /// ```
    parameters {
        f0: C, UNIT, "F₀", "reflectance at normal incidence";
    }
    /// | u | `cos_theta` | cosine of the angle of incidence (V·H on microfacets) | −1 … 1, the sign is ignored |
    ///
    /// # Energy
    /// Reciprocal. Conserving: F ≤ 1. Falls monotonically from 1 at grazing to F₀, so it does not
    /// vanish for F₀ = 0 (no surface). Seen from inside a dense medium it needs the cosine on the thin
    /// side, and 1 in total reflection; use [`Dielectric`](super::Dielectric) there. Another colour at
    /// grazing and another exponent has [`GeneralSchlick`](super::GeneralSchlick).
    ///
    /// # Accuracy
    /// The original claims an error below 1 %. That holds for the mean absolute error only, for
    /// dielectrics with 1.4 ≤ n ≤ 1.6; against the exact curve it is
    ///
    /// | n | 1.1 | 1.2 | 1.33 | 1.4 | 1.5 | 1.8 | 2 | 2.5 | 3 |
    /// |---|---|---|---|---|---|---|---|---|---|
    /// | largest | 0.2105 | 0.1130 | 0.0599 | 0.0461 | 0.0357 | 0.0345 | 0.0444 | 0.0824 | 0.1250 |
    /// | at | 83.1° | 83.0° | 83.8° | 84.3° | 85.0° | 85.4° | 85.2° | 84.4° | 84.1° |
    /// | mean over θ | 0.0399 | 0.0208 | 0.0109 | 0.0094 | 0.0092 | 0.0106 | 0.0111 | 0.0142 | 0.0211 |
    ///
    /// and for metals 0.0066 (silver, 0.06 + 3.586i), 0.0176 (gold, 1.38 + 1.914i), 0.0390 (copper, 1.02 +
    /// 2.577i), 0.0801 (aluminium, 0.789 + 5.852i), 0.1978 (chromium, 3.18 + 3.33i); other wavelengths of
    /// the same metal may be worse.
    ///
    /// # Sources
    /// C. Schlick, *An Inexpensive BRDF Model for Physically-based Rendering*, Computer Graphics Forum
    /// 13(3), 1994, doi:10.1111/1467-8659.1330233.
    ///
    /// ```
    /// use brdf::{Fresnel, Schlick};
    ///
    /// let glass = Schlick::new(0.04_f64)?;
    /// assert!((glass.reflectance(0.5) - 0.07).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct Schlick<C = glam::Vec3>;

    /// A surface of the given reflectance at normal incidence.
    pub fn new;
}

impl<T: Real, C: Color<T>> Fresnel<T> for Schlick<C> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        let one = T::one();
        let versine = one - incident_cosine(cos_theta);
        let weight = versine.squared().squared() * versine;
        self.f0.map(|f0| f0 + (one - f0) * weight)
    }

    #[inline(always)]
    fn average(&self) -> C {
        let one = T::one();
        self.f0.map(|f0| f0 + (one - f0) * T::lit(1.0 / 21.0))
    }
}
