//! Every model has the derivatives of its answers.

use brdf_checks::measure::derivatives::{LARGEST, of_reflection, questions};
use brdf_checks::measure::differences::Steps;
use brdf_checks::models;

/// By every number of the description and by both directions, against differences.
#[test]
fn derivatives_are_those_of_the_answers() {
    let (mut compared, mut undecided, mut wrong) = (0, 0, Vec::new());
    for row in models::rows() {
        // The mean of samples has the derivatives of the integral, not its own: see
        // `the_mean_of_samples_has_the_derivative_of_the_integral`.
        let albedos = if row.has_exact_albedo() { 2 } else { 0 };
        let found = of_reflection(&row.brdf, &questions(8, albedos));
        let name = &row.name;
        wrong.extend(found.faults.iter().map(|fault| format!("{name}: {fault}")));
        if found.largest > LARGEST || found.undecided * 10 >= found.compared {
            wrong.push(format!("{name}: {found:?}"));
        }
        compared += found.compared;
        undecided += found.undecided;
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(undecided * 100 < compared, "differences cannot tell {undecided} of {compared}");
}

/// What the derivatives are held against.
#[test]
fn differences_tell_slopes() {
    let slope = |formula: &dyn Fn(f64) -> Option<f64>| {
        let steps = Steps::of(0.05);
        steps.difference(&steps.map(formula))
    };
    let smooth = slope(&|step| Some((1.0 + step).exp()));
    assert!((smooth.slope - 1.0_f64.exp()).abs() <= smooth.error && smooth.error < 1e-11);
    let kink = slope(&|step: f64| Some(step.max(0.0) * (1.0 + step)));
    assert!((kink.slope - 0.5).abs() <= kink.error && kink.error < 1e-11, "{kink:?}");
    let end = slope(&|step: f64| (step >= 0.0).then(|| step.exp()));
    assert!((end.slope - 1.0).abs() <= end.error && end.error < 1e-10, "{end:?}");
    let narrow = slope(&|step: f64| Some((-((step - 1e-3) / 1e-3).powi(2)).exp()));
    let want = 2e3 * (-1.0_f64).exp();
    assert!((narrow.slope - want).abs() <= 2.0 * narrow.error, "{narrow:?}");
    assert!(narrow.error < 2e-6 * want, "{narrow:?}");
    let jump = slope(&|step: f64| Some(f64::from(u8::from(step > 0.0))));
    assert!(jump.error > 1.0, "{jump:?}");
}
