//! Directional albedo by cubature of `eval`.

use std::f64::consts::{FRAC_PI_2, PI};

use brdf::from_spherical;
use glam::DVec3;
use rayon::prelude::*;

use super::Model64;
use super::hemisphere::{Integral, cells, integrate};

/// The largest directional albedo of any channel, and where it was found.
#[derive(Clone, Copy, Debug)]
pub struct Energy {
    pub maximum: f64,
    /// The angle of the viewer from the normal.
    pub degrees: f64,
    /// An upper estimate of the error of `maximum`.
    pub error: f64,
    /// The cells of the most laborious integral.
    pub cells: usize,
}

/// ∫ f cosθᵢ dωᵢ: with an error of `tolerance`, and the closer to 1 the better, down to 2·10⁻¹³,
/// so that the side of 1 is beyond doubt.
pub fn albedo(model: &Model64, wo: DVec3, tolerance: f64) -> Integral {
    integrate(
        wo,
        &cells(model, wo),
        |wi| model.eval(wi, wo) * wi.z,
        |value, error| {
            let distance = 0.1 * (value.max_element() - 1.0).abs();
            error <= tolerance.min(distance.max(2e-13))
        },
    )
}

/// Angles from the normal to 89.99°, in radians: one half even up to 75°, the other ever denser.
pub fn angles(count: u32) -> Vec<f64> {
    let even = count / 2;
    let dense = count - even;
    let (last, edge) = (15.0_f64, 0.01_f64);
    (0..even)
        .map(|step| f64::from(step) / f64::from(even) * (90.0 - last))
        .chain((0..dense).map(|step| {
            let part = f64::from(step) / f64::from(dense - 1);
            90.0 - last * (edge / last).powf(part)
        }))
        .map(f64::to_radians)
        .collect()
}

/// Whether a model looks the same when the surface is turned.
pub fn is_isotropic(model: &Model64) -> bool {
    [(0.4, 0.5, 2.0), (1.0, 0.2, 3.0), (1.3, 1.2, 3.3)].into_iter().all(
        |(theta_i, theta_o, phi)| {
            let at = |turn: f64| {
                model.eval(from_spherical(theta_i, turn), from_spherical(theta_o, turn + phi))
            };
            let (here, turned) = (at(0.0), at(0.7));
            here.abs_diff_eq(turned, 1e-8 * here.max_element())
        },
    )
}

/// The largest albedo over so many angles, of anisotropic models along both axes.
pub fn energy(model: &Model64, count: u32, tolerance: f64) -> Energy {
    let azimuths: &[f64] = if is_isotropic(model) { &[PI] } else { &[PI, FRAC_PI_2] };
    let viewers: Vec<(f64, f64)> = azimuths
        .iter()
        .flat_map(|&phi| angles(count).into_iter().map(move |theta| (theta, phi)))
        .collect();
    let found: Vec<(f64, Integral)> = viewers
        .into_par_iter()
        .map(|(theta, phi)| (theta, albedo(model, from_spherical(theta, phi), tolerance)))
        .collect();
    let cells = found.iter().map(|(_, integral)| integral.cells).max().unwrap_or(0);
    let brightest = |integral: &Integral| integral.value.max_element();
    let maximum = found.iter().map(|(_, integral)| brightest(integral)).fold(0.0, f64::max);
    // Of equal ones the first.
    let first = found.iter().find(|(_, integral)| maximum - brightest(integral) <= 1e-9);
    let (degrees, error) =
        first.map_or((0.0, 0.0), |(theta, integral)| (theta.to_degrees(), integral.error));
    Energy { maximum, degrees, error, cells }
}
