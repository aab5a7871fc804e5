//! Polarised light on microfacets.

use brdf::description::BrdfDescription;
use brdf::fresnel::PolarizedFresnel;
use brdf::polarization::{Complex, Jones, Mueller, Stokes};
use brdf::{
    Beckmann, Brdf, Conductor, CookTorrance, Dielectric, Ggx, PolarizedBrdf, SmithCorrelated,
    from_spherical,
};
use brdf_checks::directions::pairs_to_grazing;
use brdf_checks::models;
use glam::DVec3;
use serde_json::Value;

fn largest_difference(a: &Mueller<f64>, b: &Mueller<f64>) -> f64 {
    let pairs = a.rows.iter().flatten().zip(b.rows.iter().flatten());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The amplitude matrices of the group of He's model are those of its facets, from scalar products
/// of the wave vectors with the axes of the frames: an independent way to the same matrix.
#[test]
fn facets_turn_light_as_scalar_products_say() {
    let text = brdf_checks::text("tests/data/values.json");
    let values: Value = serde_json::from_str(&text).expect("JSON");
    let cases = values["groups"]["he_1991_directional_diffuse"]["cases"].as_array().expect("cases");
    // Two cases are of unpolarised light alone.
    let polarized: Vec<&Value> =
        cases.iter().filter(|case| case["out"]["J_ss"].is_object()).collect();
    assert_eq!(polarized.len(), cases.len() - 2);
    for case in polarized {
        let input = |key: &str| case["in"][key].as_f64().expect(key);
        let wi = from_spherical(input("theta_i"), input("phi_i"));
        let wo = from_spherical(input("theta_o"), input("phi_o"));
        let element = |key: &str| {
            let element = &case["out"][key];
            let part = |part: &str| element[part].as_f64().expect(key);
            element.as_f64().map_or_else(|| Complex::new(part("re"), part("im")), Complex::real)
        };
        let jones = Jones {
            rows: [[element("J_ss"), element("J_sp")], [element("J_ps"), element("J_pp")]],
        };
        let metal = Conductor::new(input("n"), input("k")).expect("in range");
        let facets = CookTorrance::new(Beckmann::new(0.3).expect("in range"), metal);
        let got = facets.polarization(wi, wo);
        let mut want = jones.mueller();
        let whole = want.rows[0][0];
        want.rows.iter_mut().flatten().for_each(|element| *element /= whole);
        let off = largest_difference(&got, &want);
        assert!(off < 1e-13, "{}: {off:e}", case["in"]);
    }
}

/// Unpolarised light gives the scalar model to the last digit, sampled too, and no matrix makes light
/// that cannot be.
#[test]
fn every_polarizing_model_of_the_registry() {
    let mut seen = 0;
    for row in models::rows() {
        let model = row.brdf.build::<f64>().expect("it can be built");
        if model.mueller(DVec3::Z, DVec3::Z).is_none() {
            continue;
        }
        seen += 1;
        for (index, (wi, wo)) in pairs_to_grazing(300).into_iter().enumerate() {
            let matrix = model.mueller(wi, wo).expect("it has one always");
            let value = model.eval(wi, wo);
            assert_eq!(matrix.rows[0][0], value, "{} at {wi} {wo}", row.name);
            let channels = matrix.channels::<f64>();
            for channel in channels.iter().filter(|it| it.rows[0][0] > 1e-290) {
                let realizable = channel.realizability();
                assert!(realizable > -1e-14, "{} at {wi} {wo}: {realizable:e}", row.name);
            }
            let u = [(index as f64 * 0.618) % 1.0, (index as f64 * 0.755) % 1.0];
            let (sample, matrix) = model.sample_mueller(wo, u).expect("it has one always");
            assert_eq!(sample, model.sample(wo, u), "{}", row.name);
            assert_eq!(matrix.rows[0][0], sample.weight, "{}", row.name);
        }
        let below = model.mueller(-DVec3::Z, DVec3::Z).expect("it has one always");
        assert!(below.rows.iter().flatten().all(|element| *element == DVec3::ZERO));
    }
    assert!(seen > 15, "{seen}");
    let lambert = r#"{"lambert": {"albedo": 0.5}}"#;
    let lambert: BrdfDescription = serde_json::from_str(lambert).expect("a description");
    assert_eq!(lambert.build::<f64>().expect("Lambert").mueller(DVec3::Z, DVec3::Z), None);
}

/// The same light backwards: M(wo, wi) is the transposed matrix but for the signs of time reversal.
#[test]
fn mueller_matrices_are_reciprocal() {
    let glass = CookTorrance::new(Ggx::new(0.4).expect("in range"), Dielectric::new(1.5).unwrap())
        .with_shadowing(SmithCorrelated);
    let metal = CookTorrance::new(Ggx::new(0.4).unwrap(), Conductor::new(0.43, 2.455).unwrap());
    for (wi, wo) in pairs_to_grazing(300) {
        for (there, back) in [
            (glass.mueller(wi, wo), glass.mueller(wo, wi)),
            (metal.mueller(wi, wo), metal.mueller(wo, wi)),
        ] {
            let signs = [1.0, 1.0, -1.0, 1.0];
            let transposed = Mueller {
                rows: std::array::from_fn(|row| {
                    std::array::from_fn(|column| {
                        signs[row] * signs[column] * back.rows[column][row]
                    })
                }),
            };
            let off = largest_difference(&there, &transposed);
            assert!(off <= 1e-13 * there.rows[0][0], "{wi} {wo}: {there:?} {back:?}");
        }
    }
}

/// In the plane of incidence a facet does what a smooth surface does; at the retro direction that of
/// normal incidence, and in any frame.
#[test]
fn special_directions() {
    let metal = Conductor::new(0.43, 2.455).expect("in range");
    let facets = CookTorrance::new(Beckmann::new(0.3).expect("in range"), metal);
    let (wi, wo) = (DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.6, 0.0, 0.8));
    let r = metal.amplitudes(0.8);
    let mut smooth = Jones::diagonal(r.s, r.p).mueller();
    let whole = smooth.rows[0][0];
    smooth.rows.iter_mut().flatten().for_each(|element| *element /= whole);
    assert!(largest_difference(&facets.polarization(wi, wo), &smooth) < 1e-15);
    for w in [DVec3::Z, wi, DVec3::new(0.0, 0.6, 0.8), DVec3::new(1e-200, 0.0, 1.0)] {
        let retro = facets.polarization(w, w);
        for (place, want) in [1.0, 1.0, -1.0, -1.0].into_iter().enumerate() {
            assert!((retro.rows[place][place] - want).abs() < 1e-15, "{w}: {retro:?}");
        }
        // The frame near the normal is that of a plane of incidence x–z.
        let light = facets.mueller(w, w) * Stokes::linear(1.0, 0.3);
        assert!((light.degree_of_polarization() - 1.0).abs() < 1e-14);
    }
    let limit = facets.polarization(DVec3::new(1e-9, 0.0, 1.0), wo);
    assert!(largest_difference(&facets.polarization(DVec3::Z, wo), &limit) < 1e-8);
}
