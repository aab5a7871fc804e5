//! Directions to test with.

use std::f64::consts::{FRAC_PI_2, TAU};

use brdf::from_spherical;
use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// `count` pairs above the surface, the same at every call: uniform in the polar angle, so that
/// normal and grazing directions are both well represented, and a part of them near to mirror
/// pairs, where narrow lobes live.
pub fn pairs(count: usize) -> Vec<(DVec3, DVec3)> {
    let mut rng = Pcg64Mcg::seed_from_u64(0x5eed);
    let mut uniform = move || rng.random::<f64>();
    let mut pairs = Vec::with_capacity(count);
    for index in 0..count {
        let wo = from_spherical(uniform() * FRAC_PI_2, uniform() * TAU);
        let wi = if index % 2 == 0 {
            from_spherical(uniform() * FRAC_PI_2, uniform() * TAU)
        } else {
            let tilt = DVec3::new(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5) * 0.1;
            let near = (DVec3::new(-wo.x, -wo.y, wo.z) + tilt).normalize();
            DVec3::new(near.x, near.y, near.z.abs())
        };
        pairs.push((wi, wo));
    }
    pairs
}

/// Pairs over the whole domain: those of [`pairs`], and as many of which one or both directions
/// graze, with cosines down to 10⁻⁶, some of them near to mirror pairs.
pub fn pairs_to_grazing(count: usize) -> Vec<(DVec3, DVec3)> {
    pairs_to_power(count, 6.0)
}

/// The same with cosines down to another power of ten, 10 to the −`power`.
pub fn pairs_to_power(count: usize, power: f64) -> Vec<(DVec3, DVec3)> {
    let mut rng = Pcg64Mcg::seed_from_u64(0x9a2e);
    let mut all = pairs(count / 2);
    all.extend(pairs(count - count / 2).into_iter().enumerate().map(|(index, (wi, wo))| {
        let mut grazing = |w: DVec3| {
            let cos = 10.0_f64.powf(-power * rng.random::<f64>());
            let tangent = DVec3::new(w.x, w.y, 0.0).normalize_or(DVec3::X);
            tangent * ((1.0 - cos) * (1.0 + cos)).sqrt() + DVec3::Z * cos
        };
        match index % 3 {
            0 => (grazing(wi), wo),
            1 => (wi, grazing(wo)),
            _ => (grazing(wi), grazing(wo)),
        }
    }));
    all
}
