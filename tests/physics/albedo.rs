//! The albedo of microfacet models, six digits of it.

use approx::assert_relative_eq;
use brdf::{
    AnyCookTorrance, AnyDistribution, AnyFresnel, AnyMixture, AnyShadowing, Beckmann, BelcourBarla,
    Blinn, Brdf, Conductor, Constant, Cook, CookTorrance, Dielectric, Gaussian, Ggx, Hall, Lift,
    Schlick, from_spherical,
};
use brdf_checks::measure::facets;
use brdf_checks::text;
use glam::DVec3;
use rayon::prelude::*;
use serde_json::Value;

type Double = AnyCookTorrance<f64>;

fn model(
    distribution: impl Into<AnyDistribution<f64>>,
    fresnel: impl Into<AnyFresnel<f64>>,
    shadowing: AnyShadowing,
) -> Double {
    CookTorrance::new(distribution.into(), fresnel.into()).with_shadowing(shadowing)
}

fn white() -> Constant<DVec3> {
    Constant::new(DVec3::ONE).unwrap()
}

/// Distributions with the least width of their lobes.
fn distributions() -> Vec<(String, AnyDistribution<f64>, f64)> {
    let mut all: Vec<(String, AnyDistribution<f64>, f64)> = Vec::new();
    for width in [0.01, 0.1, 0.4, 1.0] {
        all.push((format!("Gaussian {width}"), Gaussian::new(width).unwrap().into(), width));
        all.push((format!("Beckmann {width}"), Beckmann::new(width).unwrap().into(), width));
        all.push((format!("GGX {width}"), Ggx::new(width).unwrap().into(), width));
        let blinn = Blinn::from_roughness(width).unwrap();
        all.push((format!("Blinn {width}"), blinn.into(), width));
    }
    for (x, y) in [(0.02, 0.2), (0.5, 0.1)] {
        let (beckmann, ggx) = (Beckmann::anisotropic(x, y), Ggx::anisotropic(x, y));
        all.push((format!("Beckmann {x} {y}"), beckmann.unwrap().into(), x.min(y)));
        all.push((format!("GGX {x} {y}"), ggx.unwrap().into(), x.min(y)));
    }
    let terms: [(f64, AnyDistribution<f64>); 2] =
        [(0.5, Beckmann::new(0.05).unwrap().into()), (0.5, Ggx::new(0.4).unwrap().into())];
    all.push(("mixture".into(), AnyMixture::new(terms).unwrap().into(), 0.05));
    all
}

/// Fresnel terms with the angles at which they are not smooth.
fn fresnel_terms() -> Vec<(&'static str, AnyFresnel<f64>, Vec<f64>)> {
    let color = DVec3::new;
    let gold = Conductor::new(color(0.143, 0.374, 1.442), color(3.983, 2.386, 1.603));
    let inside = color(0.4, 0.66, 0.9);
    let film = BelcourBarla::new(2.4, 100.0, [2.6, 3.4], 1.0);
    let cook = Cook::new(color(0.9, 0.6, 0.3), color(1.0, 0.9, 0.8), 1.5);
    vec![
        ("constant", white().into(), vec![]),
        ("Schlick", Schlick::new(color(0.04, 0.5, 0.9)).unwrap().into(), vec![]),
        ("glass", Dielectric::new(color(1.1, 1.5, 2.5)).unwrap().into(), vec![]),
        (
            "from inside",
            Dielectric::new(inside).unwrap().into(),
            inside.to_array().map(f64::asin).into(),
        ),
        ("gold", gold.unwrap().into(), vec![]),
        ("Hall", Hall::new(color(0.95, 0.64, 0.54), 1.5).unwrap().into(), vec![]),
        ("Cook", cook.unwrap().into(), vec![]),
        ("oxide on metal", film.unwrap().into(), vec![]),
    ]
}

fn shadowings(distribution: &AnyDistribution<f64>) -> &'static [AnyShadowing] {
    let all = &[AnyShadowing::VCavity, AnyShadowing::SmithCorrelated, AnyShadowing::SmithSeparable];
    if distribution.has_smith() { all } else { &all[..1] }
}

