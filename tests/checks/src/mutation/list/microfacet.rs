//! Bugs of distributions, shadowing and what is made of them.

use std::f64::consts::{LN_2, PI, SQRT_2};

use super::super::mutant::{LEFT, MINUS, Mutant, ONE, PLUS, RIGHT};
use crate::faulty::Operation::{
    Add, AngleSquared, Div, Literal, Max, Min, Mul, Neg, SinCosTurns, Sqrt, Squared, Sub, X,
};

const BECKMANN: &str = "src/distribution/beckmann.rs";
const BLINN: &str = "src/distribution/blinn.rs";
const BLINN_1977: &str = "src/distribution/blinn_1977.rs";
const GAUSSIAN: &str = "src/distribution/gaussian.rs";
const TILTS: &str = "src/distribution/gaussian_tilts.rs";
const GGX: &str = "src/distribution/ggx.rs";
const GROOVES: &str = "src/microfacet/groove_azimuth.rs";
const HISTORICAL: &str = "src/microfacet/historical.rs";
const IERFC: &str = "src/real/math/ierfc.rs";
const MEAN_MAGNITUDE: &str = "src/real/math/mean_magnitude.rs";
const MIXTURE: &str = "src/distribution/mixture.rs";
const ROUGHNESS: &str = "src/distribution/roughness.rs";
const SHADOWING: &str = "src/microfacet/shadowing.rs";
const SLOPES: &str = "src/distribution/normal_slopes.rs";
const SMITH: &str = "src/microfacet/smith.rs";
const V_CAVITY: &str = "src/microfacet/v_cavity.rs";

