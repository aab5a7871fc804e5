//! Limits of the exact reflectances.

use brdf::fresnel::{conductor_polarized, dielectric_polarized, normal_incidence};
use brdf::{
    Conductor, Constant, Cook, Dielectric, Fresnel, Hall, Schlick, brewster_angle, critical_angle,
};
use glam::Vec3;

pub(crate) fn dielectric(ior: f64, cos: f64) -> f64 {
    Dielectric::new(ior).unwrap().reflectance(cos)
}

pub(crate) fn conductor(eta: f64, k: f64, cos: f64) -> f64 {
    Conductor::new(eta, k).unwrap().reflectance(cos)
}

/// Cosines in [0, 1], dense, and denser towards both ends.
pub(crate) fn cosines() -> Vec<f32> {
    let even = (0..=400_u16).map(|i| f32::from(i) / 400.0);
    let grazing = (1..=149).map(|i| 0.5_f32.powi(i));
    let normal = (1..=24).map(|i| 1.0 - 0.5_f32.powi(i));
    even.chain(grazing).chain(normal).collect()
}

/// Indices over the whole range, dense, and denser towards 1 from both sides. Without 1.
pub(crate) fn indices() -> Vec<f32> {
    let even = (-159..=160_i16).map(|i| 10_f32.powf(f32::from(i) / 40.0));
    let near = (1..=23).flat_map(|i| [1.0 - 0.5_f32.powi(i + 1), 1.0 + 0.5_f32.powi(i)]);
    even.chain(near).filter(|n| *n != 1.0).collect()
}

pub(crate) fn extinctions() -> impl Iterator<Item = f32> {
    [0.0, 1e-30].into_iter().chain((-40..=20_i16).map(|i| 10_f32.powf(f32::from(i) / 5.0)))
}

#[test]
fn types_need_no_annotation() -> Result<(), brdf::ParameterError> {
    let gold = Conductor::new(Vec3::new(0.14, 0.43, 1.38), Vec3::new(3.697, 2.455, 1.914))?;
    let glass = Dielectric::new(1.5_f32)?;
    let green: f32 = gold.reflectance(0.5).y - glass.reflectance(0.5);
    assert!((green - 0.6989452_f32).abs() < 1e-6, "{green}");
    let terms: Vec<Box<dyn Fresnel<Color = Vec3>>> =
        vec![Box::new(gold), Box::new(Hall::new(Vec3::splat(0.5), 1.5)?)];
    assert_eq!(terms[1].reflectance(1.0), Vec3::splat(0.5));
    Ok(())
}

#[test]
fn parameters_out_of_range_are_refused() {
    assert_eq!(Dielectric::new(0.0_f64).unwrap_err().parameter(), "ior");
    assert_eq!(Dielectric::new(Vec3::new(1.5, f32::NAN, 1.5)).unwrap_err().parameter(), "ior");
    assert_eq!(Conductor::new(0.0_f64, 1.0).unwrap_err().parameter(), "eta");
    assert_eq!(Conductor::new(1.0_f64, -1.0).unwrap_err().parameter(), "k");
    assert_eq!(Schlick::new(1.1_f64).unwrap_err().parameter(), "f0");
    assert_eq!(Hall::new(1.1_f64, 1.5).unwrap_err().parameter(), "f0");
    assert_eq!(Hall::new(1.0_f64, 0.0).unwrap_err().parameter(), "ior");
    assert_eq!(Cook::new(0.5_f64, -1.0, 1.5).unwrap_err().parameter(), "light");
    assert_eq!(Constant::new(-0.1_f64).unwrap_err().parameter(), "reflectance");
    let error = brdf::fresnel::index_from_normal_incidence(1.0_f64).unwrap_err();
    assert_eq!(error.parameter(), "r0");
}

#[test]
fn without_a_surface_nothing_is_reflected() {
    for cos in cosines() {
        for cos in [cos, -cos] {
            assert_eq!(Dielectric::new(1.0_f32).unwrap().reflectance(cos), 0.0, "{cos}");
            assert_eq!(dielectric(1.0, f64::from(cos)), 0.0, "{cos}");
            assert_eq!(dielectric_polarized(1.0, cos).unpolarized(), 0.0, "{cos}");
            assert_eq!(Conductor::new(1.0_f32, 0.0).unwrap().reflectance(cos), 0.0, "{cos}");
            assert_eq!(conductor(1.0, 0.0, f64::from(cos)), 0.0, "{cos}");
            assert_eq!(conductor_polarized(1.0, 0.0, cos).unpolarized(), 0.0, "{cos}");
        }
    }
    assert_eq!(Dielectric::new(1.0_f64).unwrap().average(), 0.0);
    assert_eq!(Dielectric::new(1.0_f32).unwrap().average(), 0.0);
    assert_eq!(Conductor::new(1.0_f32, 0.0).unwrap().average(), 0.0);
}

