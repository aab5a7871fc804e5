//! The square in which the spheres are seen.

use std::error::Error;

use glam::Vec3;

use crate::environment::{Environment, Lamp};

const SQUARE: &[u8] = include_bytes!("data/city_256x128.hdr");

/// Puts the brightest clouds to the left of the viewer and the buildings behind.
const TURN: f32 = 0.1;
/// White balance: a little warm, as the eye would have it.
const EXPOSURE: Vec3 = Vec3::new(0.475, 0.45, 0.36);
/// A round lamp before the square, at the left above the viewer's shoulder.
const LAMP: Lamp =
    Lamp { towards: Vec3::new(-0.5, 0.62, 0.6), radius: 0.2, radiance: Vec3::new(13.0, 11.5, 9.0) };

/// A photographed square under an overcast sky, and a lamp.
///
/// # Errors
/// If the photograph cannot be read.
pub fn square() -> Result<Environment, Box<dyn Error>> {
    Environment::new(SQUARE, TURN, EXPOSURE, LAMP)
}