/// Every combination of parts against an adaptive quadrature in another order.
#[test]
fn albedo_has_six_digits() {
    let wrong: Vec<String> = distributions()
        .into_par_iter()
        .flat_map_iter(|(name, distribution, width)| {
            let mut wrong = Vec::new();
            for &shadowing in shadowings(&distribution) {
                for (index, (fresnel_name, fresnel, angles)) in
                    fresnel_terms().into_iter().enumerate()
                {
                    let model = model(distribution.clone(), fresnel, shadowing);
                    // Every term sees half of the angles.
                    let half: [f64; 2] = if index % 2 == 0 { [0.0, 80.0] } else { [50.0, 89.0] };
                    for degrees in half {
                        let wo = from_spherical(degrees.to_radians(), 0.7);
                        let exact = facets::albedo(&model, wo, width, &angles, 1e-8);
                        let error = ((model.albedo(wo) - exact) / exact).abs().max_element();
                        if error.is_nan() || error > 1e-6 {
                            let parts = format!("{name}, {shadowing:?}, {fresnel_name}");
                            wrong.push(format!("{parts} at {degrees}°: {error:.1e}"));
                        }
                    }
                }
            }
            wrong
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Where a metal's reflectance comes out of its dip, Hall's interpolation has a kink: 10⁻⁶ with it.
#[test]
fn the_dip_of_a_metal_is_no_obstacle() {
    let silver = Conductor::new(1.442, 1.603).unwrap();
    let hall = Hall::with_reference(DVec3::new(0.95, 0.64, 0.3), silver).unwrap();
    for shadowing in [AnyShadowing::VCavity, AnyShadowing::SmithCorrelated] {
        for degrees in [20.0_f64, 50.0, 70.0, 85.0] {
            let wo = from_spherical(degrees.to_radians(), 0.7);
            let model = model(Ggx::new(0.4).unwrap(), hall, shadowing);
            let exact = facets::albedo(&model, wo, 0.4, &[], 1e-9);
            let error = ((model.albedo(wo) - exact) / exact).abs().max_element();
            assert!(error < 1e-6, "{shadowing:?} {degrees}°: {error:e}");
        }
    }
}

/// Figures of others: quadratures of their own.
#[test]
fn albedo_has_the_reference_values() {
    let all: Value = serde_json::from_str(&text("tests/data/values.json")).unwrap();
    let cases = all["groups"]["albedo_ggx_correlated"]["cases"].as_array().unwrap();
    assert!(!cases.is_empty());
    for case in cases {
        let number = |place: &str| case.pointer(place).and_then(Value::as_f64).unwrap();
        let ggx = Ggx::new(number("/in/alpha_g")).unwrap();
        let wo = from_spherical(number("/in/mu").acos(), 0.4);
        let got = model(ggx, white(), AnyShadowing::SmithCorrelated).albedo(wo).x;
        assert_relative_eq!(got, number("/out/E"), max_relative = 1e-8);
    }
    let plastic = Schlick::new(DVec3::splat(0.04)).unwrap();
    let rough = model(Beckmann::new(0.8).unwrap(), plastic, AnyShadowing::VCavity);
    let got = rough.albedo(from_spherical(80.0_f64.to_radians(), 0.0)).x;
    assert!((got - 0.121618).abs() < 5e-7, "{got}");
}

/// The one exception that is documented, and no larger than that: a medium of an index below 1 under grain.
#[test]
fn grain_from_inside_is_the_exception() {
    let inside = DVec3::new(0.4, 0.66, 0.9);
    let (glass, angles) = (Dielectric::new(inside).unwrap(), inside.to_array().map(f64::asin));
    let mut largest = 0.0_f64;
    for (x, y) in [(1.0, 0.1), (0.1, 1.0), (0.01, 1.0)] {
        for shadowing in [AnyShadowing::VCavity, AnyShadowing::SmithCorrelated] {
            for degrees in [0.0_f64, 40.0, 60.0, 80.0, 89.0] {
                let grain = model(Beckmann::anisotropic(x, y).unwrap(), glass, shadowing);
                let wo = from_spherical(degrees.to_radians(), 0.7);
                let exact = facets::albedo(&grain, wo, x.min(y), &angles, 1e-8);
                let error = ((grain.albedo(wo) - exact) / exact).abs().max_element();
                println!("{x} {y} {shadowing:?} {degrees}°: {error:.1e}");
                largest = largest.max(error);
            }
        }
    }
    assert!(largest > 1e-6 && largest < 4e-5, "{largest:e}");
}

/// In single precision 10⁻⁶, relative.
#[test]
fn albedo_in_single_precision() {
    let mut worst = (0.0, String::new());
    for (name, distribution, _) in distributions() {
        for &shadowing in shadowings(&distribution) {
            for (fresnel_name, fresnel, _) in fresnel_terms() {
                let double = model(distribution.clone(), fresnel, shadowing);
                #[allow(clippy::cast_possible_truncation, reason = "single precision is tested")]
                let single = double.lift(|parameter| parameter as f32);
                let double = single.lift(f64::from);
                for degrees in [0.0_f32, 50.0, 80.0, 89.0] {
                    let wo = from_spherical(degrees.to_radians(), 0.7);
                    let exact = double.albedo(wo.as_dvec3());
                    let error = ((single.albedo(wo).as_dvec3() - exact) / exact).abs();
                    if error.max_element() > worst.0 {
                        let parts = format!("{name}, {shadowing:?}, {fresnel_name}");
                        worst = (error.max_element(), format!("{parts} at {degrees}°"));
                    }
                }
            }
        }
    }
    assert!(worst.0 < 1e-6, "{worst:?}");
}

/// By the roughness it changes without steps: differences over two distances agree.
#[test]
fn albedo_has_a_derivative_by_the_roughness() {
    for shadowing in [AnyShadowing::VCavity, AnyShadowing::SmithCorrelated] {
        for (name, fresnel, _) in fresnel_terms() {
            for degrees in [0.0_f64, 30.0, 45.0, 60.0, 85.0] {
                let wo = from_spherical(degrees.to_radians(), 0.7);
                let at = |roughness: f64| {
                    model(Ggx::new(roughness).unwrap(), fresnel.clone(), shadowing).albedo(wo)
                };
                let slope = |step: f64| (at(0.4 + step) - at(0.4 - step)) / (2.0 * step);
                let (far, near) = (slope(1e-3), slope(1e-4));
                let error = (far - near).abs().max_element();
                assert!(error < 1e-5, "{name} {shadowing:?} {degrees}°: {far} {near}");
            }
        }
    }
}
