//! What a device answers, against `f64` and against the `f32` of the crate.

use brdf::Sample;
use brdf::wgsl::{Binding, Module};
use brdf_checks::directions::pairs_to_grazing;
use brdf_checks::measure::Model64;
use brdf_checks::measure::precision::{Model32, Quantity, precision};
use brdf_checks::models;
use brdf_shaders::device::{Device, Program};
use brdf_shaders::recorded::{Question, Recorded, Shader};
use glam::{DVec3, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// The number of pairs of directions for every model; the environment may ask for another.
fn count() -> usize {
    let asked = std::env::var("BRDF_SHADER_PAIRS").ok();
    asked.map_or(100_000, |count| count.parse().expect("a number of pairs"))
}

fn questions(count: usize) -> Vec<Question> {
    let mut rng = Pcg64Mcg::seed_from_u64(0x91f0);
    let pairs = pairs_to_grazing(count).into_iter();
    let pairs = pairs.map(|(wi, wo)| (wi.as_vec3(), wo.as_vec3()));
    pairs
        .filter(|(wi, wo)| wi.z > 0.0 && wo.z > 0.0)
        .map(|(wi, wo)| Question { wi, wo, u: [rng.random(), rng.random()] })
        .collect()
}

/// Errors of samples: of the direction, relative of the weight, and of the density against that of
/// the direction that was drawn.
fn sample_errors(model: &Model64, question: &Question, got: &Sample<f32, Vec3>) -> [f64; 3] {
    let wo = question.wo.as_dvec3();
    let want = model.sample(wo, question.u.map(f64::from));
    let weight = (got.weight.as_dvec3() - want.weight).abs().max_element();
    let pdf = model.pdf(got.wi.as_dvec3(), wo);
    [
        (got.wi.as_dvec3() - want.wi).length(),
        weight / want.weight.max_element().max(1e-3),
        (f64::from(got.pdf) - pdf).abs() / pdf.max(1e-6),
    ]
}

/// The value below which all but a part of the errors are.
fn quantile(errors: &mut [f64], part: f64) -> f64 {
    errors.sort_by(f64::total_cmp);
    errors[((errors.len() - 1) as f64 * part) as usize]
}

/// What an error may be, where the crate has another: a tenth more, and one rounding.
fn allowed(own: f64) -> f64 {
    1.1 * own + f64::from(f32::EPSILON)
}

/// Value and density of a model: median and maximum of the relative errors, and the largest one in
/// units of what rounding may do.
fn pairs_are_as_exact(
    failures: &mut Vec<String>,
    name: &str,
    [shader, single]: [&Model32; 2],
    double: &Model64,
    pairs: &[(Vec3, Vec3)],
) {
    for quantity in [Quantity::Eval, Quantity::Pdf] {
        let [got, own] = [shader, single].map(|it| precision(quantity, it, double, pairs));
        println!(
            "{name:45} {quantity:?}: median {:.1e} ({:.1e}) maximum {:.2e} ({:.2e}) of the bound \
             {:.2} ({:.2})",
            got.median, own.median, got.maximum, own.maximum, got.ratio, own.ratio
        );
        // In units of the bound a rounding is 2⁻²³/2·10⁻⁶.
        let ratio = 1.1 * own.ratio + 0.06;
        // The largest error of a flank depends on how the bits fall; of what rounding may do there it is no larger part.
        if !(got.median <= allowed(own.median)
            && got.maximum <= 1.25 * allowed(own.maximum)
            && got.ratio <= ratio)
        {
            failures.push(format!("{name}, {quantity:?}: {got:?}, the crate {own:?}"));
        }
    }
}

#[test]
fn shaders_are_as_exact_as_single_precision() {
    let Some(device) = Device::find() else { return };
    let questions = questions(count());
    println!("{}, {} pairs; in parentheses the crate's f32", device.name, questions.len());
    let pairs: Vec<_> = questions.iter().map(|it| (it.wi, it.wo)).collect();
    let mut failures = Vec::new();
    for ((row, single), double) in models::rows().iter().zip(models::single()).zip(models::double())
    {
        let mut module = Module::new();
        module.add_described("model", &row.brdf).expect(&row.name);
        let answers = Shader::new(&device, &module.to_string()).ask(&questions, None);
        let recorded = Recorded::new(&questions, &answers);
        let (single, double) = (&*single.model, &*double.model);
        pairs_are_as_exact(&mut failures, &row.name, [&recorded, single], double, &pairs);
        let mut errors = [const { [const { Vec::new() }; 3] }; 2];
        for (question, answered) in questions.iter().zip(&answers) {
            let own = single.sample(question.wo, question.u);
            for (errors, sample) in errors.iter_mut().zip([answered.sample, own]) {
                for (errors, error) in
                    errors.iter_mut().zip(sample_errors(double, question, &sample))
                {
                    errors.push(error);
                }
            }
        }
        let [mut got, mut own] = errors;
        for (index, what) in ["direction", "weight", "density"].into_iter().enumerate() {
            let [got, own] = [&mut got[index], &mut own[index]];
            // The largest errors stand where a sample jumps or grazes, and depend on how the bits fall; so do those of
            // a number that was left by the choice of a lobe, which has lost digits.
            let chosen = if row.promises.one_to_one { 1.0 } else { 1.25 };
            for (part, more) in [(0.5, 1.0), (0.9, 1.0), (0.99, chosen), (0.999, 1.25)] {
                let [got, own] = [quantile(got, part), quantile(own, part)];
                let within = got <= more * allowed(own);
                if !within {
                    failures.push(format!("{}, {what} at {part}: {got:e}, {own:e}", row.name));
                }
            }
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

/// What a uniform buffer says is what a constant says, but for rounding.
#[test]
fn uniform_parameters_are_those_of_the_buffer() {
    let Some(device) = Device::find() else { return };
    let questions = questions(2_000);
    for (row, double) in models::rows().iter().zip(models::double()) {
        let mut module = Module::new();
        let binding = Binding { group: 1, binding: 0 };
        let uniforms = module.add_described_with("model", &row.brdf, binding).expect(&row.name);
        let shader = Shader::new(&device, &module.to_string());
        let answers = shader.ask(&questions, Some(&uniforms.bytes()));
        let mut errors: Vec<f64> = questions
            .iter()
            .zip(&answers)
            .map(|(Question { wi, wo, .. }, answered)| {
                let want = double.model.eval(wi.as_dvec3(), wo.as_dvec3());
                let error = (answered.value.as_dvec3() - want).abs().max_element();
                error / want.max_element().max(1e-20)
            })
            .collect();
        let median = quantile(&mut errors, 0.5);
        assert!(median < 5e-6, "{}: {median:e}", row.name);
    }
}

/// The loop over samples is the mean that the crate's `f64` makes of the same samples.
#[test]
fn albedos_are_means_of_samples() {
    let Some(device) = Device::find() else { return };
    let directions: Vec<Vec3> = questions(16).iter().map(|question| question.wo).collect();
    let given: Vec<f32> = directions.iter().flat_map(|wo| wo.to_array()).collect();
    for (row, double) in models::rows().iter().zip(models::double()) {
        let mut module = Module::new();
        module.add_described("model", &row.brdf).expect(&row.name);
        module.add_albedo("model").expect(&row.name);
        let program = Program {
            text: &module.to_string(),
            statements: "
    let albedo = model_albedo(vec3(given[at], given[at + 1u], given[at + 2u]));
    for (var i = 0u; i < 3u; i++) {
        answers[to + i] = albedo[i];
    }",
            inputs: 3,
            outputs: 3,
        };
        let answers = device.compile(&program).run(&given, None);
        for (wo, got) in directions.iter().zip(answers.chunks_exact(3)) {
            let got = Vec3::from_slice(got).as_dvec3();
            let mean: DVec3 = brdf::quadrature::mean_over_square(|u: [f64; 2]| {
                double.model.sample(wo.as_dvec3(), u).weight
            });
            let error = (got - mean).abs().max_element() / mean.max_element().max(1e-3);
            assert!(error < 2e-3, "{} at {wo}: {got} {mean}", row.name);
        }
    }
}
