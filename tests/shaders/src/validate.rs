//! Whether text is a shader, in WGSL and in the languages it is translated to.

use naga::back::{glsl, hlsl, msl, spv};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{Module, ShaderStage};

/// The module and what the validator found out about it.
///
/// # Panics
/// If the text is not valid.
pub fn validate(name: &str, text: &str) -> (Module, ModuleInfo) {
    let module = naga::front::wgsl::parse_str(text)
        .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(text)));
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    let info = validator
        .validate(&module)
        .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(text)));
    (module, info)
}

/// The text of a module with a compute shader in GLSL, HLSL and MSL, and the length in words of SPIR-V.
pub struct Translations {
    pub glsl: String,
    pub hlsl: String,
    pub msl: String,
    pub spir_v: usize,
}

/// Translates a module whose entry point is a compute shader `main`.
///
/// # Panics
/// If one of the languages does not have it.
pub fn translate(name: &str, module: &Module, info: &ModuleInfo) -> Translations {
    let mut glsl = String::new();
    let options = glsl::Options { version: glsl::Version::new_gles(310), ..Default::default() };
    let pipeline = glsl::PipelineOptions {
        shader_stage: ShaderStage::Compute,
        entry_point: "main".into(),
        multiview: None,
    };
    glsl::Writer::new(&mut glsl, module, info, &options, &pipeline, Default::default())
        .and_then(|mut writer| writer.write())
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let mut hlsl = String::new();
    let options = hlsl::Options::default();
    hlsl::Writer::new(&mut hlsl, &options, &hlsl::PipelineOptions::default())
        .write(module, info, None)
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let options = msl::Options::default();
    let (msl, _) = msl::write_string(module, info, &options, &msl::PipelineOptions::default())
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let spir_v = spv::write_vec(module, info, &spv::Options::default(), None)
        .unwrap_or_else(|error| panic!("{name}: {error}"))
        .len();
    Translations { glsl, hlsl, msl, spir_v }
}
