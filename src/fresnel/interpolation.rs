use super::dielectric::Dielectric;
use super::term::{Fresnel, average_over_cosine, incident_cosine};
use crate::error::{ParameterError, range};
use crate::parameter::{Kind, Parameter, Preset, model};
use crate::real::{Color, Lift, Real, lift, positive_zero};

/// Hall's interpolation: the colour at normal incidence turns white towards grazing as the exact
/// curve of a reference material does.
///
/// # Formula
/// ```text
/// F(θ) = F₀ + (1 − F₀) max{0, F_ref(θ) − F_ref(0)}/(1 − F_ref(0))
/// ```
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | F₀ | `f0` | reflectance at normal incidence, per channel | 0 … 1 |
/// | F_ref | `ior` or `reference` | exact reflectance at one reference wavelength | see there |
///
/// # Energy
/// Reciprocal. Conserving: F₀ ≤ F ≤ 1. Exact for a channel whose F₀ is that of the reference,
/// except where the reference dips below its normal incidence, as metals (and dielectrics with
/// n > 3.7) do: the maximum, as printed, cuts the dip off. A reference that reflects everything at
/// normal incidence gives 0/0; the answer is F₀ then.
///
/// At normal incidence, where the maximum is of two zeros, derivatives are those of F_ref: the second
/// ones too, which are 0 in truth where the curve begins with a cut dip.
///
/// # Accuracy
/// The weight is a difference of reflectances, so it is off by up to
/// 2ε/(1 − F_ref(0)) of the number's ε, absolutely. The average is the default quadrature.
///
/// # Sources
/// R. Hall, *Illumination and Color in Computer Generated Imagery*, Springer 1989.
///
/// ```
/// use brdf::{Conductor, Fresnel, Hall};
/// use glam::Vec3;
///
/// let f0 = Vec3::new(0.95, 0.64, 0.54);
/// let copper = Hall::new(f0, 1.5)?;
/// assert_eq!(copper.reflectance(1.0), f0);
/// assert_eq!(copper.reflectance(0.0), Vec3::ONE);
///
/// // Driven by copper's own curve at 548.6 nm.
/// let copper = Hall::with_reference(f0, Conductor::new(1.02, 2.577)?)?;
/// assert_eq!(copper.reflectance(1.0), f0);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hall<C = glam::Vec3, F = Dielectric<f32>> {
    f0: C,
    reference: F,
}

/// The reference as descriptions have it.
const REFERENCE: Parameter = Parameter::new(
    "ior",
    "F_ref",
    "index of the transparent or absorbing medium whose exact reflectance is the reference",
    Kind::Index(range::ETA, range::K),
)
.or(Preset::Number(1.5));

impl<C, T: Real> Hall<C, Dielectric<T>> {
    /// A surface with the colour `f0` at normal incidence and the angular course of a transparent
    /// medium of index `ior`.
    ///
    /// # Errors
    /// If a channel of `f0` is not in 0 … 1, or `ior` not in 10⁻⁴ … 10⁴.
    pub fn new(f0: C, ior: T) -> Result<Self, ParameterError>
    where
        C: Color<T>,
    {
        Self::with_reference(f0, Dielectric::new(ior)?)
    }
}

impl<C, F> Hall<C, F> {
    /// The table of the parameters.
    pub const PARAMETERS: &'static [Parameter] =
        &[model!(@row f0: C, UNIT, "F₀", "reflectance at normal incidence"), REFERENCE];

    /// A surface with the colour `f0` at normal incidence and the angular course of `reference`,
    /// for example a [`Conductor`](super::Conductor) at one wavelength.
    ///
    /// # Errors
    /// If a channel of `f0` is not in 0 … 1.
    pub fn with_reference<T: Real>(f0: C, reference: F) -> Result<Self, ParameterError>
    where
        C: Color<T>,
        F: Fresnel<T, Color = T>,
    {
        range::UNIT.check("f0", f0)?;
        Ok(Self { f0, reference })
    }
}

lift! {
    [T: Real, C: Color<T>, F: Lift<T>] Hall<C, F> => Hall<C::Over<U>, F::Over<U>>:
    Hall { f0: color, reference: part }
}
lift! {
    [T: Real, C: Color<T>, F: Lift<T>] Cook<C, F> => Cook<C::Over<U>, F::Over<U>>:
    Cook { reflectance: part, light: color }
}

