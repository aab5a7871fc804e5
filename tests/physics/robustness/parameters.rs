//! Models at the ends of the ranges of their parameters.
//!
//! The largest weight of a sample is known for each: of a microfacet surface it is the largest
//! reflectance of a facet, of a lobe it follows from the ratio of the lobe to the density.

use std::f64::consts::{PI, TAU};

use brdf::{
    AnyBrdf, AnyFresnel, AnyMixture, Beckmann, Blinn, Blinn1977, Blinn1977Printed, BlinnPhong,
    Brdf, ClassicPhong, Conductor, Constant, Cook, CookTorrance, CookTorrance1982Printed,
    Dielectric, Distribution, Gaussian, Ggx, Hall, Lambert, OrenNayar, ParameterError, Phong, Real,
    Schlick, SchlickPower, SmithCorrelated, SmithSeparable, Vector, WeightedSum,
};

use super::inputs::{UNIFORMS, directions};
use brdf_checks::models::{Compiled, Model};
use brdf_checks::sound::assert_sound;

/// A model, and the largest weight of its samples for the two cosines.
struct Case<T: Real> {
    name: String,
    model: Box<Model<T>>,
    largest_weight: Box<dyn Fn(f64, f64) -> f64>,
}

impl<T: Compiled> Case<T> {
    fn new(name: String, largest_weight: f64, model: impl Into<AnyBrdf<T>>) -> Self {
        let model = T::object(model.into());
        Self { name, model, largest_weight: Box::new(move |_, _| largest_weight) }
    }
}

fn gray<T: Real>(value: f64) -> T::Vec3 {
    Vector::new(T::lit(value), T::lit(value), T::lit(value))
}

const EXPONENTS: [f64; 10] = [0.0, 5e-324, 1e-40, 1e-8, 0.5, 0.9999999, 1.0, 1.0000001, 1e4, 1e8];
const ROUGHNESS: [f64; 8] = [1e-8, 1e-6, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e4];

fn lobes<T: Compiled + Into<f64>>() -> Result<Vec<Case<T>>, ParameterError> {
    let mut cases = Vec::new();
    let lit = T::lit;
    for color in [0.0, 5e-324, 1e-40, 1.0] {
        cases.push(Case::new(
            format!("Lambert {color}"),
            color.max(1e-40),
            Lambert::new(gray::<T>(color))?,
        ));
        for n in EXPONENTS {
            // With a color of one, a value at the normal is the constant of the lobe.
            let name = |lobe: &str| format!("{lobe} of {color}, exponent {n}");
            let specular = gray::<T>(color);
            let k = color.max(1e-40);
            cases.push(Case::new(
                name("Phong"),
                k * (n + 2.0) / (n + 1.0),
                Phong::new(specular, lit(n))?,
            ));
            cases.push(Case::new(
                name("classic Phong"),
                k * TAU / (n + 1.0),
                ClassicPhong::new(specular, lit(n))?,
            ));
            // (V·H)(N·L)/(N·H) ≤ 2, as N·L ≤ 2 (V·H)(N·H).
            let constant = (n + 2.0) * (n + 4.0) / (8.0 * PI * ((-0.5 * n).exp2() + n));
            for (name, constant, model) in [
                (name("Blinn-Phong"), constant, BlinnPhong::new(specular, lit(n))?),
                (name("classic Blinn-Phong"), 1.0, BlinnPhong::unnormalized(specular, lit(n))?),
            ] {
                cases.push(Case::new(name, k * 16.0 * PI * constant / (n + 2.0), model));
            }
            // ∫ of the density's shape: ln h/(h − 1), and 1 below an exponent of 1.
            let integral = if n > 1.0 { n.ln() / (n - 1.0) } else { 1.0 };
            let normal = <T::Vec3 as Vector<T>>::new(lit(0.0), lit(0.0), lit(1.0));
            let peak = SchlickPower::new(gray::<T>(1.0), lit(n))?.eval(normal, normal);
            for (name, constant, model) in [
                (name("Schlick"), peak.x().into(), SchlickPower::new(specular, lit(n))?),
                (name("classic Schlick"), 1.0, SchlickPower::unnormalized(specular, lit(n))?),
            ] {
                cases.push(Case::new(name, k * TAU * constant * integral, model));
            }
        }
    }
    for sigma in [0.0, 5e-324, 1e-40, 1e-8, 0.3, 1.5, PI / 2.0] {
        let model = OrenNayar::new(gray::<T>(1.0), lit(sigma))?;
        let b = 0.45 * sigma * sigma / (sigma * sigma + 0.09);
        cases.push(Case {
            name: format!("Oren-Nayar {sigma}"),
            model: T::object(model.into()),
            largest_weight: Box::new(move |cos_i, cos_o| 1.0 + b / cos_i.max(cos_o)),
        });
    }
    Ok(cases)
}

