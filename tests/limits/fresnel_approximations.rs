//! Schlick's, Hall's and Cook's approximations: what they promise and how far off they are.

use brdf::fresnel::normal_incidence;
use brdf::quadrature::integrate;
use brdf::{Conductor, Constant, Cook, Dielectric, Fresnel, GeneralSchlick, Hall, Schlick};

use super::fresnel::{conductor, cosines, dielectric};

#[test]
fn schlick_falls_from_one_to_f0() {
    for f0 in [0.0_f32, 0.04, 0.1, 0.3, 0.7, 0.99, 1.0] {
        let schlick = Schlick::new(f0).unwrap();
        assert_eq!((schlick.reflectance(0.0), schlick.reflectance(1.0)), (1.0, f0));
        let mut cosines = cosines();
        cosines.sort_by(f32::total_cmp);
        for pair in cosines.windows(2) {
            assert!(schlick.reflectance(pair[1]) <= schlick.reflectance(pair[0]), "{f0} {pair:?}");
        }
    }
}

/// From one end to the other, monotonically but for rounding, with the average of a quadrature.
#[test]
fn general_schlick_goes_from_f0_to_f90() {
    let mut cosines: Vec<f64> = cosines().into_iter().map(f64::from).collect();
    cosines.sort_by(f64::total_cmp);
    for (f0, f90) in [(0.0, 1.0), (0.04, 0.5), (0.9, 0.2), (0.3, 0.3)] {
        for exponent in [0.01, 0.5, 1.0, 3.5, 5.0, 40.0, 1e4] {
            let schlick = GeneralSchlick::new(f0, f90, exponent).unwrap();
            assert_eq!((schlick.reflectance(1.0), schlick.reflectance(0.0)), (f0, f90));
            for pair in cosines.windows(2) {
                let [far, near] = [pair[0], pair[1]].map(|cos| schlick.reflectance(cos));
                let at = format!("{f0} {f90} {exponent} {pair:?}: {far} {near}");
                assert!((far - near) * (f90 - f0) >= -1e-15, "{at}");
                assert!(near >= f0.min(f90) - 1e-16 && near <= f0.max(f90) + 1e-16, "{at}");
                assert_eq!(near, schlick.reflectance(-pair[1]), "{at}");
            }
            // Gauss's quadrature is exact for polynomials, and not for much else.
            if (1.0..100.0).contains(&exponent) {
                let average = integrate(0.0, 1.0, |cos| 2.0 * cos * schlick.reflectance(cos));
                let bound = if exponent == exponent.floor() { 1e-14 } else { 1e-9 };
                let error = (schlick.average() - average).abs();
                assert!(error < bound, "{f0} {f90} {exponent}: {error:e}");
            }
        }
    }
    for cos in cosines {
        let (plain, general) = (Schlick::new(0.04), GeneralSchlick::new(0.04, 1.0, 5.0));
        let off = plain.unwrap().reflectance(cos) - general.unwrap().reflectance(cos);
        assert!(off.abs() < 1e-15, "{cos}: {off:e}");
    }
}

/// Largest absolute error, the degrees where it is, the mean over the angle, and the largest
/// relative error with its sign.
fn errors_of_schlick(eta: f64, k: f64) -> (f64, f64, f64, f64) {
    let schlick = Schlick::new(normal_incidence(eta, k)).unwrap();
    let count = 9000;
    let (mut largest, mut at, mut sum, mut relative) = (0.0, 0.0, 0.0, 0.0_f64);
    for i in 0..count {
        let degrees = 90.0 * (f64::from(i) + 0.5) / f64::from(count);
        let cos = degrees.to_radians().cos();
        let exact = conductor(eta, k, cos);
        let error = schlick.reflectance(cos) - exact;
        if error.abs() > largest {
            (largest, at) = (error.abs(), degrees);
        }
        if error.abs() / exact > relative.abs() {
            relative = error / exact;
        }
        sum += error.abs();
    }
    (largest, at, sum / f64::from(count), relative)
}

