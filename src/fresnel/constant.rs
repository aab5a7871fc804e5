use super::term::Fresnel;
use crate::error::{ParameterError, range};
use crate::real::{Color, Real, lift, unsigned};

/// The same reflectance at all angles: an ideal mirror, or no Fresnel effect at all.
///
/// ```text
/// F = F₀
/// ```
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | F₀ | `reflectance` | fraction of the light that is reflected | 0 … 1 |
///
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant<C = glam::Vec3> {
    reflectance: C,
}

impl<C> Constant<C> {
    /// A surface of the given reflectance.
    ///
    /// # Errors
    /// If a channel of `reflectance` is not in 0 … 1.
    pub fn new<T: Real>(reflectance: C) -> Result<Self, ParameterError>
    where
        C: Color<T>,
    {
        range::UNIT.check("reflectance", reflectance)?;
        Ok(Self { reflectance: unsigned(reflectance) })
    }
}

lift! {
    [T: Real, C: Color<T>] Constant<C> => Constant<C::Over<U>>:
    Constant { reflectance: color }
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