#[test]
fn at_grazing_everything_is_reflected() {
    for ior in indices() {
        for cos in [0.0, -0.0] {
            assert_eq!(Dielectric::new(ior).unwrap().reflectance(cos), 1.0, "{ior}");
            assert_eq!(dielectric_polarized(ior, cos).unpolarized(), 1.0, "{ior}");
            assert_eq!(dielectric(f64::from(ior), f64::from(cos)), 1.0, "{ior}");
            for k in extinctions() {
                // The square of a rounded root, and the products above and below the line.
                let single = Conductor::new(ior, k).unwrap().reflectance(cos);
                assert!((1.0 - 4.0 * f32::EPSILON..=1.0).contains(&single), "{ior} {k}: {single}");
                let double = conductor(f64::from(ior), f64::from(k), 0.0);
                assert!((1.0 - 4.0 * f64::EPSILON..=1.0).contains(&double), "{ior} {k}: {double}");
            }
        }
    }
    let faint = Conductor::new(1.0_f32, 1e-18).unwrap().reflectance(0.0);
    assert!((1.0 - 4.0 * f32::EPSILON..=1.0).contains(&faint), "{faint}");
}

#[test]
fn at_normal_incidence() {
    for n in indices().into_iter().map(f64::from) {
        let want = normal_incidence(n, 0.0);
        for cos in [1.0, -1.0] {
            assert!((dielectric(n, cos) - want).abs() <= 2e-15 * want, "{n}");
        }
        for k in extinctions().map(f64::from) {
            let want = normal_incidence(n, k);
            let polarized = conductor_polarized(n, k, 1.0);
            for got in [conductor(n, k, 1.0), polarized.s, polarized.p] {
                assert!((got - want).abs() <= 4e-15 * want, "{n} {k}: {got} {want}");
            }
        }
    }
}

#[test]
fn total_reflection_is_total() {
    for n in indices().into_iter().filter(|n| *n < 1.0) {
        let critical = (1.0 - f64::from(n).powi(2)).sqrt();
        for cos in cosines().into_iter().filter(|cos| f64::from(*cos) < critical - 1e-6) {
            assert_eq!(Dielectric::new(n).unwrap().reflectance(cos), 1.0, "{n} {cos}");
            let polarized = dielectric_polarized(n, cos);
            assert_eq!((polarized.s, polarized.p), (1.0, 1.0), "{n} {cos}");
            assert_eq!(dielectric(f64::from(n), f64::from(cos)), 1.0, "{n} {cos}");
            let from_below = dielectric(1.0 / f64::from(n), -f64::from(cos));
            assert_eq!(if cos == 0.0 { 1.0 } else { from_below }, 1.0, "{n} {cos}");
        }
    }
}

#[test]
fn around_the_critical_angle() {
    for n in [0.2_f64, 0.5, 1.0 / 1.5, 0.75, 0.99] {
        let critical = critical_angle(1.0, n).cos();
        assert!(dielectric(n, critical) > 1.0 - 1e-6);
        assert_eq!(dielectric(n, critical - 1e-9), 1.0);
        // Inside, R falls as 1 − (4/c + 2c/n²) q with q = √(2 c δ), c at the critical angle.
        let delta = 1e-8;
        let q = (2.0 * critical * delta).sqrt();
        let fall = (4.0 / critical + 2.0 * critical / (n * n)) * q;
        let got = 1.0 - dielectric(n, critical + delta);
        assert!((got / fall - 1.0).abs() < 0.02, "{n}: {got} {fall}");
    }
}

#[test]
fn at_brewsters_angle_from_either_side() {
    // Beyond, Brewster's angle is so close to the normal or to grazing that its cosine has too few
    // digits.
    for n in indices().into_iter().map(f64::from).filter(|n| (0.05..=20.0).contains(n)) {
        let s = ((n - 1.0) * (n + 1.0) / (n * n + 1.0)).powi(2);
        for (ior, cos) in [
            (n, brewster_angle(1.0, n).cos()),
            (n, -brewster_angle(n, 1.0).cos()),
            (1.0 / n, -brewster_angle(1.0, n).cos()),
        ] {
            let polarized = dielectric_polarized(ior, cos);
            assert!((polarized.s - s).abs() <= 1e-12 * s.sqrt(), "{n}: {} {s}", polarized.s);
            // The rounding of the cosine, enlarged by the slope of the amplitude.
            let allowed = (1e-15 * (n + 1.0 / n).powi(3)).powi(2);
            assert!(polarized.p <= allowed, "{n}: {:e}", polarized.p);
        }
    }
}