#[test]
fn schlicks_error_on_dielectrics() {
    let table = [
        (1.1, 0.2105, 83.1, 0.0399, 1.87),
        (1.2, 0.1130, 83.0, 0.0208, 0.467),
        (1.3, 0.0683, 83.6, 0.0121, -0.219),
        (1.33, 0.0599, 83.8, 0.0109, -0.227),
        (1.4, 0.0461, 84.3, 0.0094, -0.235),
        (1.5, 0.0357, 85.0, 0.0092, -0.232),
        (1.6, 0.0319, 85.3, 0.0098, -0.220),
        (1.8, 0.0345, 85.4, 0.0106, -0.182),
        (2.0, 0.0444, 85.2, 0.0111, -0.140),
        (2.2, 0.0582, 84.8, 0.0118, 0.103),
        (2.5, 0.0824, 84.4, 0.0142, 0.154),
        (3.0, 0.1250, 84.1, 0.0211, 0.247),
    ];
    for (n, largest, at, mean, relative) in table {
        let got = errors_of_schlick(n, 0.0);
        assert!((got.0 - largest).abs() < 6e-5, "{n}: {got:?}");
        assert!((got.1 - at).abs() < 0.11, "{n}: {got:?}");
        assert!((got.2 - mean).abs() < 6e-5, "{n}: {got:?}");
        assert!((got.3 - relative).abs() < 6e-3, "{n}: {got:?}");
    }
}

#[test]
fn schlicks_error_on_metals() {
    for (eta, k, largest) in [
        (0.14, 3.697, 0.0153),
        (0.43, 2.455, 0.0096),
        (1.38, 1.914, 0.0176),
        (0.22, 3.747, 0.0235),
        (1.02, 2.577, 0.0390),
        (0.06, 3.586, 0.0066),
        (0.789405353, 5.851936501, 0.0801),
        (2.95, 2.93, 0.1759),
        (3.18, 3.33, 0.1978),
    ] {
        let got = errors_of_schlick(eta, k).0;
        assert!((got - largest).abs() < 6e-5, "{eta} + i {k}: {got}");
    }
}

#[test]
fn hall_with_its_own_reference_is_exact() {
    for n in [1.1, 1.5, 2.42] {
        let hall = Hall::new(normal_incidence(n, 0.0), n).unwrap();
        for cos in cosines().into_iter().map(f64::from) {
            assert!((hall.reflectance(cos) - dielectric(n, cos)).abs() < 1e-15, "{n} {cos}");
        }
        // The quadrature against the closed form.
        let want = Dielectric::new(n).unwrap().average();
        assert!((hall.average() - want).abs() < 1e-9, "{n}: {} {want}", hall.average());
    }
}

#[test]
fn hall_does_not_follow_a_dip() {
    // Gold at 548.6 nm dips below its normal incidence: least 0.78535 at 48.6°.
    let (eta, k) = (0.43, 2.455);
    let f0 = normal_incidence(eta, k);
    let least = (0..9000)
        .map(|i| f64::from(i) / 100.0)
        .min_by(|a, b| {
            let at = |degrees: &f64| conductor(eta, k, degrees.to_radians().cos());
            at(a).total_cmp(&at(b))
        })
        .unwrap();
    assert!((f0 - 0.78692).abs() < 5e-6 && (least - 48.6).abs() < 0.06, "{f0} {least}");
    let cos = least.to_radians().cos();
    assert!((conductor(eta, k, cos) - 0.78535).abs() < 5e-6);
    let hall = Hall::with_reference(0.5_f64, Conductor::new(eta, k).unwrap()).unwrap();
    assert_eq!(hall.reflectance(cos), 0.5);
    assert!(hall.reflectance(0.1) > 0.6);
}

#[test]
fn dielectrics_dip_from_index_3_7_on() {
    let least = |n| (0..9000).map(|i| dielectric(n, f64::from(i) / 9000.0)).fold(1.0, f64::min);
    assert!(least(3.7) >= dielectric(3.7, 1.0));
    assert!(least(3.8) < dielectric(3.8, 1.0) - 1e-6);
}

#[test]
fn a_reference_that_reflects_all_leaves_the_color() {
    let hall = Hall::with_reference(0.3_f64, Constant::new(1.0).unwrap()).unwrap();
    for cos in [0.0, 0.5, 1.0] {
        assert_eq!(hall.reflectance(cos), 0.3);
    }
}

#[test]
fn cook_is_hall_times_the_light() {
    let hall = Hall::new(0.2_f64, 1.5).unwrap();
    let cook = Cook::new(0.2_f64, 3.0, 1.5).unwrap();
    for cos in cosines().into_iter().map(f64::from) {
        // As printed, with both ends colours of reflected light.
        let (reference, normal) = (dielectric(1.5, cos), dielectric(1.5, 1.0));
        let weight = (reference - normal).max(0.0) / (1.0 - normal);
        let want = 0.2 * 3.0 + (3.0 - 0.2 * 3.0) * weight;
        assert!((cook.reflectance(cos) - want).abs() < 2e-15);
        assert!((cook.reflectance(cos) - 3.0 * hall.reflectance(cos)).abs() < 1e-15);
    }
    assert!(cook.reflectance(0.0) == 3.0 && (cook.average() / hall.average() - 3.0).abs() < 1e-15);
}
