//! A model as another crate would write it from public parts: glTF's metallic-roughness material.

use brdf::{
    Brdf, CookTorrance, Fresnel, Ggx, Lambert, Pair, ParameterError, Sample, Schlick,
    distribution::alpha_of_perceptual_roughness,
};
use glam::Vec3;

/// f = (1 − F) (1 − metallic) base/π + F D G/(4 N·L N·V), F of the facet.
#[derive(Clone, Copy)]
pub struct MetallicRoughness {
    base: Lambert,
    schlick: Schlick,
    gloss: CookTorrance<Ggx, Schlick>,
}

impl MetallicRoughness {
    pub fn new(color: Vec3, metallic: f32, roughness: f32) -> Result<Self, ParameterError> {
        let schlick = Schlick::new(Vec3::splat(0.04).lerp(color, metallic))?;
        let ggx = Ggx::new(alpha_of_perceptual_roughness(roughness))?;
        let base = Lambert::new(color * (1.0 - metallic))?;
        Ok(Self { base, schlick, gloss: CookTorrance::new(ggx, schlick) })
    }
}

impl Brdf for MetallicRoughness {
    type Color = Vec3;

    #[inline(always)]
    fn eval(&self, wi: Vec3, wo: Vec3) -> Vec3 {
        let kept = Vec3::ONE - self.schlick.reflectance(Pair::new(wi, wo).cos_d);
        kept * self.base.eval(wi, wo) + self.gloss.eval(wi, wo)
    }

    #[inline(always)]
    fn pdf(&self, wi: Vec3, wo: Vec3) -> f32 {
        0.5 * (self.base.pdf(wi, wo) + self.gloss.pdf(wi, wo))
    }

    #[inline(always)]
    fn sample(&self, wo: Vec3, [u0, u1]: [f32; 2]) -> Sample<f32, Vec3> {
        let wi = if u0 < 0.5 {
            self.base.sample(wo, [2.0 * u0, u1]).wi
        } else {
            self.gloss.sample(wo, [2.0 * u0 - 1.0, u1]).wi
        };
        let (value, pdf) = self.eval_pdf(wi, wo);
        let weight = if pdf > 0.0 { value * (wi.z / pdf) } else { Vec3::ZERO };
        Sample { wi, weight, pdf }
    }
}
