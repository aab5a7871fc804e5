use core::f64::consts::FRAC_1_PI;

use super::grooves::{AT_GRAZING, reflected, shape};
use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above};
use crate::parameter::model;
use crate::real::{Color, Real, Vector};
use crate::sampling::cosine_hemisphere;

model! {
    /// Fujii's Oren–Nayar model by roughness, "FON": a rough diffuse surface that never
    /// reflects more than it receives.
    ///
    /// # Formula
    /// ```text
    /// f = ρ/π · A (1 + r s/t′)          A = 1/(1 + (½ − 2/(3π)) r)
    /// s = L·V − (N·L)(N·V)       t′ = max(N·L, N·V) for s > 0, 1 otherwise
    /// ```
    parameters {
        albedo: C, UNIT, "ρ", "fraction of the light that a facet reflects";
        roughness: T, UNIT, "r", "roughness: 0 is Lambert's surface, 1 the roughest";
    }
    constants {
        /// A.
        a: T = T::one() / (T::one() + T::lit(AT_GRAZING) * roughness);
    }
    ///
    /// # Energy
    /// Reciprocal, to the last bit. Conserving: the directional albedo is ρ A (1 + r G/π), with S = sinθ, μ = cosθ,
    /// G = S(θ − Sμ) + ⅔ (Sμ (1 + S + S²)/(1 + S) − S), which rises from ρA at normal incidence to ρ at
    /// grazing: a rough white surface loses the light that its grooves send to each other,
    /// up to 22 % of it. [`Eon`](crate::Eon) gives it back. r = 0 is [`Lambert`](crate::Lambert) but for
    /// rounding. f grows without bound, as 1/t′, where both directions graze side by side; the radiance
    /// f cosθᵢ does not.
    ///
    /// # Sampling
    /// With density cosθ/π.
    ///
    /// # Sources
    /// Y. Fujii, *A tiny improvement of Oren–Nayar reflectance model*, a page on the web without date, the second
    /// of its two forms. G as in J. Portsmouth, P. Kutz, S. Hill, *EON: A Practical Energy-Preserving Rough
    /// Diffuse BRDF*, JCGT 14(1), 2025, where Sμ (1 + S + S²)/(1 + S) stands as S (1 − S³)/μ, 0/0 at grazing.
    ///
    /// ```
    /// use brdf::{Brdf, Fon};
    /// use glam::DVec3;
    ///
    /// let clay = Fon::new(DVec3::splat(0.6), 0.8)?;
    /// let grazing = DVec3::new(1.0, 0.0, 1e-9).normalize();
    /// assert!((clay.albedo(grazing).x - 0.6).abs() < 1e-8);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("Fujii"))]
    pub struct Fon<C = glam::Vec3, T = f32>;

    /// A rough diffuse surface.
    pub fn new;
}

impl<T: Real, C: Color<T>> Fon<C, T> {
    /// π f for a facet albedo of 1.
    #[inline(always)]
    fn relative(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        // A direction that is a little too long makes s a little less than −1.
        self.a * (T::one() + self.roughness * shape::<T>(wi, wo)).max(T::zero())
    }
}

impl<T: Real, C: Color<T>> Brdf<T> for Fon<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let value = T::lit(FRAC_1_PI) * self.relative(wi, wo);
        (self.albedo * value).only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        (wi.z() * T::lit(FRAC_1_PI)).only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let wi = cosine_hemisphere(u);
        let weight = self.albedo * self.relative(wi, wo);
        Sample { wi, weight, pdf: wi.z() * T::lit(FRAC_1_PI) }.only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn albedo(&self, wo: T::Vec3) -> C {
        let value = self.a * (T::one() + self.roughness * reflected::<T>(wo));
        (self.albedo * value).only_where(above_surface::<T, _>(wo))
    }
}
