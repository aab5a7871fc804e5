//! `f32` against `f64` on the same inputs: how many digits single precision keeps.

use brdf_checks::directions::pairs_to_grazing;
use brdf_checks::measure::precision::{Quantity, precision};
use brdf_checks::models;
use glam::Vec3;

/// Every model over the whole hemisphere, from the centre of its lobe to where it underflows,
/// without a figure of its own for any of them.
fn single_precision(quantity: Quantity) {
    let pairs: Vec<(Vec3, Vec3)> = pairs_to_grazing(20_000)
        .into_iter()
        .map(|(wi, wo)| (wi.as_vec3(), wo.as_vec3()))
        .filter(|(wi, wo)| wi.z > 0.0 && wo.z > 0.0)
        .collect();
    let mut failures = Vec::new();
    for (single, double) in models::single().iter().zip(models::double()) {
        let found = precision(quantity, &*single.model, &*double.model, &pairs);
        println!(
            "{:45} median {:.1e} maximum {:.1e} of the bound {:.2}",
            single.name, found.median, found.maximum, found.ratio
        );
        if found.ratio > 1.0 {
            failures.push(format!("{}: {found:?}", single.name));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn f32_keeps_the_digits_of_f64() {
    single_precision(Quantity::Eval);
}

#[test]
fn f32_keeps_the_digits_of_f64_in_densities() {
    single_precision(Quantity::Pdf);
}
