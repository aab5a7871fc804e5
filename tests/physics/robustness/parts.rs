//! The parts of microfacet models and the Fresnel functions, asked directly.

use brdf::fresnel::{conductor_polarized, dielectric_polarized, forms, normal_incidence};
use brdf::{
    Beckmann, Blinn, Blinn1977, Blinn1977Printed, Brdf, Constant, Distribution, Gaussian, Ggx,
    Mixture, Real, Smith, Vector,
};
use glam::DVec3;

use super::inputs::{NUMBERS, directions};

fn sound<T: Into<f64>>(what: &str, value: T) -> f64 {
    let value: f64 = value.into();
    assert!(value.is_finite() && value >= 0.0, "{what}: {value}");
    value
}

/// Vectors of all lengths, finite but for the last ones.
fn vectors() -> Vec<[f64; 3]> {
    let mut vectors = directions();
    for a in NUMBERS {
        vectors.extend([[a, 0.0, 1.0], [0.0, a, 1e-20], [0.0, 0.0, a], [a, -a, a], [1.0, a, 0.5]]);
    }
    vectors.retain(|v| v.iter().all(|c| c.is_finite()));
    vectors
}

fn densities_are_sound<T: Real<Mask = bool> + Into<f64>>() {
    for roughness in [1e-8, 1e-3, 0.3, 1.0, 30.0, 1e4] {
        let [a, b] = [roughness, 0.1].map(T::lit);
        let smith: [Box<dyn Smith<T>>; 4] = [
            Box::new(Beckmann::anisotropic(a, b).unwrap()),
            Box::new(Ggx::anisotropic(b, a).unwrap()),
            Box::new(Ggx::new(a).unwrap()),
            Box::new(
                Mixture::new([(b, Beckmann::new(a).unwrap()), (a, Beckmann::new(b).unwrap())])
                    .unwrap(),
            ),
        ];
        let others: [Box<dyn Distribution<T>>; 3] = [
            Box::new(Gaussian::new(a).unwrap()),
            Box::new(Blinn::new(T::lit(1.0 / roughness)).unwrap()),
            Box::new(Blinn::new(T::lit(0.0)).unwrap()),
        ];
        for v in vectors() {
            let w: T::Vec3 = Vector::new(T::lit(v[0]), T::lit(v[1]), T::lit(v[2]));
            let what = format!("roughness {roughness} at {v:?}");
            let below = !w.z().gt(T::lit(0.0));
            for distribution in &smith {
                let density = sound(&what, distribution.density(w));
                assert!(!below || density == 0.0, "{what}: {density} below the surface");
                sound(&what, distribution.lambda_cos(w));
            }
            for distribution in &others {
                let density = sound(&what, distribution.density(w));
                assert!(!below || density == 0.0, "{what}: {density} below the surface");
            }
        }
    }
}

#[test]
fn densities_of_vectors_of_any_length() {
    densities_are_sound::<f32>();
    densities_are_sound::<f64>();
}

#[test]
fn printed_lobes_at_any_angle() {
    for beta in [2e-4, 0.1, 1.0, 1.57] {
        let blinn = Blinn1977::new(beta).unwrap();
        let printed = Blinn1977Printed::d2(blinn, Constant::new(1.0).unwrap()).unwrap();
        for alpha in NUMBERS {
            for value in [blinn.d1(alpha), blinn.d2(alpha), blinn.d3(alpha)] {
                assert!((0.0..=1.0).contains(&value), "{beta} {alpha}: {value}");
            }
        }
        for wi in directions().into_iter().map(DVec3::from_array) {
            for wo in directions().into_iter().map(DVec3::from_array) {
                let (value, intensity) = (printed.eval(wi, wo), printed.specular(wi, wo));
                sound("specular", intensity);
                assert!(value > 0.0 || intensity == 0.0, "{wi} {wo}");
            }
        }
    }
}

/// For the documented indices every cosine has a reflectance; other indices do not panic.
#[test]
fn reflectances_of_any_numbers() {
    for (a, b) in NUMBERS.into_iter().flat_map(|a| NUMBERS.map(|b| (a, b))) {
        for cos in NUMBERS {
            let (dielectric, conductor) =
                (dielectric_polarized(a, cos), conductor_polarized(a, b, cos));
            let answers = [
                dielectric.s,
                dielectric.p,
                conductor.s,
                conductor.p,
                forms::gc(a, cos),
                forms::abu(a, b, cos),
                normal_incidence(a, b),
            ];
            if (1e-4..=1e4).contains(&a) && (0.0..=1e4).contains(&b) {
                assert!(answers.iter().all(|r| (0.0..=1.0).contains(r)), "{a} {b} {cos}");
            }
        }
    }
}
