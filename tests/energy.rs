//! The directional albedo of every model under test, by its own `albedo`.

mod common;

use approx::assert_relative_eq;
use brdf::from_spherical;
use common::models;
use glam::DVec3;

/// Models that promise it never reflect more than they receive, at any angle; the others do at
/// some angle, so that the list tells the truth.
#[test]
fn albedo_keeps_its_promise() {
    for entry in models::all::<f64>() {
        let albedo = |step: u32| {
            let wo = from_spherical(f64::from(step) * 1.57 / 24.0, 0.7);
            entry.model.albedo(wo).max_element()
        };
        let largest = (0..=24).map(albedo).fold(0.0, f64::max);
        if entry.gain.is_none() {
            assert!(largest <= 1.0 + 1e-12, "{}: {largest}", entry.name);
        } else {
            assert!(largest > 1.0, "{} is conserving after all: {largest}", entry.name);
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
        let albedo = entry.model.albedo(wo).max_element();
        assert_relative_eq!(mean, albedo, max_relative = 5e-3);
    }
}
