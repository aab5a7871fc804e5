use super::roughness::Roughness;
use super::spread::{Spread, Spreads};
use super::traits::{Distribution, Smith};
use crate::direction::above_or_normal;
use crate::error::ParameterError;
use crate::parameter::model;
use crate::real::{Real, Vector};
use crate::sampling::uniform;

model! {
    /// GGX, the distribution of Trowbridge and Reitz: the facets of an ellipsoid.
    ///
    /// # Formula
    /// ```text
    /// D = 1 / (π α_x α_y (h_x²/α_x² + h_y²/α_y² + h_z²)²)
    /// Λ = (√(1 + (α_x² w_x² + α_y² w_y²)/w_z²) − 1)/2
    /// ```
    ///
    /// With equal roughness α, D = α²/(π ((α² − 1) cos²θ_h + 1)²), where θ_h is the angle between h and the
    /// normal.
    parameters {
        roughness: Roughness<T>, ROUGHNESS, "α_x, α_y", "roughness along tangent and bitangent";
    }
    ///
    /// # Energy
    /// Normalised, ∫ D cosθ_h dω = 1. The tails are long: the variance of the slopes is infinite.
    /// Roughness 1 makes D = 1/π at all angles; roughness to 0 makes a mirror.
    ///
    /// # Sampling
    /// Visible normals are drawn with spherical caps: in the space stretched to roughness 1, the sum
    /// of the viewer's direction and a uniform point of the cap z > −s_z.
    ///
    /// # Sources
    /// T. S. Trowbridge, K. P. Reitz, "Average irregularity representation of a rough surface for ray
    /// reflection", JOSA 65, 1975, [doi:10.1364/JOSA.65.000531](https://doi.org/10.1364/JOSA.65.000531).
    /// B. Walter et al., "Microfacet models for refraction through rough surfaces", EGSR 2007, eq. 33.
    /// J. Dupuy, A. Benyoub, "Sampling visible GGX normals with spherical caps", HPG 2023,
    /// [doi:10.1111/cgf.14867](https://doi.org/10.1111/cgf.14867).
    ///
    /// ```
    /// use brdf::{Distribution, Ggx};
    /// use glam::DVec3;
    ///
    /// let ggx = Ggx::new(0.5_f64)?;
    /// assert!((ggx.density(DVec3::Z) - 1.2732395447).abs() < 1e-10); // 1/(π α²)
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("Trowbridge-Reitz", "TrowbridgeReitz", "TR", "GTR2"))]
    pub struct Ggx<T = f32>;
}

impl<T: Real> Ggx<T> {
    /// The distribution of a surface that is equally rough in all directions.
    ///
    /// # Errors
    /// If `roughness` is not in 10⁻⁸ … 10⁴.
    pub fn new(roughness: T) -> Result<Self, ParameterError> {
        Ok(Self { roughness: Roughness::isotropic(roughness)? })
    }

    /// The distribution of a surface with grain: roughness along the tangent and the bitangent.
    ///
    /// # Errors
    /// If `along_x` or `along_y` is not in 10⁻⁸ … 10⁴.
    pub fn anisotropic(along_x: T, along_y: T) -> Result<Self, ParameterError> {
        Ok(Self { roughness: Roughness::anisotropic(along_x, along_y)? })
    }
}

impl<T: Real> Distribution<T> for Ggx<T> {
    #[inline(always)]
    fn density(&self, h: T::Vec3) -> T {
        self.density_along(h)
    }

    /// D = (|m|²/(m_x²/α_x² + m_y²/α_y² + m_z²))²/(π α_x α_y), the formula above for h = m/|m|.
    #[inline(always)]
    fn density_along(&self, m: T::Vec3) -> T {
        let cos_squared = m.z().squared();
        // A vector taken for a unit vector needs its length too: the fourth power would multiply the
        // rounding of it.
        let length_squared = m.x().squared() + m.y().squared() + cos_squared;
        let sum = self.roughness.sin_over_alpha_squared(m) + cos_squared;
        let quotient = length_squared / sum;
        let density = self.roughness.inverse_area() * quotient.squared();
        // Not a number where squares underflow or overflow, as those of no direction do.
        density.min(T::max_finite()).only_where(m.z().gt(T::zero()))
    }

    #[inline(always)]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        Vector::normalize_or_normal(self.sample_along(u))
    }

    #[inline(always)]
    fn sample_along(&self, u: [T; 2]) -> T::Vec3 {
        let [u, turn] = uniform(u);
        // tan²θ = u₀/(1 − u₀) in the space of roughness 1: slope sinθ over cosθ.
        let (sin, cos) = (u.sqrt(), (T::one() - u).sqrt());
        let (sin_phi, cos_phi) = turn.sin_cos_turns();
        self.roughness.unstretch_along(sin * cos_phi, sin * sin_phi, cos)
    }

    fn spreads(&self) -> Option<Spreads<T>> {
        Spread::ellipsoid(self.roughness.along()).of_all()
    }
}

impl<T: Real> Smith<T> for Ggx<T> {
    /// Λ cosθ = (√(cos²θ + α² sin²θ) − cosθ)/2, without the difference α² sin²θ over twice the sum.
    #[inline(always)]
    fn lambda_cos(&self, w: T::Vec3) -> T {
        let cos = w.z().max(T::zero());
        let alpha_sin_squared = self.roughness.alpha_sin_squared(w);
        // The sum is at least 10⁻⁸ for a direction; its lower bound only keeps the zero vector from
        // dividing 0 by 0.
        let sum = ((cos.squared() + alpha_sin_squared).sqrt() + cos).max(T::lit(1e-30));
        (T::lit(0.5) * alpha_sin_squared / sum).min(T::max_finite())
    }

    /// (1 + 2Λ) cosθ = √(cos²θ + α² sin²θ), the projected area of the ellipsoid.
    #[inline(always)]
    fn projected_area(&self, w: T::Vec3) -> T {
        (w.z().squared() + self.roughness.alpha_sin_squared(w)).min(T::max_finite()).sqrt()
    }

    #[inline(always)]
    fn sample_visible(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        let wo = above_or_normal::<T, _>(wo);
        Vector::normalize_or_normal(self.sample_visible_along(wo, u))
    }

    #[inline(always)]
    fn sample_visible_along(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        let ([turn, u], one) = (uniform(u), T::one());
        // No roughness is below 10⁻⁸: a stretched direction has a length.
        let stretched = self.roughness.stretch_along(wo);
        let s = stretched * (one / Vector::length_squared(stretched).sqrt());
        // The cap is 1 + s_z high. Both 1 − z and 1 + z of its uniform point are sums of positive
        // terms, so that 1 − z² keeps its digits near the poles.
        let height = one + s.z();
        let one_minus_s_z = (s.x().squared() + s.y().squared()) / height;
        let below_top = u * height;
        let above_rim = (one - u) * height;
        let sin = (below_top * (above_rim + one_minus_s_z)).sqrt();
        let (sin_phi, cos_phi) = turn.sin_cos_turns();
        self.roughness.unstretch_along(sin * cos_phi + s.x(), sin * sin_phi + s.y(), above_rim)
    }
}
