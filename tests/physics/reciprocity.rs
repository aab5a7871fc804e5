//! f(wi, wo) = f(wo, wi) to the last bit, or not at all.

use brdf_checks::directions::{pairs_to_grazing, pairs_to_power};
use brdf_checks::measure::reciprocity::reciprocity;
use brdf_checks::models;
use glam::{DVec3, Vec3};

macro_rules! reciprocity {
    ($test:ident, $models:expr, $float:ident, $vector:ident, $narrow:expr) => {
        #[test]
        fn $test() {
            let pairs: Vec<($vector, $vector)> = pairs_to_grazing(100_000)
                .into_iter()
                .chain(pairs_to_power(20_000, 20.0))
                .map(|(wi, wo)| ($narrow(wi), $narrow(wo)))
                .collect();
            for entry in $models {
                let found = reciprocity(&*entry.model, &pairs, f64::from($float::EPSILON));
                println!("{:45} {found:?}", entry.name);
                assert_eq!(
                    entry.model.is_reciprocal(),
                    entry.promises.reciprocal,
                    "{}",
                    entry.name
                );
                if entry.promises.reciprocal {
                    assert!(found.ulp == 0.0, "{}: {found:?}", entry.name);
                } else {
                    assert!(found.relative > 0.5, "{} is reciprocal after all", entry.name);
                }
            }
        }
    };
}
reciprocity!(in_f64, models::double(), f64, DVec3, |w: DVec3| w);
reciprocity!(in_f32, models::single(), f32, Vec3, |w: DVec3| w.as_vec3());
