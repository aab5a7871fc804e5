//! The weak white furnace.

use std::f64::consts::FRAC_PI_2;

use brdf::{Distribution, Pair, Shadowing, reflect};
use glam::DVec3;

use crate::slopes::Facing;

/// ∫ G₁(wo, h) (wo·h)₊ D dω_h / (N·wo), which is 1: the facets that a viewer sees fill what the
/// viewer sees of the surface. Facets that reflect everything, without shadowing of the light,
/// then lose nothing.
pub fn weak_furnace<D: Distribution<f64>>(
    distribution: &D,
    shadowing: &impl Shadowing<f64, D>,
    scale: [f64; 2],
    wo: DVec3,
) -> f64 {
    let facing = Facing::new(wo, scale);
    let formula = |h: DVec3| {
        let pair = Pair::new(reflect(wo, h), wo);
        4.0 * shadowing.masking(distribution, &pair) * wo.dot(h).max(0.0) * distribution.density(h)
    };
    // The far wall of a V-cavity begins to hide facets where they turn as far towards the viewer
    // as the last visible ones turn away.
    let end = facing.chi[1];
    facing.integral([-FRAC_PI_2, -end], facing.psi, 2, formula)
        + facing.integral([-end, end], facing.psi, 2, formula)
}
