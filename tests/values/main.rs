//! Every formula against reference values of 50 digits.

#[path = "../common/mod.rs"]
mod common;

mod directions;
mod distributions;
mod fresnel;
mod lobes;
mod microfacet;
