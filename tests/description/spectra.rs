//! Descriptions at wavelengths of choice, materials of one's own and media outside.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use brdf::colorimetry::WAVELENGTHS;
use brdf::description::{BrdfDescription, BsdfDescription, FresnelDescription, Problem};
use brdf::materials::{GOLD, N_BK7_GLASS_SCHOTT, TITANIUM};
use brdf::polarization::{Complex, Layer};
use brdf::{AnyFresnel, Brdf, Bsdf, Fresnel, Spectrum, Stack, TransportMode, from_spherical};
use glam::DVec3;

use crate::forms::{FRESNEL, models};

/// What red, green and blue stand for.
const LINES: [f64; 3] = [650.0, 550.0, 450.0];

fn term(text: &str) -> FresnelDescription {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn bits(color: impl Into<[f64; 3]>) -> [u64; 3] {
    color.into().map(f64::to_bits)
}

/// To the last bit, in whatever order the wavelengths stand.
#[test]
fn at_the_three_wavelengths_the_answers_are_those_of_red_green_and_blue() {
    let turned = [LINES[2], LINES[0], LINES[1]];
    for text in FRESNEL {
        // The channels of a stack that says so have other wavelengths.
        if text.contains("belcour_barla") || text.contains("[600,550,450]") {
            continue;
        }
        let described = term(text);
        let rgb = described.build::<f64>().expect(text);
        let spectrum = described.build_spectrum::<f64, 3>(&LINES).expect(text);
        let other = described.build_spectrum::<f64, 3>(&turned).expect(text);
        for cos in [1.0, 0.7, 0.2] {
            let [r, g, b] = rgb.reflectance(cos).to_array();
            assert_eq!(bits(spectrum.reflectance(cos).0), bits([r, g, b]), "{text}");
            assert_eq!(bits(other.reflectance(cos).0), bits([b, r, g]), "{text}");
        }
    }
    let (wi, wo) = (from_spherical(0.4, 0.3), from_spherical(0.7, 2.0));
    for text in models() {
        if text.contains("belcour_barla") || text.contains("[600,550,450]") {
            continue;
        }
        let described: BrdfDescription = serde_json::from_str(&text).expect(&text);
        let rgb = described.build::<f64>().expect(&text).eval(wi, wo);
        let spectrum = described.build_spectrum::<f64, 3>(&LINES).expect(&text);
        assert_eq!(bits(spectrum.eval(wi, wo).0), bits(rgb), "{text}");
    }
    for text in [
        r#"{"mirror":{"fresnel":{"metal":"Au"}}}"#,
        r#"{"plastic":{"diffuse":[0.7,0.3,0.1],"ior":{"material":"PMMA"}}}"#,
        r#"{"dielectric":{"ior":{"material":"BK7"}}}"#,
        r#"{"thin_dielectric":{"ior":{"samples":[[400,1.6,0],[700,1.5,0]]}}}"#,
        r#"{"rough_dielectric":{"distribution":{"ggx":{"roughness":0.3}},"ior":{"material":"SF11"}}}"#,
    ] {
        let described: BsdfDescription = serde_json::from_str(text).expect(text);
        let (rgb, mode) = (described.build::<f64>().expect(text), TransportMode::Radiance);
        let spectrum = described.build_spectrum::<f64, 3>(&LINES).expect(text);
        for wi in [wi, -wi] {
            assert_eq!(bits(spectrum.eval(wi, wo, mode).0), bits(rgb.eval(wi, wo, mode)), "{text}");
        }
        let (one, other) = (rgb.specular(wo, mode), spectrum.specular(wo, mode));
        assert_eq!(bits(other.reflected.weight.0), bits(one.reflected.weight), "{text}");
        assert_eq!(bits(other.transmitted.weight.0), bits(one.transmitted.weight), "{text}");
        assert_eq!(other.transmitted.wi, one.transmitted.wi, "{text}");
    }
}

/// The tint of Disney's material is the same by itself and among other wavelengths.
#[test]
fn a_tint_depends_on_no_other_wavelength() {
    let text = r#"{"disney_2012": {"base_color": [0.8, 0.4, 0.2], "sheen": 1, "sheen_tint": 1,
                                   "specular_tint": 1}}"#;
    let described: BrdfDescription = serde_json::from_str(text).expect(text);
    let (wi, wo) = (DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.48, 0.36, 0.8));
    let [r, g, b] = described.build::<f64>().expect(text).eval(wi, wo).to_array();
    let one = described.build_spectrum::<f64, 1>(&[550.0]).expect(text).eval(wi, wo);
    let two = described.build_spectrum::<f64, 2>(&[650.0, 550.0]).expect(text).eval(wi, wo);
    let turned = described.build_spectrum::<f64, 3>(&[450.0, 550.0, 650.0]).expect(text);
    assert_eq!(one.0, [g]);
    assert_eq!(two.0, [r, g]);
    assert_eq!(turned.eval(wi, wo).0, [b, g, r]);
}

