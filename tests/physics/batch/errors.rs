//! Slices that do not fit are refused by name, and nothing is written.

use brdf::batch::{BatchError, ColorBuffer, Directions, SampleBuffer};
use brdf::{Brdf, Lambert, Spectrum};
use glam::Vec3;

fn white() -> Lambert<Vec3> {
    Lambert::new(Vec3::ONE).unwrap()
}

#[test]
fn slices_of_different_lengths_are_named() {
    let (directions, numbers) = ([Vec3::Z; 5], [0.5_f32; 5]);
    let mut values = [Vec3::MAX; 4];
    let error = white()
        .eval_batch((&directions).into(), (&directions).into(), (&mut values).into())
        .unwrap_err();
    assert_eq!(
        error,
        BatchError::Length { argument: "values", length: 4, other: "wi", other_length: 5 }
    );
    assert_eq!(values, [Vec3::MAX; 4]);

    let wo: Directions<'_, f32> = [&numbers[..], &numbers[..3], &numbers[..]].into();
    let error = white().pdf_batch((&directions).into(), wo, &mut [0.0; 5]).unwrap_err();
    assert_eq!(error.to_string(), "pdf has 5 elements, but wo.y has 3");

    let (mut wi, mut weight, mut pdf) = ([Vec3::MAX; 5], [Vec3::MAX; 5], [0.0; 5]);
    let mut refused = |u: &[[f32; 2]], weights: usize| {
        let samples = SampleBuffer {
            wi: (&mut wi).into(),
            weight: (&mut weight[..weights]).into(),
            pdf: &mut pdf,
        };
        white().sample_batch((&directions).into(), u.into(), samples).unwrap_err().to_string()
    };
    assert_eq!(refused(&[[0.5; 2]; 6], 5), "samples.pdf has 5 elements, but u has 6");
    assert_eq!(refused(&[[0.5; 2]; 5], 2), "samples.pdf has 5 elements, but samples.weight has 2");
    assert_eq!(wi, [Vec3::MAX; 5]);
}

/// As many slices as channels, whatever their number: another one is no colour buffer at all.
#[test]
fn slices_of_channels_have_the_length_of_the_batch() {
    let gray = Lambert::new(Spectrum([0.5_f32; 4])).unwrap();
    let mut planes = [[0.0_f32; 2]; 4];
    let values = ColorBuffer::from(planes.each_mut());
    gray.eval_batch(Vec3::Z.into(), Vec3::Z.into(), values).unwrap();
    assert_eq!(planes, gray.eval(Vec3::Z, Vec3::Z).0.map(|value| [value; 2]));
    let [a, b, c, _] = &mut planes;
    let values = ColorBuffer::Planes([a.as_mut_slice(), b, c, &mut []]);
    let error = gray.eval_batch(Vec3::Z.into(), Vec3::Z.into(), values).unwrap_err();
    assert_eq!(error.to_string(), "values[0] has 2 elements, but values[3] has 0");
}
