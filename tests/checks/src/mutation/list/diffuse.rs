//! Bugs of the diffuse models, their sampler and the sum of models.

use super::super::mutant::{LEFT, MINUS, Mutant, ONE, PLUS, RIGHT};
use crate::faulty::Operation::{Add, Div, Literal, Max, Mul, SinCosTurns, Sqrt, Squared, Sub};

const LAMBERT: &str = "src/diffuse/lambert.rs";
const OREN_NAYAR: &str = "src/diffuse/oren_nayar.rs";
const SAMPLING: &str = "src/sampling.rs";
const SUM: &str = "src/sum/weighted.rs";
const TERMS: &str = "src/sum/terms.rs";

#[rustfmt::skip]
pub(super) static MUTANTS: [Mutant; 18] = [
    Mutant::new("Lambert", "f without 1/π", LAMBERT,
        "(self.albedo * ▸T::lit(FRAC_1_PI)).only_where(above)", Literal, ONE),
    Mutant::new("Lambert", "density without the cosine", LAMBERT,
        "▸(wi.z() * T::lit(FRAC_1_PI)).only_where(above)", Mul, RIGHT),
    Mutant::new("Lambert", "density of a sample with the cosine twice", LAMBERT,
        "pdf: ▸wi.z() * T::lit(FRAC_1_PI) }", Mul, |left, _, result| left * result),
    Mutant::new("Lambert", "samples crowd at the normal: the radius without its root", SAMPLING,
        "let radius = radius_squared.▸sqrt();", Sqrt, LEFT),
    Mutant::new("Lambert", "samples in one half of the azimuths: π for 2π", SAMPLING,
        "let radius = radius_squared.sqrt();\n    let (sin, cos) = turn.▸sin_cos_turns()", SinCosTurns, |turns, _, _| 0.5 * turns),
    Mutant::new("Oren–Nayar", "f without 1/π", OREN_NAYAR,
        "let value = ▸T::lit(FRAC_1_PI) * self.relative(wi, wo);", Literal, ONE),
    Mutant::new("Oren–Nayar", "σ for σ²", OREN_NAYAR,
        "let variance = sigma.▸squared();", Squared, LEFT),
    Mutant::new("Oren–Nayar", "sign of A: 1 + 0.5 σ²/(σ² + 0.33)", OREN_NAYAR,
        "a: T = ▸T::one() - T::lit(0.5)", Sub, PLUS),
    Mutant::new("Oren–Nayar", "0.33 where 0.57 stands for interreflection", OREN_NAYAR,
        "let offset = ▸T::lit(if interreflection", Literal, |_, _, _| 0.33),
    Mutant::new("Oren–Nayar", "0.5 for 0.45 in B", OREN_NAYAR,
        "b: T = ▸T::lit(0.45)", Literal, |_, _, _| 0.5),
    Mutant::new("Oren–Nayar", "cosΔφ may be negative", OREN_NAYAR,
        "(across.▸max(T::zero()) / cos_theta_2)", Max, LEFT),
    Mutant::new("Oren–Nayar", "tan of the larger angle, sin of the smaller", OREN_NAYAR,
        "let cos_theta_2 = wi.z().▸max(wo.z());", Max, |left, right, _| left.min(right)),
    Mutant::new("Oren–Nayar", "cosΔφ with the wrong sign of y", OREN_NAYAR,
        "let across = ▸wi.x() * wo.x() + wi.y() * wo.y();", Add, MINUS),
    Mutant::new("weighted sum", "weights left out of f", SUM,
        "sum + ▸term.weight * color(&term.model)", Mul, RIGHT),
    Mutant::new("weighted sum", "density without the probability of the term", SUM,
        "sum + ▸term.probability * term.model.pdf(wi, wo)", Mul, RIGHT),
    Mutant::new("weighted sum", "u₀ used again without taking off the start of the term", TERMS,
        "let stretched = ▸(u - start)", Sub, LEFT),
    Mutant::new("weighted sum", "u₀ used again without being stretched", TERMS,
        "let stretched = ▸(u - start) / T::select", Div, LEFT),
    Mutant::new("weighted sum", "probabilities do not add up to 1", SUM,
        "term.probability = ▸term.probability / total;", Div, LEFT),
];
