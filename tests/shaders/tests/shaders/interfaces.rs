//! Models over the whole sphere: whether their text is valid, and what a device makes of it.

use brdf::wgsl::{Binding, Module};
use brdf::{BsdfSample, TransportMode};
use brdf_checks::directions::pairs_to_grazing;
use brdf_checks::interfaces::{self, MODES, Row};
use brdf_shaders::device::{Compiled, Device, Program};
use brdf_shaders::validate::{translate, validate};
use glam::{DVec3, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// What runs for each question.
const STATEMENTS: &str = "
    let wi = vec3(given[at], given[at + 1u], given[at + 2u]);
    let wo = vec3(given[at + 3u], given[at + 4u], given[at + 5u]);
    let u = vec3(given[at + 6u], given[at + 7u], given[at + 8u]);
    let value = model_eval(wi, wo);
    let drawn = model_sample(wo, u);
    for (var i = 0u; i < 3u; i++) {
        answers[to + i] = value[i];
        answers[to + 4u + i] = drawn.wi[i];
        answers[to + 7u + i] = drawn.weight[i];
    }
    answers[to + 3u] = model_pdf(wi, wo);
    answers[to + 10u] = drawn.pdf;
    answers[to + 11u] = select(0.0, 1.0, drawn.specular);";

/// Bytes of the functions of a model with constants: Beckmann's facets with the beta function have most.
const LONGEST: usize = 34_000;

/// Of models of wave optics, whose sums are written out.
const LONGEST_SUMS: usize = 180_000;

const fn program(text: &str) -> Program<'_> {
    Program { text, statements: STATEMENTS, inputs: 9, outputs: 12 }
}

fn constants(row: &Row, mode: TransportMode) -> String {
    let mut module = Module::new();
    module.add_described_bsdf("model", &row.bsdf, mode).expect(&row.name);
    module.to_string()
}

/// The modes of which the text differs: where nothing is refracted there is one text.
fn modes(row: &Row) -> impl Iterator<Item = TransportMode> {
    let [first, second] = MODES;
    let same = constants(row, first) == constants(row, second);
    [first, second].into_iter().take(if same { 1 } else { 2 })
}

/// A pair of directions and three uniform numbers.
type Question = ([Vec3; 2], [f32; 3]);
/// Value, density and sample.
type Answered = (Vec3, f32, BsdfSample<f32, Vec3>);

/// Pairs of directions on both sides.
fn questions(count: usize) -> Vec<Question> {
    let mut rng = Pcg64Mcg::seed_from_u64(0x91f0);
    let mut turned = move |w: DVec3| {
        let w = w.as_vec3();
        if rng.random() { w } else { Vec3::new(w.x, w.y, -w.z) }
    };
    let mut rng = Pcg64Mcg::seed_from_u64(0x5eed);
    pairs_to_grazing(count)
        .into_iter()
        .map(|(wi, wo)| ([turned(wi), turned(wo)], std::array::from_fn(|_| rng.random())))
        .collect()
}

fn ask(shader: &Compiled<'_>, questions: &[Question], uniforms: Option<&[u8]>) -> Vec<Answered> {
    let given: Vec<f32> = questions
        .iter()
        .flat_map(|([wi, wo], u)| [&wi.to_array(), &wo.to_array(), u].map(|it| *it).concat())
        .collect();
    let answers = shader.run(&given, uniforms);
    let answered = |it: &[f32]| {
        let sample = BsdfSample {
            wi: Vec3::from_slice(&it[4..7]),
            weight: Vec3::from_slice(&it[7..10]),
            pdf: it[10],
            specular: it[11] == 1.0,
        };
        (Vec3::from_slice(&it[0..3]), it[3], sample)
    };
    answers.chunks_exact(12).map(answered).collect()
}

#[test]
fn every_interface_is_a_valid_shader_in_all_languages() {
    for (row, mode) in
        interfaces::rows().iter().flat_map(|row| modes(row).map(move |mode| (row, mode)))
    {
        let text = constants(row, mode);
        println!("{:35} {mode:?} {:6} bytes", row.name, text.len());
        let sums = matches!(row.form().as_str(), "beckmann_kirchhoff_1963" | "he_1991");
        let longest = if sums { LONGEST_SUMS } else { LONGEST };
        assert!(text.len() <= longest, "{}: {}", row.name, text.len());
        let mut module = Module::new();
        let binding = Binding { group: 1, binding: 0 };
        let uniforms = module.add_described_bsdf_with("model", &row.bsdf, mode, binding);
        let uniforms = uniforms.expect(&row.name);
        let with_parameters = module.to_string();
        for field in uniforms.fields() {
            let used = with_parameters.contains(&format!("model_parameters.{}", field.name));
            assert!(used, "{}: {}", row.name, field.name);
        }
        for text in [text, with_parameters] {
            let shader = program(&text).shader();
            let (module, info) = validate(&row.name, &shader);
            let translated = translate(&row.name, &module, &info);
            assert!(translated.glsl.contains("model_sample"), "{}", row.name);
        }
    }
}

