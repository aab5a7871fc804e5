//! What can be measured of a model. Functions that answer numbers and assert nothing.

use brdf::Brdf;
use glam::{DVec3, Vec3};

pub mod derivatives;
pub mod differences;
pub mod energy;
pub mod facets;
pub mod furnace;
pub mod hemisphere;
pub mod normalization;
pub mod precision;
pub mod reciprocity;
pub mod sampling;
pub mod sphere;

/// A model as it is measured.
pub type Model64 = dyn Brdf<f64, Color = DVec3>;
/// The same in single precision.
pub type Model32 = dyn Brdf<f32, Color = Vec3>;
