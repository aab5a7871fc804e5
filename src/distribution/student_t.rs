use super::roughness::Roughness;
use super::spread::{Spread, Spreads};
use super::traits::Distribution;
use crate::error::{ParameterError, range};
use crate::parameter::{Parameter, model};
use crate::quadrature::integrate;
use crate::real::{Real, Vector, lift};
use crate::sampling::{ln_of_rest, uniform};

/// Slopes of Student's t-distribution: between the long tail of GGX and none, Beckmann's, by a parameter.
///
/// # Formula
/// ```text
/// D = (1 + e/(γ − 1))^(−γ)/(π α_x α_y h_z⁴)        e = (h_x²/α_x² + h_y²/α_y²)/h_z²
/// Λ = N ((1 + ν²)^(3/2 − γ)/((2γ − 3) ν) − ∫_ν^∞ (1 + t²)^(1/2 − γ) dt)
/// ν = w_z/√((γ − 1)(α_x² w_x² + α_y² w_y²))          N = Γ(γ − 1/2)/(Γ(γ − 1) √π)
/// ```
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | α_x, α_y | `roughness` | roughness along tangent and bitangent | 10⁻⁸ … 10⁴ |
/// | γ | `gamma` | how short the tail is: 2 is [`Ggx`](crate::Ggx), ∞ [`Beckmann`](crate::Beckmann) | 1.500001 … 10⁶ |
///
/// # Energy
/// Normalised, ∫ D cosθ_h dω = 1. For γ < 2 D itself grows without bound where h grazes.
///
/// Below γ = 3/2 slopes have no mean, and Smith's Λ is infinite. [`lambda`](Self::lambda) answers it, by a
/// quadrature with a relative error of 10⁻¹² of the first of its terms; but normals visible from a direction cannot be drawn in
/// closed form, so that as a part of a model this distribution has the shadowing of V-cavities.
///
/// # Sources
/// M. Ribardière, B. Bringier, D. Meneveaux, L. Simonot, *STD: Student's t-Distribution of Slopes for
/// Microfacet Based BSDFs*, Computer Graphics Forum 36(2), 2017,
/// [doi:10.1111/cgf.13137](https://doi.org/10.1111/cgf.13137). The integral is theirs in terms of Gauss'
/// hypergeometric function.
///
/// ```
/// use brdf::{Distribution, Ggx, StudentT};
/// use glam::DVec3;
///
/// let h = DVec3::new(0.6, 0.0, 0.8);
/// let (student, ggx) = (StudentT::new(0.3_f64, 2.0)?, Ggx::new(0.3)?);
/// assert!((student.density(h) / ggx.density(h) - 1.0).abs() < 1e-14);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("STD"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StudentT<T = f32> {
    roughness: Roughness<T>,
    gamma: T,
}

lift! {
    [T: Real] StudentT<T> => StudentT<U>: StudentT { roughness: part, gamma: number }
}

impl<T> StudentT<T> {
    /// The table of the parameters.
    pub const PARAMETERS: &'static [Parameter] = &[
        model!(@row roughness: Roughness, ROUGHNESS, "α_x, α_y", "roughness along tangent and bitangent"),
        model!(@row gamma: T, SHORTNESS, "γ", "how short the tail is: 2 is GGX"),
    ];
}

impl<T: Real> StudentT<T> {
    /// The distribution of a surface that is equally rough in all directions.
    ///
    /// # Errors
    /// If `roughness` is not in 10⁻⁸ … 10⁴, or `gamma` not in 1.500001 … 10⁶.
    pub fn new(roughness: T, gamma: T) -> Result<Self, ParameterError> {
        range::SHORTNESS.check("gamma", gamma)?;
        Ok(Self { roughness: Roughness::isotropic(roughness)?, gamma })
    }

    /// The distribution of a surface with grain: roughness along the tangent and the bitangent.
    ///
    /// # Errors
    /// If `along_x` or `along_y` is not in 10⁻⁸ … 10⁴, or `gamma` not in 1.500001 … 10⁶.
    pub fn anisotropic(along_x: T, along_y: T, gamma: T) -> Result<Self, ParameterError> {
        range::SHORTNESS.check("gamma", gamma)?;
        Ok(Self { roughness: Roughness::anisotropic(along_x, along_y)?, gamma })
    }

