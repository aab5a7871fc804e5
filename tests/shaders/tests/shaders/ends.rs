//! Odd inputs, and parameters at the ends of their ranges.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

use brdf::description::BrdfDescription;
use brdf::wgsl::{Binding, Module};
use brdf_checks::models;
use brdf_shaders::device::Device;
use brdf_shaders::recorded::{Answered, Question, Shader};
use brdf_shaders::validate::validate;
use glam::Vec3;
use serde_json::Value;

/// Directions, and what is none.
const DIRECTIONS: [[f32; 3]; 18] = [
    [0.0, 0.0, 1.0],
    [0.6, 0.0, 0.8],
    [-0.6, 0.0, 0.8],
    [0.0, -0.28, 0.96],
    [1.0, 0.0, 1e-4],
    [-1.0, 0.0, 1e-20],
    [0.0, 1.0, 1e-38],
    [1.0, 0.0, 1e-44],
    [1.0, 0.0, 0.0],
    [1.0, 0.0, -0.0],
    [0.6, 0.0, -0.8],
    [0.0, 0.0, -1.0],
    [0.0, 0.0, 0.0],
    [0.0, 0.0, 2.0],
    [0.0, 0.0, 3e38],
    [f32::NAN, 0.0, 1.0],
    [f32::INFINITY, 0.0, 1.0],
    [f32::NAN, f32::NAN, f32::NAN],
];

const UNIFORMS: [f32; 10] =
    [0.0, 1.0, 0.5, 0.99999994, 5.9604645e-8, 1e-44, -1.0, 2.0, f32::NAN, f32::INFINITY];

fn questions() -> Vec<Question> {
    let mut questions = Vec::new();
    for (index, wo) in DIRECTIONS.into_iter().enumerate() {
        for (other, wi) in DIRECTIONS.into_iter().enumerate() {
            let (wi, wo) = (Vec3::from(wi), Vec3::from(wo));
            for step in 0..6 {
                let place = index * 7 + other * 3 + step * 11;
                let u = [UNIFORMS[place % 10], UNIFORMS[place / 10 % 10]];
                questions.push(Question { wi, wo, u });
            }
        }
    }
    questions
}

/// Finite, not negative where a value or density; zero where a direction is none.
fn assert_sound(name: &str, question: &Question, answered: &Answered) {
    let at = || format!("{name} at {question:?}: {answered:?}");
    assert!(answered.numbers().iter().all(|number| number.is_finite()), "{}", at());
    let Answered { value, pdf, sample } = answered;
    let least = value.min_element().min(*pdf).min(sample.weight.min_element()).min(sample.pdf);
    assert!(least >= 0.0, "{}", at());
    let above = brdf::above_surface::<f32, Vec3>;
    if !(above(question.wi) && above(question.wo)) {
        assert_eq!((*value, *pdf), (Vec3::ZERO, 0.0), "{}", at());
    }
    if !above(question.wo) {
        assert_eq!((sample.weight, sample.pdf), (Vec3::ZERO, 0.0), "{}", at());
    }
}

#[test]
fn odd_inputs_are_harmless() {
    let Some(device) = Device::find() else { return };
    let questions = questions();
    for row in models::rows() {
        let mut module = Module::new();
        module.add_described("model", &row.brdf).expect(&row.name);
        let answers = Shader::new(&device, &module.to_string()).ask(&questions, None);
        for (question, answered) in questions.iter().zip(&answers) {
            assert_sound(&row.name, question, answered);
        }
    }
}

/// Numbers at which some parameter's range ends, and some between.
const NUMBERS: [f64; 16] = [
    0.0, 1e-30, 1e-8, 1e-5, 2e-4, 1e-4, 1e-2, 0.5, 0.999999, 1.0, 1.57, FRAC_PI_2, 1e4, 1e5, 1e8,
    1e10,
];

/// The places of the numbers of a description.
fn numbers(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(path.into()),
        Value::Array(list) => {
            let each = list.iter().enumerate();
            each.for_each(|(index, value)| numbers(value, &format!("{path}/{index}"), found));
        }
        Value::Object(keys) => {
            keys.iter().for_each(|(key, value)| numbers(value, &format!("{path}/{key}"), found));
        }
        _ => {}
    }
}

/// Descriptions of every kind of the registry, each with numbers at the ends of their ranges, by the
/// first of the kind.
fn at_ends() -> BTreeMap<String, Vec<BrdfDescription>> {
    let mut kinds: BTreeMap<String, Vec<BrdfDescription>> = BTreeMap::new();
    for row in models::rows() {
        let whole = serde_json::to_value(&row.brdf).expect("JSON");
        let mut places = Vec::new();
        numbers(&whole, "", &mut places);
        let mut kind = whole.clone();
        for place in &places {
            *kind.pointer_mut(place).expect("a place") = Value::from(0);
        }
        if kinds.contains_key(&kind.to_string()) {
            continue;
        }
        let mut variants = Vec::new();
        for place in &places {
            for number in NUMBERS.into_iter().flat_map(|number| [number, -number]) {
                let mut changed = whole.clone();
                *changed.pointer_mut(place).expect("a place") = Value::from(number);
                // What is out of range is no description.
                variants.extend(serde_json::from_value::<BrdfDescription>(changed).ok());
            }
        }
        assert!(variants.len() > places.len(), "{}", row.name);
        kinds.insert(kind.to_string(), variants);
    }
    kinds
}

#[test]
fn constants_at_the_ends_of_their_ranges_are_valid_text() {
    let mut count = 0;
    for description in at_ends().values().flatten() {
        let mut module = Module::new();
        // Nearest to an end, single precision may lie beyond it.
        if module.add_described("model", description).is_ok() {
            validate(&serde_json::to_string(description).expect("JSON"), &module.to_string());
            count += 1;
        }
    }
    println!("{count} descriptions");
    assert!(count > 500, "{count}");
}

#[test]
fn parameters_at_the_ends_of_their_ranges_are_harmless() {
    let Some(device) = Device::find() else { return };
    let questions = questions();
    let binding = Binding { group: 1, binding: 0 };
    let mut count = 0;
    for variants in at_ends().values() {
        // Whether a list of numbers is one number may differ: the text is that of the fields.
        let mut shaders: BTreeMap<String, Shader<'_>> = BTreeMap::new();
        for description in variants {
            let name = serde_json::to_string(description).expect("JSON");
            let mut module = Module::new();
            let uniforms = module.add_described_with("model", description, binding).expect(&name);
            let text = module.to_string();
            let shader = shaders.entry(text).or_insert_with_key(|text| Shader::new(&device, text));
            let answers = shader.ask(&questions, Some(&uniforms.bytes()));
            for (question, answered) in questions.iter().zip(&answers) {
                assert_sound(&name, question, answered);
            }
            count += 1;
        }
    }
    println!("{count} descriptions");
    assert!(count > 500, "{count}");
}
