//! A model for every element.

use brdf::batch::{BatchError, SampleBuffer, eval_each, eval_pdf_each, pdf_each, sample_each};
use brdf::{Beckmann, Brdf, CookTorrance, ParameterError, Schlick};
use glam::Vec3;

use brdf_checks::directions::pairs;

type Plastic = CookTorrance<Beckmann, Schlick>;

#[test]
fn every_element_has_the_bits_of_its_own_model() {
    let (wi, wo): (Vec<_>, Vec<_>) =
        pairs(300).into_iter().map(|(wi, wo)| (wi.as_vec3(), wo.as_vec3())).unzip();
    let roughness: Vec<f32> = (1..=300_u16).map(|i| f32::from(i) * 0.004).collect();
    let model = |index: usize| -> Result<Plastic, ParameterError> {
        let f0 = Vec3::splat(1.0 - 0.5 * roughness[index] / 1.2);
        Ok(CookTorrance::new(Beckmann::new(roughness[index])?, Schlick::new(f0)?))
    };
    for n in [0, 1, 128, 129, 300] {
        let (wi_in, wo_in) = ((&wi[..n]).into(), (&wo[..n]).into());
        let (mut values, mut densities) = (vec![Vec3::MAX; n], vec![f32::MAX; n]);
        eval_each(model, wi_in, wo_in, (&mut values).into()).unwrap();
        pdf_each(model, wi_in, wo_in, &mut densities).unwrap();
        let (mut both, mut beside) = (values.clone(), densities.clone());
        eval_pdf_each(model, wi_in, wo_in, (&mut both).into(), &mut beside).unwrap();
        assert_eq!((&both, &beside), (&values, &densities));
        let u: Vec<[f32; 2]> = roughness[..n].iter().map(|r| [r * 0.8, 0.9 - r * 0.7]).collect();
        let (mut drawn, mut weight, mut pdf) = (values.clone(), values.clone(), densities.clone());
        let samples =
            SampleBuffer { wi: (&mut drawn).into(), weight: (&mut weight).into(), pdf: &mut pdf };
        sample_each(model, wo_in, (&u).into(), samples).unwrap();
        for index in 0..n {
            let model = model(index).unwrap();
            let (wi, wo) = (wi[index], wo[index]);
            assert_eq!(values[index], model.eval(wi, wo));
            assert_eq!(densities[index], model.pdf(wi, wo));
            let sample = model.sample(wo, u[index]);
            assert_eq!(drawn[index], sample.wi);
            assert_eq!((weight[index], pdf[index]), (sample.weight, sample.pdf));
        }
    }
}

#[test]
fn a_parameter_out_of_range_names_its_element() {
    let roughness = [0.5_f32, 0.5, -1.0];
    let model = |index: usize| -> Result<Plastic, ParameterError> {
        Ok(CookTorrance::new(Beckmann::new(roughness[index])?, Schlick::new(Vec3::ONE)?))
    };
    let error = pdf_each(model, Vec3::Z.into(), Vec3::Z.into(), &mut [0.0; 3]).unwrap_err();
    assert!(matches!(error, BatchError::Parameter { index: 2, .. }));
    assert_eq!(
        error.to_string(),
        "there is no model for element 2: roughness must be between 1e-8 and 10000, not -1"
    );
}
