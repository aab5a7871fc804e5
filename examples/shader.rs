//! Prints a shader that lights a sphere of gold, to be put into any program that takes WGSL.
//!
//! ```sh
//! cargo run --features wgsl,materials --example shader
//! ```
//!
//! The functions `gold_eval`, `gold_pdf` and `gold_sample` are written by the crate from the same
//! formulas that run on the processor; what calls them is written by hand.

use std::error::Error;

use brdf::materials::GOLD;
use brdf::wgsl::{Binding, Expr, Module};
use brdf::{CookTorrance, Ggx, Lift, ParameterError, SmithCorrelated};
use glam::DVec3;

/// A sphere in the middle of the picture, seen from the front, in the light of one lamp.
const SPHERE: &str = "
@fragment
fn sphere(@location(0) place: vec2<f32>) -> @location(0) vec4<f32> {
    let height = 1.0 - dot(place, place);
    if height <= 0.0 {
        return vec4<f32>(0.0);
    }
    let normal = vec3<f32>(place, sqrt(height));
    let tangent = normalize(cross(vec3<f32>(0.0, 1.0, 0.0), normal));
    let bitangent = cross(normal, tangent);
    // From the world into the frame of the surface, where the normal is +z.
    let to_surface = transpose(mat3x3<f32>(tangent, bitangent, normal));
    let wi = to_surface * normalize(vec3<f32>(-0.5, 0.5, 1.0));
    let wo = to_surface * vec3<f32>(0.0, 0.0, 1.0);
    let irradiance = 3.0 * max(wi.z, 0.0);
    return vec4<f32>(gold_eval(wi, wo) * irradiance, 1.0);
}
";

/// The whole shader. The roughness comes from a uniform buffer, so that it can be changed while the
/// program runs.
pub fn shader() -> Result<String, Box<dyn Error>> {
    // Its refractive index at three wavelengths, as numbers of the shader.
    let metal = GOLD.conductor(DVec3::new(650.0, 550.0, 450.0))?.lift(Expr::from);
    let mut module = Module::new();
    let _uniforms = module.add_with("gold", Binding { group: 0, binding: 0 }, |parameters| {
        let facets = Ggx::new(parameters.number("roughness", 0.3))?;
        let surface = CookTorrance::new(facets, metal).with_shadowing(SmithCorrelated);
        Ok::<_, ParameterError>(surface)
    })?;
    Ok(format!("{module}{SPHERE}"))
}

#[allow(dead_code, reason = "tests take the shader alone")]
fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", shader()?);
    Ok(())
}
