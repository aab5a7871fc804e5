//! Bugs of the lobes of Phong, Blinn and Schlick, and of directions.

use std::f64::consts::FRAC_PI_2;

use super::super::mutant::{LEFT, MINUS, Mutant, NEGATIVE, ONE, PLUS, TURNED};
use crate::faulty::Operation::{Add, Atan2, Div, Literal, Mul, SinCosTurns, Sub};

const PHONG: &str = "src/glossy/phong.rs";
const CLASSIC: &str = "src/glossy/classic_phong.rs";
const BLINN_PHONG: &str = "src/glossy/blinn_phong.rs";
const SCHLICK: &str = "src/glossy/schlick_power.rs";
const MIRROR: &str = "src/glossy/mirror.rs";
const FRAME: &str = "src/frame.rs";
const DIRECTION: &str = "src/direction.rs";

#[rustfmt::skip]
pub(super) static MUTANTS: [Mutant; 22] = [
    Mutant::new("Phong", "n + 1 for n + 2 in f", PHONG,
        "let constant = (self.exponent + ▸T::lit(2.0)) * T::lit(0.5 * FRAC_1_PI);", Literal, ONE),
    Mutant::new("Phong", "weight without the cosine", PHONG,
        "▸(ratio * wi.z())", Mul, LEFT),
    Mutant::new("Phong", "weight with the cosine twice", PHONG,
        "▸(ratio * wi.z())", Mul, |_, right, result| result * right),
    Mutant::new("Phong", "samples of the power n + 1", MIRROR,
        "-(ln_of_rest(u) / (exponent + ▸T::one())).exp_m1()", Literal, |_, _, _| 2.0),
    Mutant::new("Phong", "samples in one half of the azimuths: π for 2π", MIRROR,
        "turn.▸sin_cos_turns();", SinCosTurns, |turns, _, _| 0.5 * turns),
    Mutant::new("Phong", "mirror direction on the wrong side", MIRROR,
        "▸wi.z() - wo.z());", Sub, PLUS),
    Mutant::new("classic Phong", "an intensity taken for a BRDF: not divided by the cosine", CLASSIC,
        "let value = ▸(power / cos)", Div, LEFT),
    Mutant::new("classic Phong", "n for n + 1 in the density", CLASSIC,
        "let constant = (self.exponent + ▸T::one()) * T::lit(0.5 * FRAC_1_PI);", Literal, |_, _, _| 0.0),
    Mutant::new("Blinn–Phong", "the popular constant (n + 8)/(8π)", BLINN_PHONG,
        "let integral = ▸(exponent * T::lit(-0.5 * LN_2)).exp() + exponent;", Add,
        |_, n, _| (n + 2.0) * (n + 4.0) / (n + 8.0)),
    Mutant::new("Blinn–Phong", "density without the Jacobian 1/(V·H)", BLINN_PHONG,
        "density * halfway.power(self.exponent) * ▸(halfway.height / whole);", Div, LEFT),
    Mutant::new("Blinn–Phong", "density of half vectors without the cosine", BLINN_PHONG,
        "let value = ▸density * halfway.power(self.exponent) * (halfway.height / whole);", Mul, LEFT).link(1),
    Mutant::new("Blinn–Phong", "half vectors of the power n", BLINN_PHONG,
        "let versine = -(ln_of_rest(u) / ▸(self.exponent + two)).exp_m1();", Add, LEFT),
    Mutant::new("Schlick's power", "sign in S/(h − hS + S)", SCHLICK,
        "cos / ▸(self.exponent * versine + cos)", Add, MINUS),
    Mutant::new("Schlick's power", "constant without 1/π", SCHLICK,
        "{ ▸T::lit(FRAC_1_PI) / twice_j }", Literal, ONE),
    Mutant::new("directions", "bitangent with the wrong sign", FRAME,
        "let b = ▸n.x() * n.y() * a;", Mul, NEGATIVE).link(1),
    Mutant::new("directions", "half vector not normalised", DIRECTION,
        "let h = ▸sum * (T::one() / length);", Mul, LEFT),
    Mutant::new("directions", "V·H twice as large", DIRECTION,
        "let cos_d = ▸length * T::lit(0.5);", Mul, LEFT),
    Mutant::new("directions", "sign of R = 2N(N·L) − L", DIRECTION,
        "    ▸normal * (Vector::dot(w, normal) * T::lit(2.0)) - w\n", Sub, PLUS),
    Mutant::new("directions", "sign of the root in the refracted direction", DIRECTION,
        "facing * ▸(n12 * cos.abs() - cos_t)", Sub, PLUS),
    Mutant::new("directions", "n₂/n₁ for n₁/n₂ in Snell's law", DIRECTION,
        "T::select(from_below, eta_below / eta_above, ▸eta_above / eta_below)", Div, TURNED),
    Mutant::new("directions", "cotangent for tangent of Brewster's angle", DIRECTION,
        "    n2.▸atan2(n1)\n", Atan2, |_, _, result| FRAC_PI_2 - result),
    Mutant::new("Phong", "a sample off the mirror direction by twice its versine", MIRROR,
        "let sin = ▸(versine * (T::lit(2.0) - versine)).max(T::zero()).sqrt();\n    let (sin_phi", Mul,
        |_, _, result| 2.0 * result),
];
