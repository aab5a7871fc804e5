//! The directions from which models are measured.

use brdf::from_spherical;
use glam::DVec3;

/// Directions `wo` with their names: at and next to the normal, oblique on and off the axes,
/// grazing. All are numbers of single precision, up to their length, so that both precisions look
/// from the same place.
pub fn all() -> Vec<(&'static str, DVec3)> {
    let at_height = |cos: f64, phi: f64| from_spherical(cos.acos(), phi);
    [
        ("normal", DVec3::Z),
        ("0.01 off the normal", from_spherical(0.01, 1.0)),
        ("30° along x", from_spherical(30_f64.to_radians(), 0.0)),
        ("45°", from_spherical(45_f64.to_radians(), 2.0)),
        ("60°", from_spherical(60_f64.to_radians(), -2.5)),
        ("80°", from_spherical(80_f64.to_radians(), 0.9)),
        ("height 1e-2 along y", DVec3::new(0.0, (1.0 - 1e-4_f64).sqrt(), 1e-2)),
        ("height 1e-3", at_height(1e-3, -0.8)),
    ]
    .map(|(name, wo)| (name, wo.as_vec3().as_dvec3().normalize()))
    .into()
}