#[test]
fn a_colour_is_a_spectrum_of_straight_lines() {
    let paint: BrdfDescription =
        serde_json::from_str(r#"{"lambert": {"albedo": [0.2, 0.4, 0.8]}}"#).expect("a model");
    let at = [380.0, 450.0, 475.0, 550.0, 625.0, 650.0, 780.0];
    let spectrum = paint.build_spectrum::<f64, 7>(&at).expect("in range").albedo(DVec3::Z);
    for (got, want) in spectrum.0.into_iter().zip([0.8, 0.8, 0.7, 0.4, 0.25, 0.2, 0.2]) {
        assert!((got - want).abs() < 1e-15, "{got} {want}");
    }
    // In a stack the three numbers stand at the wavelengths of the stack.
    let text = r#"{"stack": {"layers": [], "substrate": {"eta": [1.5, 1.7, 1.6], "k": 0},
                             "wavelength": [600, 400, 500]}}"#;
    let stack = term(text).build_spectrum::<f64, 3>(&[400.0, 450.0, 700.0]).expect("in range");
    for (got, n) in stack.reflectance(1.0).0.into_iter().zip([1.7, 1.65, 1.5_f64]) {
        let want = ((n - 1.0) / (n + 1.0)).powi(2);
        assert!((got - want).abs() < 1e-15, "{got} {want}");
    }
}

/// Films and metals have the phases and indices of each wavelength.
#[test]
fn oxide_on_titanium_is_the_stack_at_every_wavelength() {
    let text = r#"{"stack": {"layers": [{"index": 2.4, "thickness": 60}], "substrate": {"material": "Ti"}}}"#;
    let built = term(text).build_spectrum::<f64, 81>(&WAVELENGTHS).expect("in range");
    let titanium = TITANIUM.refractive_index(Spectrum(WAVELENGTHS)).expect("in range");
    let real = |n: f64| Complex::new(Spectrum([n; 81]), Spectrum([0.0; 81]));
    let oxide = Layer { index: real(2.4), thickness: 60.0 };
    let substrate = Complex::new(titanium.eta, titanium.k);
    let want = Stack::new(real(1.0), &[oxide], substrate, Spectrum(WAVELENGTHS)).expect("a stack");
    assert_eq!(built, AnyFresnel::Stack(want));
}

