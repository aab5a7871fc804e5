//! `f32` against `f64` on the same inputs: how many digits single precision keeps.

mod common;

use common::directions::pairs;
use common::models;

/// The largest and the median relative difference of `eval`, brightest channel, over pairs of
/// directions all over the hemisphere. Values below 1e-12 of the model's largest are left out:
/// far down a tail, the input's own rounding decides the digits.
#[test]
fn f32_keeps_the_digits_of_f64() {
    let pairs: Vec<_> = pairs(20_000)
        .into_iter()
        .map(|(wi, wo)| (wi.as_vec3(), wo.as_vec3()))
        .filter(|(wi, wo)| wi.z > 0.0 && wo.z > 0.0)
        .collect();
    let mut failures = Vec::new();
    for (single, double) in models::all::<f32>().iter().zip(models::all::<f64>()) {
        let values: Vec<(f64, f64)> = pairs
            .iter()
            .map(|&(wi, wo)| {
                let got = single.model.eval(wi, wo).max_element();
                let want = double.model.eval(wi.as_dvec3(), wo.as_dvec3()).max_element();
                (f64::from(got), want)
            })
            .collect();
        let largest = values.iter().fold(0.0, |largest: f64, (_, want)| largest.max(*want));
        let mut errors: Vec<f64> = values
            .iter()
            .filter(|(_, want)| *want > 1e-12 * largest)
            .map(|(got, want)| (got - want).abs() / want)
            .collect();
        errors.sort_by(f64::total_cmp);
        let (median, worst) = (errors[errors.len() / 2], errors[errors.len() - 1]);
        println!("{:40} median {median:.1e} largest {worst:.1e}", single.name);
        if worst > single.precision {
            failures.push(format!("{}: {worst:.2e}, stated {:.1e}", single.name, single.precision));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
