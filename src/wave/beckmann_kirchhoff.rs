use super::scattering::{Scattering, of_scattering};
use super::surface::{Hiding, Surface};
use crate::block::{ColorBlock, PairBlock};
use crate::bsdf::{Bsdf, BsdfSample, Lobes, Power, TransportMode};
use crate::error::ParameterError;
use crate::fresnel::Fresnel;
use crate::parameter::{Kind, Parameter, Part, Preset, model};
use crate::real::{Color, Lift, Real, lift};

/// Beckmann's solution of Kirchhoff's integral for a rough conductor, 1963: a specular lobe and, around
/// it, what the heights diffract.
///
/// # Formula
/// ```text
/// f = F π τ² |v̂|⁴/(4 λ² v̂_z² N·wi N·wo) · Σ_{m≥1} gᵐ e^(−g)/(m! m) exp(−v_xy² τ²/(4m))
/// g = (kσ)² (N·wi + N·wo)²   v̂ = wi + wo   v_xy = k |v̂_xy|   k = 2π/λ
/// ```
///
/// And one [specular lobe](Bsdf::specular) of weight F(N·wo) e^(−g).
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | σ | `sigma` | root-mean-square height, nm | 0 … 10⁹ |
/// | τ | `correlation` | correlation length, nm: heights at a distance r are correlated by exp(−r²/τ²) | 10⁻³ … 10⁹ |
/// | F | `fresnel` | reflectance, any [`Fresnel`] term, at the angle of the facets, V·H | |
/// | λ | `wavelength` | wavelength of each channel in vacuum, nm | 1 … 10⁹ |
///
/// Only the ratios of the lengths count. F = 1 is the perfect conductor of the book.
///
/// # Energy
/// Reciprocal. Not conserving: nothing shadows or masks. Of F = 1, σ = 200 nm, τ = 2 µm, λ = 550 nm it
/// reflects 1.00 at the normal, 1.17 at 80° and 17 at 89.9°.
///
/// # Limits
/// σ = 0 is a mirror. For g ≫ 1 the lobe vanishes and the value is that of a microfacet model with
/// [`Beckmann`](crate::Beckmann)'s distribution of roughness 2σ/τ and G = 1; what it is off by is of the
/// order of 1/g. The theory is scalar, scatters once, and wants radii of curvature far above λ, τ ≫ λ and
/// no grazing directions.
///
/// # Accuracy
/// The series is summed around its largest term by a number of terms that does not grow with g: to 5·10⁻¹⁴
/// relative in `f64`, 10⁻⁶ (1 + x) in `f32`, where the sum is e⁻ˣ times that in the mirror direction;
/// measured for g of 10⁻¹² to 10⁶.
///
/// # Sampling
/// The lobe and the diffuse part by their shares of the power, the former exactly, the latter guessed; then
/// the orders m of the series, each of which makes (wi + wo)_xy normally distributed, mixed over the
/// channels, and from g = 4 on mostly the visible normals of the geometric limit; and cosθ/π, up to half
/// of it for steep slopes. The standard error of the mean of 10⁴ weights is at most 0.8 % of the albedo up to
/// 75° and 2 % at 85°, for σ of 50 to 1500 nm and τ of 1 to 6 µm; nearer to the horizon few draws weigh much.
/// [`power`](Bsdf::power), by 4181 points of a lattice, was within 0.4 % up to 75° and 0.8 % at 85°.
///
/// # Sources
/// P. Beckmann, A. Spizzichino, *The Scattering of Electromagnetic Waves from Rough Surfaces*, 1963,
/// chapter 5.
///
/// ```
/// use brdf::{BeckmannKirchhoff, Bsdf, Constant, TransportMode};
/// use glam::DVec3;
///
/// let white = Constant::new(DVec3::ONE)?;
/// let lines = DVec3::new(650.0, 550.0, 450.0);
/// let metal = BeckmannKirchhoff::new(50.0, 2000.0, white, lines)?;
/// let lobe = metal.specular(DVec3::Z, TransportMode::Radiance).reflected.weight;
/// assert!((lobe.y - (-(0.4_f64 * std::f64::consts::PI / 1.1).powi(2)).exp()).abs() < 1e-15);
/// assert!(lobe.x > lobe.y && lobe.y > lobe.z);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("Spizzichino", "Kirchhoff", "diffraction"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeckmannKirchhoff<F, C = glam::Vec3, T = f32> {
    scattering: Scattering<F, C, T>,
}

impl<F, C, T> BeckmannKirchhoff<F, C, T> {
    /// The table of the parameters.
    pub const PARAMETERS: &'static [Parameter] = &[
        model!(@row sigma: T, HEIGHT, "σ", "root-mean-square height, nm"),
        model!(@row correlation: T, CORRELATION, "τ", "correlation length of the heights, nm"),
        Parameter::new("fresnel", "F", "reflectance of a facet", Kind::Part(Part::Fresnel))
            .or(Preset::White),
        model!(@row wavelength: C, WAVELENGTH, "λ", "wavelength of each channel in vacuum, nm")
            .or(Preset::Color([650.0, 550.0, 450.0])),
    ];
}

impl<T: Real, C: Color<T>, F: Fresnel<T, Color = C>> BeckmannKirchhoff<F, C, T> {
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
        let surface = Surface::new(sigma, correlation, wavelength, Hiding::Nothing)?;
        let uniform = C::splat(T::zero());
        Ok(Self { scattering: Scattering { surface, fresnel, uniform } })
    }
}

of_scattering!(BeckmannKirchhoff);
