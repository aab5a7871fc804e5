//! Objects whose type is known only at run time.

use alloc::boxed::Box;

use crate::brdf::Brdf;
use crate::distribution::Distribution;
use crate::fresnel::Fresnel;
use crate::real::Real;

/// A model whose type is known only at run time.
pub type AnyBrdf<T> = Box<dyn Brdf<T, Color = <T as Real>::Vec3>>;

/// A Fresnel term whose type is known only at run time.
pub type AnyFresnel<T> = Box<dyn Fresnel<T, Color = <T as Real>::Vec3>>;

/// A distribution whose type is known only at run time.
pub type AnyDistribution<T> = Box<dyn Distribution<T>>;
