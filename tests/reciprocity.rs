//! f(wi, wo) = f(wo, wi), to the rounding of the last steps.

mod common;

use common::directions::pairs;
use common::models;
use glam::{DVec3, Vec3};

macro_rules! reciprocity {
    ($test:ident, $float:ident, $vector:ident, $narrow:expr, $bound:expr) => {
        #[test]
        fn $test() {
            let pairs: Vec<($vector, $vector)> =
                pairs(20_000).into_iter().map(|(wi, wo)| ($narrow(wi), $narrow(wo))).collect();
            for entry in models::all::<$float>() {
                let mut worst: $float = 0.0;
                for &(wi, wo) in &pairs {
                    let (there, back) = (entry.model.eval(wi, wo), entry.model.eval(wo, wi));
                    let difference = (there - back).abs().max_element();
                    worst = worst.max(difference / there.max(back).max_element().max(1e-30));
                }
                let ulps = worst / $float::EPSILON;
                if entry.reciprocal {
                    assert!(ulps <= $bound, "{}: {ulps} ulp", entry.name);
                } else {
                    assert!(worst > 0.01, "{} is reciprocal after all: {worst}", entry.name);
                }
            }
        }
    };
}
reciprocity!(in_f64, f64, DVec3, |w: DVec3| w, 8.0);
reciprocity!(in_f32, f32, Vec3, |w: DVec3| w.as_vec3(), 8.0);
