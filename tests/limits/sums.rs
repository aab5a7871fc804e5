use brdf::{
    Brdf, ClassicPhong, Lambert, OrenNayar, Phong, SchlickPower, WeightedSum, from_spherical,
};
use glam::{DVec3, Vec3};

use crate::hemisphere::{Model, albedo, assert_samples_follow_pdf};
use brdf_checks::directions::pairs;

fn layers() -> [(f64, Model); 4] {
    [
        (0.25, Box::new(Lambert::new(0.9).unwrap())),
        (0.5, Box::new(Phong::new(0.8, 25.0).unwrap())),
        (0.0, Box::new(Phong::new(1.0, 1e6).unwrap())),
        (1.25, Box::new(SchlickPower::new(0.1, 4.0).unwrap())),
    ]
}

#[test]
fn a_sum_is_the_sum() {
    let sum = WeightedSum::new(layers()).unwrap();
    let color = WeightedSum::new([
        (Vec3::new(0.5, 0.2, 0.0), Lambert::new(Vec3::new(0.1, 0.2, 0.3)).unwrap()),
        (Vec3::new(0.5, 0.4, 0.3), Lambert::new(Vec3::ONE).unwrap()),
    ])
    .unwrap();
    let got = color.albedo(Vec3::Z);
    assert!(got.abs_diff_eq(Vec3::new(0.55, 0.44, 0.3), 1e-7), "{got}");
    for (wi, wo) in pairs(1000) {
        let want: f64 = layers().iter().map(|(w, model)| w * model.eval(wi, wo)).sum();
        assert!((sum.eval(wi, wo) - want).abs() <= 1e-15 * want);
        let want: f64 = layers().iter().map(|(w, model)| w / 2.0 * model.pdf(wi, wo)).sum();
        assert!((sum.pdf(wi, wo) - want).abs() <= 1e-15 * want);
        let want: f64 = layers().iter().map(|(w, model)| w * model.albedo(wo)).sum();
        assert!((sum.albedo(wo) - want).abs() <= 1e-15 * want);
    }
}

#[test]
fn a_sum_of_one_is_that_one() {
    let model = OrenNayar::new(0.7, 0.4).unwrap();
    let sum = WeightedSum::new([(1.0, model)]).unwrap();
    for (index, (wi, wo)) in pairs(1000).into_iter().enumerate() {
        assert_eq!(sum.eval(wi, wo), model.eval(wi, wo));
        assert_eq!(sum.pdf(wi, wo), model.pdf(wi, wo));
        let u = [index as f64 / 1000.0, (index as f64 * 0.618).fract()];
        let (got, want) = (sum.sample(wo, u), model.sample(wo, u));
        assert_eq!((got.wi, got.pdf), (want.wi, want.pdf));
        assert!((got.weight - want.weight).abs() < 1e-14 * want.weight);
    }
}

#[test]
fn samples_of_a_sum_follow_its_density() {
    let nested = WeightedSum::new([
        (0.5, Box::new(WeightedSum::new(layers()).unwrap()) as Model),
        (0.5, Box::new(ClassicPhong::new(0.3, 8.0).unwrap())),
    ])
    .unwrap();
    for (theta, phi) in [(0.0, 0.0), (0.7, 2.0), (1.3, -1.0), (1.55, 0.3)] {
        let wo = from_spherical(theta, phi);
        let flat = WeightedSum::new(layers()).unwrap();
        let failures = assert_samples_follow_pdf("sum", &flat, wo, 300_000);
        assert!(failures > -1e-9, "{failures}");
        assert_samples_follow_pdf("nested sum", &nested, wo, 300_000);
        let (got, want) = (flat.albedo(wo), albedo(&flat, theta, 1e-8));
        assert!((got / want - 1.0).abs() < 1e-7, "{theta}: {got}, {want}");
    }
}

/// Every weight and every direction, also where the terms saturate.
#[test]
fn sums_saturate() {
    let sum = WeightedSum::new([
        (1e10_f32, ClassicPhong::new(1.0, 3.0).unwrap()),
        (0.0, ClassicPhong::new(0.0, 1e8).unwrap()),
        (1e9, ClassicPhong::new(0.5, 0.0).unwrap()),
    ])
    .unwrap();
    for cos in [1e-45_f32, 1e-38, 1e-20, 1e-3] {
        let (wi, wo) = (Vec3::new(1.0, 0.0, cos), Vec3::new(-1.0, 0.0, cos));
        let (value, pdf) = (sum.eval(wi, wo), sum.pdf(wi, wo));
        assert!(value.is_finite() && value > 1e9 && pdf.is_finite() && pdf > 0.0, "{value} {pdf}");
        for u in [[0.0, 0.0], [0.3, 0.1], [0.95, 0.6], [1.0 - f32::EPSILON / 2.0, 0.9]] {
            let sample = sum.sample(wo, u);
            assert!(sample.weight.is_finite() && sample.weight >= 0.0, "{sample:?}");
        }
    }
    assert_eq!(sum.sample(Vec3::NAN, [0.5, 0.5]).weight, 0.0);
    assert_eq!(sum.sample(Vec3::NEG_Z, [0.5, 0.5]).pdf, 0.0);
}

#[test]
fn sums_are_checked() {
    let model = Lambert::new(0.5).unwrap();
    let none: [(f64, Lambert<f64>); 0] = [];
    assert_eq!(WeightedSum::new(none).unwrap_err().parameter(), "total weight");
    let error = WeightedSum::new([(0.0, model), (0.0, model)]).unwrap_err();
    assert_eq!((error.parameter(), error.value()), ("total weight", 0.0));
    let error = WeightedSum::new([(1.0, model), (-0.5, model)]).unwrap_err();
    assert_eq!((error.parameter(), error.value()), ("weight", -0.5));
    assert!(WeightedSum::new([(f64::INFINITY, model)]).is_err());
    let red = WeightedSum::new([(DVec3::X, Lambert::new(DVec3::ONE).unwrap())]).unwrap();
    assert_eq!(red.albedo(DVec3::Z), DVec3::X);
}
