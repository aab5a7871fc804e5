//! The models, all of one material: rough gold.

use std::f32::consts::PI;
use std::sync::Arc;

use brdf::materials::GOLD;
use brdf::{
    Beckmann, BeckmannKirchhoff, Blinn, Blinn1977, Blinn1977Printed, BlinnPhong, Brdf, Bsdf,
    ClassicPhong, CookTorrance, Eon, Fresnel, Ggx, He1991, Lambert, Opaque, OrenNayarFull,
    ParameterError, Schlick1994, Schlick1994Layer, SmithCorrelated, VCavity,
};
use glam::Vec3;

/// A model with its specular lobes.
pub type Model = Arc<dyn Bsdf<Color = Vec3>>;

/// A step of the history.
pub struct Step {
    /// Name of its files, without the ending.
    pub file: &'static str,
    /// What is written under the sphere.
    pub label: &'static str,
    /// The model.
    pub model: Model,
}

/// The wavelengths of red, green and blue, nm.
const LINES: Vec3 = Vec3::new(650.0, 550.0, 450.0);
/// Root-mean-square height and correlation length of the surface, nm.
const HEIGHT: [f32; 2] = [150.0, 1000.0];
/// The roughness that such heights have: 2σ/τ.
const ROUGHNESS: f32 = 2.0 * HEIGHT[0] / HEIGHT[1];

/// A model of reflection.
fn above(model: impl Brdf<Color = Vec3> + 'static) -> Model {
    Arc::new(Opaque::new(model))
}

/// All steps, from the oldest.
///
/// # Errors
/// None but those of the constants.
pub fn all() -> Result<Vec<Step>, ParameterError> {
    let gold = GOLD.conductor(LINES)?;
    let color = gold.reflectance(1.0);
    let [sigma, correlation] = HEIGHT;
    let beckmann = Beckmann::new(ROUGHNESS)?;
    // Peaks as high as Beckmann's; Phong's exponent is a fourth of Blinn's.
    let exponent = Blinn::from_roughness(ROUGHNESS)?.exponent();
    // Where Beckmann's distribution is about half as high as at the normal.
    let half = (ROUGHNESS * 2.0_f32.ln().sqrt()).atan();
    let satin = Schlick1994Layer { specular: color, roughness: ROUGHNESS.powi(2), isotropy: 1.0 };
    let step = |file, label, model| Step { file, label, model };
    Ok(vec![
        step("lambert", "Lambert", above(Lambert::new(color)?)),
        step(
            "beckmann-kirchhoff",
            "Beckmann–Kirchhoff",
            Arc::new(BeckmannKirchhoff::new(sigma, correlation, gold, LINES)?),
        ),
        step(
            "torrance-sparrow",
            "Torrance–Sparrow",
            above(CookTorrance::torrance_sparrow_1967(PI / 180.0 / ROUGHNESS, gold)?),
        ),
        step("phong", "Phong, n = 5", above(ClassicPhong::new(color, 0.25 * exponent)?)),
        step("blinn-phong", "Blinn–Phong, n = 20", above(BlinnPhong::new(color, exponent)?)),
        step(
            "blinn-1977",
            "Blinn 1977, D₃ as printed",
            above(Blinn1977Printed::d3(Blinn1977::new(half)?, gold)?),
        ),
        step(
            "cook-torrance",
            "Cook–Torrance",
            above(CookTorrance::from_parts(beckmann, gold, VCavity)),
        ),
        step("he-1991", "He et al. 1991", Arc::new(He1991::new(sigma, correlation, gold, LINES)?)),
        step("schlick-1994", "Schlick 1994", above(Schlick1994::new(satin)?)),
        step("oren-nayar", "Oren–Nayar, σ = 0.3", above(OrenNayarFull::new(color, ROUGHNESS)?)),
        step(
            "ggx",
            "GGX, Smith",
            above(CookTorrance::from_parts(Ggx::new(ROUGHNESS)?, gold, SmithCorrelated)),
        ),
        step("eon", "EON, r = 0.5", above(Eon::new(color, 0.5)?)),
    ])
}
