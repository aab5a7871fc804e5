//! Uniform numbers at the ends of [0, 1) and beyond.

use brdf::{Beckmann, Blinn, Distribution, Gaussian, Ggx, Mixture, Real, Smith, Vector};

use super::inputs::{COSINES, UNIFORMS, direction, directions};
use brdf_checks::models::{self, Entry};
use brdf_checks::sound::assert_sound;

/// Pairs of the numbers of [`UNIFORMS`].
fn squares() -> impl Iterator<Item = [f64; 2]> {
    UNIFORMS.into_iter().flat_map(|u| UNIFORMS.into_iter().map(move |v| [u, v]))
}

fn ends_are_sound<T: Real<Mask = bool> + Into<f64>>(models: &[Entry<T>]) {
    let viewers: Vec<_> = directions().into_iter().step_by(3).collect();
    for entry in models {
        for &wo in &viewers {
            for u in squares() {
                let largest = |cos_i, cos_o| entry.promises.weight(cos_i, cos_o);
                assert_sound(entry.name, entry.model.as_ref(), largest, [wo, wo], u);
            }
        }
    }
}

#[test]
fn samples_at_the_ends_are_sound() {
    ends_are_sound(models::single());
    ends_are_sound(models::double());
}

/// The number that counts in place of another one.
fn moved(u: f64) -> f64 {
    if u > 0.0 { u.min(1.0) } else { 0.0 }
}

fn beyond_is_the_end<T: Real<Mask = bool> + PartialEq>(models: &[Entry<T>]) {
    let wo = <T::Vec3 as Vector<T>>::new(T::lit(0.48), T::lit(0.6), T::lit(0.64));
    for entry in models {
        for u in squares() {
            let sample = |u: [f64; 2]| {
                let sample = entry.model.sample(wo, u.map(T::lit));
                let (w, c) = (sample.wi, sample.weight);
                [w.x(), w.y(), w.z(), c.x(), c.y(), c.z(), sample.pdf]
            };
            assert_eq!(sample(u), sample(u.map(moved)), "{}: {u:?}", entry.name);
        }
    }
}

#[test]
fn numbers_beyond_the_ends_count_as_the_ends() {
    beyond_is_the_end(models::single());
    beyond_is_the_end(models::double());
}

fn normals_are_units<T: Real<Mask = bool> + Into<f64>>() {
    let unit = |h: T::Vec3, u: [f64; 2]| {
        let [x, y, z]: [f64; 3] = [h.x(), h.y(), h.z()].map(Into::into);
        let length = (x * x + y * y + z * z).sqrt();
        assert!((length - 1.0).abs() < 1e-6 && z >= 0.0, "{h:?} at {u:?}");
    };
    for roughness in [1e-8, 1e-3, 0.3, 1.0, 30.0, 1e4] {
        let [a, b]: [T; 2] = [T::lit(roughness), T::lit(0.1)];
        let smith: [Box<dyn Smith<T>>; 4] = [
            Box::new(Beckmann::new(a).unwrap()),
            Box::new(Beckmann::anisotropic(b, a).unwrap()),
            Box::new(Ggx::anisotropic(a, b).unwrap()),
            Box::new(Mixture::new([(b, Ggx::new(a).unwrap()), (a, Ggx::new(b).unwrap())]).unwrap()),
        ];
        let others: [Box<dyn Distribution<T>>; 2] = [
            Box::new(Gaussian::new(a).unwrap()),
            Box::new(Blinn::new(T::lit(1.0 / roughness)).unwrap()),
        ];
        for u in squares() {
            let numbers = u.map(T::lit);
            for distribution in &smith {
                unit(distribution.sample(numbers), u);
                for cos in COSINES {
                    let [x, y, z] = direction(cos, 0.4);
                    let wo = Vector::new(T::lit(x), T::lit(y), T::lit(z));
                    unit(distribution.sample_visible(wo, numbers), u);
                }
            }
            for distribution in &others {
                unit(distribution.sample(numbers), u);
            }
        }
    }
}

#[test]
fn drawn_normals_are_unit_vectors_that_face_up() {
    normals_are_units::<f32>();
    normals_are_units::<f64>();
}
