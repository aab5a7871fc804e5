//! Where fits end: at minima, from starts at the bounds of the parameters too.

use brdf::Brdf;
use brdf::description::BrdfDescription;
use brdf::fit::{Fit, Fitted, Measured, Metric};
use brdf::from_spherical;
use glam::DVec3;

use super::fit_parameters::described;

const METRICS: [Metric; 3] = [Metric::Value, Metric::Cosine, Metric::CubeRoot];

/// What a model answers to light from both sides, seen next to the plane of incidence.
fn answers(model: &BrdfDescription) -> Vec<Measured> {
    let model = model.build::<f64>().unwrap();
    let mut points = Vec::new();
    for lit in -15_i8..=15 {
        for seen in [0.0, 0.5, 1.0] {
            let wi = from_spherical(f64::from(lit) * 0.1, 0.0);
            let wo = from_spherical(seen, 0.3);
            points.push(Measured::new(wi, wo, model.eval(wi, wo)));
        }
    }
    points
}

fn black() -> Vec<Measured> {
    let white = described(r#"{"lambert": {"albedo": 1}}"#);
    let points = answers(&white).into_iter();
    points.map(|point| Measured { value: DVec3::ZERO, ..point }).collect()
}

fn fitted(
    start: &BrdfDescription,
    free: &[&str],
    metric: Metric,
    measured: &[Measured],
) -> Fitted<BrdfDescription> {
    let fit = free.iter().fold(Fit::of(start).by(metric), |fit, path| fit.free(path));
    fit.to(measured).expect("a fit")
}

/// The root mean square with one of the numbers moved, if that builds a model.
fn beside(
    fitted: &Fitted<BrdfDescription>,
    path: &str,
    moved: f64,
    metric: Metric,
    measured: &[Measured],
) -> Option<f64> {
    let numbers = |at: &brdf::description::Path<'_>, value| {
        if at.to_string() == path { moved } else { value }
    };
    let model = fitted.description().with_numbers(numbers).ok()?.build::<f64>().ok()?;
    let compared = |value: f64, cos: f64| match metric {
        Metric::Value => value,
        Metric::Cosine => value * cos,
        _ => (value * cos).cbrt(),
    };
    let squares = measured.iter().map(|point| {
        let (value, cos) = (model.eval(point.wi, point.wo), point.wi.z);
        let off = compared(value.x, cos) - compared(point.value.x, cos);
        off * off
    });
    Some((squares.sum::<f64>() / measured.len() as f64).sqrt())
}

/// No step of a number makes the residual smaller.
fn assert_minimum(fitted: &Fitted<BrdfDescription>, metric: Metric, measured: &[Measured]) {
    assert!(fitted.is_minimum(), "{fitted:?}");
    for parameter in fitted.parameters() {
        for step in [1e-1, 1e-2, 1e-3, 1e-4] {
            for moved in [
                parameter.value * (1.0 + step),
                parameter.value * (1.0 - step),
                parameter.value + step,
            ] {
                let Some(other) = beside(fitted, &parameter.path, moved, metric, measured) else {
                    continue;
                };
                let floor = fitted.residual() * (1.0 - 1e-9) - 1e-14;
                assert!(other >= floor, "{} {moved}: {other} {fitted:?}", parameter.path);
            }
        }
    }
}

#[test]
fn a_number_leaves_the_bound_at_which_it_starts() {
    let truth = described(r#"{"oren_nayar": {"albedo": 0.5, "sigma": 0.4}}"#);
    let measured = answers(&truth);
    for metric in METRICS {
        for sigma in [0.0, 1e-9, 0.1, 1.57, std::f64::consts::FRAC_PI_2] {
            let start = format!(r#"{{"oren_nayar": {{"albedo": 0.3, "sigma": {sigma}}}}}"#);
            let fitted = fitted(&described(&start), &["oren_nayar"], metric, &measured);
            assert!(fitted.residual() < 1e-12 && fitted.is_minimum(), "{sigma} {fitted:?}");
            for (parameter, want) in fitted.parameters().iter().zip([0.5, 0.4]) {
                assert!((parameter.value - want).abs() < 1e-9 && !parameter.at_bound, "{sigma}");
            }
        }
    }
}

#[test]
fn a_lobe_is_found_from_the_far_ends_of_the_roughness() {
    let facets = |roughness: &str| {
        described(&format!(
            r#"{{"cook_torrance": {{"distribution": {{"ggx": {{"roughness": {roughness}}}}},
                "fresnel": {{"schlick": {{"f0": 0.3}}}}}}}}"#
        ))
    };
    let measured = answers(&facets("0.3"));
    for metric in METRICS {
        for start in ["1e-8", "1e-4", "1e-2", "10", "1e4"] {
            let fitted = fitted(&facets(start), &["cook_torrance.distribution"], metric, &measured);
            let roughness = &fitted.parameters()[0];
            assert!((roughness.value - 0.3).abs() < 1e-9, "{start} {metric:?} {fitted:?}");
            assert!(fitted.is_minimum() && !roughness.at_bound);
        }
    }
}

