//! What a model is asked where a batch does not fill a block.

use brdf::batch::{SampleBuffer, Uniforms};
use brdf::{Brdf, Sample};
use glam::Vec3;

/// Of another crate: takes it badly to be asked for what is no direction.
struct Strict;

impl Brdf for Strict {
    type Color = f32;

    fn eval(&self, wi: Vec3, wo: Vec3) -> f32 {
        assert!(wi.is_normalized() && wo.is_normalized(), "{wi} {wo}");
        wi.x
    }

    fn pdf(&self, wi: Vec3, wo: Vec3) -> f32 {
        self.eval(wi, wo)
    }

    fn sample(&self, wo: Vec3, u: [f32; 2]) -> Sample<f32, f32> {
        assert!(wo.is_normalized() && u[0] > 0.0 && u[1] > 0.0, "{wo} {u:?}");
        Sample { wi: wo, weight: u[0], pdf: u[1] }
    }
}

#[test]
fn a_model_is_asked_for_what_the_batch_contains_only() {
    for length in [1, 3, 127, 128, 129, 300] {
        let vectors: Vec<Vec3> =
            (0..length).map(|index| Vec3::new(1.0, 1.0 + index as f32, 1.0).normalize()).collect();
        let planes = [0, 1, 2].map(|axis| vectors.iter().map(|w| w[axis]).collect::<Vec<f32>>());
        let x = planes[0].clone();
        let pairs: Vec<[f32; 2]> = x.iter().map(|x| [*x, *x]).collect();
        let mut values = vec![0.0; length];
        let (from, to) = (&vectors, planes.each_ref());

        Strict.eval_batch(from.into(), to.into(), (&mut values).into()).unwrap();
        assert_eq!(values, x);
        Strict.pdf_batch(to.into(), from.into(), &mut values).unwrap();
        assert_eq!(values, x);
        for u in [Uniforms::from(&pairs), [&x, &x].into()] {
            let (mut wi, mut weight, mut pdf) =
                (vec![Vec3::ZERO; length], vec![0.0; length], vec![0.0; length]);
            let samples =
                SampleBuffer { wi: (&mut wi).into(), weight: (&mut weight).into(), pdf: &mut pdf };
            Strict.sample_batch(from.into(), u, samples).unwrap();
            assert_eq!((&wi, &weight, &pdf), (&vectors, &x, &x));
        }
    }
}