/// Fresnel terms, with the largest reflectance where it is above 1.
fn terms<T: Real>() -> Result<Vec<(String, f64, AnyFresnel<T>)>, ParameterError> {
    let mut terms: Vec<(String, f64, AnyFresnel<T>)> = Vec::new();
    for reflectance in [0.0, 1e-40, 1.0] {
        terms.push((
            format!("constant {reflectance}"),
            1.0,
            Constant::new(gray::<T>(reflectance))?.into(),
        ));
        terms.push((
            format!("Schlick {reflectance}"),
            1.0,
            Schlick::new(gray::<T>(reflectance))?.into(),
        ));
    }
    let (below, above) = (1.0 - f64::from(f32::EPSILON), 1.0 + f64::from(f32::EPSILON));
    for n in [1e-4, 1e-3, below, 1.0, above, 100.0, 1e4] {
        terms.push((format!("dielectric {n}"), 1.0, Dielectric::new(gray::<T>(n))?.into()));
        for k in [0.0, 1e-40, 1e-8, 1e3, 1e4] {
            let conductor = Conductor::new(gray::<T>(n), gray::<T>(k))?;
            terms.push((format!("conductor {n} {k}"), 1.0, conductor.into()));
        }
        terms.push((format!("Hall {n}"), 1.0, Hall::new(gray::<T>(0.1), T::lit(n))?.into()));
        for light in [1e-40, 1e10] {
            let cook = Cook::new(gray::<T>(1.0), gray::<T>(light), T::lit(n))?;
            terms.push((format!("Cook {n} {light}"), light, cook.into()));
        }
    }
    Ok(terms)
}

