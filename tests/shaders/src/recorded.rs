//! What a device answered, as a model.

use std::collections::HashMap;

use brdf::{Brdf, Sample};
use glam::Vec3;

use crate::device::{Compiled, Device, Program};

/// A pair of directions, a viewer's two uniform numbers.
#[derive(Clone, Copy, Debug)]
pub struct Question {
    pub wi: Vec3,
    pub wo: Vec3,
    pub u: [f32; 2],
}

/// What the shader of a model answers to a question.
#[derive(Clone, Copy, Debug)]
pub struct Answered {
    pub value: Vec3,
    pub pdf: f32,
    pub sample: Sample<f32, Vec3>,
}

/// The functions of a model `model` on a device.
pub struct Shader<'a>(Compiled<'a>);

/// What runs for each question.
pub const STATEMENTS: &str = "
    let wi = vec3(given[at], given[at + 1u], given[at + 2u]);
    let wo = vec3(given[at + 3u], given[at + 4u], given[at + 5u]);
    let u = vec2(given[at + 6u], given[at + 7u]);
    let value = model_eval(wi, wo);
    let drawn = model_sample(wo, u);
    for (var i = 0u; i < 3u; i++) {
        answers[to + i] = value[i];
        answers[to + 4u + i] = drawn.wi[i];
        answers[to + 7u + i] = drawn.weight[i];
    }
    answers[to + 3u] = model_pdf(wi, wo);
    answers[to + 10u] = drawn.pdf;";

/// The program that answers questions about the model of a module.
pub const fn program(text: &str) -> Program<'_> {
    Program { text, statements: STATEMENTS, inputs: 8, outputs: 11 }
}

impl<'a> Shader<'a> {
    pub fn new(device: &'a Device, text: &str) -> Self {
        Self(device.compile(&program(text)))
    }

    pub fn ask(&self, questions: &[Question], uniforms: Option<&[u8]>) -> Vec<Answered> {
        let given: Vec<f32> = questions
            .iter()
            .flat_map(|Question { wi, wo, u }| [wi.x, wi.y, wi.z, wo.x, wo.y, wo.z, u[0], u[1]])
            .collect();
        let answers = self.0.run(&given, uniforms);
        let answered = |it: &[f32]| Answered {
            value: Vec3::from_slice(&it[0..3]),
            pdf: it[3],
            sample: Sample {
                wi: Vec3::from_slice(&it[4..7]),
                weight: Vec3::from_slice(&it[7..10]),
                pdf: it[10],
            },
        };
        answers.chunks_exact(11).map(answered).collect()
    }
}

/// A model that knows the answers to some pairs. It draws no direction: samples are compared one by one.
pub struct Recorded(HashMap<[u32; 6], Answered>);

fn key(wi: Vec3, wo: Vec3) -> [u32; 6] {
    [wi.x, wi.y, wi.z, wo.x, wo.y, wo.z].map(f32::to_bits)
}

impl Answered {
    /// All numbers.
    pub fn numbers(&self) -> [f32; 11] {
        let Self { value, pdf, sample } = self;
        let (wi, weight) = (sample.wi, sample.weight);
        [
            value.x, value.y, value.z, *pdf, wi.x, wi.y, wi.z, weight.x, weight.y, weight.z,
            sample.pdf,
        ]
    }
}

impl Recorded {
    pub fn new(questions: &[Question], answers: &[Answered]) -> Self {
        let keys = questions.iter().map(|question| key(question.wi, question.wo));
        Self(keys.zip(answers.iter().copied()).collect())
    }
}

impl Brdf for Recorded {
    type Color = Vec3;
    fn eval(&self, wi: Vec3, wo: Vec3) -> Vec3 {
        self.0[&key(wi, wo)].value
    }
    fn pdf(&self, wi: Vec3, wo: Vec3) -> f32 {
        self.0[&key(wi, wo)].pdf
    }
    fn sample(&self, wo: Vec3, _: [f32; 2]) -> Sample<f32, Vec3> {
        Sample { wi: wo, weight: Vec3::ZERO, pdf: 0.0 }
    }
}