#[test]
fn the_same_from_either_side_along_a_refracted_ray() {
    for n in indices().into_iter().map(f64::from).filter(|n| *n > 1.0) {
        for cos in cosines().into_iter().map(f64::from) {
            let cos_refracted = (1.0 - (1.0 - cos) * (1.0 + cos) / (n * n)).sqrt();
            let (outside, inside) = (dielectric(n, cos), dielectric(n, -cos_refracted));
            // From inside, the rounding of the refracted cosine counts as an angle.
            if cos > 0.05 {
                let allowed = 1e-13 * (n * n).max(1.0) / (cos * cos);
                assert!((outside - inside).abs() <= allowed, "{n} {cos}: {outside} {inside}");
            }
        }
    }
}

#[test]
fn from_the_other_side_the_index_is_inverted() {
    for n in [0.3_f64, 0.75, 1.33, 1.5, 2.42, 40.0] {
        for cos in cosines().into_iter().map(f64::from).filter(|cos| *cos > 0.0) {
            let near_critical = (1.0 - 1.0 / (n * n).max(1.0 / (n * n))).sqrt();
            if (cos - near_critical).abs() > 1e-3 {
                let (got, want) = (dielectric(n, -cos), dielectric(1.0 / n, cos));
                assert!((got - want).abs() <= 1e-12 * want, "{n} {cos}: {got} {want}");
            }
        }
    }
}

#[test]
fn a_conductor_that_does_not_absorb_is_a_dielectric() {
    for n in indices().into_iter().map(f64::from) {
        for cos in cosines().into_iter().map(f64::from) {
            let q_squared = n * n - (1.0 - cos) * (1.0 + cos);
            if q_squared.abs() > 1e-3 * n * n {
                let (got, want) = (conductor(n, 0.0, cos), dielectric(n, cos));
                assert!((got - want).abs() <= 1e-13 * want, "{n} {cos}: {got} {want}");
                let (got, want) = (conductor_polarized(n, 0.0, cos), dielectric_polarized(n, cos));
                assert!((got.s - want.s).abs() <= 1e-13 * want.s, "{n} {cos}");
                assert!((got.p - want.p).abs() <= 1e-13 * want.s, "{n} {cos}");
            }
        }
    }
    for cos in [0.1, 0.5, 0.9] {
        let (weak, none) = (conductor(1.5, 1e-9, cos), conductor(1.5, 0.0, cos));
        assert!((weak - none).abs() < 1e-15);
    }
}

#[test]
fn close_to_index_one() {
    // n = 1 + δ: r_s → δ/(2c²), r_p → r_s (1 − 2c²), from either side of 1.
    for delta in [1e-3_f64, 1e-6, 1e-9, 1e-12, -1e-3, -1e-6, -1e-9, -1e-12] {
        let n = 1.0 + delta;
        let delta = n - 1.0;
        for c in [0.3_f64, 0.5, 0.7, 0.9, 1.0] {
            let s = (delta / (2.0 * c * c)).powi(2);
            let want = s * (1.0 + (1.0 - 2.0 * c * c).powi(2)) / 2.0;
            let allowed = want * (40.0 * delta.abs() / c.powi(2) + 1e-14);
            for got in [dielectric(n, c), dielectric(n, -c), conductor(n, 0.0, c)] {
                assert!((got - want).abs() <= allowed, "{delta} {c}: {got:e} {want:e}");
            }
        }
    }
}

#[test]
fn huge_indices_are_mirrors() {
    for (n, k) in [(1e4, 0.0), (1e4, 1e4), (1e-4, 1e4), (1.0, 1e4)] {
        for c in [1.0, 0.5, 0.1] {
            // 1 − R_s → 4 n c/|N|², 1 − R_p → 4 n/(c |N|²).
            let want = 2.0 * n * (c + 1.0 / c) / (n * n + k * k);
            let got = 1.0 - conductor(n, k, c);
            assert!((got - want).abs() <= 0.005 * want + 1e-15, "{n} {k} {c}: {got:e} {want:e}");
        }
    }
}
