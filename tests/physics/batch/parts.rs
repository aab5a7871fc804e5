//! Fresnel terms and distributions.

use brdf::batch::InstructionSet;
use brdf::{Beckmann, Blinn, Conductor, Cook, Dielectric, Distribution, Fresnel};
use brdf::{Gaussian, Ggx, Hall, Schlick};
use glam::Vec3;

use super::bits::SELECTION;
use brdf_checks::directions::pairs;

#[test]
fn fresnel_terms_have_the_bits_of_calls() {
    let cosines: Vec<f32> = (0..=300_u16).map(|i| f32::from(i) / 150.0 - 1.0).collect();
    let terms: [Box<dyn Fresnel<f32, Color = Vec3>>; 5] = [
        Box::new(Dielectric::new(Vec3::new(1.5, 0.7, 1.0)).unwrap()),
        Box::new(Conductor::new(Vec3::new(0.1, 0.4, 1.4), Vec3::new(4.0, 2.4, 1.6)).unwrap()),
        Box::new(Schlick::new(Vec3::new(0.04, 0.5, 1.0)).unwrap()),
        Box::new(Hall::new(Vec3::new(0.04, 0.5, 1.0), 1.5).unwrap()),
        Box::new(Cook::new(Vec3::new(0.04, 0.5, 1.0), Vec3::splat(2.0), 1.5).unwrap()),
    ];
    let _alone = SELECTION.lock().unwrap();
    for set in InstructionSet::available() {
        set.select();
        for (index, term) in terms.iter().enumerate() {
            let mut values = vec![Vec3::MAX; cosines.len()];
            term.reflectance_batch(&cosines, (&mut values).into()).unwrap();
            for (cos, value) in cosines.iter().zip(&values) {
                assert_eq!(*value, term.reflectance(*cos), "{index} at {cos} on {set:?}");
            }
        }
    }
    let error = terms[0].reflectance_batch(&cosines, (&mut vec![Vec3::ZERO; 3]).into());
    assert_eq!(error.unwrap_err().to_string(), "values has 3 elements, but cos_theta has 301");
}

#[test]
fn distributions_have_the_bits_of_calls() {
    let normals: Vec<Vec3> = pairs(300).into_iter().map(|(h, _)| h.as_vec3()).collect();
    let distributions: [Box<dyn Distribution>; 4] = [
        Box::new(Beckmann::anisotropic(0.2, 0.5).unwrap()),
        Box::new(Ggx::new(0.3).unwrap()),
        Box::new(Gaussian::new(0.3).unwrap()),
        Box::new(Blinn::new(20.0).unwrap()),
    ];
    let _alone = SELECTION.lock().unwrap();
    for set in InstructionSet::available() {
        set.select();
        for (index, distribution) in distributions.iter().enumerate() {
            let mut densities = vec![-1.0; normals.len()];
            distribution.density_batch((&normals).into(), &mut densities).unwrap();
            for (h, density) in normals.iter().zip(&densities) {
                assert_eq!(*density, distribution.density(*h), "{index} at {h} on {set:?}");
            }
        }
    }
    let error = distributions[0].density_batch((&normals).into(), &mut [0.0; 2]).unwrap_err();
    assert_eq!(error.to_string(), "densities has 2 elements, but h has 300");
}
