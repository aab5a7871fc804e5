//! Every model under test at random, awkward and impossible directions.

use std::f64::consts::PI;

use brdf::Real;
use proptest::prelude::*;

use super::inputs::{pairs, uniforms};
use crate::common::models::{self, Entry};
use crate::common::sound::assert_sound;

thread_local! {
    static F32: Vec<Entry<f32>> = models::all();
    static F64: Vec<Entry<f64>> = models::all();
}

fn assert_all_sound<T: Real<Mask = bool> + Into<f64>>(
    models: &[Entry<T>],
    pair: [[f64; 3]; 2],
    u: [f64; 2],
) {
    for entry in models {
        // Of the models that conserve energy, Blinn and Phong's lobe has the largest weights: 8
        // for exponent 0, Lambert's surface, sampled by half vectors all the same. The
        // printed lobes are at most 4/D(N) ≤ 4π times a microfacet surface. Oren and Nayar's
        // surface is brighter by 0.45 times the tangent of the smaller angle.
        let lobe = if entry.gain.is_none() { 8.0 } else { 4.0 * PI };
        let grooves = if entry.name.contains("Oren-Nayar") { 0.45 } else { 0.0 };
        let largest = |cos_i: f64, cos_o: f64| lobe + grooves / cos_i.max(cos_o);
        assert_sound(entry.name, entry.model.as_ref(), largest, pair, u);
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 10_000,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn every_answer_is_sound_in_f32(pair in pairs(), u in uniforms()) {
        F32.with(|models| assert_all_sound(models, pair, u));
    }

    #[test]
    fn every_answer_is_sound_in_f64(pair in pairs(), u in uniforms()) {
        F64.with(|models| assert_all_sound(models, pair, u));
    }
}
