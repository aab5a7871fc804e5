//! What the functions of a model answer to symbols.

use alloc::vec::Vec;

use super::expr::{Expr, ExprVec3};
use super::graph::input;
use super::simplify::component;
use super::value::{Value, Width};
use crate::brdf::{Brdf, Sample};
use crate::bsdf::{Bsdf, BsdfSample, TransportMode};

/// Answers to a pair of directions, and to a viewer and uniform numbers.
pub(super) struct Traced {
    pub(super) kind: Kind,
    pub(super) eval: ExprVec3,
    pub(super) pdf: Expr,
    pub(super) sample: Vec<(Value, Width)>,
}

/// What models of reflection and those over the whole sphere do not have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    Brdf,
    Bsdf,
}

impl Traced {
    pub(super) fn brdf<M: Brdf<Expr, Color = ExprVec3>>(model: &M) -> Self {
        let [wi, wo] = directions();
        let u = input("u".into(), Width::Two);
        let u = [0, 1].map(|place| Expr(component(u, place)));
        let (eval, pdf) = (model.eval(wi, wo), model.pdf(wi, wo));
        let Sample { wi, weight, pdf: density } = model.sample(wo, u);
        let sample = [(wi.0, Width::Three), (weight.0, Width::Three), (density.0, Width::One)];
        Self { kind: Kind::Brdf, eval, pdf, sample: sample.into() }
    }

    pub(super) fn bsdf<M>(model: &M, mode: TransportMode) -> Self
    where
        M: Bsdf<Expr, Color = ExprVec3>,
    {
        let [wi, wo] = directions();
        let u = input("u".into(), Width::Three);
        let u = [0, 1, 2].map(|place| Expr(component(u, place)));
        let (eval, pdf) = (model.eval(wi, wo, mode), model.pdf(wi, wo, mode));
        let BsdfSample { wi, weight, pdf: density, specular } = model.sample(wo, u, mode);
        let sample = [
            (wi.0, Width::Three),
            (weight.0, Width::Three),
            (density.0, Width::One),
            (specular.0, Width::One),
        ];
        Self { kind: Kind::Bsdf, eval, pdf, sample: sample.into() }
    }
}

fn directions() -> [ExprVec3; 2] {
    ["wi", "wo"].map(|name| ExprVec3(input(name.into(), Width::Three)))
}

impl Traced {
    /// All answers.
    pub(super) fn values(&self) -> impl Iterator<Item = Value> {
        [self.eval.0, self.pdf.0].into_iter().chain(self.sample.iter().map(|(value, _)| *value))
    }
}

impl Kind {
    /// What the structure of samples is called.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Brdf => "BrdfSample",
            Self::Bsdf => "BsdfSample",
        }
    }

    /// What its members are called.
    pub(super) const fn parts(self) -> &'static [&'static str] {
        match self {
            Self::Brdf => &["wi", "weight", "pdf"],
            Self::Bsdf => &["wi", "weight", "pdf", "specular"],
        }
    }

    /// The arguments of `sample`.
    pub(super) const fn arguments(self) -> &'static str {
        match self {
            Self::Brdf => "wo: vec3<f32>, u: vec2<f32>",
            Self::Bsdf => "wo: vec3<f32>, u: vec3<f32>",
        }
    }

    /// What `sample` does.
    pub(super) const fn comment(self) -> &'static str {
        match self {
            Self::Brdf => {
                "A direction towards the light for wo, from two uniform numbers in 0 .. 1."
            }
            Self::Bsdf => {
                "A direction towards the light for wo, from three uniform numbers in 0 .. 1: the \
                 third chooses the event."
            }
        }
    }

    /// The structure of samples.
    pub(super) const fn structure(self) -> &'static str {
        match self {
            Self::Brdf => {
                "
struct BrdfSample {
    // Towards the light.
    wi: vec3<f32>,
    // f cos/pdf; zero where there is no direction.
    weight: vec3<f32>,
    // Per steradian.
    pdf: f32,
}
"
            }
            Self::Bsdf => {
                "
struct BsdfSample {
    // Where the path goes on.
    wi: vec3<f32>,
    // f |cos|/pdf, or the weight of a lobe over its probability; zero where there is no direction.
    weight: vec3<f32>,
    // Per steradian; zero of a lobe.
    pdf: f32,
    // Whether a specular lobe was drawn.
    specular: bool,
}
"
            }
        }
    }
}
