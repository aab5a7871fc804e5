//! How many digits single precision keeps, over the whole range of indices and angles.

use brdf::fresnel::{Polarized, conductor_polarized, dielectric_polarized};
use brdf::{Conductor, Cook, Dielectric, Fresnel, Hall, Schlick};

use super::fresnel::{conductor, cosines, dielectric, extinctions, indices};

const EPSILON: f64 = 6e-8;

/// R_p is small by cancellation near Brewster's angle: off by so many ε of the amplitude there.
fn check_p(got: f32, want: Polarized<f64>, label: &str) {
    let amplitude = (want.p / want.s).sqrt();
    let slack = 6.0 * EPSILON;
    let allowed = 1.2e-6 * want.p + want.s * slack * (2.0 * amplitude + slack);
    assert!((f64::from(got) - want.p).abs() <= allowed, "{label}: {got:e} {:e}", want.p);
}

#[test]
fn dielectric_in_single_precision() {
    let (mut far, mut near): (f64, f64) = (0.0, 0.0);
    for ior in indices() {
        for cos in cosines().into_iter().flat_map(|cos| [cos, -cos]) {
            let (n, c) = (f64::from(ior), f64::from(cos).abs());
            let (n1, n2) = if cos < 0.0 { (n, 1.0) } else { (1.0, n) };
            let sines = n1 * (1.0 - c) * (1.0 + c);
            let q_squared = n2 * n2 - n1 * sines;
            let got = Dielectric::new(ior).unwrap().reflectance(cos);
            let want = dielectric(n, f64::from(cos));
            let error = (f64::from(got) - want).abs();
            if q_squared.abs() > 0.1 * n2 * n2 {
                far = far.max(error / want);
                let label = format!("{ior} {cos}");
                check_p(
                    dielectric_polarized(ior, cos).p,
                    dielectric_polarized(n, f64::from(cos)),
                    &label,
                );
            } else {
                // q² is off by some ε of its terms, and dR/dq = −(4/p + 2c/(n₁ s²)) at q = 0.
                let scale = EPSILON * (n2 * n2).min((n2 * n2 - n1 * n1).abs());
                let q_error = scale / q_squared.abs().max(scale).sqrt();
                near = near.max(error / (1e-6 + q_error * (4.0 / (n1 * c) + 2.0 * c / sines)));
            }
        }
    }
    assert!(far < 1.2e-6 && near < 2.0, "{far:e} {near}");
}

#[test]
fn conductor_in_single_precision() {
    let (mut far, mut near): (f64, f64) = (0.0, 0.0);
    for eta in indices() {
        for k in extinctions() {
            for cos in cosines().into_iter().step_by(3) {
                let (n, k_double, c) = (f64::from(eta), f64::from(k), f64::from(cos));
                let x = (n - k_double) * (n + k_double) - (1.0 - c) * (1.0 + c);
                let q_squared = x.hypot(2.0 * n * k_double);
                let got = Conductor::new(eta, k).unwrap().reflectance(cos);
                let want = conductor(n, k_double, c);
                let error = (f64::from(got) - want).abs();
                let size = n * n + k_double * k_double;
                if q_squared > 0.1 * size {
                    far = far.max(error / want);
                    let label = format!("{eta} {k} {cos}");
                    check_p(
                        conductor_polarized(eta, k, cos).p,
                        conductor_polarized(n, k_double, c),
                        &label,
                    );
                } else {
                    let scale = EPSILON * size.min((1.0 - size).abs());
                    let q_error = scale / q_squared.max(scale).sqrt();
                    near = near.max(error / (1e-6 + q_error * (4.0 / c + 2.0 * c / (1.0 - c * c))));
                }
            }
        }
    }
    assert!(far < 1e-6 && near < 2.0, "{far:e} {near}");
}

#[test]
fn averages_in_single_precision() {
    for ior in indices() {
        let got = f64::from(Dielectric::new(ior).unwrap().average());
        let want = Dielectric::new(f64::from(ior)).unwrap().average();
        assert!((got - want).abs() <= 1e-6 * want, "{ior}: {got} {want}");
        for k in extinctions().step_by(4) {
            let got = f64::from(Conductor::new(ior, k).unwrap().average());
            let want = Conductor::new(f64::from(ior), f64::from(k)).unwrap().average();
            assert!((got - want).abs() <= 1e-6 * want, "{ior} {k}: {got} {want}");
        }
    }
}

#[test]
fn approximations_in_single_precision() {
    for cos in cosines() {
        for f0 in [0.0_f32, 0.04, 0.5, 1.0] {
            let (f0_double, cos_double) = (f64::from(f0), f64::from(cos));
            let got = f64::from(Schlick::new(f0).unwrap().reflectance(cos));
            let want = Schlick::new(f0_double).unwrap().reflectance(cos_double);
            assert!((got - want).abs() <= 5e-7 * want, "{f0} {cos}: {got} {want}");
            // The weight of an interpolation is a difference of reflectances.
            for ior in [1.1_f32, 1.5, 2.42, 40.0] {
                let ior_double = f64::from(ior);
                let room = 1.0 - dielectric(ior_double, 1.0);
                let allowed = |want: f64| 1e-7 * want + 4.0 * EPSILON / room;
                let got = f64::from(Hall::new(f0, ior).unwrap().reflectance(cos));
                let want = Hall::new(f0_double, ior_double).unwrap().reflectance(cos_double);
                assert!((got - want).abs() <= allowed(want), "{f0} {ior} {cos}: {got} {want}");
                let got = f64::from(Cook::new(f0, 0.5, ior).unwrap().reflectance(cos));
                let want = Cook::new(f0_double, 0.5, ior_double).unwrap().reflectance(cos_double);
                assert!((got - want).abs() <= allowed(want), "{f0} {ior} {cos}: {got} {want}");
            }
        }
    }
}
