//! Measured metals in red, green and blue.

use brdf::materials::{COPPER, GOLD, SILVER};
use brdf::{Conductor, ParameterError};
use glam::Vec3;

/// The wavelengths that stand for red, green and blue, nm.
const WAVELENGTHS: Vec3 = Vec3::new(650.0, 550.0, 450.0);

/// Gold.
pub fn gold() -> Result<Conductor, ParameterError> {
    GOLD.conductor(WAVELENGTHS)
}

/// Silver.
pub fn silver() -> Result<Conductor, ParameterError> {
    SILVER.conductor(WAVELENGTHS)
}

/// Copper.
pub fn copper() -> Result<Conductor, ParameterError> {
    COPPER.conductor(WAVELENGTHS)
}
