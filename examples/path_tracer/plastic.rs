//! A model of our own: plastic, a pigment under a clear coat.

use std::f32::consts::FRAC_PI_2;

use brdf::{
    Brdf, Color, CookTorrance, Dielectric, Ggx, Lambert, ParameterError, Sample, SmithCorrelated,
    from_spherical,
};
use glam::Vec3;

type Coat = CookTorrance<Ggx, Dielectric<f32>, SmithCorrelated>;

/// A pigment under a clear coat:
///
/// ```text
/// f = f_coat + ρ (1 − E(ωᵢ)) (1 − E(ωₒ)) / (π (1 − Ē))
/// ```
///
/// with the pigment's reflectance ρ, the directional albedo E of the coat and its mean over the
/// hemisphere Ē = 2 ∫ E cosθ d(cosθ). Reciprocal; the directional albedo is E + ρ (1 − E), so a
/// white pigment gives back all light and no pigment gives back more (C. Kelemen, L. Szirmay-Kalos,
/// *A microfacet based coupled specular-matte BRDF model with importance sampling*, Eurographics
/// 2001 short presentations). A sum 0.9 Lambert + 1.0 coat would exceed 1 at grazing.
#[derive(Clone, Copy, Debug)]
pub struct Plastic<C> {
    coat: Coat,
    pigment: Lambert<C>,
    /// 1 − E at even steps of cosθ from 0 to 1.
    passed: [f32; STEPS + 1],
    mean_passed: f32,
    mean_pigment: f32,
}

const STEPS: usize = 64;

impl<C: Color<f32>> Plastic<C> {
    /// Of a pigment's reflectance, the roughness α of the coat and its refractive index.
    ///
    /// # Errors
    /// If a part refuses its parameter.
    pub fn new(pigment: C, roughness: f32, index: f32) -> Result<Self, ParameterError> {
        let coat = CookTorrance::new(Ggx::new(roughness)?, Dielectric::new(index)?);
        let mut passed = [0.0; STEPS + 1];
        let mut mean_passed = 0.0;
        for (step, passed) in passed.iter_mut().enumerate() {
            let cos = step as f32 / STEPS as f32;
            // At 90° the directions lie in the surface: just above.
            let angle = cos.acos().min(FRAC_PI_2 - 1e-3);
            *passed = 1.0 - coat.albedo(from_spherical(angle, 0.0));
        }
        // 2 ∫ (1 − E) cosθ d(cosθ) of the straight lines between the steps.
        for (step, ends) in passed.windows(2).enumerate() {
            let (width, start) = ((STEPS as f32).recip(), step as f32 / STEPS as f32);
            let mean = 0.5 * (ends[0] + ends[1]);
            mean_passed += width * (2.0 * start * mean + width * (ends[0] + 2.0 * ends[1]) / 3.0);
        }
        let mean_pigment = pigment.mean();
        Ok(Self { coat, pigment: Lambert::new(pigment)?, passed, mean_passed, mean_pigment })
    }

    /// 1 − E, the part of the light that the coat lets through.
    fn passed(&self, w: Vec3) -> f32 {
        let place = w.z.clamp(0.0, 1.0) * STEPS as f32;
        let step = (place as usize).min(STEPS - 1);
        let (start, end) = (self.passed[step], self.passed[step + 1]);
        start + (end - start) * (place - step as f32)
    }

    /// The probability to draw from the coat: its part of the albedo.
    fn choose_coat(&self, wo: Vec3) -> f32 {
        let passed = self.passed(wo);
        (1.0 - passed) / (1.0 - passed + passed * self.mean_pigment)
    }
}

impl<C: Color<f32>> Brdf for Plastic<C> {
    type Color = C;

    fn eval(&self, wi: Vec3, wo: Vec3) -> C {
        let coupled = self.passed(wi) * self.passed(wo) / self.mean_passed;
        C::splat(self.coat.eval(wi, wo)) + self.pigment.eval(wi, wo) * coupled
    }

    fn pdf(&self, wi: Vec3, wo: Vec3) -> f32 {
        let coat = self.choose_coat(wo);
        coat * self.coat.pdf(wi, wo) + (1.0 - coat) * self.pigment.pdf(wi, wo)
    }

    fn sample(&self, wo: Vec3, [u0, u1]: [f32; 2]) -> Sample<f32, C> {
        let coat = self.choose_coat(wo);
        // What is left of the first number after the choice is uniform again.
        let wi = if u0 < coat {
            self.coat.sample(wo, [u0 / coat, u1]).wi
        } else {
            self.pigment.sample(wo, [(u0 - coat) / (1.0 - coat), u1]).wi
        };
        let (value, pdf) = self.eval_pdf(wi, wo);
        let scale = if pdf > 0.0 { wi.z / pdf } else { 0.0 };
        Sample { wi, weight: value * scale, pdf }
    }
}
