//! The directional albedo of every model under test, by cubature of its `eval`.

mod common;

use approx::assert_relative_eq;
use brdf::from_spherical;
use common::measure::energy::{albedo, angles, energy};
use common::models;
use glam::DVec3;

/// Models that promise it never reflect more than they receive, at any angle; the others have
/// their largest albedo where the registry says.
#[test]
fn albedo_keeps_its_promise() {
    for entry in models::all::<f64>() {
        let got = energy(&*entry.model, 12, 1e-5);
        let context = format!("{}: {got:?}", entry.name);
        println!("{context}");
        assert!(got.error <= 1e-5, "{context}");
        let Some(gain) = entry.gain else {
            assert!(got.maximum <= 1.0 + 1e-12, "{context}");
            continue;
        };
        // Towards 90° the last angle is 89.99°, where the albedo has still about cosθ to go.
        assert!(got.maximum > 1.0 + got.error, "conserving after all? {context}");
        assert_relative_eq!(got.maximum, gain.albedo, max_relative = 5e-4);
        assert!((got.degrees - gain.degrees).abs() < 0.02, "{context}");
    }
}

/// `albedo` against cubature of `eval`: closed forms and integrals on a line to 10⁻⁷, the lattice of
/// samples behind the default of microfacet models to the 5·10⁻⁴ of F = 1 that they promise.
#[test]
fn albedo_is_the_integral() {
    for entry in models::all::<f64>() {
        let lattice = ["CookTorrance", "Blinn1977", "nested"]
            .iter()
            .any(|part| entry.type_name.contains(part) || entry.name.contains(part));
        // The printed constants of 1977 multiply the lattice with 4/D(N), at most 4π.
        let promised = if !lattice {
            1e-7
        } else if entry.gain.is_some() {
            4.0 * std::f64::consts::PI * 5e-4
        } else {
            5e-4
        };
        for theta in angles(6) {
            let wo = from_spherical(theta, 0.7);
            let integral = albedo(&*entry.model, wo, 1e-5);
            let error = (entry.model.albedo(wo) - integral.value).abs().max_element();
            let context =
                format!("{} {:8.4}° {error:.1e}: {integral:?}", entry.name, theta.to_degrees());
            println!("{context}");
            assert!(integral.error <= 1e-5, "{context}");
            assert!(error <= promised + integral.error, "{context}");
        }
    }
}

/// The mean weight of random samples estimates the same integral.
#[test]
fn weights_of_samples_average_to_the_albedo() {
    let wo = from_spherical(0.8, 0.3);
    for entry in models::all::<f64>() {
        let side = 160_u32;
        let mut sum = DVec3::ZERO;
        for i in 0..side * side {
            let place = |number: u32| (f64::from(number) + 0.5) / f64::from(side);
            sum += entry.model.sample(wo, [place(i % side), place(i / side)]).weight;
        }
        let mean = (sum / f64::from(side * side)).max_element();
        let albedo = albedo(&*entry.model, wo, 1e-5).value.max_element();
        assert_relative_eq!(mean, albedo, max_relative = 5e-3);
    }
}
