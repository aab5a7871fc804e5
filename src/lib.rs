#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]
#![warn(unreachable_pub, clippy::unwrap_used, clippy::expect_used, clippy::panic)]
#![cfg_attr(not(feature = "std"), no_std)]

extern crate alloc;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("brdf needs the feature `std` or the feature `libm`");

mod brdf;
pub mod diffuse;
mod direction;
mod error;
mod frame;
pub mod fresnel;
pub mod microfacet;
pub mod quadrature;
mod real;
mod sampling;

pub use brdf::{Brdf, Sample};
pub use diffuse::Lambert;
pub use direction::{
    Pair, Refraction, above_surface, brewster_angle, critical_angle, from_spherical, reflect,
    refract, to_spherical,
};
pub use error::ParameterError;
pub use frame::Frame;
pub use fresnel::Fresnel;
pub use microfacet::{
    Beckmann, CookTorrance, Distribution, Ggx, Shadowing, Smith, SmithCorrelated, SmithSeparable,
    VCavity,
};
pub use real::{Color, Lanes, Mask, Real, Vector, Vector3};
