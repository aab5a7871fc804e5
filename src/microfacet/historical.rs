//! Models as they were first printed, with the conventions of their time.

use core::f64::consts::PI;

use super::cook_torrance::CookTorrance;
use super::scaled::Scaled;
use crate::brdf::Brdf;
use crate::distribution::{Beckmann, Blinn, Blinn1977, Distribution, Gaussian, Ggx};
use crate::error::{ParameterError, range};
use crate::fresnel::Fresnel;
use crate::real::{Real, Vector};

impl<F, T: Real> CookTorrance<Gaussian<T>, F> {
    /// The model of Torrance and Sparrow: D = b exp(−c²θ_h²) with the tilt θ_h in degrees, and V-cavity
    /// shadowing.
    ///
    /// `c` in 1/degree is π/180 over the roughness of [`Gaussian`] in radians; b is the constant
    /// that normalises D, as everywhere in this crate. The paper gives the reflected radiance,
    /// F G D/(4 cosθ_r) times the irradiance on a plane across the light, which is this BRDF times
    /// N·L; its diffuse term a N·L is a [`Lambert`](crate::Lambert) of its own.
    ///
    /// K. E. Torrance, E. M. Sparrow, "Theory for off-specular reflection from roughened surfaces",
    /// JOSA 57, 1967, [doi:10.1364/JOSA.57.001105](https://doi.org/10.1364/JOSA.57.001105).
    ///
    /// # Errors
    /// If `c` is not in 10⁻⁵ … 10⁵.
    ///
    /// ```
    /// use brdf::{CookTorrance, Dielectric};
    ///
    /// let frosted = CookTorrance::torrance_sparrow_1967(0.05, Dielectric::new(1.5_f64)?)?;
    /// let roughness: f64 = frosted.distribution().roughness();
    /// assert!((roughness - 0.349066).abs() < 1e-6); // 20°
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub fn torrance_sparrow_1967(c: T, fresnel: F) -> Result<Self, ParameterError> {
        range::SHARPNESS_1967.check("c", c)?;
        Ok(Self::new(Gaussian::new(T::lit(PI / 180.0) / c)?, fresnel))
    }
}

/// The model with the constants that Cook and Torrance printed: four times too bright.
///
/// # Formula
/// ```text
/// f = F/π · D G/((N·L)(N·V)),  D = exp(−tan²θ_h/α²)/(α² cos⁴θ_h)
/// ```
///
/// D is π times the normalised [`Beckmann`], F/π takes the π away again, and the 4 of
/// [`CookTorrance`] is missing; α is the roughness of [`Beckmann`]. To compare with pictures and
/// codes made with these constants.
///
/// # Energy
/// Reciprocal. Not conserving: with F = 1 the albedo is 4 at normal incidence (measured 4.000 at
/// roughness 0.1) and nowhere above 4.
///
/// # Sampling
/// As [`CookTorrance`]; a sample has four times the weight.
///
/// # Sources
/// R. L. Cook, K. E. Torrance, "A reflectance model for computer graphics", ACM TOG 1(1), 1982,
/// [doi:10.1145/357290.357293](https://doi.org/10.1145/357290.357293).
///
/// ```
/// use brdf::{Beckmann, Brdf, CookTorrance1982Printed, Dielectric};
/// use glam::DVec3;
///
/// let plastic = CookTorrance1982Printed::new(Beckmann::new(0.3)?, Dielectric::new(1.5)?);
/// let f: f64 = plastic.eval(DVec3::Z, DVec3::Z);
/// assert!((f - 0.04 / (std::f64::consts::PI * 0.09)).abs() < 1e-12);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
pub type CookTorrance1982Printed<F, T = f32> = Scaled<CookTorrance<Beckmann<T>, F>, T>;

impl<F, T: Real> CookTorrance1982Printed<F, T> {
    /// A surface with these normals and this reflectance.
    #[must_use]
    pub fn new(distribution: Beckmann<T>, fresnel: F) -> Self {
        Self::of(CookTorrance::new(distribution, fresnel), T::lit(4.0))
    }
}

