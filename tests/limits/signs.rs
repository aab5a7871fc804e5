//! A zero has no sign: where a parameter is −0, no answer is.

use brdf::{
    BlinnPhong, Brdf, ClassicPhong, Conductor, Constant, Cook, Fresnel, Hall, Lambert, OrenNayar,
    Phong, Schlick, SchlickPower, WeightedSum,
};
use glam::DVec3;

const NOTHING: DVec3 = DVec3::splat(-0.0);
const ABOVE: DVec3 = DVec3::new(0.6, 0.0, 0.8);
const MIRROR: DVec3 = DVec3::new(-0.6, 0.0, 0.8);
const BELOW: DVec3 = DVec3::new(0.6, 0.0, -0.8);

fn model(name: &str, model: impl Brdf<f64, Color = DVec3>) {
    let mut answers = Vec::new();
    for wo in [ABOVE, MIRROR, DVec3::Z, BELOW] {
        answers.extend([ABOVE, MIRROR, DVec3::Z, BELOW].map(|wi| model.eval(wi, wo)));
        answers.extend([[0.1, 0.2], [0.5, 0.5], [0.9, 0.7]].map(|u| model.sample(wo, u).weight));
        answers.push(model.albedo(wo));
    }
    for answer in answers {
        assert_eq!(answer.to_array().map(f64::to_bits), [0; 3], "{name}: {answer}");
    }
}

#[test]
fn a_surface_of_negative_zero_reflects_zero() {
    model("Lambert", Lambert::new(NOTHING).expect("zero"));
    model("OrenNayar", OrenNayar::new(NOTHING, 0.3).expect("zero"));
    model("OrenNayar", OrenNayar::with_interreflection(NOTHING, 0.3).expect("zero"));
    model("Phong", Phong::new(NOTHING, 20.0).expect("zero"));
    model("ClassicPhong", ClassicPhong::new(NOTHING, 20.0).expect("zero"));
    model("BlinnPhong", BlinnPhong::new(NOTHING, 20.0).expect("zero"));
    model("SchlickPower", SchlickPower::new(NOTHING, 20.0).expect("zero"));
    let white = Lambert::new(DVec3::ONE).expect("white");
    let black = Lambert::new(DVec3::ZERO).expect("black");
    model("sum", WeightedSum::new([(NOTHING, white), (DVec3::ONE, black)]).expect("a sum"));
}

#[test]
fn fresnel_terms_of_negative_zero_have_no_sign() {
    let mut answers = Vec::new();
    for cos in [0.0_f64, -0.0, 0.3, 1.0, -0.3] {
        answers.extend([
            Constant::new(-0.0_f64).expect("zero").reflectance(cos),
            Schlick::new(-0.0_f64).expect("zero").reflectance(cos),
            Hall::new(-0.0_f64, 1.5).expect("zero").reflectance(cos),
            Cook::new(0.5_f64, -0.0, 1.5).expect("zero").reflectance(cos),
            Cook::new(-0.0_f64, 1.0, 1.5).expect("zero").reflectance(cos),
            Conductor::new(1.0_f64, -0.0).expect("zero").reflectance(cos),
        ]);
    }
    for (index, answer) in answers.into_iter().enumerate() {
        assert!(answer.is_sign_positive(), "{index}: {answer}");
    }
}
