use core::f64::consts::FRAC_1_PI;

use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above};
use crate::parameter::model;
use crate::real::{Color, Real, Vector};
use crate::sampling::cosine_power;

model! {
    /// Minnaert's law: a power of both cosines, with which planetary scientists describe how a disc
    /// darkens towards its limb.
    ///
    /// # Formula
    /// ```text
    /// f = ρ (k + 1)/2π · (N·L N·V)^(k − 1)
    /// ```
    parameters {
        albedo: C, UNIT, "ρ", "directional albedo at normal incidence";
        k: T, LIMB_DARKENING, "k", "limb darkening: ½ is a flat disc at full phase, 1 is Lambert's surface";
    }
    ///
    /// At full phase, where light and viewer coincide, the radiance goes with cos^(2k − 1)θ. Fits to
    /// the moon give k near ½ for small phase angles, and larger k for larger ones.
    ///
    /// # Energy
    /// Reciprocal, to the last bit. The directional albedo is ρ cos^(k − 1)θ: conserving for k ≥ 1,
    /// where it falls towards grazing, and **not** for k < 1, where it grows without bound. Value,
    /// density and albedo for k = 1 are those of [`Lambert`](crate::Lambert), to the last bit.
    ///
    /// # Sampling
    /// With density (k + 1)/2π (N·L)ᵏ, so that every sample of a viewer has the same weight, the
    /// directional albedo.
    ///
    /// # Sources
    /// M. Minnaert, *The Reciprocity Principle in Lunar Photometry*, Astrophysical Journal 93, 1941,
    /// [doi:10.1086/144279](https://doi.org/10.1086/144279). The constant (k + 1)/2π, which makes ρ the albedo
    /// at normal incidence, is not his.
    ///
    /// ```
    /// use brdf::{Brdf, Minnaert};
    /// use glam::DVec3;
    ///
    /// let moon = Minnaert::new(DVec3::splat(0.12), 0.5)?;
    /// let limb = DVec3::new(0.8, 0.0, 0.6);
    /// // At full phase the disc is as bright at its limb as in its middle.
    /// let (middle, edge) = (moon.eval(DVec3::Z, DVec3::Z), moon.eval(limb, limb) * limb.z);
    /// assert!((middle.x - edge.x).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct Minnaert<C = glam::Vec3, T = f32>;

    /// A surface of the given albedo at normal incidence and limb darkening.
    pub fn new;
}

impl<C, T: Real> Minnaert<C, T> {
    /// (k + 1)/2π.
    #[inline(always)]
    fn constant(&self) -> T {
        (self.k + T::one()) * T::lit(0.5 * FRAC_1_PI)
    }

    /// cosᵏ⁻¹θ of a direction above the surface; 1 elsewhere. A length above 1 makes no cosine above 1.
    #[inline(always)]
    fn darkening(&self, above: T::Mask, cos: T) -> T {
        T::select(above, cos.at_most(T::one()), T::one()).powf(self.k - T::one())
    }
}

impl<T: Real, C: Color<T>> Brdf<T> for Minnaert<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let above = both_above::<T>(wi, wo);
        let product = self.darkening(above, wi.z()) * self.darkening(above, wo.z());
        let value = (self.constant() * product).min(T::max_finite());
        (self.albedo * value).only_where(above)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let above = both_above::<T>(wi, wo);
        (self.constant() * self.darkening(above, wi.z()) * wi.z()).only_where(above)
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let wi = cosine_power(self.k, u);
        let above = both_above::<T>(wi, wo);
        let weight = self.albedo * self.darkening(above, wo.z());
        Sample { wi, weight, pdf: self.pdf(wi, wo) }.only_where(above)
    }

    #[inline(always)]
    fn albedo(&self, wo: T::Vec3) -> C {
        let above = above_surface::<T, _>(wo);
        (self.albedo * self.darkening(above, wo.z())).only_where(above)
    }
}
