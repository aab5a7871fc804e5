//! Every model that the other tests know can be described: a new model is not finished before it
//! stands here too.

use std::collections::BTreeSet;

use brdf::Brdf;
use brdf::description::BrdfDescription;
use brdf::from_spherical;

use crate::common::models;

const GOLD: &str = r#"{"conductor": {"eta": [0.143, 0.374, 1.442], "k": [3.983, 2.386, 1.603]}}"#;
const GLASS: &str = r#"{"dielectric": {"ior": 1.5}}"#;
const PLASTIC: &str = r#"{"schlick": {"f0": [0.04, 0.05, 0.06]}}"#;
const WHITE: &str = r#"{"constant": 1}"#;

fn cook_torrance(distribution: &str, fresnel: &str, shadowing: &str) -> String {
    format!(
        r#"{{"cook_torrance": {{"distribution": {distribution}, "fresnel": {fresnel},
            "shadowing": "{shadowing}"}}}}"#
    )
}

fn beckmann(roughness: &str) -> String {
    format!(r#"{{"beckmann": {{"roughness": {roughness}}}}}"#)
}

fn ggx(roughness: &str) -> String {
    format!(r#"{{"ggx": {{"roughness": {roughness}}}}}"#)
}

fn gaussian(roughness: &str) -> String {
    format!(r#"{{"gaussian": {{"roughness": {roughness}}}}}"#)
}

fn blinn(exponent: &str) -> String {
    format!(r#"{{"blinn": {{"exponent": {exponent}}}}}"#)
}

fn mixture(terms: &[(&str, String)]) -> String {
    let term = |(weight, distribution): &(&str, String)| {
        format!(r#"{{"weight": {weight}, "distribution": {distribution}}}"#)
    };
    format!(r#"{{"mixture": [{}]}}"#, terms.iter().map(term).collect::<Vec<_>>().join(", "))
}

fn lobe(name: &str, exponent: &str, normalized: bool) -> String {
    format!(
        r#"{{"{name}": {{"specular": [1.0, 0.9, 0.8], "exponent": {exponent},
            "normalized": {normalized}}}}}"#
    )
}

fn blinn_1977(form: &str) -> String {
    format!(
        r#"{{"blinn_1977_printed": {{"distribution": "{form}", "beta": 1, "fresnel": {GOLD}}}}}"#
    )
}

/// The description of the model with that name. Of several entries of one type at least one.
fn described(name: &str) -> Option<String> {
    let text = match name {
        "Lambert" => r#"{"lambert": {"albedo": [0.8, 0.5, 0.2]}}"#.into(),
        "Oren-Nayar 0.3" => r#"{"oren_nayar": {"albedo": [1.0, 0.5, 0.2], "sigma": 0.3}}"#.into(),
        "Oren-Nayar 0.5 with interreflection" => r#"{"oren_nayar": {"albedo": [0.9, 0.5, 0.2],
            "sigma": 0.5, "interreflection": true}}"#
            .into(),
        "Phong 10" => lobe("phong", "10", true),
        "Phong 2000" => lobe("phong", "2000", true),
        "classic Phong 3" => lobe("phong", "3", false),
        "Blinn-Phong 40" => lobe("blinn_phong", "40", true),
        "Blinn-Phong 1e5" => lobe("blinn_phong", "1e5", true),
        "unnormalised Blinn-Phong 5" => lobe("blinn_phong", "5", false),
        "Schlick's power 10" => lobe("schlick_power", "10", true),
        "Schlick's power 1000" => lobe("schlick_power", "1000", true),
        "unnormalised Schlick's power 2" => lobe("schlick_power", "2", false),
        "weighted sum of three" => r#"{"sum": [
            {"weight": [0.5, 0.25, 0.125], "brdf": {"lambert": {"albedo": [0.8, 0.5, 0.2]}}},
            {"weight": [0.25, 0.5, 0.5], "brdf": {"phong": {"specular": 1, "exponent": 30}}},
            {"weight": [0.25, 0.25, 0.375],
             "brdf": {"schlick_power": {"specular": [1.0, 0.9, 0.8], "exponent": 8}}}]}"#
            .into(),
        "Beckmann 0.25, gold" => cook_torrance(&beckmann("0.25"), GOLD, "v_cavity"),
        "Beckmann 1, white" => cook_torrance(&beckmann("1"), WHITE, "v_cavity"),
        "Beckmann 0.01, Smith, plastic" => cook_torrance(&beckmann("0.01"), PLASTIC, "smith"),
        "Beckmann 0.3, Smith, white" => cook_torrance(&beckmann("0.3"), WHITE, "smith"),
        "Beckmann 0.1 0.5, Smith separable, Hall" => cook_torrance(
            &beckmann("[0.1, 0.5]"),
            r#"{"hall": {"f0": [0.95, 0.64, 0.54]}}"#,
            "smith_separable",
        ),
        "GGX 0.3, Smith, gold" => cook_torrance(&ggx("0.3"), GOLD, "smith"),
        "GGX 1, Smith separable, white" => cook_torrance(&ggx("1"), WHITE, "smith_separable"),
        "GGX 0.05 0.4, Smith, glass" => cook_torrance(&ggx("[0.05, 0.4]"), GLASS, "smith"),
        "Gaussian 0.25, plastic" => cook_torrance(&gaussian("0.25"), PLASTIC, "v_cavity"),
        "Gaussian 1, white" => cook_torrance(&gaussian("1"), WHITE, "v_cavity"),
        "Blinn 50, white" => cook_torrance(&blinn("50"), WHITE, "v_cavity"),
        "Blinn 8, gold" => cook_torrance(&blinn("8"), GOLD, "v_cavity"),
        "mixture of Beckmann, Smith, gold" => cook_torrance(
            &mixture(&[("0.75", beckmann("0.125")), ("0.25", beckmann("0.5"))]),
            GOLD,
            "smith",
        ),
        "mixture of GGX, Smith, gold" => {
            cook_torrance(&mixture(&[("0.9", ggx("0.02")), ("0.1", ggx("0.6"))]), GOLD, "smith")
        }
        "mixture of Gaussians, glass" => cook_torrance(
            &mixture(&[
                ("0.5", gaussian("0.1")),
                ("0.25", gaussian("0.3")),
                ("0.25", gaussian("0.6")),
            ]),
            GLASS,
            "v_cavity",
        ),
        "GGX 0.001, Cook" => cook_torrance(
            &ggx("0.001"),
            r#"{"cook": {"f0": [0.9, 0.6, 0.3], "light": [1.0, 0.9, 0.8]}}"#,
            "v_cavity",
        ),
        "Torrance-Sparrow 1967, glass" => {
            format!(r#"{{"torrance_sparrow_1967": {{"c": 0.05, "fresnel": {GLASS}}}}}"#)
        }
        "Cook-Torrance as printed in 1982, gold" => {
            format!(r#"{{"cook_torrance_1982_printed": {{"roughness": 0.2, "fresnel": {GOLD}}}}}"#)
        }
        "Blinn 1977 as printed, D1, gold" => blinn_1977("d1"),
        "Blinn 1977 as printed, D2, gold" => blinn_1977("d2"),
        "Blinn 1977 as printed, D3, gold" => blinn_1977("d3"),
        _ => return None,
    };
    Some(text)
}

/// In single precision, to which the registry rounds its parameters.
#[test]
fn every_model_can_be_described() {
    let mut described_types = BTreeSet::new();
    let mut types = BTreeSet::new();
    for entry in models::all::<f32>() {
        types.insert(entry.type_name);
        let Some(text) = described(entry.name) else { continue };
        described_types.insert(entry.type_name);
        let description: BrdfDescription = serde_json::from_str(&text).expect(&text);
        let built = description.build::<f32>().expect(&text);
        for (i, j) in (0..12).flat_map(|i| (0..12).map(move |j| (i as f32, j as f32))) {
            let wi = from_spherical(0.13 * i, 0.5 * j);
            let wo = from_spherical(0.14 * j, 0.3 * i + 2.0);
            assert_eq!(built.eval(wi, wo), entry.model.eval(wi, wo), "{}", entry.name);
            assert_eq!(built.pdf(wi, wo), entry.model.pdf(wi, wo), "{}", entry.name);
            let u = [i / 12.0, j / 12.0];
            assert_eq!(built.sample(wo, u), entry.model.sample(wo, u), "{}", entry.name);
        }
    }
    assert_eq!(described_types, types, "every type needs an entry with a description here");
}
