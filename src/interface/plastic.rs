use core::f64::consts::FRAC_1_PI;

use super::side::Viewer;
use crate::bsdf::{Bsdf, BsdfSample, Lobes, Power, TransportMode, never};
use crate::direction::{above_or_normal, above_surface, both_above};
use crate::fresnel::{dielectric_average, split};
use crate::parameter::model;
use crate::real::{Color, Mask, Real, Vector};
use crate::sampling::cosine_hemisphere;

model! {
    /// Lambert's diffuse surface under a smooth dielectric: plastic, ceramics, varnished wood.
    ///
    /// # Formula
    /// ```text
    /// f = (1 − F(N·wi)) (1 − F(N·wo)) ρ/(π n² (1 − ρ F_in))      nonlinear
    /// f = (1 − F(N·wi)) (1 − F(N·wo)) ρ/(π n² (1 − F_in))        linear
    /// n² (1 − F_in) = 1 − F_avg
    /// ```
    ///
    /// F is Fresnel's reflectance of the surface, F_avg its average over the cosine from outside, F_in that
    /// from inside: light that comes from the diffuse ground is thrown back by the surface to the part
    /// F_in, and what the ground reflects of it, once more.
    parameters {
        diffuse: C, UNIT, "ρ", "albedo of the diffuse ground";
        ior: T, DENSER = 1.5, "n", "index of the dielectric over that above it";
    }
    flags {
        nonlinear: true, "whether the ground colours light once for each reflection inside";
    }
    constants {
        /// 1 − F_avg.
        passed: T = T::one() - dielectric_average(ior);
        /// ρ/(n² (1 − ρ F_in)), without the difference that vanishes for large n.
        inner: C = diffuse.map(|rho| {
            let absorbed = ior.squared() * (T::one() - rho);
            if nonlinear { rho / (absorbed + rho * passed) } else { rho / passed }
        });
    }
    /// And one [specular lobe](Bsdf::specular) of weight F(N·wo).
    ///
    /// # Energy
    /// Reciprocal. Conserving: a beam keeps F + (1 − F) ρ (1 − F_in)/(1 − ρ F_in), all of it for ρ = 1,
    /// and F + (1 − F) ρ in the linear form.
    ///
    /// # Sampling
    /// The third number chooses: the lobe below F, with the weight 1; else cosθ/π, with the weight
    /// (1 − F(N·wi)) ρ/(n² (1 − ρ F_in)).
    ///
    /// # Limits
    /// The colour of the ground is that under the surface: seen from outside it is darker and, in the
    /// nonlinear form, more saturated.
    ///
    /// # Sources
    /// The interreflection: F. C. Williams, F. R. Clapper, "Multiple internal reflections in photographic
    /// color prints", JOSA 43(7), 1953,
    /// [doi:10.1364/JOSA.43.000595](https://doi.org/10.1364/JOSA.43.000595).
    ///
    /// ```
    /// use brdf::{Bsdf, Plastic, TransportMode};
    /// use glam::DVec3;
    ///
    /// let white = Plastic::new(DVec3::ONE, 1.5)?;
    /// let power = white.power(DVec3::new(0.6, 0.0, 0.8));
    /// assert!((power.reflectance.x - 1.0).abs() < 1e-14);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("coated diffuse", "varnish"))]
    pub struct Plastic<C = glam::Vec3, T = f32>;

    /// The form in which the ground colours light once for each reflection.
    pub fn new(nonlinear: true);

    /// The form in which the ground colours light once.
    pub fn linear(nonlinear: false);
}

impl<T: Real, C: Color<T>> Plastic<C, T> {
    /// F and 1 − F of a direction above the surface.
    #[inline(always)]
    fn surface(&self, w: T::Vec3) -> [T; 2] {
        split(self.ior, above_or_normal::<T, _>(w).z())
    }
}

impl<T: Real, C: Color<T>> Bsdf<T> for Plastic<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3, _: TransportMode) -> C {
        let [_, entering] = self.surface(wi);
        let [_, leaving] = self.surface(wo);
        let value = self.inner * (entering * leaving * T::lit(FRAC_1_PI));
        value.only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3, _: TransportMode) -> T {
        let [_, leaving] = self.surface(wo);
        (leaving * wi.z() * T::lit(FRAC_1_PI)).only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, [x, y, u]: [T; 3], mode: TransportMode) -> BsdfSample<T, C> {
        let (zero, one) = (T::zero(), T::one());
        let above = above_surface::<T, _>(wo);
        let [reflected, leaving] = self.surface(wo);
        let wi = self.specular(wo, mode).reflected.wi;
        let lobe = BsdfSample { wi, weight: C::splat(one), pdf: zero, specular: above };
        let wi = cosine_hemisphere([x, y]);
        let [_, entering] = self.surface(wi);
        let diffuse = BsdfSample {
            wi,
            weight: self.inner * entering,
            pdf: leaving * wi.z() * T::lit(FRAC_1_PI),
            specular: never::<T>(),
        };
        let diffuse = diffuse.only_where(above_surface::<T, _>(wi));
        let mirrored = u.clamp(zero, one).lt(reflected).or(leaving.le(zero));
        BsdfSample::choose(mirrored, lobe, diffuse).only_where(above)
    }

    #[inline(always)]
    fn specular(&self, wo: T::Vec3, _: TransportMode) -> Lobes<T, C> {
        let [reflected, _] = self.surface(wo);
        Viewer::<T>::above(wo).mirror(C::splat(reflected))
    }

    fn power(&self, wo: T::Vec3) -> Power<C> {
        let [reflected, entering] = self.surface(wo);
        let power = C::splat(reflected) + self.inner * (self.passed * entering);
        let reflectance = power.map(|power| power.at_most(T::one()));
        Power {
            reflectance: reflectance.only_where(above_surface::<T, _>(wo)),
            transmittance: C::splat(T::zero()),
        }
    }
}
