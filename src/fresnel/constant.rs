use super::term::Fresnel;
use crate::parameter::model;
use crate::real::{Color, Real};

model! {
    /// The same reflectance at all angles: an ideal mirror, or no Fresnel effect at all.
    ///
    /// # Formula
    /// ```text
    /// F = F₀
    /// ```
    parameters {
        reflectance: C, UNIT, "F₀", "fraction of the light that is reflected";
    }
    ///
    /// # Energy
    /// Reciprocal, conserving. No real surface behaves so; it serves to test the other factors of a
    /// model.
    ///
    /// ```
    /// use brdf::{Constant, Fresnel};
    ///
    /// let mirror = Constant::new(0.9_f64)?;
    /// assert_eq!(mirror.reflectance(0.1), 0.9);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct Constant<C = glam::Vec3>;

    /// A surface of the given reflectance.
    pub fn new;
}

impl<T: Real, C: Color<T>> Fresnel<T> for Constant<C> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, _cos_theta: T) -> C {
        self.reflectance
    }

    #[inline(always)]
    fn average(&self) -> C {
        self.reflectance
    }
}