impl<T: Real, C: Color<T>, F: Fresnel<T, Color = T>> Fresnel<T> for Hall<C, F> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        let (zero, one) = (T::zero(), T::one());
        let normal = self.reference.reflectance(one);
        let rise = self.reference.reflectance(incident_cosine(cos_theta)) - normal;
        // At normal incidence the curve is still that of the reference.
        let rise = rise.only_where(rise.ge(zero));
        let room = one - normal;
        let weight = rise / T::select(room.gt(zero), room, one);
        self.f0.map(|f0| f0 + (one - f0) * weight)
    }

    fn average(&self) -> C {
        // At most 1, but for rounding.
        average_over_cosine(|cos| self.reflectance(cos)).map(|average| average.at_most(T::one()))
    }

    /// That of the reference, or that where the curve comes out of its dip.
    fn kinks(&self) -> Option<C> {
        let (zero, one, half) = (T::zero(), T::one(), T::lit(0.5));
        let normal = self.reference.reflectance(one);
        let (mut low, mut high) = (zero, one);
        for _ in 0..48 {
            let middle = (low + high) * half;
            let above = self.reference.reflectance(middle).gt(normal);
            low = T::select(above, middle, low);
            high = T::select(above, high, middle);
        }
        let dip = low.only_where(low.lt(T::lit(0.999)));
        let kink = self.reference.kinks().map_or(dip, |kink| T::select(kink.gt(zero), kink, dip));
        Some(C::splat(kink))
    }
}

/// Cook and Torrance's interpolation: the colour of the reflected light turns from the colour at
/// normal incidence into the colour of the light towards grazing.
///
/// # Formula
/// ```text
/// C(θ) = F₀ I + (I − F₀ I) max{0, F_ref(θ) − F_ref(0)}/(1 − F_ref(0))
/// ```
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | F₀ | `f0` | reflectance at normal incidence, per channel | 0 … 1 |
/// | I | `light` | colour of the light | 0 … 10¹⁰ |
/// | F_ref | `ior` or `reference` | exact reflectance at one reference wavelength | see there |
///
/// **The answer is not a reflectance but the colour of reflected light.** It contains the light:
/// do not multiply by the light again. It exceeds 1 where the light does. It equals the light
/// times [`Hall`]'s reflectance. Printed with F(π/2) = I beside an F₀ that is a reflectance, the
/// formula mixes the two: F₀ = 0.2, I = 0.5 and weight ½ give 0.35, times the light 0.175, where
/// 0.30 is right. Here both ends are colours of reflected light.
///
/// # Energy
/// Reciprocal. Conserving relative to the light: C ≤ I. The rest as for [`Hall`].
///
/// # Sources
/// R. L. Cook, K. E. Torrance, *A Reflectance Model for Computer Graphics*, ACM Transactions on
/// Graphics 1(1), 1982, doi:10.1145/357290.357293.
///
/// ```
/// use brdf::{Cook, Fresnel};
///
/// let plastic = Cook::new(0.2_f64, 0.5, 1.5)?;
/// assert_eq!(plastic.reflectance(1.0), 0.1);
/// assert_eq!(plastic.reflectance(0.0), 0.5);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cook<C = glam::Vec3, F = Dielectric<f32>> {
    reflectance: Hall<C, F>,
    light: C,
}

impl<C, T: Real> Cook<C, Dielectric<T>> {
    /// A surface with the colour `f0` at normal incidence and the angular course of a transparent
    /// medium of index `ior`, under light of colour `light`.
    ///
    /// # Errors
    /// If a channel of `f0` is not in 0 … 1, one of `light` not in 0 … 10¹⁰, or `ior` not in
    /// 10⁻⁴ … 10⁴.
    pub fn new(f0: C, light: C, ior: T) -> Result<Self, ParameterError>
    where
        C: Color<T>,
    {
        Self::with_reference(f0, light, Dielectric::new(ior)?)
    }
}

impl<C, F> Cook<C, F> {
    /// The table of the parameters.
    pub const PARAMETERS: &'static [Parameter] = &[
        model!(@row f0: C, UNIT, "F₀", "reflectance at normal incidence"),
        model!(@row light: C, LIGHT, "I", "colour of the light"),
        REFERENCE,
    ];

    /// A surface with the colour `f0` at normal incidence and the angular course of `reference`,
    /// for example a [`Conductor`](super::Conductor) at one wavelength, under light of colour
    /// `light`.
    ///
    /// # Errors
    /// If a channel of `f0` is not in 0 … 1 or a channel of `light` not in 0 … 10¹⁰.
    pub fn with_reference<T: Real>(f0: C, light: C, reference: F) -> Result<Self, ParameterError>
    where
        C: Color<T>,
        F: Fresnel<T, Color = T>,
    {
        let reflectance = Hall::with_reference(f0, reference)?;
        range::LIGHT.check("light", light)?;
        Ok(Self { reflectance, light: positive_zero(light) })
    }
}

impl<T: Real, C: Color<T>, F: Fresnel<T, Color = T>> Fresnel<T> for Cook<C, F> {
    type Color = C;

    /// The colour of the reflected light.
    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        self.reflectance.reflectance(cos_theta) * self.light
    }

    /// The colour of the reflected light, averaged.
    #[inline(always)]
    fn average(&self) -> C {
        self.reflectance.average() * self.light
    }

    fn kinks(&self) -> Option<C> {
        self.reflectance.kinks()
    }
}