fn microfacets<T: Compiled + Into<f64>>() -> Result<Vec<Case<T>>, ParameterError> {
    let mut cases = Vec::new();
    let lit = T::lit;
    let white = || Constant::new(gray::<T>(1.0));
    for (x, y) in ROUGHNESS.into_iter().flat_map(|x| ROUGHNESS.map(|y| (x, y))) {
        let beckmann = Beckmann::anisotropic(lit(x), lit(y))?;
        let ggx = Ggx::anisotropic(lit(x), lit(y))?;
        macro_rules! surface {
            ($name:literal, $distribution:ident) => {
                let surface = CookTorrance::new($distribution, white()?);
                let name = |shadowing: &str| format!("{} {x} {y}, {shadowing}", $name);
                cases.push(Case::new(name("V-cavity"), 1.0, surface));
                cases.push(Case::new(name("Smith"), 1.0, surface.with_shadowing(SmithCorrelated)));
                let separable = surface.with_shadowing(SmithSeparable);
                cases.push(Case::new(name("Smith separable"), 1.0, separable));
            };
        }
        surface!("Beckmann", beckmann);
        surface!("GGX", ggx);
        cases.push(Case::new(
            format!("printed Cook-Torrance {x} {y}"),
            4.0,
            CookTorrance1982Printed::new(beckmann, white()?),
        ));
        for weight in [0.0, 1e-29, 1e-10, 1.0, 1e10] {
            let terms = [(lit(weight), ggx.into()), (lit(1e-29), Ggx::new(lit(x))?.into())];
            cases.push(Case::new(
                format!("mixture of GGX {x} {y}, weight {weight}"),
                1.0,
                CookTorrance::new(AnyMixture::new(terms)?, white()?)
                    .with_shadowing(SmithCorrelated),
            ));
        }
    }
    for roughness in ROUGHNESS {
        let surface = CookTorrance::new(Gaussian::new(lit(roughness))?, white()?);
        cases.push(Case::new(format!("Gaussian {roughness}"), 1.0, surface));
    }
    for n in EXPONENTS {
        let surface = CookTorrance::new(Blinn::new(lit(n))?, white()?);
        cases.push(Case::new(format!("Blinn {n}"), 1.0, surface));
    }
    for c in [1e-5, 1.0, 1e5] {
        let surface = CookTorrance::torrance_sparrow_1967(lit(c), white()?)?;
        cases.push(Case::new(format!("Torrance-Sparrow {c}"), 1.0, surface));
    }
    for beta in [2e-4, 0.1, 1.57] {
        let blinn = Blinn1977::new(lit(beta))?;
        let normal = <T::Vec3 as Vector<T>>::new(lit(0.0), lit(0.0), lit(1.0));
        let over_peak = |distribution: &dyn Distribution<T>| -> f64 {
            4.0 / distribution.density(normal).into()
        };
        let name = |number: u8| format!("printed Blinn D{number}, {beta}");
        let d1 = over_peak(&Blinn::new(blinn.c1())?);
        cases.push(Case::new(name(1), d1, Blinn1977Printed::d1(blinn, white()?)?));
        let d2 = over_peak(&Gaussian::new(lit(1.0) / blinn.c2())?);
        cases.push(Case::new(name(2), d2, Blinn1977Printed::d2(blinn, white()?)?));
        let d3 = over_peak(&Ggx::new(blinn.c3())?);
        cases.push(Case::new(name(3), d3, Blinn1977Printed::d3(blinn, white()?)?));
    }
    // The terms on a surface whose peak, times a light of 10¹⁰, leaves the range of an f32.
    for (name, largest, term) in terms::<T>()? {
        let surface = CookTorrance::new(Ggx::anisotropic(lit(1e-8), lit(0.1))?, term);
        cases.push(Case::new(format!("GGX 1e-8 0.1, {name}"), largest.max(1e-40), surface));
    }
    Ok(cases)
}

fn sums<T: Compiled + Into<f64>>() -> Result<Vec<Case<T>>, ParameterError> {
    let mut cases = Vec::new();
    let narrow = || {
        let mirror = CookTorrance::new(Ggx::new(T::lit(1e-8))?, Constant::new(gray::<T>(1.0))?);
        Ok(AnyBrdf::from(mirror))
    };
    for weight in [0.0, 1e-29, 1e-8, 1.0, 1e10] {
        let diffuse = AnyBrdf::from(Lambert::new(gray::<T>(1.0))?);
        let sum = WeightedSum::new([
            (gray::<T>(weight), diffuse),
            (gray::<T>(1.0), narrow()?),
            (gray::<T>(weight), narrow()?),
        ])?;
        // Each term weighs at most its weight over its probability: the sum of the weights.
        cases.push(Case::new(format!("sum with {weight}"), 1.0 + 2.0 * weight, sum));
    }
    Ok(cases)
}

fn assert_cases_sound<T: Compiled<Mask = bool> + Into<f64>>(cases: Vec<Case<T>>) {
    let directions = directions();
    for (index, case) in cases.iter().enumerate() {
        let mut step = index;
        for &wo in &directions {
            let mirror = [-wo[0], -wo[1], wo[2]];
            for &wi in directions.iter().chain([&mirror]) {
                // Neighbours take other uniform numbers, so that all meet all.
                step += 1;
                let u = [UNIFORMS[step % 17], UNIFORMS[step / 17 % 17]];
                assert_sound(&case.name, case.model.as_ref(), &case.largest_weight, [wi, wo], u);
            }
        }
    }
}

macro_rules! extremes {
    ($($test:ident: $cases:ident;)*) => {$(
        #[test]
        fn $test() {
            assert_cases_sound($cases::<f32>().unwrap());
            assert_cases_sound($cases::<f64>().unwrap());
        }
    )*};
}
extremes! {
    lobes_at_the_ends_of_their_parameters: lobes;
    microfacets_at_the_ends_of_their_parameters: microfacets;
    sums_at_the_ends_of_their_weights: sums;
}
