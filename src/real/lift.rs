//! The same model in another number.

use super::traits::Real;

/// What has parameters of one number and can have them in another.
///
/// All models, distributions, Fresnel terms and shadowings of known type have it. A formula that
/// runs on lanes, derivatives or symbols needs its parameters in that number:
///
/// ```
/// use brdf::{Beckmann, Brdf, CookTorrance, Lanes, Lift, Schlick, Vector3};
/// use glam::Vec3;
///
/// let plastic = CookTorrance::new(Beckmann::new(0.3)?, Schlick::new(Vec3::splat(0.04))?);
/// let lanes = plastic.lift(|parameter| Lanes([parameter; 2]));
/// let wi = Vector3 { x: Lanes([0.6, -0.6]), y: Lanes([0.0; 2]), z: Lanes([0.8; 2]) };
/// let values = lanes.eval(wi, wi);
/// assert_eq!(values.x.0[1], plastic.eval(Vec3::new(-0.6, 0.0, 0.8), Vec3::new(-0.6, 0.0, 0.8)).x);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
///
/// Parameters are lifted one by one, and what a constructor has computed from them is one of them.
/// For derivatives by a parameter call the constructor in that number instead.
pub trait Lift<T: Real> {
    /// The same type with parameters of another number.
    type Over<U: Real>;

    /// Lifts every parameter.
    #[must_use]
    fn lift<U: Real>(&self, lift: impl Fn(T) -> U + Copy) -> Self::Over<U>;
}

/// Implements [`Lift`] field by field: a `color`, a `number`, an array of `numbers`, a `part` that
/// lifts itself, or an array of `parts`.
macro_rules! lift {
    ([$($generics:tt)*] $from:ty => $over:ty: $name:ident { $($field:ident: $kind:ident),* $(,)? }) => {
        impl<$($generics)*> $crate::real::Lift<T> for $from {
            type Over<U: $crate::real::Real> = $over;

            #[inline]
            fn lift<U: $crate::real::Real>(
                &self,
                lift: impl Fn(T) -> U + Copy,
            ) -> Self::Over<U> {
                $name { $($field: $crate::real::lift!(@$kind self.$field, lift)),* }
            }
        }
    };
    ($name:ident) => {
        impl<T: $crate::real::Real> $crate::real::Lift<T> for $name {
            type Over<U: $crate::real::Real> = Self;

            #[inline]
            fn lift<U: $crate::real::Real>(&self, _: impl Fn(T) -> U + Copy) -> Self {
                *self
            }
        }
    };
    (@color $value:expr, $lift:ident) => { $crate::real::Color::<T>::lift($value, $lift) };
    (@number $value:expr, $lift:ident) => { $lift($value) };
    (@numbers $value:expr, $lift:ident) => { $value.map($lift) };
    (@C $value:expr, $lift:ident) => { $crate::real::lift!(@color $value, $lift) };
    (@T $value:expr, $lift:ident) => { $crate::real::lift!(@number $value, $lift) };
    (@part $value:expr, $lift:ident) => { $crate::real::Lift::<T>::lift(&$value, $lift) };
    (@parts $value:expr, $lift:ident) => {
        $value.each_ref().map(|part| $crate::real::Lift::<T>::lift(part, $lift))
    };
    (@$type:ident $value:expr, $lift:ident) => { $crate::real::lift!(@part $value, $lift) };
}
pub(crate) use lift;
