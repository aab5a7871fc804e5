use core::f64::consts::FRAC_1_PI;

use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above};
use crate::parameter::model;
use crate::real::{Color, Real, Vector};
use crate::sampling::cosine_hemisphere;

model! {
    /// Lambert's ideal diffuse surface: equal radiance in all directions.
    ///
    /// # Formula
    /// ```text
    /// f = ρ/π
    /// ```
    parameters {
        albedo: C, UNIT, "ρ", "fraction of the light that is reflected";
    }
    ///
    /// # Energy
    /// Reciprocal. Conserving: the directional albedo is ρ at every angle.
    ///
    /// # Sampling
    /// With density cosθ/π, so that every sample has weight ρ.
    ///
    /// # Sources
    /// J. H. Lambert, *Photometria*, 1760.
    ///
    /// ```
    /// use brdf::{Brdf, Lambert};
    /// use glam::DVec3;
    ///
    /// let paper = Lambert::new(DVec3::new(0.8, 0.8, 0.7))?;
    /// assert_eq!(paper.albedo(DVec3::Z).z, 0.7);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("diffuse"))]
    pub struct Lambert<C = glam::Vec3>;

    /// A diffuse surface of the given albedo.
    pub fn new;
}

impl<T: Real, C: Color<T>> Brdf<T> for Lambert<C> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let above = both_above::<T>(wi, wo);
        (self.albedo * T::lit(FRAC_1_PI)).only_where(above)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let above = both_above::<T>(wi, wo);
        (wi.z() * T::lit(FRAC_1_PI)).only_where(above)
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let wi = cosine_hemisphere(u);
        Sample { wi, weight: self.albedo, pdf: wi.z() * T::lit(FRAC_1_PI) }
            .only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn albedo(&self, wo: T::Vec3) -> C {
        self.albedo.only_where(above_surface::<T, _>(wo))
    }
}
