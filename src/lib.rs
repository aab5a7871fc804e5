#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]
#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("brdf needs the feature `std` or the feature `libm`");

mod error;
mod real;

pub use error::ParameterError;
pub use real::{Color, Lanes, Mask, Real, Vector, Vector3};
