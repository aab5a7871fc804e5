//! What cannot be fitted, and what the fit says about it.

use brdf::description::BrdfDescription;
use brdf::fit::{Fit, FitError, Measured, MeasuredReflectance, Unfit};
use glam::DVec3;

use super::fit_parameters::{answers, described, metal};

const GREY: &str = r#"{"lambert": {"albedo": 0.5}}"#;

fn error(fit: &Fit<'_, BrdfDescription>, points: &[Measured]) -> FitError {
    fit.to(points).unwrap_err()
}

#[test]
fn what_cannot_be_fitted_says_why() {
    let grey = described(GREY);
    let measured = answers(&grey);
    let fit = || Fit::of(&grey);
    assert_eq!(error(&fit(), &measured), FitError::NothingFree);
    let nothing = error(&fit().free("lambert.sigma"), &measured);
    assert_eq!(nothing.to_string(), "the description has no number lambert.sigma");
    assert!(matches!(error(&fit().free("lamb"), &measured), FitError::NoSuchNumber(_)));
    for (bounds, shown) in [
        (0.5..=0.1, "0.5 and 0.1"),
        (-1.0..=1.0, "-1 and 1"),
        (0.0..=f64::NAN, "0 and NaN"),
        (0.2..=0.2, "0.2 and 0.2"),
    ] {
        let error = error(&fit().free_within("lambert.albedo", bounds), &measured);
        assert!(matches!(error, FitError::Bounds { .. }));
        let rule = "the bounds of lambert.albedo must rise and lie between 0 and 1, not be ";
        assert_eq!(error.to_string(), format!("{rule}{shown}"));
    }
    let few = error(&fit().free("lambert"), &[]);
    assert_eq!(few, FitError::TooFew { measured: 0, free: 1 });
}

#[test]
fn measurements_with_which_nothing_compares_are_named() {
    let grey = described(GREY);
    let (fit, measured) = (Fit::of(&grey).free("lambert"), answers(&grey));
    let said = |change: &dyn Fn(&mut Measured)| {
        let mut broken = measured.clone();
        change(&mut broken[3]);
        error(&fit, &broken).to_string()
    };
    for (change, want) in [
        (
            &(|point: &mut Measured| point.value.y = 1e200) as &dyn Fn(&mut Measured),
            "value[1] must be between -1e100 and 1e100, not 1e200",
        ),
        (&|point| point.value.x = f64::NAN, "value[0] must be between -1e100 and 1e100, not NaN"),
        (
            &|point| point.value.z = f64::NEG_INFINITY,
            "value[2] must be between -1e100 and 1e100, not -inf",
        ),
        (&|point| point.weight.z = -1.0, "weight[2] must be between 0 and 1e100, not -1"),
        (&|point| point.weight.x = 1e200, "weight[0] must be between 0 and 1e100, not 1e200"),
        (&|point| point.weight.x = f64::NAN, "weight[0] must be between 0 and 1e100, not NaN"),
        (
            &|point| point.wi = DVec3::NAN,
            "wi: squared length must be between 0.99 and 1.01, not NaN",
        ),
        (
            &|point| point.wo = DVec3::splat(f64::INFINITY),
            "wo: squared length must be between 0.99 and 1.01, not inf",
        ),
        (
            &|point| point.wo = DVec3::new(0.0, 0.0, 1.02),
            "wo: squared length must be between 0.99 and 1.01, not 1.0404",
        ),
        (&|point| point.wi = DVec3::new(0.6, 0.0, -0.8), "wi must lie above the surface"),
        (&|point| point.wo = DVec3::X, "wo must lie above the surface"),
    ] {
        assert_eq!(said(change), format!("measured[3]: {want}"));
    }
    // What has no weight may be anything.
    let mut without = measured.clone();
    without.push(Measured { wi: DVec3::NAN, weight: DVec3::ZERO, ..measured[0] });
    assert_eq!(fit.to(&without), fit.to(&measured));
}

#[test]
fn cosines_out_of_range_are_named() {
    let start = metal(r#"{"conductor": {"eta": 1, "k": 3}}"#);
    let fit = Fit::of(&start).free("conductor.k");
    let at = |cos: f64| {
        fit.to(&[MeasuredReflectance::new(0.5, 0.6), MeasuredReflectance::new(cos, 0.6)])
    };
    for cos in [f64::NAN, f64::INFINITY, 7.0, -0.1] {
        let Err(FitError::Measured { index: 1, problem: Unfit::Number(error) }) = at(cos) else {
            panic!("{cos} is no cosine")
        };
        assert_eq!((error.parameter(), error.range()), ("cos", (0.0, 1.0)));
    }
    // What a quotient of rounded lengths makes of the normal.
    for cos in [0.0, 1.0, 1.0_f64.next_up()] {
        assert!(at(cos).is_ok(), "{cos}");
    }
}

/// Only their ratios matter, but to the residual, which has their unit.
#[test]
fn the_unit_of_the_weights_is_free() {
    let start = described(r#"{"lambert": {"albedo": 0.8}}"#);
    let fit = Fit::of(&start).free("lambert");
    let fitted = |weight: f64| {
        let mut measured = answers(&described(GREY));
        for point in &mut measured {
            point.weight *= weight * (1.5 + point.wo.x);
            point.value *= 1.0 + 0.1 * point.wo.y;
        }
        fit.to(&measured).unwrap()
    };
    let plain = fitted(1.0);
    let error = plain.parameters()[0].standard_error.unwrap();
    assert!(error > 1e-4, "{error}");
    for weight in [1e-300, 1e-200, 1e-20, 1e20, 1e99] {
        let other = fitted(weight);
        assert!((other.residual() / weight / plain.residual() - 1.0).abs() < 1e-12);
        let [one, two] = [&plain, &other].map(|fitted| &fitted.parameters()[0]);
        assert!((one.value - two.value).abs() < 1e-12);
        assert!((two.standard_error.unwrap() / error - 1.0).abs() < 1e-9, "{weight}");
    }
}