    /// Roughness along the tangent and the bitangent.
    #[must_use]
    pub fn roughness(&self) -> [T; 2] {
        self.roughness.along()
    }

    /// γ.
    #[must_use]
    pub const fn gamma(&self) -> T {
        self.gamma
    }

    /// γ − 1.
    #[inline(always)]
    fn degrees(&self) -> T {
        self.gamma - T::one()
    }

    /// Smith's Λ of a direction above the surface: the ratio of hidden to visible projected facet area.
    #[must_use]
    pub fn lambda(&self, w: T::Vec3) -> T {
        let (one, two, three) = (T::one(), T::lit(2.0), T::lit(3.0));
        let across = (self.degrees() * self.roughness.alpha_sin_squared(w)).max(T::lit(1e-36));
        let nu = w.z().max(T::lit(1e-18)) / across.sqrt();
        let square = one + nu.squared();
        let power = (square.ln() * (T::lit(1.5) - self.gamma)).exp();
        let first = power / ((two * self.gamma - three) * nu);
        let whole = two * self.tail(T::zero());
        ((first - self.tail(nu)) / whole).clamp(T::zero(), T::max_finite())
    }

    /// ∫_ν^∞ (1 + t²)^(1/2 − γ) dt, of t = sinh x, up to where 10⁻¹⁶ of the integrand are left.
    fn tail(&self, nu: T) -> T {
        let one = T::one();
        let power = T::lit(2.0) * self.degrees();
        let root = (one + nu.squared()).sqrt();
        let first = (nu + root).ln();
        let cosh = root * (T::lit(37.0) / power).min(T::lit(40.0)).exp();
        let last = (cosh + ((cosh - one) * (cosh + one)).max(T::lit(1e-30)).sqrt()).ln();
        integrate(first, last, |x: T| {
            let cosh = (x.exp() + (-x).exp()) * T::lit(0.5);
            (-(cosh.ln() * power)).exp()
        })
    }
}

impl<T: Real> Distribution<T> for StudentT<T> {
    #[inline(always)]
    fn density(&self, h: T::Vec3) -> T {
        self.density_along(h)
    }

    /// With g = γ − 1, D = (g/q)² (g cos²θ_h/q)^(g − 1)/(π α_x α_y), where q = g cos²θ_h + h_x²/α_x² + h_y²/α_y²: GGX
    /// times a power of a part of a whole.
    #[inline(always)]
    fn density_along(&self, m: T::Vec3) -> T {
        let (one, bound) = (T::one(), T::max_finite());
        let g = self.degrees();
        let (along, across) = (m.z().squared(), m.x().squared() + m.y().squared());
        let length_squared = (along + across).min(bound);
        let sines = self.roughness.sin_over_alpha_squared(m).min(T::lit(1e36));
        let sum = g * along + sines;
        let quotient = g * length_squared / sum.max(length_squared * T::lit(1e-9));
        let steep = g.lt(one);
        let exponent = T::select(steep, one - g, g - one);
        let part = (g * along).max(T::lit(4.0) / bound).max(sines * T::lit(1e-36));
        let power = part.power_of_part(sines, exponent);
        let power = T::select(steep, one / power.max(T::lit(1e-30)), power);
        let density = self.roughness.inverse_area() * quotient.squared() * power;
        density.min(bound).only_where(m.z().gt(T::zero()))
    }

    /// tan²θ_h = g ((1 − u₀)^(−1/g) − 1) in the space of roughness 1.
    #[inline(always)]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        Vector::normalize_or_normal(self.sample_along(u))
    }

    #[inline(always)]
    fn sample_along(&self, u: [T; 2]) -> T::Vec3 {
        let ([u, turn], g) = (uniform(u), self.degrees());
        let logarithm = ln_of_rest(u) / g;
        let sin = (g * -logarithm.exp_m1()).max(T::zero()).sqrt();
        let cos = (logarithm * T::lit(0.5)).exp();
        let (sin_phi, cos_phi) = turn.sin_cos_turns();
        self.roughness.unstretch_along(sin * cos_phi, sin * sin_phi, cos)
    }

    fn spreads(&self) -> Option<Spreads<T>> {
        Spread::student(self.roughness.along(), self.degrees()).of_all()
    }
}
