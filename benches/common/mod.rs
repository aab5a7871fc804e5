//! Varied inputs for all benches.
#![allow(dead_code, unreachable_pub, reason = "each bench uses its own part")]

pub mod by_hand;
pub mod by_hand_models;
pub mod metallic_roughness;
pub mod planes;

use glam::{DVec3, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Pairs of directions in one buffer: large enough to defeat the branch predictor, small enough
/// for the cache.
pub const COUNT: usize = 4096;

/// A direction uniform over the upper hemisphere with cosθ ≥ 1e-3.
fn direction(rng: &mut Pcg64Mcg) -> DVec3 {
    let z = 1e-3 + (1.0 - 1e-3) * rng.random::<f64>();
    let (sin, cos) = (std::f64::consts::TAU * rng.random::<f64>()).sin_cos();
    let radius = (1.0 - z * z).sqrt();
    DVec3::new(radius * cos, radius * sin, z)
}

/// Independent pairs (wi, wo).
pub fn pairs() -> Vec<(DVec3, DVec3)> {
    let mut rng = Pcg64Mcg::seed_from_u64(7);
    (0..COUNT).map(|_| (direction(&mut rng), direction(&mut rng))).collect()
}

/// The same pairs in single precision.
pub fn pairs_f32() -> Vec<(Vec3, Vec3)> {
    pairs().into_iter().map(|(wi, wo)| (wi.as_vec3(), wo.as_vec3())).collect()
}

/// Uniform numbers for `sample`.
pub fn uniforms() -> Vec<[f64; 2]> {
    let mut rng = Pcg64Mcg::seed_from_u64(8);
    (0..COUNT).map(|_| [rng.random(), rng.random()]).collect()
}