/// Blinn's model of 1977, with distributions that are 1 at the normal.
///
/// # Formula
/// ```text
/// s = D G F/(N·E)     the printed intensity: `specular`
/// f = s/(N·L)         as a BRDF: `eval`
/// ```
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | D | `distribution` | D₁, D₂ or D₃ of [`Blinn1977`], not normalised | |
/// | F | `fresnel` | reflectance of a facet | |
///
/// G is [`VCavity`](crate::VCavity), E points to the eye. The constant of s is free: D₁, D₂, D₃ are
/// [`Blinn`], [`Gaussian`] and [`Ggx`] divided by their value at the normal, so that f is
/// [`CookTorrance`] with the same distribution times 4/D(N).
///
/// # Energy
/// Reciprocal as f, not as s. Not conserving: the constant makes narrow lobes too dark, the albedo
/// of D₂ at normal incidence is 0.180 for a half-width of 0.1, and wide ones too bright, 4.08 for 1.
///
/// # Sampling
/// With the density of [`CookTorrance`].
///
/// # Sources
/// J. F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977,
/// [doi:10.1145/563858.563893](https://doi.org/10.1145/563858.563893).
///
/// ```
/// use brdf::{Blinn1977, Blinn1977Printed, Dielectric};
/// use glam::DVec3;
///
/// let plastic = Blinn1977Printed::d3(Blinn1977::new(0.2)?, Dielectric::new(1.5)?)?;
/// let s: f64 = plastic.specular(DVec3::Z, DVec3::Z);
/// assert!((s - 0.04).abs() < 1e-12);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
pub type Blinn1977Printed<D, F, T = f32> = Scaled<CookTorrance<D, F>, T>;

impl<F, T: Real> Blinn1977Printed<Blinn<T>, F, T> {
    /// With D₁, Phong's lobe around the half vector.
    ///
    /// # Errors
    /// If c₁ is above the range of [`Blinn`]'s exponent.
    pub fn d1(distribution: Blinn1977<T>, fresnel: F) -> Result<Self, ParameterError> {
        Ok(Self::with_maximum_1(Blinn::new(distribution.c1())?, fresnel))
    }
}

impl<F, T: Real> Blinn1977Printed<Gaussian<T>, F, T> {
    /// With D₂, the lobe of Torrance and Sparrow.
    ///
    /// # Errors
    /// If 1/c₂ is outside the range of [`Gaussian`]'s roughness.
    pub fn d2(distribution: Blinn1977<T>, fresnel: F) -> Result<Self, ParameterError> {
        Ok(Self::with_maximum_1(Gaussian::new(T::one() / distribution.c2())?, fresnel))
    }
}

impl<F, T: Real> Blinn1977Printed<Ggx<T>, F, T> {
    /// With D₃, the lobe of Trowbridge and Reitz.
    ///
    /// # Errors
    /// If c₃ is outside the range of [`Ggx`]'s roughness.
    pub fn d3(distribution: Blinn1977<T>, fresnel: F) -> Result<Self, ParameterError> {
        Ok(Self::with_maximum_1(Ggx::new(distribution.c3())?, fresnel))
    }
}

impl<T, D, F> Blinn1977Printed<D, F, T>
where
    T: Real,
    D: Distribution<T>,
{
    /// The model with D divided by its value at the normal.
    fn with_maximum_1(distribution: D, fresnel: F) -> Self {
        let normal = Vector::new(T::zero(), T::zero(), T::one());
        let scale = T::lit(4.0) / distribution.density(normal);
        Self::of(CookTorrance::new(distribution, fresnel), scale)
    }

    /// The printed s = D G F/(N·E): reflected intensity for light of intensity 1 from `wi`. It is
    /// the BRDF times N·L.
    #[inline(always)]
    #[must_use]
    pub fn specular(&self, wi: T::Vec3, wo: T::Vec3) -> F::Color
    where
        F: Fresnel<T>,
    {
        // The BRDF is zero where the clamp takes part.
        self.eval(wi, wo) * wi.z().max(T::zero()).at_most(T::one())
    }
}
