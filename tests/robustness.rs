//! No NaN, no infinity, nothing negative and no panic, whatever the directions.

mod common;

use std::f64::consts::FRAC_PI_2;

use brdf::{Real, Vector, from_spherical};
use common::models::{self, Entry};
use glam::Vec3;
use proptest::prelude::*;

thread_local! {
    static F32: Vec<Entry<f32>> = models::all();
    static F64: Vec<Entry<f64>> = models::all();
}

/// Numbers that formulas trip over: zeros, the smallest, the just-not-zero, the just-not-one.
const AWKWARD: [f64; 16] = [
    0.0, -0.0, 1e-320, 1e-45, 1e-38, 1e-20, 1e-7, -1e-7, 1e-3, 0.5, 0.9999999, 1.0, 1.0000001,
    -1.0, 1e10, -1e38,
];

fn awkward_numbers() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -1.0..1.0_f64,
        2 => prop::sample::select(AWKWARD.to_vec()),
        1 => prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO,
    ]
}

/// A direction: mostly above the surface, often grazing or close to the normal, sometimes no unit
/// vector at all.
fn directions() -> impl Strategy<Value = [f64; 3]> {
    let unit = (0.0..FRAC_PI_2, -3.2..3.2_f64).prop_map(|(t, p)| from_spherical(t, p).to_array());
    let grazing = (prop::sample::select(AWKWARD.to_vec()), -3.2..3.2_f64)
        .prop_map(|(z, phi): (f64, f64)| [phi.cos(), phi.sin(), z]);
    let near_normal = (-1e-4..1e-4_f64, -1e-4..1e-4_f64).prop_map(|(x, y)| [x, y, 1.0]);
    let any = prop::array::uniform3(awkward_numbers());
    prop_oneof![5 => unit, 3 => grazing, 2 => near_normal, 2 => any]
}

/// Pairs, with mirror, equal and opposite ones among them.
fn pairs() -> impl Strategy<Value = ([f64; 3], [f64; 3])> {
    (directions(), directions(), 0..6_u8).prop_map(|(wi, wo, relation)| {
        let wi = match relation {
            0 => [-wo[0], -wo[1], wo[2]],
            1 => wo,
            2 => [-wo[0], -wo[1], -wo[2]],
            _ => wi,
        };
        (wi, wo)
    })
}

/// What must hold of one model at one pair of directions.
fn assert_sound<T: Real<Mask = bool> + Into<f64> + PartialOrd>(
    entry: &Entry<T>,
    (wi, wo): ([f64; 3], [f64; 3]),
    u: [f64; 2],
) {
    let vector =
        |w: [f64; 3]| <T::Vec3 as Vector<T>>::new(T::lit(w[0]), T::lit(w[1]), T::lit(w[2]));
    let sound = |what: &str, value: T| {
        let value: f64 = value.into();
        let fine = value.is_finite() && value >= 0.0;
        assert!(fine, "{}: {what} is {value} at wi {wi:?} wo {wo:?} u {u:?}", entry.name);
    };
    let each = |what: &str, color: T::Vec3| {
        sound(what, color.x());
        sound(what, color.y());
        sound(what, color.z());
    };
    let (wi, wo) = (vector(wi), vector(wo));
    let value = entry.model.eval(wi, wo);
    each("eval", value);
    let pdf = entry.model.pdf(wi, wo);
    sound("pdf", pdf);
    if !(wi.z() > T::lit(0.0) && wo.z() > T::lit(0.0)) {
        let sum: f64 = (value.x() + value.y() + value.z() + pdf).into();
        assert_eq!(sum, 0.0, "{}: not zero below the surface", entry.name);
    }
    let sample = entry.model.sample(wo, [T::lit(u[0]), T::lit(u[1])]);
    each("weight", sample.weight);
    sound("sample pdf", sample.pdf);
    // As long as the direction it mirrors, whose length may be 0.5 % off.
    for component in [sample.wi.x(), sample.wi.y(), sample.wi.z()] {
        let component: f64 = component.into();
        assert!(component.abs() <= 1.0051, "{}: sample {component} for {wo:?}", entry.name);
    }
}

/// Uniform numbers in [0, 1), with the ends: 0 and the last `f32` below 1.
fn uniforms() -> impl Strategy<Value = [f64; 2]> {
    let one = prop_oneof![
        4 => 0.0..0.9999999_f64,
        1 => Just(0.0),
        1 => Just(1.0 - 2.0_f64.powi(-24)),
        1 => Just(2.0_f64.powi(-24)),
        1 => Just(0.5),
    ];
    [one.clone(), one]
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 20_000,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn every_answer_is_sound_in_f32(pair in pairs(), u in uniforms()) {
        F32.with(|models| models.iter().for_each(|entry| assert_sound(entry, pair, u)));
    }

    #[test]
    fn every_answer_is_sound_in_f64(pair in pairs(), u in uniforms()) {
        F64.with(|models| models.iter().for_each(|entry| assert_sound(entry, pair, u)));
    }

    #[test]
    fn non_finite_directions_do_not_panic(
        wi in prop::array::uniform3(prop::num::f32::ANY),
        wo in prop::array::uniform3(prop::num::f32::ANY),
    ) {
        let (wi, wo) = (Vec3::from_array(wi), Vec3::from_array(wo));
        F32.with(|models| for entry in models {
            let _ = entry.model.eval(wi, wo);
            let _ = entry.model.pdf(wi, wo);
            let _ = entry.model.sample(wo, [0.3, 0.7]);
            if !(wi.is_finite() && wo.is_finite()) {
                assert_eq!(entry.model.eval(wi, wo), Vec3::ZERO, "{}", entry.name);
                assert_eq!(entry.model.pdf(wi, wo), 0.0, "{}", entry.name);
            }
        });
    }
}
