//! Numbers of descriptions that are found again in what the models answer, and how well they are
//! known.

use brdf::description::{BrdfDescription, FresnelDescription};
use brdf::fit::{Fit, Measured, MeasuredReflectance, Metric};
use brdf::{Brdf, Conductor, Fresnel, from_spherical};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

pub fn described(text: &str) -> BrdfDescription {
    serde_json::from_str(text).expect(text)
}

/// What a model answers in the plane of incidence and across it.
pub fn answers(model: &BrdfDescription) -> Vec<Measured> {
    let model = model.build::<f64>().unwrap();
    let mut points = Vec::new();
    for lit in [0.1, 0.6, 1.1] {
        for seen in -14_i8..=14 {
            for azimuth in [0.0, 1.3] {
                let wi = from_spherical(lit, 0.0);
                let wo = from_spherical(f64::from(seen) * 0.1, azimuth);
                points.push(Measured::new(wi, wo, model.eval(wi, wo)));
            }
        }
    }
    points
}

pub fn metal(text: &str) -> FresnelDescription {
    serde_json::from_str(text).expect(text)
}

fn reflectances(eta: f64, k: f64, spread: f64, seed: u64) -> Vec<MeasuredReflectance> {
    let metal = Conductor::new(eta, k).unwrap();
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    (0..=17_u8)
        .map(|step| {
            let cos = (f64::from(step) * 5.0).to_radians().cos();
            let noise: f64 = (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0;
            MeasuredReflectance::new(cos, metal.reflectance(cos) + spread * noise)
        })
        .collect()
}

#[test]
fn every_kind_of_number_is_found_again() {
    for (truth, start, free) in [
        (
            r#"{"cook_torrance": {"distribution": {"ggx": {"roughness": [0.2, 0.4]}},
                "fresnel": {"schlick": {"f0": [0.9, 0.5, 0.2]}}}}"#,
            r#"{"cook_torrance": {"distribution": {"ggx": {"roughness": [0.5, 0.5]}},
                "fresnel": {"schlick": {"f0": [0.5, 0.5, 0.5]}}}}"#,
            &["cook_torrance"][..],
        ),
        (
            r#"{"sum": [{"weight": 0.6, "brdf": {"oren_nayar": {"albedo": 0.8, "sigma": 0.5}}},
                        {"weight": 0.3, "brdf": {"blinn_phong": {"specular": 1, "exponent": 40}}}]}"#,
            r#"{"sum": [{"weight": 0.6, "brdf": {"oren_nayar": {"albedo": 0.5, "sigma": 0.2}}},
                        {"weight": 0.6, "brdf": {"blinn_phong": {"specular": 1, "exponent": 15}}}]}"#,
            &["sum[0].brdf.oren_nayar", "sum[1].weight", "sum[1].brdf.blinn_phong.exponent"],
        ),
        (
            r#"{"minnaert": {"albedo": [0.12, 0.1, 0.08], "k": 0.7}}"#,
            r#"{"minnaert": {"albedo": [0.5, 0.5, 0.5], "k": 1}}"#,
            &["minnaert"],
        ),
    ] {
        let (truth, start) = (described(truth), described(start));
        let measured = answers(&truth);
        for metric in [Metric::Value, Metric::Cosine, Metric::CubeRoot] {
            let fit = free.iter().fold(Fit::of(&start).by(metric), |fit, path| {
                if path.ends_with("weight") {
                    fit.free_within(path, 0.0..=1.0)
                } else {
                    fit.free(path)
                }
            });
            let fitted = fit.to(&measured).expect("it converges");
            assert!(fitted.residual() < 1e-9 && fitted.is_minimum(), "{metric:?} {fitted:?}");
            let found = fitted.description().numbers();
            for (found, number) in found.iter().zip(truth.numbers()) {
                let off = (found.value - number.value).abs();
                // Schlick's exponent does not matter to a term that is built without one.
                assert!(off < 1e-6 * number.value.max(1.0), "{metric:?} {found:?} {number:?}");
            }
        }
    }
}

#[test]
fn reflectance_over_the_angle_tells_the_index_of_a_metal() {
    for (eta, k) in [(0.42, 2.47), (0.96, 2.58), (0.06, 3.6), (0.96, 6.69)] {
        let start = metal(r#"{"conductor": {"eta": 1, "k": 3}}"#);
        let fit = Fit::of(&start).free("conductor.eta").free("conductor.k");
        let exact = fit.to(&reflectances(eta, k, 0.0, 1)).unwrap();
        let [found_eta, found_k] = exact.parameters() else { panic!("two") };
        assert!((found_eta.value - eta).abs() < 1e-6 && (found_k.value - k).abs() < 1e-6);

        // The standard error is that of many measurements.
        let (mut squares, count) = ([0.0; 2], 100_u32);
        for seed in 0..u64::from(count) {
            let noisy = fit.to(&reflectances(eta, k, 1e-4, seed)).unwrap();
            for ((square, parameter), truth) in
                squares.iter_mut().zip(noisy.parameters()).zip([eta, k])
            {
                let error = parameter.standard_error.expect("told");
                *square += ((parameter.value - truth) / error).powi(2);
            }
        }
        for square in squares {
            let spread = (square / f64::from(count)).sqrt();
            assert!((0.7..1.4).contains(&spread), "{eta} + {k}i: {spread}");
        }
    }
}

#[test]
fn numbers_that_act_as_one_have_no_error() {
    let truth = described(r#"{"sum": [{"weight": 0.5, "brdf": {"lambert": {"albedo": 0.8}}}]}"#);
    let measured = answers(&truth);
    let one = Fit::of(&truth).free("sum[0].brdf.lambert.albedo").to(&measured).unwrap();
    assert!(one.parameters()[0].standard_error.is_some());
    let both = Fit::of(&truth)
        .free_within("sum[0].weight", 0.0..=1.0)
        .free("sum[0].brdf.lambert.albedo")
        .to(&measured)
        .unwrap();
    assert!(both.parameters().iter().all(|parameter| parameter.standard_error.is_none()));
    assert!(both.parameters().iter().all(|parameter| !parameter.at_bound));
}

#[test]
fn a_weight_of_zero_leaves_a_channel_out() {
    let grey = described(r#"{"lambert": {"albedo": 0.5}}"#);
    let mut measured = answers(&grey);
    for point in &mut measured {
        point.value.y = f64::NAN;
        point.weight.y = 0.0;
    }
    let start = described(r#"{"lambert": {"albedo": 0.9}}"#);
    let fitted = Fit::of(&start).free("lambert").to(&measured).unwrap();
    assert!((fitted.parameters()[0].value - 0.5).abs() < 1e-9);
}
