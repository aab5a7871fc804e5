use core::f64::consts::{FRAC_1_PI, FRAC_2_PI};

use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above};
use crate::parameter::model;
use crate::real::{Color, Real, Vector};
use crate::sampling::cosine_hemisphere;

model! {
    /// Oren and Nayar's rough diffuse surface of Lambertian V-grooves, qualitative form.
    ///
    /// # Formula
    /// ```text
    /// f = ρ/π · (A + B max(0, cosΔφ) sinθ₁ tanθ₂)
    /// A = 1 − 0.5 σ²/(σ² + 0.33)        B = 0.45 σ²/(σ² + 0.09)
    /// θ₁ = max(θᵢ, θₒ)    θ₂ = min(θᵢ, θₒ)    cosΔφ sinθ₁ tanθ₂ = (xᵢxₒ + yᵢyₒ)/max(cosθᵢ, cosθₒ)
    /// ```
    parameters {
        albedo: C, UNIT, "ρ", "fraction of the light that a facet reflects";
        sigma: T, SIGMA, "σ", "standard deviation of the tilt of the facets, radians";
    }
    flags {
        interreflection: false, "whether light that facets send to each other is made up for";
    }
    constants {
        let variance = sigma.squared();
        let offset = T::lit(if interreflection { 0.57 } else { 0.33 });
        /// A.
        a: T = T::one() - T::lit(0.5) * variance / (variance + offset);
        /// B.
        b: T = T::lit(0.45) * variance / (variance + T::lit(0.09));
    }
    ///
    /// The paper calls the angles θ₁ and θ₂ α and β. The model is meant for σ up to about 1.2; a
    /// tilt never exceeds π/2. σ is not the roughness of the microfacet distributions: for small
    /// angles that is √2 σ.
    ///
    /// The constant 0.33 leaves out the light that facets send to each other. The authors offer
    /// 0.57 in its place, in A alone, to make up for part of it:
    /// [`with_interreflection`](Self::with_interreflection). These are two values and no range.
    ///
    /// # Energy
    /// Reciprocal, to the last bit. σ = 0 is [`Lambert`](crate::Lambert), to the last bit. **Not**
    /// conserving: the directional albedo rises from ρA at normal incidence to ρ(A + B/2) at
    /// grazing, at most 1.0152 ρ (σ = 0.199), with interreflection 1.0444 ρ (σ = 0.291); with
    /// ρ ≤ 0.95 all energy balances. f grows without bound, as tanθ₂, where both directions graze;
    /// the radiance f cosθᵢ does not.
    ///
    /// Albedo in closed form, with s = sinθ, c = cosθ:
    /// E = ρ (A + 2B/π · (s(θ − sc)/2 + sc(1 + s + s²)/(3(1 + s)))).
    ///
    /// # Sampling
    /// With density cosθ/π.
    ///
    /// # Sources
    /// M. Oren, S. K. Nayar, *Generalization of Lambert's Reflectance Model*, SIGGRAPH 1994,
    /// [doi:10.1145/192161.192213](https://doi.org/10.1145/192161.192213), the qualitative model.
    /// Some descriptions drop the factor 1/π: they count the light as irradiance divided by π.
    ///
    /// ```
    /// use brdf::{Brdf, OrenNayar};
    /// use glam::DVec3;
    ///
    /// let plaster = OrenNayar::new(DVec3::splat(0.8), 0.3)?;
    /// let f = plaster.eval(DVec3::Z, DVec3::Z);
    /// assert!((f.x - 0.22736420441699334).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct OrenNayar<C = glam::Vec3, T = f32>;

    /// A rough diffuse surface; light that facets send to each other is left out (0.33).
    pub fn new(interreflection: false);
    /// A rough diffuse surface; light that facets send to each other is made up for in part
    /// (0.57): up to 10 % brighter at the same σ.
    pub fn with_interreflection(interreflection: true);
}

impl<T: Real, C: Color<T>> OrenNayar<C, T> {
    /// π f for a facet albedo of 1: A + B max(0, cosΔφ) sinθ₁ tanθ₂.
    #[inline(always)]
    fn relative(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        // sinθᵢ sinθₒ cosΔφ, and the cosine of the smaller angle θ₂.
        let across = wi.x() * wo.x() + wi.y() * wo.y();
        let cos_theta_2 = wi.z().max(wo.z());
        // Two directions that graze to the last bit overflow, and 0 · ∞ must not arise for B = 0.
        let limit = T::max_finite();
        let sin_tan = (across.max(T::zero()) / cos_theta_2).min(limit);
        (self.a + self.b * sin_tan).min(limit)
    }
}

impl<T: Real, C: Color<T>> Brdf<T> for OrenNayar<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let above = both_above::<T>(wi, wo);
        let value = T::lit(FRAC_1_PI) * self.relative(wi, wo);
        (self.albedo * value).only_where(above)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let above = both_above::<T>(wi, wo);
        (wi.z() * T::lit(FRAC_1_PI)).only_where(above)
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let wi = cosine_hemisphere(u);
        let weight = self.albedo * self.relative(wi, wo);
        Sample { wi, weight, pdf: wi.z() * T::lit(FRAC_1_PI) }.only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn albedo(&self, wo: T::Vec3) -> C {
        let (one, third) = (T::one(), T::lit(1.0 / 3.0));
        let w = Vector::normalize_or_normal(wo);
        let cos = w.z();
        let sin = (w.x() * w.x() + w.y() * w.y()).sqrt();
        let theta = sin.atan2(cos);
        // tanθ (1 − sin³θ), where the cosine of the tangent cancels.
        let tangent = sin * cos * (one + sin + sin * sin) / (one + sin);
        let integral = sin * (theta - sin * cos) * T::lit(0.5) + tangent * third;
        let value = self.a + self.b * T::lit(FRAC_2_PI) * integral;
        (self.albedo * value).only_where(above_surface::<T, _>(wo))
    }
}