/// A diffuse term under a lobe that is too dark: the best fit is not exact.
#[test]
fn a_weight_and_an_albedo_that_act_as_one_end_at_a_minimum() {
    let layers = |[weight, albedo, roughness, f0]: [f64; 4]| {
        described(&format!(
            r#"{{"sum": [{{"weight": {weight}, "brdf": {{"lambert": {{"albedo": {albedo}}}}}}},
                {{"weight": 0.5, "brdf": {{"cook_torrance": {{
                    "distribution": {{"ggx": {{"roughness": {roughness}}}}},
                    "fresnel": {{"schlick": {{"f0": {f0}}}}}}}}}}}]}}"#
        ))
    };
    let measured = answers(&layers([0.5, 0.5, 0.2, 0.3]));
    let free = [
        "sum[0].weight",
        "sum[0].brdf.lambert.albedo",
        "sum[1].brdf.cook_torrance.distribution.ggx.roughness",
    ];
    for metric in METRICS {
        for start in [[0.9, 0.9, 0.1, 0.1], [0.0, 0.9, 0.1, 0.1], [2.0, 0.0, 0.5, 0.1]] {
            let fitted = fitted(&layers(start), &free, metric, &measured);
            assert_minimum(&fitted, metric, &measured);
            assert!(fitted.residual() < 0.06, "{start:?} {metric:?} {}", fitted.residual());
            let [weight, albedo, roughness] = fitted.parameters() else { panic!("three") };
            assert!(weight.standard_error.is_none() && albedo.standard_error.is_none());
            assert!(roughness.standard_error.is_some(), "{fitted:?}");
        }
    }
}

fn mixture([a, one, b, two]: [f64; 4]) -> BrdfDescription {
    described(&format!(
        r#"{{"cook_torrance": {{"distribution": {{"mixture": [
            {{"weight": {a}, "distribution": {{"beckmann": {{"roughness": {one}}}}}}},
            {{"weight": {b}, "distribution": {{"beckmann": {{"roughness": {two}}}}}}}]}},
            "fresnel": {{"schlick": {{"f0": 0.3}}}}}}}}"#
    ))
}

/// Only the ratio of the weights counts, which is found, and neither of them is known.
#[test]
fn the_weights_of_a_mixture_are_known_by_their_ratio() {
    let measured = answers(&mixture([0.4, 0.2, 0.6, 0.5]));
    for metric in METRICS {
        for start in [
            [0.5, 0.25, 0.5, 0.4],
            [0.9, 0.1, 0.1, 0.9],
            [1.0, 0.3, 1.0, 0.3],
            [0.0, 0.5, 1.0, 0.2],
            [1e10, 0.05, 1.0, 0.4],
        ] {
            let start = mixture(start);
            let fitted = fitted(&start, &["cook_torrance.distribution"], metric, &measured);
            assert!(fitted.residual() < 1e-10 && fitted.is_minimum(), "{start:?} {fitted:?}");
            let [a, one, b, two] = fitted.parameters() else { panic!("four") };
            let ((a, one), (b, two)) =
                if one.value < two.value { ((a, one), (b, two)) } else { ((b, two), (a, one)) };
            assert!((b.value / a.value - 1.5).abs() < 1e-6, "{fitted:?}");
            assert!((one.value - 0.2).abs() < 1e-7 && (two.value - 0.5).abs() < 1e-7);
            assert!(a.standard_error.is_none() && b.standard_error.is_none(), "{fitted:?}");
            assert!(one.standard_error.is_some() && two.standard_error.is_some());
        }
    }
    // From a start nearby they stay nearby.
    let start = mixture([0.5, 0.25, 0.5, 0.4]);
    let fitted = fitted(&start, &["cook_torrance.distribution"], Metric::Value, &measured);
    assert!((0.5..2.0).contains(&(fitted.parameters()[0].value + fitted.parameters()[2].value)));
}

/// A sum whose weights are all zero is none: the fit stops before.
#[test]
fn black_is_fitted_by_a_weight_next_to_zero() {
    let layer = described(r#"{"sum": [{"weight": 0.5, "brdf": {"lambert": {"albedo": 0.8}}}]}"#);
    for metric in METRICS {
        let fitted = fitted(&layer, &["sum[0].weight"], metric, &black());
        let weight = &fitted.parameters()[0];
        assert!(weight.value < 1e-9 && weight.at_bound && fitted.is_minimum(), "{fitted:?}");
        assert_eq!(weight.standard_error, None);
    }
}

/// Every number that is free ends exactly at its bound where the measured values drive it out.
#[test]
fn a_number_that_is_driven_out_ends_at_its_bound() {
    let measured = answers(&described(r#"{"oren_nayar": {"albedo": 0.9, "sigma": 0.4}}"#));
    let start = described(r#"{"oren_nayar": {"albedo": 0.2, "sigma": 0.1}}"#);
    for metric in METRICS {
        let fit = Fit::of(&start).by(metric);
        let fit = fit.free_within("oren_nayar.albedo", 0.0..=0.7).free("oren_nayar.sigma");
        let fitted = fit.to(&measured).unwrap();
        let [albedo, sigma] = fitted.parameters() else { panic!("two") };
        assert!(albedo.value == 0.7 && albedo.at_bound && albedo.standard_error.is_none());
        assert!(fitted.is_minimum(), "{fitted:?}");
        println!("{metric:?}: {fitted:?}");
        for moved in [0.69, 0.6999] {
            let other = beside(&fitted, &albedo.path, moved, metric, &measured).unwrap();
            assert!(other > fitted.residual());
        }
        // A smoother surface is brighter too: σ may be driven out as well.
        let beside_sigma = [sigma.value - 1e-3, sigma.value + 1e-3];
        for moved in beside_sigma.into_iter().filter(|moved| *moved >= 0.0) {
            let other = beside(&fitted, &sigma.path, moved, metric, &measured).unwrap();
            assert!(other > fitted.residual());
        }
    }
}
