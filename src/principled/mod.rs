//! Materials of many sliders: a diffuse, a glossy and a coating part by the parameters of artists.

mod disney_2012;
mod parameters;

pub use disney_2012::{Disney2012, DisneyForm};
pub use parameters::DisneyParameters;
#[cfg(feature = "serde")]
pub(crate) use parameters::luminance;
