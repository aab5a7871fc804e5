//! A model in a crate without the standard library.

#![no_std]

use brdf::glam::Vec3;
use brdf::{Brdf, CookTorrance, Ggx, ParameterError, Schlick};

/// A plastic seen from above.
///
/// # Errors
/// Where the roughness is out of its range.
pub fn plastic(roughness: f32) -> Result<Vec3, ParameterError> {
    let facets = CookTorrance::new(Ggx::new(roughness)?, Schlick::new(Vec3::splat(0.04))?);
    Ok(facets.eval(Vec3::Z, Vec3::Z))
}
