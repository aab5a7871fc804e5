use super::masking::Masking;
use super::scattering::{Scattering, of_scattering};
use super::surface::{Hiding, Surface};
use crate::block::{ColorBlock, PairBlock};
use crate::bsdf::{Bsdf, BsdfSample, Lobes, Power, TransportMode};
use crate::direction::{above_or_normal, above_surface, both_above};
use crate::error::{ParameterError, range};
use crate::fresnel::Fresnel;
use crate::parameter::{Kind, Parameter, Part, Preset, model};
use crate::real::{Color, Lift, Real, lift};

/// The model of He, Torrance, Sillion and Greenberg, 1991: rough metals and ground surfaces in wave optics,
/// with a specular lobe, what the heights diffract around it, and a uniform part.
///
/// # Formula
/// ```text
/// f = |F|²/π · G S D/(N·wi N·wo) + a
/// D = π² τ²/(4λ²) Σ_{m≥1} gᵐ e^(−g)/(m! m) exp(−v_xy² τ²/(4m))     v_xy = k |v̂_xy|   k = 2π/λ
/// g = (kσ)² (N·wi + N·wo)²   G = (|v̂|²/v̂_z)²   v̂ = wi + wo   S = S₁(wi) S₁(wo)
/// S₁ = (1 − ½ erfc ν)/(1 + Λ)   Λ = ½ (e^(−ν²)/(√π ν) − erfc ν)   ν = τ cotθ/(2σ₀)
/// σ = σ₀/√(1 + W)   W e^W = (Kᵢ + Kₒ)²/(8π)   K = tanθ erfc ν
/// ```
///
/// And one [specular lobe](Bsdf::specular) of weight |F|² e^(−g) S at wi = (−x, −y, z).
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | σ₀ | `sigma` | root-mean-square height, nm | 0 … 10⁹ |
/// | τ | `correlation` | correlation length, nm: heights at a distance r are correlated by exp(−r²/τ²) | 10⁻³ … 10⁹ |
/// | \|F\|² | `fresnel` | reflectance, any [`Fresnel`] term, at the angle of the facets, V·H | |
/// | a | `uniform_diffuse` | what scatters alike in all directions, below the surface or more than once, sr⁻¹ | 0 … 10¹⁰, 0 by default |
/// | | `masking` | which form of Λ: [`Masking`] | corrected by default |
/// | λ | `wavelength` | wavelength of each channel in vacuum, nm | 1 … 10⁹ |
///
/// Only the ratios of the lengths count. σ is the roughness of what is seen: at grazing angles the depths
/// are hidden, and a rough surface becomes a mirror.
///
/// # Errata
/// Equation 25 of the paper lacks e^(−ν²) in Λ, [`Masking::Printed`]: the value is then 10 to 15 % too small. And
/// v_xy in equation 78 has the wave number, unlike the unit vectors of equation 76; read otherwise the exponent
/// has a dimension.
///
/// # Energy
/// Reciprocal. Conserving but for slightly rough surfaces near 80°. Of F = 1, (σ₀, τ, λ) in µm, it reflects at
/// 0°, 60°, 75°, 80°, 85° and 89°: (0.05, 1, 0.55) 1.0002, 0.985, 1.026, 1.037, 0.799, 0.096;
/// (0.1, 2, 0.55) 1.0000, 0.992, 0.999, 1.044, 0.840, 0.105; (0.28, 1.77, 0.5) 0.996, 0.882, 0.782, 0.766,
/// 0.446, 0.098. The uniform part comes on top: π a should be what is left.
///
/// # Limits
/// σ₀ = 0 is a mirror, and so is τ → ∞. For g ≫ 1 the lobe vanishes and the value is that of a microfacet
/// model with [`Beckmann`](crate::Beckmann)'s distribution of roughness 2σ/τ, and S in the place of G; what it
/// is off by is of the order of 1/g. Towards grazing S₁ ~ cosθ: the value stays finite and the lobe vanishes,
/// also of a nearly smooth surface. Radii of curvature are far above λ.
///
/// # What is not established
/// How the paper itself writes its polarised form (c_s, c_p) and the Δ of the specular cone could not be
/// compared with print. The equations above agree with Beckmann's, with public implementations, and with the
/// published erratum of Λ.
///
/// # Accuracy
/// As of [`BeckmannKirchhoff`](crate::BeckmannKirchhoff).
///
/// # Sampling
/// As of [`BeckmannKirchhoff`](crate::BeckmannKirchhoff); the uniform part by cosθ/π.
///
/// # Sources
/// X. D. He, K. E. Torrance, F. X. Sillion, D. P. Greenberg, "A comprehensive physical model for light
/// reflection", SIGGRAPH 1991, [doi:10.1145/122718.122738](https://doi.org/10.1145/122718.122738). The erratum:
/// N. Holzschuch, R. Pacanowski, "Demystifying the He, Torrance, Sillion and Greenberg BRDF", note on the web.
///
/// ```
/// use brdf::{Bsdf, Conductor, He1991, TransportMode};
/// use glam::DVec3;
///
/// // Ground aluminium, at 500 nm.
/// let metal = Conductor::new(0.789405353_f64, 5.851936501)?;
/// let ground = He1991::new(280.0, 1770.0, metal, 500.0)?;
/// let lobe = ground.specular(brdf::from_spherical(1.35, 0.0), TransportMode::Radiance);
/// assert!((lobe.reflected.weight - 0.0785501452142612).abs() < 1e-13);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("HTSG", "He-Torrance"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct He1991<F, C = glam::Vec3, T = f32> {
    pub(super) scattering: Scattering<F, C, T>,
}

