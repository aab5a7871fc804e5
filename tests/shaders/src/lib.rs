//! What the tests of shader text have: a validator, and a device that runs it.

pub mod device;
pub mod recorded;
pub mod validate;

/// The page about shaders, whose code runs where there is naga.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/shaders.md")]
mod page {}
