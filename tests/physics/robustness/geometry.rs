//! Frames, mirror and refracted directions, angles, for odd vectors and indices.

use std::f64::consts::{FRAC_PI_2, PI};

use brdf::{
    Frame, Pair, Real, Vector, above_surface, brewster_angle, critical_angle, from_spherical,
    reflect, refract, to_spherical,
};
use glam::{DVec3, Vec3};
use proptest::prelude::*;

use super::inputs::{NUMBERS, directions, pairs};

/// Vectors of all lengths, along the axes, in the planes and anywhere.
fn vectors() -> Vec<[f64; 3]> {
    let mut vectors = directions();
    for a in NUMBERS {
        vectors.extend([[a, 0.0, 0.0], [0.0, a, 0.0], [0.0, 0.0, a], [a, -a, a], [1.0, a, -1.0]]);
        vectors.extend([[a, 1e-20, -1.0], [1e-3, a, 1e-3]]);
    }
    vectors
}

/// How far three vectors are from orthonormal and right-handed.
fn skewness([x, y, z]: [DVec3; 3]) -> f64 {
    let lengths = [x, y, z].map(|v| (v.length() - 1.0).abs()).into_iter().fold(0.0, f64::max);
    let angles = [x.dot(y), y.dot(z), z.dot(x)].map(f64::abs).into_iter().fold(0.0, f64::max);
    lengths.max(angles).max((x.cross(y) - z).length())
}

#[test]
fn every_frame_is_orthonormal() {
    for n in vectors() {
        let (double, single) = (DVec3::from_array(n), DVec3::from_array(n).as_vec3());
        let axes = |frame: Frame<Vec3>| {
            [frame.tangent(), frame.bitangent(), frame.normal()].map(Vec3::as_dvec3)
        };
        let frame = Frame::from_normal(double);
        let skew = skewness([frame.tangent(), frame.bitangent(), frame.normal()]);
        assert!(skew < 1e-15, "{n:?}: {skew}");
        let skew = skewness(axes(Frame::from_normal(single)));
        assert!(skew < 5e-7, "{n:?}: {skew}");
        for t in vectors() {
            let frame = Frame::from_normal_and_tangent(double, DVec3::from_array(t));
            let skew = skewness([frame.tangent(), frame.bitangent(), frame.normal()]);
            assert!(skew < 1e-15, "{n:?} {t:?}: {skew}");
            let tangent = DVec3::from_array(t).as_vec3();
            let skew = skewness(axes(Frame::from_normal_and_tangent(single, tangent)));
            assert!(skew < 5e-7, "{n:?} {t:?}: {skew}");
        }
    }
}

fn angles_are_in_range<T: Real<Mask = bool> + Into<f64>>(half_turn: f64) {
    for v in vectors() {
        let w = <T::Vec3 as Vector<T>>::new(T::lit(v[0]), T::lit(v[1]), T::lit(v[2]));
        let [x, y, z]: [f64; 3] = [w.x(), w.y(), w.z()].map(Into::into);
        // A direction: anything whose square neither overflows nor vanishes.
        let length = (x * x + y * y + z * z).sqrt();
        if (1e-18..1e18).contains(&length) {
            let (theta, phi): (T, T) = to_spherical(w);
            let (theta, phi): (f64, f64) = (theta.into(), phi.into());
            assert!((0.0..=half_turn).contains(&theta), "{v:?}: {theta}");
            assert!((-half_turn..=half_turn).contains(&phi), "{v:?}: {phi}");
            assert!((theta.cos() - z / length).abs() < 3e-7, "{v:?}: {theta}");
        }
    }
}

#[test]
fn spherical_angles_stay_in_their_ranges() {
    angles_are_in_range::<f32>(f64::from(std::f32::consts::PI));
    angles_are_in_range::<f64>(PI);
    for theta in [0.0, 5e-324, 1e-20, FRAC_PI_2, PI, -1.0, 1e3] {
        for phi in [0.0, 5e-324, PI, -1e4] {
            assert!((from_spherical(theta, phi).length() - 1.0).abs() < 1e-15, "{theta} {phi}");
        }
    }
}