/// Both kinds of samples, and both modes, in one module.
#[test]
fn models_of_both_kinds_fit_into_one_module() {
    let mut module = Module::new();
    for (index, row) in interfaces::rows().iter().enumerate() {
        for mode in MODES {
            let name = format!("model_{index}_{}", format!("{mode:?}").to_lowercase());
            module.add_described_bsdf(&name, &row.bsdf, mode).expect(&row.name);
        }
    }
    let row = &brdf_checks::models::rows()[0];
    module.add_described("paper", &row.brdf).expect(&row.name);
    let text = module.to_string();
    assert_eq!(text.matches("struct BrdfSample {").count(), 1);
    assert_eq!(text.matches("struct BsdfSample {").count(), 1);
    validate("all", &text);
}

/// The value below which all but a part of the errors are.
fn quantile(errors: &mut [f64], part: f64) -> f64 {
    errors.sort_by(f64::total_cmp);
    errors[((errors.len() - 1) as f64 * part) as usize]
}

/// Errors of value and density, of the direction and weight of a sample, and of its density against that
/// of the direction.
fn errors(
    model: &interfaces::Model<f64>,
    mode: TransportMode,
    ([wi, wo], u): &Question,
    (value, pdf, sample): &Answered,
) -> [f64; 5] {
    let (wi, wo) = (wi.as_dvec3(), wo.as_dvec3());
    let want = model.eval(wi, wo, mode);
    let value = (value.as_dvec3() - want).abs().max_element() / want.max_element().max(1e-20);
    let want = model.pdf(wi, wo, mode);
    let density = (f64::from(*pdf) - want).abs() / want.max(1e-20);
    let want = model.sample(wo, u.map(f64::from), mode);
    let direction = (sample.wi.as_dvec3() - want.wi).length();
    let weight = (sample.weight.as_dvec3() - want.weight).abs().max_element()
        / want.weight.max_element().max(1e-3);
    let want = model.pdf(sample.wi.as_dvec3(), wo, mode);
    let of_sample = if sample.specular {
        f64::from(sample.pdf)
    } else {
        (f64::from(sample.pdf) - want).abs() / want.max(1e-6)
    };
    [value, density, direction, weight, of_sample]
}

#[test]
fn shaders_of_interfaces_are_as_exact_as_single_precision() {
    let Some(device) = Device::find() else { return };
    let questions = questions(20_000);
    let mut failures = Vec::new();
    let models = interfaces::double().iter().zip(interfaces::single());
    for (double, single, mode) in models
        .flat_map(|(double, single)| modes(double.row).map(move |mode| (double, single, mode)))
    {
        let name = &double.row.name;
        let text = constants(double.row, mode);
        let answers = ask(&device.compile(&program(&text)), &questions, None);
        let (mut got, mut own) = ([const { Vec::new() }; 5], [const { Vec::new() }; 5]);
        let mut events = [0, 0];
        for (question, answer) in questions.iter().zip(&answers) {
            let ([wi, wo], u) = *question;
            let (value, pdf) = single.model.eval_pdf(wi, wo, mode);
            let crate_answer = (value, pdf, single.model.sample(wo, u, mode));
            let double_event = double.model.sample(wo.as_dvec3(), u.map(f64::from), mode).specular;
            for ((all, answer), events) in
                [(&mut got, answer), (&mut own, &crate_answer)].into_iter().zip(&mut events)
            {
                *events += u32::from(answer.2.specular != double_event);
                for (all, error) in
                    all.iter_mut().zip(errors(&*double.model, mode, question, answer))
                {
                    all.push(error);
                }
            }
        }
        if events[0] > events[1] + 2 {
            failures.push(format!("{name}, {mode:?}: {events:?} other events"));
        }
        for (index, what) in ["value", "density", "direction", "weight", "density of samples"]
            .into_iter()
            .enumerate()
        {
            for (part, more) in [(0.5, 1.0), (0.9, 1.0), (0.99, 1.0), (0.999, 1.25)] {
                let [got, own] = [&mut got, &mut own].map(|it| quantile(&mut it[index], part));
                let within = got <= more * (1.1 * own + f64::from(f32::EPSILON));
                if !within {
                    failures.push(format!("{name}, {mode:?}, {what} at {part}: {got:e}, {own:e}"));
                }
            }
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

/// What a uniform buffer says is what a constant says, but for rounding.
#[test]
fn uniform_parameters_of_interfaces_are_those_of_the_buffer() {
    let Some(device) = Device::find() else { return };
    let questions = questions(2_000);
    let models = interfaces::double().iter();
    for (double, mode) in models.flat_map(|it| modes(it.row).map(move |mode| (it, mode))) {
        let row = double.row;
        let mut module = Module::new();
        let binding = Binding { group: 1, binding: 0 };
        let uniforms = module.add_described_bsdf_with("model", &row.bsdf, mode, binding);
        let uniforms = uniforms.expect(&row.name);
        let text = module.to_string();
        let bytes = (uniforms.size() > 0).then(|| uniforms.bytes());
        let answers = ask(&device.compile(&program(&text)), &questions, bytes.as_deref());
        let mut all: [Vec<f64>; 5] = Default::default();
        for (question, answer) in questions.iter().zip(&answers) {
            for (all, error) in all.iter_mut().zip(errors(&*double.model, mode, question, answer)) {
                all.push(error);
            }
        }
        let medians = all.each_mut().map(|errors| quantile(errors, 0.5));
        assert!(medians.iter().all(|median| *median < 5e-6), "{}: {medians:?}", row.name);
    }
}