#[test]
fn what_is_not_known_at_a_wavelength_is_an_error() {
    let error = |text: &str, at: f64| {
        let spectrum = term(text).build_spectrum::<f64, 2>(&[550.0, at]);
        spectrum.expect_err(text).to_string()
    };
    assert_eq!(
        error(r#"{"metal": "Au"}"#, 250.0),
        "metal: wavelength must be between 292.4 and 1088, not 250"
    );
    assert_eq!(
        error(r#"{"dielectric": {"ior": {"material": "BK7"}}}"#, 1500.0),
        "dielectric.ior.material: wavelength must be between 300 and 1000, not 1500"
    );
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = error(r#"{"constant": 1}"#, wrong);
        assert!(error.starts_with("wavelength[1] must be between 1 and 1e9, not "), "{error}");
    }
    let film = term(r#"{"belcour_barla": {"film": 1.33, "thickness": 300, "substrate": 1}}"#);
    let error = film.build_spectrum::<f64, 1>(&[550.0]).expect_err("a colour");
    assert_eq!((error.path(), error.problem()), ("belcour_barla", &Problem::NoSpectrum));
}

/// The same numbers, by name and as samples.
#[test]
fn samples_are_what_they_were_copied_from() {
    let samples: Vec<[f64; 3]> =
        GOLD.samples().map(|it| [it.wavelength, it.index.eta, it.index.k]).collect();
    for (own, named) in [
        (serde_json::json!({"metal": {"samples": samples}}), r#"{"metal": "Au"}"#),
        (
            serde_json::json!({"stack": {"layers": [], "substrate": {"samples": samples}}}),
            r#"{"stack": {"layers": [], "substrate": {"material": "Au"}}}"#,
        ),
        (
            serde_json::json!({"metal": {"samples": samples, "outside": 1.33}}),
            r#"{"metal": {"outside": 1.33, "material": "gold"}}"#,
        ),
    ] {
        let own = term(&own.to_string());
        assert_eq!(own.build::<f64>(), term(named).build());
        assert_eq!(
            own.build_spectrum::<f64, 81>(&WAVELENGTHS),
            term(named).build_spectrum(&WAVELENGTHS)
        );
    }
}

/// The numbers are those of `tests/materials/surroundings.rs`, which says how they were made.
#[test]
fn what_lies_above_a_surface_counts() {
    for (text, degrees, want) in [
        (
            r#"{"metal": {"material": "Au", "outside": {"material": "water"}}}"#,
            40.0_f64,
            [0.9446490658183889, 0.7565959682897099, 0.3436961827753057],
        ),
        (
            r#"{"metal": {"material": "silver", "outside": 1.5}}"#,
            75.0,
            [0.9860364050363845, 0.9811239535051713, 0.9843945159555488],
        ),
        (
            r#"{"dielectric": {"ior": {"material": "BK7", "outside": {"material": "water"}}}}"#,
            0.0,
            [0.004159522867671418, 0.004232893891154903, 0.004328690357564672],
        ),
    ] {
        let built = term(text).build::<f64>().expect(text);
        let got = built.reflectance(degrees.to_radians().cos());
        assert!(got.abs_diff_eq(want.into(), 3e-15), "{text}: {got} instead of {want:?}");
    }
    // Air is the default, and changes nothing.
    let [short, long] =
        [r#"{"metal": "Au"}"#, r#"{"metal": {"material": "Au", "outside": 1}}"#].map(term);
    assert_eq!(short.build::<f64>(), long.build());
    assert_ne!(short, long);
}

/// The least deviation of light by a prism of glass with an angle of 60° at its edge, from the smooth
/// interface that the description builds at each wavelength: δ = 2 asin(n sin(A/2)) − A.
///
/// n is that of the tables, with 40 digits.
#[test]
fn a_prism_deviates_by_the_wavelength() {
    let edge = FRAC_PI_3;
    for (name, rows) in [
        (
            "BK7",
            [
                (450.0, 0.6876339684395487),
                (550.0, 0.6771560729206794),
                (587.6, 0.6745110377292758),
                (656.3, 0.6707139733117005),
            ],
        ),
        (
            "SF11",
            [
                (450.0, 1.237091749561584),
                (550.0, 1.172219319365223),
                (587.6, 1.157890256337005),
                (656.3, 1.13872738509402),
            ],
        ),
    ] {
        let text = format!(r#"{{"dielectric": {{"ior": {{"material": "{name}"}}}}}}"#);
        let described: BsdfDescription = serde_json::from_str(&text).expect("a glass");
        for (wavelength, want) in rows {
            let glass = described.build_spectrum::<f64, 1>(&[wavelength]).expect("in range");
            // The sine of the angle at which light goes on that arrives at an angle.
            let onwards = |w: DVec3| glass.specular(w, TransportMode::Importance).transmitted.wi;
            let deviation = |first: f64| {
                let inside = onwards(from_spherical(first, 0.0));
                let second = edge - (-inside.x).atan2(-inside.z);
                let outside = onwards(DVec3::new(second.sin(), 0.0, -second.cos()));
                first + (-outside.x).atan2(outside.z) - edge
            };
            let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
            // Below, light is totally reflected at the second face.
            let mid = 0.5 * (want + edge);
            let (mut lower, mut upper) = (mid - 0.05, (mid + 0.05).min(FRAC_PI_2));
            for _ in 0..60 {
                let (left, right) =
                    (upper - golden * (upper - lower), lower + golden * (upper - lower));
                if deviation(left) < deviation(right) { upper = right } else { lower = left }
            }
            let least = deviation(0.5 * (lower + upper));
            assert!((least - want).abs() < 1e-14, "{name} at {wavelength}: {least} {want}");
        }
        // All channels have one direction: that of green.
        let [rgb, green] = [
            described.build::<f64>().map(|it| {
                it.specular(from_spherical(0.8, 0.0), TransportMode::Radiance).transmitted.wi
            }),
            described.build_spectrum::<f64, 1>(&[550.0]).map(|it| {
                it.specular(from_spherical(0.8, 0.0), TransportMode::Radiance).transmitted.wi
            }),
        ];
        assert_eq!(rgb, green);
    }
    let index = term(r#"{"dielectric": {"ior": {"material": "BK7"}}}"#);
    let AnyFresnel::Dielectric(glass) = index.build::<f64>().expect("in range") else {
        panic!("a dielectric")
    };
    let want = N_BK7_GLASS_SCHOTT.refractive_index(DVec3::from(LINES)).expect("in range");
    assert_eq!(glass.ior(), want.eta);
}
