//! Cosine-averaged reflectances against other ways to compute them.

use std::f64::consts::PI;

use brdf::quadrature::integrate;
use brdf::{Conductor, Dielectric, Fresnel};

use super::fresnel::{conductor, indices};

/// Quadratures over panels that shrink geometrically towards the kink and towards grazing.
fn reference_average(eta: f64, k: f64) -> f64 {
    let kink = (1.0 - (eta - k) * (eta + k)).clamp(0.0, 1.0).sqrt();
    let panels = |from: f64, to: f64| -> f64 {
        let at = |i: i32| from + (to - from) * if i == 0 { 0.0 } else { 0.8_f64.powi(150 - i) };
        let panel = |i| integrate(at(i), at(i + 1), |c: f64| 2.0 * c * conductor(eta, k, c));
        (0..150).map(panel).sum()
    };
    let middle = kink / 2.0;
    panels(0.0, middle) - panels(kink, middle) + panels(kink, 1.0)
}

#[test]
fn averages_of_conductors() {
    let ks = [0.0, 1e-4, 0.01, 0.03, 0.1, 0.3, 1.0, 2.0, 3.7, 6.0, 10.0, 100.0, 1e4];
    let (mut largest, mut metals) = (0.0_f64, 0.0_f64);
    for n in [1e-4, 0.04, 0.14, 0.43, 0.6, 0.8, 0.95, 0.99, 1.01, 1.1, 1.5, 2.0, 3.0, 10.0, 1e4] {
        for k in ks {
            let want = reference_average(n, k);
            let error = (Conductor::new(n, k).unwrap().average() - want).abs() / want;
            largest = largest.max(error);
            if (0.04..=10.0).contains(&n) && (1.0..=10.0).contains(&k) {
                metals = metals.max(error);
            }
        }
        let (got, want) =
            (Conductor::new(n, 0.0).unwrap().average(), Dielectric::new(n).unwrap().average());
        assert!((got - want).abs() <= 2e-8 * want, "{n}: {got} {want}");
    }
    assert!(largest < 4e-7 && metals < 1e-14, "{largest:e} {metals:e}");
    for (distance, bound) in [(1e-5, 1e-5), (1e-6, 3e-4), (1e-9, 0.1)] {
        for turn in 0..=16 {
            let (k, real) = (PI / 16.0 * f64::from(turn)).sin_cos();
            let (n, k) = (1.0 + real * distance, k.max(0.0) * distance);
            let want = reference_average(n, k);
            let error = (Conductor::new(n, k).unwrap().average() - want).abs() / want;
            assert!(error < bound, "{n} {k:e}: {error:e}");
        }
    }
}

#[test]
fn averages_of_dielectrics() {
    for n in indices().into_iter().map(f64::from).filter(|n| *n > 1.0) {
        let (outside, inside) =
            (Dielectric::new(n).unwrap().average(), Dielectric::new(1.0 / n).unwrap().average());
        // What enters from outside in all directions leaves to the outside again.
        let want = 1.0 - (1.0 - outside) / (n * n);
        assert!((inside - want).abs() <= 1e-15, "{n}: {inside} {want}");
        // Walsh's closed form, where its terms still cancel to enough digits.
        if n > 1.01 && n < 100.0 {
            let (n2, n4) = (n * n, n.powi(4));
            let walsh = 0.5
                + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * (n + 1.0).powi(2))
                + n2 * (n2 - 1.0).powi(2) / (n2 + 1.0).powi(3) * ((n - 1.0) / (n + 1.0)).ln()
                - 2.0 * n * n2 * (n2 + 2.0 * n - 1.0) / ((n2 + 1.0) * (n4 - 1.0))
                + 8.0 * n4 * (n4 + 1.0) / ((n2 + 1.0) * (n4 - 1.0).powi(2)) * n.ln();
            let allowed = 1e-13 + 1e-15 * (n - 1.0).powi(-2);
            assert!((outside - walsh).abs() <= allowed, "{n}: {outside} {walsh}");
        }
    }
    // n = 1 + δ: F → δ/3.
    let near = Dielectric::new(1.0 + 1e-9).unwrap().average();
    assert!((near / ((1.0_f64 + 1e-9) - 1.0) * 3.0 - 1.0).abs() < 1e-7, "{near}");
}