impl<F, C, T> He1991<F, C, T> {
    /// The table of the parameters.
    pub const PARAMETERS: &'static [Parameter] = &[
        model!(@row sigma: T, HEIGHT, "σ₀", "root-mean-square height, nm"),
        model!(@row correlation: T, CORRELATION, "τ", "correlation length of the heights, nm"),
        Parameter::new("fresnel", "|F|²", "reflectance of a facet", Kind::Part(Part::Fresnel)),
        model!(@row uniform_diffuse: C, UNIFORM, "a", "value of the uniform part, sr⁻¹")
            .or(Preset::Number(0.0)),
        Parameter::new("masking", "Λ", "which form", Kind::Word(&["corrected", "printed"]))
            .or(Preset::Word("corrected")),
        model!(@row wavelength: C, WAVELENGTH, "λ", "wavelength of each channel in vacuum, nm")
            .or(Preset::Color([650.0, 550.0, 450.0])),
    ];
}

impl<T: Real, C: Color<T>, F: Fresnel<T, Color = C>> He1991<F, C, T> {
    /// A surface of this root-mean-square height, correlation length and reflectance, seen at a wavelength
    /// for each channel; all lengths in nanometres.
    ///
    /// # Errors
    /// If `sigma` is not in 0 … 10⁹, `correlation` in 10⁻³ … 10⁹ or `wavelength` in 1 … 10⁹.
    pub fn new(
        sigma: T,
        correlation: T,
        fresnel: F,
        wavelength: C,
    ) -> Result<Self, ParameterError> {
        let hiding = Hiding::He(Masking::Corrected);
        let surface = Surface::new(sigma, correlation, wavelength, hiding)?;
        let uniform = C::splat(T::zero());
        Ok(Self { scattering: Scattering { surface, fresnel, uniform } })
    }

    /// The same surface with a uniform part, in sr⁻¹.
    ///
    /// # Errors
    /// If `uniform_diffuse` is not in 0 … 10¹⁰.
    pub fn with_uniform_diffuse(self, uniform_diffuse: C) -> Result<Self, ParameterError> {
        range::UNIFORM.check("uniform_diffuse", uniform_diffuse)?;
        Ok(Self { scattering: Scattering { uniform: uniform_diffuse, ..self.scattering } })
    }

    /// σ, the root-mean-square height of what is seen of a pair of directions, nm; σ₀ where either lies
    /// below the surface.
    #[must_use]
    pub fn effective_roughness(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let surface = &self.scattering.surface;
        let [light, viewer] = [wi, wo].map(|w| surface.masked(above_or_normal(w)).hidden);
        T::select(both_above::<T>(wi, wo), surface.seen(light + viewer), surface.sigma)
    }

    /// S₁ of a direction, the fraction of the surface that it sees: 0 below the surface.
    #[must_use]
    pub fn shadowing(&self, w: T::Vec3) -> T {
        let seen = self.scattering.surface.seen_by(above_or_normal(w));
        seen.only_where(above_surface::<T, _>(w))
    }

    /// The same surface with this form of Λ.
    #[must_use]
    pub fn with_masking(self, masking: Masking) -> Self {
        let surface = Surface { masking: Hiding::He(masking), ..self.scattering.surface };
        Self { scattering: Scattering { surface, ..self.scattering } }
    }
}

of_scattering!(He1991);