#[rustfmt::skip]
pub(super) static MUTANTS: [Mutant; 39] = [
    Mutant::new("Beckmann", "α for α² in the peak", ROUGHNESS,
        "inverse_area: one / ▸(T::lit(PI) * along[0] * along[1])", Mul, LEFT),
    Mutant::new("Beckmann", "D without 1/π", ROUGHNESS,
        "inverse_area: one / (▸T::lit(PI) * along[0] * along[1])", Literal, ONE),
    Mutant::new("Beckmann", "the constant of the print, 4 for π", ROUGHNESS,
        "inverse_area: one / (▸T::lit(PI) * along[0] * along[1])", Literal, |_, _, _| 4.0),
    Mutant::new("Beckmann", "cos²α for cos⁴α", BECKMANN,
        "inverse_cos_squared.▸squared() * inverse_area", Squared, LEFT),
    Mutant::new("Beckmann", "Λ without ½", BECKMANN,
        "(▸T::lit(0.5) * alpha_sin * ierfc(cos / alpha_sin))", Literal, ONE),
    Mutant::new("Beckmann", "Λ without e^(−ν²)", IERFC,
        "    ▸(-x.squared()).exp() * polynomial(x) /", Mul, RIGHT),
    Mutant::new("Beckmann", "half of what faces away in the projected area", MEAN_MAGNITUDE,
        "    ▸z + square * inverse * (z * inverse).ierfc()", Add, |z, away, _| z + 0.5 * away),
    Mutant::new("Beckmann", "sign in the equation of the visible slope", SLOPES,
        "        ▸missing + (T::select", Add, MINUS),
    Mutant::new("Beckmann", "tan²α drawn for tanα", SLOPES,
        "let tan = tan_squared.min(T::lit(40.0)).▸sqrt();", Sqrt, LEFT),
    Mutant::new("Beckmann", "visible slopes turned the wrong way", SLOPES,
        "T::select(tilted, ▸along * cos_phi - across * sin_phi, x)", Sub, PLUS),
    Mutant::new("GGX", "power 1 for 2", GGX,
        "quotient.▸squared()", Squared, LEFT),
    Mutant::new("GGX", "the axes of an anisotropic surface exchanged", ROUGHNESS,
        "h.▸x().squared() * self.inverse[0].squared()", X, LEFT),
    Mutant::new("GGX", "sign of the root in Λ", GGX,
        "let sum = ▸((cos.squared() + alpha_sin_squared).sqrt() + cos)", Add, MINUS),
    Mutant::new("GGX", "visible normals: the cap without its root", GGX,
        "let sin = (below_top * (above_rim + one_minus_s_z)).▸sqrt();", Sqrt, LEFT),
    Mutant::new("GGX", "visible normals in one half of the azimuths: π for 2π", GGX,
        "let sin = (below_top * (above_rim + one_minus_s_z)).sqrt();\n        let (sin_phi, cos_phi) = turn.▸sin_cos_turns();", SinCosTurns, |turns, _, _| 0.5 * turns),
    Mutant::new("GGX", "stretched viewer not normalised", GGX,
        "Vector::length_squared(stretched).▸sqrt()", Sqrt, ONE),
    Mutant::new("Gaussian", "the constant 1/(π m²), right for small m only: sin 2α/(2α) taken for 1", TILTS,
        "first = ▸T::lit(SINE[k])", Literal, |coefficient, _, _| f64::from(u8::from(coefficient == 1.0))),
    Mutant::new("Gaussian", "constant without 1/π", GAUSSIAN,
        "c: T = ▸T::lit(4.0 / (PI * PI * PI))", Literal, |_, _, _| 4.0 / (PI * PI)),
    Mutant::new("Gaussian", "sin²α for α²", GAUSSIAN,
        "let exponent = versine.at_most(one).▸angle_squared()", AngleSquared, |versine, _, _| versine * (2.0 - versine)),
    Mutant::new("Gaussian", "samples from beyond the horizon", TILTS,
        "let more = ▸exponential * (self.front - sum) - self.beyond;", Sub, LEFT),
    Mutant::new("Blinn", "n + 1 for n + 2 in D", BLINN,
        "let peak = (self.exponent + ▸T::lit(2.0)) * T::lit(0.5 * FRAC_1_PI);", Literal, ONE),
    Mutant::new("Blinn", "samples of the power n", BLINN,
        "let ln_cos = ln_of_rest(u) / (self.exponent + ▸T::lit(2.0));", Literal, ONE),
    Mutant::new("Blinn 1977", "c₁ of half the width", BLINN_1977,
        "c1: T = ▸T::lit(2.0 * LN_2)", Literal, |_, _, _| LN_2),
    Mutant::new("Blinn 1977", "sign of √2 in c₃", BLINN_1977,
        "c3_squared: T = sin_squared / (▸T::lit(SQRT_2 - 1.0)", Literal, |_, _, _| SQRT_2 + 1.0),
    Mutant::new("Blinn 1977", "printed model without the 4", HISTORICAL,
        "let scale = ▸T::lit(4.0) / distribution.density(normal);", Literal, ONE),
    Mutant::new("mixture", "drawn by weight, whether visible or not", MIXTURE,
        "weight * ▸((self.cos + lambda_cos) / self.all)", Div, ONE),
    Mutant::new("V-cavity", "f without ¼", V_CAVITY,
        "let denominator = larger * (smaller * pair.cos_h).max(half_cos_d(pair));\n        (▸T::lit(0.25)", Literal, ONE),
    Mutant::new("V-cavity", "density without the Jacobian's ¼", V_CAVITY,
        "let denominator = (pair.cos_o * pair.cos_h).max(half_cos_d(pair));\n        (▸T::lit(0.25)", Literal, ONE),
    Mutant::new("V-cavity", "γ without the 2", V_CAVITY,
        "pair.cos_d * ▸T::lit(0.5)", Literal, ONE),
    Mutant::new("V-cavity", "the larger of masking and shadowing", V_CAVITY,
        "let denominator = larger * (smaller * pair.cos_h).▸max(half_cos_d(pair));", Max,
        |left, right, _| left.min(right)),
    Mutant::new("V-cavity", "sign in Kepler's equation", GROOVES,
        "        ▸x - self.a * sin + self.b * versine - self.target", Sub, PLUS),
    Mutant::new("V-cavity", "azimuth counted from the front", GROOVES,
        "let (cos_behind, sin_behind) = (▸-cos_first, sin_first * side);", Neg, LEFT),
    Mutant::new("Smith", "f without ½", SMITH,
        "(▸T::lit(0.5) / (pair.cos_o * area_i + pair.cos_i * area_o))", Literal, ONE),
    Mutant::new("Smith", "density without the ½", SMITH,
        "(▸T::lit(0.5) / (pair.cos_o + area_o))", Literal, ONE),
    Mutant::new("Smith", "shadowing without masking", SMITH,
        "(T::lit(0.5) / ▸(pair.cos_o * area_i + pair.cos_i * area_o))", Add, LEFT),
    Mutant::new("Smith", "the larger of the two areas, not the sum", SMITH,
        "(T::lit(0.5) / ▸(pair.cos_o * area_i + pair.cos_i * area_o))", Add, |left, right, _| left.max(right)),
    Mutant::new("Cook–Torrance", "Fresnel's term at the angle between L and V", SHADOWING,
        "    pair.cos_d.▸at_most(T::one())", Min,
        |left, _, _| (2.0 * left * left - 1.0).abs()),
    Mutant::new("Cook–Torrance", "π for the 4 by which the print of 1982 is too bright", HISTORICAL,
        "Self::of(CookTorrance::from_parts(distribution, fresnel, VCavity), ▸T::lit(4.0))", Literal, |_, _, _| PI),
    Mutant::new("Cook–Torrance", "degrees taken for radians in the Gaussian of 1967", HISTORICAL,
        "Gaussian::new(▸T::lit(PI / 180.0) / c)", Literal, ONE),
];
