//! Numbers and directions that formulas trip over.

use std::f64::consts::FRAC_PI_2;

use brdf::from_spherical;
use glam::DVec3;
use proptest::prelude::*;

/// Zeros, the smallest, the just-not-zero, the just-not-one, the largest, and no numbers at all.
pub const NUMBERS: [f64; 23] = [
    0.0,
    -0.0,
    5e-324,
    1e-310,
    1e-45,
    1e-40,
    1e-38,
    1e-20,
    1e-7,
    -1e-7,
    1e-3,
    0.5,
    0.9999999,
    1.0,
    1.0000001,
    -1.0,
    1e10,
    -1e38,
    3e38,
    1e308,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
];

/// Uniform numbers: the ends of [0, 1) in `f32` and in `f64`, and what lies beyond them.
pub const UNIFORMS: [f64; 17] = [
    0.0,
    -0.0,
    5e-324,
    1.0 / 16777216.0,
    0.25,
    0.5,
    0.75,
    1.0 - 1.0 / 16777216.0,
    1.0 - f64::EPSILON / 2.0,
    1.0,
    1.0 + f64::EPSILON,
    -1e-7,
    -3.0,
    2.0,
    1e30,
    f64::NAN,
    f64::INFINITY,
];

/// Heights of directions: from the horizon to the normal, and just below the horizon.
pub const COSINES: [f64; 14] =
    [0.0, 1e-310, 1e-45, 1e-40, 1e-30, 1e-20, 1e-10, 1e-7, -1e-7, 1e-3, 0.1, 0.5, 0.999, 1.0];

/// The direction of a given height and azimuth.
pub fn direction(cos: f64, azimuth: f64) -> [f64; 3] {
    let sin = ((1.0 - cos) * (1.0 + cos)).max(0.0).sqrt();
    [sin * azimuth.cos(), sin * azimuth.sin(), cos]
}

/// Directions of all [`COSINES`], with a few azimuths, and some that are no directions.
pub fn directions() -> Vec<[f64; 3]> {
    let mut directions = Vec::new();
    for cos in COSINES {
        for azimuth in [0.0, 0.7, 2.0, -3.1] {
            directions.push(direction(cos, azimuth));
        }
    }
    directions.extend([
        [0.0, 0.0, -1.0],
        [0.0; 3],
        [1e-30, -1e-40, 1e-35],
        [2.0, 0.0, 1.0],
        [1e38; 3],
        [f64::NAN, 0.0, 1.0],
        [0.0, 0.0, f64::INFINITY],
        [1e-4, -2e-5, 1.0],
        [1e-20, 1e-30, 1.0],
        [0.6, 0.0, 0.80399],
        [0.6, 0.0, 0.796],
    ]);
    directions
}

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -1.0..1.0_f64,
        2 => prop::sample::select(NUMBERS.to_vec()),
        1 => prop::num::f64::ANY,
        1 => prop::num::f32::ANY.prop_map(f64::from),
    ]
}

/// A direction: mostly above the surface, often grazing or close to the normal, sometimes with a
/// length just within or just beyond what counts, sometimes no direction at all.
fn any_direction() -> impl Strategy<Value = [f64; 3]> {
    let unit = (0.0..FRAC_PI_2, -3.2..3.2_f64).prop_map(|(t, p)| from_spherical(t, p).to_array());
    let grazing = (prop::sample::select(COSINES.to_vec()), -3.2..3.2_f64)
        .prop_map(|(cos, azimuth)| direction(cos, azimuth));
    let near_normal = (-1e-4..1e-4_f64, -1e-4..1e-4_f64).prop_map(|(x, y)| [x, y, 1.0]);
    let long = (unit.clone(), 0.99..1.01_f64).prop_map(|(w, length)| w.map(|c| c * length));
    let any = prop::array::uniform3(any_number());
    prop_oneof![5 => unit, 3 => grazing, 2 => near_normal, 1 => long, 2 => any]
}

/// Pairs, with mirror, equal and opposite ones among them.
pub fn pairs() -> impl Strategy<Value = [[f64; 3]; 2]> {
    (any_direction(), any_direction(), 0..7_u8).prop_map(|(wi, wo, relation)| {
        let (light, viewer) = (DVec3::from_array(wi), DVec3::from_array(wo));
        let wi = match relation {
            0 => DVec3::new(-viewer.x, -viewer.y, viewer.z),
            1 => viewer,
            2 => -viewer,
            3 => -(light + viewer).normalize(),
            _ => light,
        };
        [wi.to_array(), wo]
    })
}

/// Uniform numbers, within [0, 1) and at and beyond its ends.
pub fn uniforms() -> impl Strategy<Value = [f64; 2]> {
    let one = prop_oneof![4 => 0.0..1.0_f64, 2 => prop::sample::select(UNIFORMS.to_vec())];
    [one.clone(), one]
}
