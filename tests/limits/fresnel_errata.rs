//! Equivalent forms of Fresnel's equations, and printed formulas that are wrong, with the numbers
//! that show it.

use brdf::fresnel::{forms, index_from_normal_incidence, normal_incidence};
use brdf::{Cook, Fresnel};

use super::fresnel::{conductor, cosines, dielectric, extinctions, indices};

fn close(got: f64, want: f64, digits: f64) {
    assert!((got - want).abs() <= 0.5 * digits, "got {got}, want {want}");
}

/// The (g, c) form with the printed sign.
fn gc_printed(n: f64, c: f64) -> f64 {
    let g = (n * n + c * c - 1.0).sqrt();
    let ratio = (c * (g + c) - 1.0) / (c * (g - c) - 1.0);
    0.5 * ((g - c) / (g + c)).powi(2) * (1.0 + ratio * ratio)
}

/// The (a, b, u) form with the printed 1/u.
fn abu_printed(a: f64, b: f64, u: f64) -> f64 {
    let inner = ((a + u - 1.0 / u).powi(2) + b * b) / ((a - u + 1.0 / u).powi(2) + b * b);
    0.5 * ((a - u).powi(2) + b * b) / ((a + u).powi(2) + b * b) * (inner + 1.0)
}

#[test]
fn the_forms_are_equal() {
    for n in indices().into_iter().map(f64::from) {
        for u in cosines().into_iter().map(f64::from) {
            // Differences in the forms cancel: absolutely near n = 1, and as a root near the
            // critical angle.
            let q_squared = n * n - (1.0 - u) * (1.0 + u);
            if q_squared.abs() < 1e-3 * n * n || n < 0.01 {
                continue;
            }
            let got = forms::gc(n, u);
            close(got, dielectric(n, u), 4e-11);
            for k in extinctions().step_by(5).map(f64::from) {
                close(forms::abu(n, k, u), conductor(n, k, u), 4e-11);
            }
        }
    }
}

#[test]
fn the_sign_in_the_gc_form() {
    close(gc_printed(1.5, 1.0), 0.20, 1e-12);
    close(forms::gc(1.5, 1.0), 0.04, 1e-12);
    close(gc_printed(2.42, 1.0), 2.948, 1e-3);
    close(forms::gc(2.42, 1.0), 0.17239, 1e-5);
    let pole = (2.42_f64 * 2.42 - 3.0).powf(-0.5);
    close(pole, 0.59168, 1e-5);
    assert!(gc_printed(2.42, pole) > 1e20);
    close(gc_printed(2.42, 0.6), 846.0, 1.0);
    close(forms::gc(2.42, 0.6), 0.19297, 1e-5);
    // Where a spot check would miss it.
    close(gc_printed(1.5, 0.5), 0.092399, 1e-6);
    close(forms::gc(1.5, 0.5), 0.089187, 1e-6);
}

#[test]
fn the_abu_form_at_grazing() {
    let (a, b) = forms::ab(1.5, 0.0, 0.0);
    assert!(abu_printed(a, b, 0.0).is_nan());
    assert_eq!(forms::abu(1.5, 0.0, 0.0), 1.0);
    let (a, b) = forms::ab(1.5, 0.0, 1e-8);
    close(1.0 - abu_printed(a, b, 1e-8), 5.81378e-8, 1e-13);
    close(1.0 - forms::abu(1.5, 0.0, 1e-8), 5.81378e-8, 1e-13);
}

#[test]
fn a_dielectric_has_b_zero_only_before_total_reflection() {
    let (n, u) = (0.5_f64, 0.5);
    assert!((n * n + u * u - 1.0).sqrt().is_nan());
    let (a, b) = forms::ab(n, 0.0, u);
    assert!(a == 0.0 && (b * b - 0.5).abs() < 1e-15, "{a} {b}");
    close(forms::abu(n, 0.0, u), 1.0, 1e-15);
}

#[test]
fn the_index_is_the_relative_one() {
    // From glass into air at half a radian.
    let cos = 0.5_f64.cos();
    close(dielectric(1.0 / 1.5, cos), 0.0514261, 1e-7);
    close(dielectric(1.5, -cos), 0.0514261, 1e-7);
    close(dielectric(1.5, cos), 0.0412417, 1e-7);
}

#[test]
fn metals_need_k_at_normal_incidence() {
    close(normal_incidence(0.14, 0.0), 0.56910, 1e-5);
    close(normal_incidence(0.14, 3.697), 0.96259, 1e-5);
}

#[test]
fn an_index_from_the_reflectance_of_a_metal_is_not_its_index() {
    let n = index_from_normal_incidence(normal_incidence(0.14, 3.697)).unwrap();
    close(n, 104.9, 0.1);
    let cos = 89.5_f64.to_radians().cos();
    close((dielectric(n, cos) - conductor(0.14, 3.697, cos)).abs(), 0.497, 1e-3);
    assert!(index_from_normal_incidence(1.0_f64).is_err());
}

#[test]
fn grazing_reflects_all_unless_there_is_no_surface() {
    assert_eq!(dielectric(1.0, 0.0), 0.0);
    assert_eq!(dielectric(1.0 + 1e-12, 0.0), 1.0);
    close(conductor(1.0, 1e-12, 0.0), 1.0, 1e-15);
}

#[test]
fn cooks_two_ends_must_be_of_one_kind() {
    // Find the cosine where the weight is ½.
    let normal = dielectric(1.5, 1.0);
    let weight = |cos: f64| (dielectric(1.5, cos) - normal) / (1.0 - normal);
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if weight(middle) > 0.5 { low = middle } else { high = middle }
    }
    let (f0, light) = (0.2, 0.5);
    close(Cook::new(f0, light, 1.5).unwrap().reflectance(low), 0.30, 1e-12);
    let printed = f0 + (light - f0) * weight(low);
    close(printed, 0.35, 1e-12);
    close(printed * light, 0.175, 1e-12);
}
