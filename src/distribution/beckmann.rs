use super::normal_slopes::{slopes, visible_slopes};
use super::roughness::Roughness;
use super::spread::{Spread, Spreads};
use super::traits::{Distribution, Smith};
use crate::direction::above_or_normal;
use crate::error::ParameterError;
use crate::parameter::model;
use crate::real::{Mask, Real, Vector, ierfc};

model! {
    /// Beckmann's distribution: facets of a surface whose slopes are normally distributed.
    ///
    /// # Formula
    /// ```text
    /// D = exp(−(h_x²/α_x² + h_y²/α_y²)/h_z²) / (π α_x α_y h_z⁴)
    /// Λ = (exp(−ν²)/(ν√π) − erfc ν)/2,  ν = w_z / √(α_x² w_x² + α_y² w_y²)
    /// ```
    ///
    /// With equal roughness α, D = exp(−tan²θ_h/α²)/(π α² cos⁴θ_h), where θ_h is the angle between h and the
    /// normal.
    parameters {
        roughness: Roughness<T>, ROUGHNESS, "α_x, α_y", "roughness along tangent and bitangent: √2 times the root-mean-square slope";
    }
    ///
    /// # Energy
    /// Normalised, ∫ D cosθ_h dω = 1. The peak 1/(π α²) lies at the normal for α ≤ 1/√2, beyond that on the
    /// ring cos²θ_h = 1/(2α²). Roughness to 0 makes a mirror.
    ///
    /// Two printed forms differ by a constant: the form in Cook and Torrance 1982,
    /// exp(−tan²θ_h/α²)/(α² cos⁴θ_h), is π times this one, and the form exp(−tan²θ_h/α²)/(4 α² cos⁴θ_h) is
    /// π/4 times this one. Neither is normalised.
    ///
    /// # Sources
    /// P. Beckmann, A. Spizzichino, *The Scattering of Electromagnetic Waves from Rough Surfaces*,
    /// 1963. R. L. Cook, K. E. Torrance, "A Reflectance Model for Computer Graphics", ACM TOG 1(1),
    /// 1982, [doi:10.1145/357290.357293](https://doi.org/10.1145/357290.357293).
    /// Λ: B. G. Smith, "Geometrical shadowing of a random rough surface", IEEE Trans. AP 15, 1967,
    /// [doi:10.1109/TAP.1967.1138991](https://doi.org/10.1109/TAP.1967.1138991), in the form of B. Walter
    /// et al., EGSR 2007, without their rational fit. Visible normals: E. Heitz, E. d'Eon, "Importance
    /// sampling microfacet-based BSDFs using the distribution of visible normals", EGSR 2014,
    /// [doi:10.1111/cgf.12417](https://doi.org/10.1111/cgf.12417).
    ///
    /// ```
    /// use brdf::{Beckmann, Distribution};
    /// use glam::DVec3;
    ///
    /// let beckmann = Beckmann::new(0.5_f64)?;
    /// assert!((beckmann.density(DVec3::Z) - 1.2732395447).abs() < 1e-10); // 1/(π α²)
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct Beckmann<T = f32>;
}

impl<T: Real> Beckmann<T> {
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

impl<T: Real> Distribution<T> for Beckmann<T> {
    #[inline(always)]
    fn density(&self, h: T::Vec3) -> T {
        self.density_along(h)
    }

    /// D = exp(−(m_x²/α_x² + m_y²/α_y²)/m_z²)/(π α_x α_y cos⁴θ_h), with 1/cos²θ_h = 1 + tan²θ_h of a
    /// vector of any length.
    #[inline(always)]
    fn density_along(&self, m: T::Vec3) -> T {
        let (zero, one) = (T::zero(), T::one());
        let squares = [m.x().squared(), m.y().squared()];
        let (sin_squared, cos_squared) = (squares[0] + squares[1], m.z().squared());
        // From a tangent of 10⁸ on the density of any allowed roughness is below exp(−10⁸): zero.
        let above = m.z().gt(zero).and(sin_squared.lt(cos_squared * T::lit(1e16)));
        let inverse = one / T::select(above, cos_squared, one);
        let octaves = self.roughness.octaves_of_squares(squares) * inverse;
        // The power is zero before the bound, which keeps the other factor finite in every number.
        let inverse_cos_squared = one + (sin_squared * inverse).min(T::lit(1e11));
        let inverse_area = self.roughness.inverse_area();
        octaves.decay(inverse_cos_squared.squared() * inverse_area).only_where(above)
    }

    #[inline(always)]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        Vector::normalize_or_normal(self.sample_along(u))
    }

    #[inline(always)]
    fn sample_along(&self, u: [T; 2]) -> T::Vec3 {
        let (x, y) = slopes(u);
        self.roughness.unstretch_along(x, y, T::one())
    }

    fn spreads(&self) -> Option<Spreads<T>> {
        Spread::normal(self.roughness.along()).of_all()
    }
}

impl<T: Real> Smith<T> for Beckmann<T> {
    /// Λ cosθ = α sinθ ierfc(ν)/2 with ν = cosθ/(α sinθ), since ierfc ν = exp(−ν²)/√π − ν erfc ν.
    #[inline(always)]
    fn lambda_cos(&self, w: T::Vec3) -> T {
        let cos = w.z().max(T::zero());
        // The least square of an f32 that is still precise. Where it takes over, Λ is zero.
        let alpha_sin = self.roughness.alpha_sin_squared(w).max(T::lit(1e-36)).sqrt();
        (T::lit(0.5) * alpha_sin * ierfc(cos / alpha_sin)).min(T::max_finite())
    }

    /// (1 + 2Λ) cosθ = cosθ erf ν + α sinθ exp(−ν²)/√π, the mean magnitude of w·(−s, 1) for slopes s.
    #[inline(always)]
    fn projected_area(&self, w: T::Vec3) -> T {
        let squares = [w.x().squared(), w.y().squared()];
        let grazing_squared = self.roughness.grazing_squared_of_squares(squares);
        // Bounds as above, and what π times is still finite.
        let grazing_squared = grazing_squared.clamp(T::lit(1e-36), T::max_finite() * T::lit(0.25));
        w.z().max(T::zero()).mean_magnitude(grazing_squared)
    }

    #[inline(always)]
    fn sample_visible(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        let wo = above_or_normal::<T, _>(wo);
        Vector::normalize_or_normal(self.sample_visible_along(wo, u))
    }

    #[inline(always)]
    fn sample_visible_along(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        let (x, y) = visible_slopes::<T>(self.roughness.stretch_along(wo), u);
        self.roughness.unstretch_along(-x, -y, T::one())
    }
}
