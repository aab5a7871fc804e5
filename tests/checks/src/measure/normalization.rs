//! Integrals of distributions of facet normals.

use std::f64::consts::{FRAC_PI_2, PI};

use brdf::{Distribution, from_spherical};
use glam::DVec3;

use crate::slopes::{Facing, composite};

/// ∫ D cosα dω, which is 1: the facets above a patch have together the area of the patch.
pub fn projected_area<D: Distribution<f64>>(distribution: &D, scale: [f64; 2]) -> f64 {
    let all = Facing::new(DVec3::Z, scale);
    all.integral(all.chi, all.psi, 2, |h| distribution.density(h) * h.z)
}

/// The same of an isotropic distribution about as wide as an angle, over that angle alone: for
/// powers of the cosine, which end at the horizon with any power.
pub fn projected_area_by_angle<D: Distribution<f64>>(distribution: &D, width: f64) -> f64 {
    let end = (9.0 * width).min(FRAC_PI_2);
    composite([0.0, end], 4, |angle| {
        PI * distribution.density(from_spherical(angle, 0.3)) * (2.0 * angle).sin()
    })
}