#[test]
fn the_horizon_and_the_length_decide_what_is_above() {
    for z in [0.0, -0.0, -1e-30, f32::NAN, -1.0] {
        let x = (1.0 - z * z).max(0.0).sqrt();
        assert!(!above_surface(Vec3::new(x, 0.0, z)), "{z}");
    }
    for z in [f32::from_bits(1), 1e-38, 1e-7, 1.0] {
        assert!(above_surface(Vec3::new((1.0 - z * z).sqrt(), 0.0, z)), "{z}");
    }
    for length in [0.0, 1e-30, 0.99, 1.01, 1e30, f64::INFINITY, f64::NAN] {
        assert!(!above_surface(DVec3::new(0.6, 0.0, 0.8) * length), "{length}");
    }
    assert!(above_surface(DVec3::new(0.6, 0.0, 0.8) * 0.996));
    assert!(above_surface(DVec3::new(0.6, 0.0, 0.8) * 1.004));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// The half vector is a unit vector for every pair above the surface, opposite ones included.
    #[test]
    fn half_vectors_are_units([wi, wo] in pairs()) {
        let pair = Pair::<f64>::new(DVec3::from_array(wi), DVec3::from_array(wo));
        if pair.above {
            prop_assert!((pair.h.length() - 1.0).abs() < 1e-15, "{:?}", pair);
            prop_assert!(pair.cos_h > 0.0 && pair.cos_d > 0.0, "{:?}", pair);
        }
        let [wi, wo] = [wi, wo].map(|w| DVec3::from_array(w).as_vec3());
        let pair = Pair::<f32>::new(wi, wo);
        if pair.above {
            prop_assert!((pair.h.length() - 1.0).abs() < 1e-6, "{:?}", pair);
            prop_assert!(pair.cos_h > 0.0 && pair.cos_d > 0.0, "{:?}", pair);
        }
    }

    /// Whatever the indices, a refracted direction is a unit vector: on the other side and along
    /// Snell's law, or the mirror direction.
    #[test]
    fn refracted_directions_are_units(
        cos in prop_oneof![-1.0..1.0_f64, prop::sample::select(vec![0.0, 1.0, -1.0, 1e-20, -1e-7])],
        azimuth in -3.2..3.2_f64,
        above in -4.0..4.0_f64,
        below in -4.0..4.0_f64,
    ) {
        let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
        let w = DVec3::new(sin * azimuth.cos(), sin * azimuth.sin(), cos);
        let (above, below) = (10_f64.powf(above), 10_f64.powf(below));
        let answer = refract(w, DVec3::Z, above, below);
        let t = answer.direction;
        if answer.total_internal_reflection {
            prop_assert_eq!(t, reflect(w, DVec3::Z));
        } else {
            // Rounding of the length of w counts as often as the ratio is large.
            let ratio = if cos < 0.0 { below / above } else { above / below };
            prop_assert!((t.length() - 1.0).abs() < 1e-15 * (4.0 + ratio), "{}", t.length());
            prop_assert!(t.z * cos <= 0.0);
            prop_assert!((ratio * sin - t.truncate().length()).abs() < 1e-15 * (1.0 + ratio));
        }
    }
}

#[test]
fn critical_and_brewster_angles_of_all_indices() {
    let indices = [1e-4, 1e-3, 1.0 - f64::EPSILON, 1.0, 1.0 + f64::EPSILON, 100.0, 1e4];
    for (n1, n2) in indices.into_iter().flat_map(|a| indices.map(|b| (a, b))) {
        let critical = critical_angle(n1, n2);
        assert!(critical > 0.0 && critical <= FRAC_PI_2, "{n1} {n2}: {critical}");
        assert!(n2 < n1 || critical == FRAC_PI_2, "{n1} {n2}: {critical}");
        let brewster = brewster_angle(n1, n2);
        assert!(brewster > 0.0 && brewster < FRAC_PI_2, "{n1} {n2}: {brewster}");
        assert!((brewster.tan() / (n2 / n1) - 1.0).abs() < 1e-7, "{n1} {n2}: {brewster}");
        // Light that arrives at either side under Brewster's angle meets itself at the other.
        assert!((brewster + brewster_angle(n2, n1) - FRAC_PI_2).abs() < 1e-15, "{n1} {n2}");
    }
}
