//! Descriptions without the measured materials.

use brdf::description::{BrdfDescription, FresnelDescription};

#[test]
fn metals_need_their_feature() {
    let error = serde_json::from_str::<FresnelDescription>(r#"{"metal": "Au"}"#).err();
    assert_eq!(
        error.map(|error| error.to_string()).as_deref(),
        Some("metal: materials by name, such as \"Au\", need the feature `materials`")
    );
}

#[test]
fn a_description_and_a_model_written_in_rust_agree() {
    let text = r#"{"cook_torrance": {"distribution": {"ggx": {"roughness": 0.3}},
                                     "fresnel": {"schlick": {"f0": 0.04}}}}"#;
    let model = serde_json::from_str::<BrdfDescription>(text)
        .ok()
        .and_then(|description| description.build::<f32>().ok());
    let up = brdf::glam::Vec3::Z;
    let value = model.map(|model| brdf::Brdf::eval(&model, up, up));
    assert_eq!(value, brdf_no_std::plastic(0.3).ok());
}
