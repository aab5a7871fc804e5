//! Every model under test at random, awkward and impossible directions.

use brdf::Real;
use proptest::prelude::*;

use super::inputs::{pairs, uniforms};
use brdf_checks::models::{self, Entry};
use brdf_checks::sound::assert_sound;

fn assert_all_sound<T: Real<Mask = bool> + Into<f64>>(
    models: &[Entry<T>],
    pair: [[f64; 3]; 2],
    u: [f64; 2],
) {
    for entry in models {
        let largest = |cos_i, cos_o| entry.promises.weight(cos_i, cos_o);
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
        assert_all_sound(models::single(), pair, u);
    }

    #[test]
    fn every_answer_is_sound_in_f64(pair in pairs(), u in uniforms()) {
        assert_all_sound(models::double(), pair, u);
    }
}
