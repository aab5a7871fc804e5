//! Bugs of Fresnel's equations and their stand-ins.

use super::super::mutant::{LEFT, MINUS, Mutant, NEGATIVE, NOT, PLUS};
use crate::faulty::Operation::{Add, Less, Literal, Mul, Select, Sub};

const DIELECTRIC: &str = "src/fresnel/dielectric.rs";
const CONDUCTOR: &str = "src/fresnel/conductor.rs";
const FORMS: &str = "src/fresnel/forms.rs";
const INTERPOLATION: &str = "src/fresnel/interpolation.rs";
const NORMAL: &str = "src/fresnel/normal_incidence.rs";
const SCHLICK: &str = "src/fresnel/schlick.rs";

#[rustfmt::skip]
pub(super) static MUTANTS: [Mutant; 19] = [
    Mutant::new("Dielectric", "index swapped: 1/n for n", DIELECTRIC,
        "let from_below = cos_theta.▸lt(zero);", Less, NOT),
    Mutant::new("Dielectric", "s-polarised light only", DIELECTRIC,
        "let squares = ▸self.cosines.squared() + self.sines.squared();", Add,
        |left, right, _| (left.sqrt() + right.sqrt()).powi(2)),
    Mutant::new("Dielectric", "R_p = R_s: sign of the sines", DIELECTRIC,
        "let ratio = ▸(cosines - self.sines)", Sub, PLUS),
    Mutant::new("Dielectric", "sign under the root of Snell's law", DIELECTRIC,
        "            ▸difference + cos_squared,", Add, MINUS),
    Mutant::new("Dielectric", "average of half the flux", DIELECTRIC,
        "let p = rho * one_minus_rho * ▸T::lit(0.5)", Literal, |_, _, _| 0.25),
    Mutant::new("Conductor", "sign of k² in n² − k² − 1", CONDUCTOR,
        "(eta - one) * (eta + one) - ▸k * k, squared - one);", Mul, NEGATIVE),
    Mutant::new("Conductor", "2 n²k² for 4 n²k²", CONDUCTOR,
        "let product = ▸T::lit(2.0) * eta * k;", Literal, |_, _, _| std::f64::consts::SQRT_2),
    Mutant::new("Conductor", "R_p = R_s: sin² left out", CONDUCTOR,
        "let real = ▸self.cos * a - self.sin_squared;", Sub, PLUS),
    Mutant::new("Conductor", "average without the 2 of 2 ∫ R μ dμ", CONDUCTOR,
        "▸(integral * T::lit(4.0)).at_most(one)", Mul, |left, _, _| 2.0 * left),
    Mutant::new("Conductor", "reflectance at normal incidence without k", NORMAL,
        "    ▸((eta - one).squared() + k_squared) /", Add, LEFT),
    Mutant::new("Dielectric", "sign in the index from normal incidence", NORMAL,
        "(one + r0.sqrt()).squared() / ▸(one - r0)", Sub, PLUS),
    Mutant::new("printed forms", "[c(g − c) − 1]², as printed", FORMS,
        "▸(c * (g - c) + one)", Add, MINUS),
    Mutant::new("printed forms", "sign in the form with a, b, u", FORMS,
        "(▸(u * (a - u) + one).squared() + bu_squared)", Add, MINUS),
    Mutant::new("Schlick", "power 4 for 5", SCHLICK,
        "let weight = ▸versine.squared().squared() * versine;", Mul, LEFT),
    Mutant::new("Schlick", "F₀ + (1 − u)⁵ without the factor 1 − F₀", SCHLICK,
        "f0 + ▸(one - f0) * weight", Sub, LEFT),
    Mutant::new("Schlick", "average of the power 4", SCHLICK,
        "▸T::lit(1.0 / 21.0)", Literal, |_, _, _| 1.0 / 15.0),
    Mutant::new("Hall and Cook", "a reference that dips darkens", INTERPOLATION,
        "let rise = rise.▸only_where(rise.ge(zero));", Select, LEFT),
    Mutant::new("Hall and Cook", "no room left by F₀", INTERPOLATION,
        "f0 + ▸(one - f0) * weight", Sub, LEFT),
    Mutant::new("Hall and Cook", "Cook's light forgotten", INTERPOLATION,
        "        ▸self.reflectance.reflectance(cos_theta) * self.light", Mul, LEFT),
];
