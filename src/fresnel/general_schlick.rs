use super::term::{Fresnel, incident_cosine};
use crate::parameter::model;
use crate::real::{Color, Real};

model! {
    /// Schlick's polynomial with a colour at the edge and an exponent of choice, for artists and for
    /// fits.
    ///
    /// # Formula
    /// ```text
    /// F = F₀ + (F₉₀ − F₀)(1 − u)ᵉ    average F₀ + 2 (F₉₀ − F₀)/((e + 1)(e + 2))
    /// ```
    parameters {
        f0: C, UNIT, "F₀", "reflectance at normal incidence";
        f90: C, UNIT = 1.0, "F₉₀", "reflectance at grazing incidence";
        exponent: T, EDGE_EXPONENT = 5.0, "e", "how late the reflectance turns from one to the other";
    }
    /// | u | `cos_theta` | cosine of the angle of incidence (V·H on microfacets) | −1 … 1, the sign is ignored |
    ///
    /// Normal incidence is the end of the curve. The slope by u there is the one on the side of the
    /// angles: 0 for e > 1 and F₀ − F₉₀ for e = 1. For e < 1 it is infinite, and [counts as
    /// 0](crate::Dual#which-derivative).
    ///
    /// # Energy
    /// Reciprocal. Conserving: F lies between F₀ and F₉₀. No real surface has F₉₀ < 1.
    ///
    /// # Accuracy
    /// With the default values it is [`Schlick`](super::Schlick) but for rounding, which is faster:
    /// a power of a real exponent is an exponential and a logarithm.
    ///
    /// # Sources
    /// C. Schlick, *An Inexpensive BRDF Model for Physically-based Rendering*, Computer Graphics Forum
    /// 13(3), 1994, doi:10.1111/1467-8659.1330233, with F₉₀ = 1 and e = 5.
    ///
    /// ```
    /// use brdf::{Fresnel, GeneralSchlick};
    ///
    /// let velvet = GeneralSchlick::new(0.04_f64, 0.5, 3.0)?;
    /// assert!((velvet.reflectance(0.5) - 0.0975).abs() < 1e-15);
    /// assert_eq!((velvet.reflectance(1.0), velvet.reflectance(0.0)), (0.04, 0.5));
    /// assert!((velvet.average() - 0.086).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct GeneralSchlick<C = glam::Vec3, T = f32>;

    /// A surface of the given reflectances at normal and at grazing incidence, and the exponent of the
    /// way from one to the other.
    pub fn new;
}

impl<T: Real, C: Color<T>> GeneralSchlick<C, T> {
    /// F₀ + (F₉₀ − F₀) w, which is the colour itself at both ends.
    #[inline(always)]
    fn between(&self, weight: T) -> C {
        self.f0 * (T::one() - weight) + self.f90 * weight
    }
}

impl<T: Real, C: Color<T>> Fresnel<T> for GeneralSchlick<C, T> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        let versine = T::one() - incident_cosine(cos_theta);
        self.between(versine.powf(self.exponent))
    }

    #[inline(always)]
    fn average(&self) -> C {
        let (one, two) = (T::one(), T::lit(2.0));
        let weight = two / ((self.exponent + one) * (self.exponent + two));
        self.between(weight)
    }
}
