//! The samples of every model, from every direction, in both precisions.

mod common;

use std::sync::LazyLock;

use brdf::quadrature::mean_over_square;
use common::measure::sampling::chi_squared::least_of;
use common::measure::sampling::{Samples, Sampling, Size, measure};
use common::measure::sampling::viewers;
use common::models;
use glam::DVec3;
use rayon::prelude::*;

/// Small enough for every day.
const SIZE: Size = Size { pilot: 8_000, draws: 20_000, tolerance: 1e-6, budget: 1_000_000 };

struct Case {
    name: String,
    sampling: Sampling,
    /// Whether the model's albedo is the mean weight of a lattice, and no formula.
    by_lattice: bool,
}

/// Every model from every direction.
static CASES: LazyLock<Vec<Case>> = LazyLock::new(|| {
    let (double, single) = (models::all::<f64>(), models::all::<f32>());
    let viewers = viewers::all();
    let by_lattice: Vec<bool> = double
        .iter()
        .map(|entry| {
            let lattice: DVec3 = mean_over_square(|u| entry.model.sample(DVec3::Z, u).weight);
            entry.model.albedo(DVec3::Z) == lattice
        })
        .collect();
    let tasks: Vec<(usize, usize)> = (0..double.len())
        .flat_map(|entry| (0..viewers.len()).map(move |viewer| (entry, viewer)))
        .collect();
    let case = |(entry, viewer): (usize, usize)| {
        let (model, (from, wo)) = (&*double[entry].model, viewers[viewer]);
        let seed = (entry * viewers.len() + viewer) as u64;
        Case {
            name: format!("{} from {from}", double[entry].name),
            sampling: measure(model, &*single[entry].model, wo, seed, SIZE),
            by_lattice: by_lattice[entry],
        }
    };
    tasks.into_par_iter().map(case).collect()
});

/// Asserts something of all cases together, with a list of those that fail.
fn assert_all(wrong: impl Fn(&Case) -> Option<String>) {
    let wrong = |case: &Case| wrong(case).map(|what| format!("{}: {what}", case.name));
    let failed: Vec<String> = CASES.iter().filter_map(wrong).collect();
    assert!(failed.is_empty(), "{} of {}:\n{}", failed.len(), CASES.len(), failed.join("\n"));
}

/// Pearson's χ² in about 256 cells that follow the lobe, draws without direction being one more.
/// Where nothing can be drawn nothing is.
#[test]
fn samples_follow_the_density() {
    let least = least_of(2 * CASES.len());
    assert_all(|Case { sampling, .. }| {
        let verdicts = [("double", &sampling.double), ("single", &sampling.single)];
        verdicts.into_iter().find_map(|(precision, samples)| {
            let verdict = &samples.verdict;
            let good = verdict.p_value > least && verdict.terms > 100;
            (!good).then(|| format!("{precision} p {:e}, {verdict:?}", verdict.p_value))
        })
    });
}

/// ∫ pdf dω + P(no direction) = 1.
#[test]
fn the_density_leaves_nothing_out() {
    assert_all(|Case { sampling, .. }| {
        let good = sampling.excess().abs() < 1e-6
            && sampling.mass.error <= 1e-6
            && sampling.failure.error <= 1e-6;
        (!good).then(|| {
            format!("{:e}, {:?}, {:?}", sampling.excess(), sampling.mass, sampling.failure)
        })
    });
}

/// The pdf of a sample is `pdf`, to the last bit; its weight times `pdf` is `eval` times the
/// cosine, up to the rounding of the few factors in which the formulas differ.
#[test]
fn samples_say_what_eval_and_pdf_say() {
    assert_all(|Case { sampling: Sampling { double, single, .. }, .. }| {
        let good = double.pdf_ulps == 0.0
            && single.pdf_ulps == 0.0
            && double.weight_ulps <= 4.0
            && single.weight_ulps <= 4.0;
        let of = |samples: &Samples| (samples.pdf_ulps, samples.weight_ulps);
        (!good).then(|| format!("{:?} {:?}", of(double), of(single)))
    });
}

/// The mean weight agrees with the integral within four standard errors.
#[test]
fn weights_average_to_the_albedo() {
    assert_all(|Case { sampling: Sampling { double, single, .. }, .. }| {
        let worst = double.albedo_z.max(single.albedo_z);
        (worst > 4.0).then(|| format!("{worst} standard errors"))
    });
}

/// The model's own albedo agrees with the integral: formulas to its precision, means of a lattice
/// to 5·10⁻⁴ of the largest weight they can have.
#[test]
fn albedo_is_the_integral() {
    assert_all(|Case { sampling, by_lattice, .. }| {
        let error = (sampling.own_albedo - sampling.albedo).abs().max_element();
        let bound = if *by_lattice { 5e-4 * sampling.albedo.max_element().max(1.0) } else { 2e-7 };
        (error > bound).then(|| format!("{error:e} of {}", sampling.albedo))
    });
}

/// All figures, for those who want to see them: `cargo test --test sampling -- --ignored figures`.
#[test]
#[ignore = "prints only"]
fn figures() {
    for Case { name, sampling, .. } in CASES.iter() {
        println!("{name}: {sampling:?}");
    }
}
