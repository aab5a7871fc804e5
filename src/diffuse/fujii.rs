use core::f64::consts::FRAC_1_PI;

use super::grooves::{reflected, shape};
use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above};
use crate::parameter::model;
use crate::real::{Color, Real, Vector};
use crate::sampling::cosine_hemisphere;

model! {
    /// Fujii's fit to Oren and Nayar's full model: no angle in it, and no dark ring where light and viewer
    /// are on opposite sides.
    ///
    /// # Formula
    /// ```text
    /// f = ρ/π · (A′ + B s/t′)
    /// A′ = 1 − 0.5 σ²/(σ² + 0.33) + 0.17 ρ σ²/(σ² + 0.13)      B = 0.45 σ²/(σ² + 0.09)
    /// s = L·V − (N·L)(N·V)       t′ = max(N·L, N·V) for s > 0, 1 otherwise
    /// ```
    parameters {
        albedo: C, UNIT, "ρ", "fraction of the light that a facet reflects";
        sigma: T, SIGMA, "σ", "standard deviation of the tilt of the facets, radians";
    }
    constants {
        let variance = sigma.squared();
        let direct = T::one() - T::lit(0.5) * variance / (variance + T::lit(0.33));
        let between = T::lit(0.17) * variance / (variance + T::lit(0.13));
        let b = T::lit(0.45) * variance / (variance + T::lit(0.09));
        /// ρ A′.
        level: C = albedo.map(|rho| rho * (direct + between * rho));
        /// ρ B.
        slope: C = albedo * b;
    }
    ///
    /// # Energy
    /// Reciprocal, to the last bit. σ = 0 is [`Lambert`](crate::Lambert) but for rounding. **Not**
    /// conserving: the directional albedo is ρ (A′ + B G/π), with G of [`Fon`](crate::Fon), at most 1.0288 for
    /// ρ = 1 (at grazing, for σ = 0.2575). f grows without bound, as 1/t′, where both directions graze side by
    /// side; the radiance f cosθᵢ does not.
    ///
    /// # Sampling
    /// With density cosθ/π.
    ///
    /// # Sources
    /// Y. Fujii, *A tiny improvement of Oren–Nayar reflectance model*, a page on the web without date, the first
    /// of its two forms. [`Fon`](crate::Fon) is the second, which conserves energy.
    ///
    /// ```
    /// use brdf::{Brdf, Fujii};
    /// use glam::DVec3;
    ///
    /// let plaster = Fujii::new(DVec3::splat(0.5), 0.8)?;
    /// let f = plaster.eval(DVec3::Z, DVec3::Z);
    /// assert!((f.x - 0.11789441298).abs() < 1e-11);
    ///
    /// let grazing = DVec3::new(1.0, 0.0, 1e-9);
    /// let most = (0..=1570)
    ///     .map(|step| Ok(Fujii::new(1.0_f64, f64::from(step) * 1e-3)?.albedo(grazing)))
    ///     .try_fold(0.0_f64, |most, albedo: Result<_, brdf::ParameterError>| Ok(most.max(albedo?)))?;
    /// assert!((1.0287..1.0288).contains(&most));
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct Fujii<C = glam::Vec3, T = f32>;

    /// A rough diffuse surface.
    pub fn new;
}

impl<T: Real, C: Color<T>> Fujii<C, T> {
    /// π f.
    #[inline(always)]
    fn relative(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        self.level + self.slope * shape::<T>(wi, wo)
    }
}

impl<T: Real, C: Color<T>> Brdf<T> for Fujii<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let value = self.relative(wi, wo) * T::lit(FRAC_1_PI);
        value.only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        (wi.z() * T::lit(FRAC_1_PI)).only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let wi = cosine_hemisphere(u);
        let weight = self.relative(wi, wo);
        Sample { wi, weight, pdf: wi.z() * T::lit(FRAC_1_PI) }.only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn albedo(&self, wo: T::Vec3) -> C {
        (self.level + self.slope * reflected::<T>(wo)).only_where(above_surface::<T, _>(wo))
    }
}
