//! `f32` against `f64` on the same inputs: how many digits single precision keeps.

mod common;

use common::directions::pairs;
use common::models;

/// How far down from a model's largest value its lobe is looked at, and how far its tail.
const LOBE: f64 = 1e-3;
const TAIL: f64 = 1e-12;

/// The relative difference of `eval`, brightest channel, over pairs of directions all over the
/// hemisphere: in the lobe at most 2e-6, in the tail what the model states. Further down the
/// rounding of the directions themselves decides the digits.
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
        let worst_above = |part: f64| {
            let errors = values
                .iter()
                .filter(|(_, want)| *want > part * largest)
                .map(|(got, want)| (got - want).abs() / want);
            errors.fold(0.0, f64::max)
        };
        let (lobe, tail) = (worst_above(LOBE), worst_above(TAIL));
        println!("{:40} lobe {lobe:.1e} tail {tail:.1e}", single.name);
        let (lobe_bound, tail_bound) = bounds(single.name);
        if lobe > lobe_bound || tail > tail_bound {
            failures.push(format!("{}: lobe {lobe:.2e}, tail {tail:.2e}", single.name));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

/// The largest relative difference that is due to the conditioning of the model, in the lobe and in
/// the tail: a power or an exponential multiplies the rounding of its argument, and where R·V
/// passes through 0 its relative error grows without bound.
fn bounds(name: &str) -> (f64, f64) {
    let of = |kind: &str| name.contains(kind);
    if of("from inside") {
        // Next to the critical angle the slope is infinite.
        (5e-5, 5e-5)
    } else if of("Schlick's power") {
        (5e-5, 2e-4)
    } else if of("Phong") || of("sum") {
        (4e-6, 3e-4)
    } else if of("Lambert") || of("Oren") || (of("GGX") && !of("mixture")) {
        (2e-6, 2e-6)
    } else {
        (2e-6, 1.2e-5)
    }
}
