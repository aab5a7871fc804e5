//! Whole models as one would write them for one's own renderer: value, density and samples with the
//! standard library's floats, behind the crate's trait so that both are called alike.

use std::f32::consts::{PI, TAU};

use brdf::{Brdf, Sample};
use glam::Vec3;

use super::by_hand::{blinn_phong, conductor, cook_torrance, ggx, oren_nayar};

const NONE: Sample<f32, Vec3> = Sample { wi: Vec3::Z, weight: Vec3::ZERO, pdf: 0.0 };

/// Facets of gold with Smith's height-correlated shadowing.
pub struct Gold {
    pub alpha: f32,
    pub eta: Vec3,
    pub k: Vec3,
}

impl Gold {
    fn reflectance(&self, cos: f32) -> Vec3 {
        let Self { eta, k, .. } = self;
        Vec3::new(
            conductor(eta.x, k.x, cos),
            conductor(eta.y, k.y, cos),
            conductor(eta.z, k.z, cos),
        )
    }
}

/// GGX.
pub struct GgxGold(pub Gold);

impl GgxGold {
    fn lambda(&self, w: Vec3) -> f32 {
        let a2 = self.0.alpha * self.0.alpha;
        0.5 * ((1.0 + a2 * (w.x * w.x + w.y * w.y) / (w.z * w.z)).sqrt() - 1.0)
    }

    fn d(&self, h: Vec3) -> f32 {
        let a2 = self.0.alpha * self.0.alpha;
        let t = h.z * h.z * (a2 - 1.0) + 1.0;
        a2 / (PI * t * t)
    }
}

impl Brdf for GgxGold {
    type Color = Vec3;

    fn eval(&self, wi: Vec3, wo: Vec3) -> Vec3 {
        ggx(wi, wo, self.0.alpha, self.0.eta, self.0.k)
    }

    fn pdf(&self, wi: Vec3, wo: Vec3) -> f32 {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return 0.0;
        }
        let h = (wi + wo).normalize();
        self.d(h) / (4.0 * wo.z * (1.0 + self.lambda(wo)))
    }

    /// By E. Heitz, "Sampling the GGX distribution of visible normals", JCGT 7(4), 2018.
    fn sample(&self, wo: Vec3, u: [f32; 2]) -> Sample<f32, Vec3> {
        if wo.z <= 0.0 {
            return NONE;
        }
        let alpha = self.0.alpha;
        let v = Vec3::new(alpha * wo.x, alpha * wo.y, wo.z).normalize();
        let length2 = v.x * v.x + v.y * v.y;
        let t1 = if length2 > 0.0 { Vec3::new(-v.y, v.x, 0.0) / length2.sqrt() } else { Vec3::X };
        let t2 = v.cross(t1);
        let r = u[0].sqrt();
        let (sin, cos) = (TAU * u[1]).sin_cos();
        let p1 = r * cos;
        let s = 0.5 * (1.0 + v.z);
        let p2 = (1.0 - s) * (1.0 - p1 * p1).sqrt() + s * r * sin;
        let n = t1 * p1 + t2 * p2 + v * (1.0 - p1 * p1 - p2 * p2).max(0.0).sqrt();
        let h = Vec3::new(alpha * n.x, alpha * n.y, n.z.max(0.0)).normalize();
        let cos_d = wo.dot(h);
        let wi = h * (2.0 * cos_d) - wo;
        if wi.z <= 0.0 {
            return NONE;
        }
        let (lambda_i, lambda_o) = (self.lambda(wi), self.lambda(wo));
        Sample {
            wi,
            weight: self.0.reflectance(cos_d) * ((1.0 + lambda_o) / (1.0 + lambda_i + lambda_o)),
            pdf: self.d(h) / (4.0 * wo.z * (1.0 + lambda_o)),
        }
    }
}

/// Beckmann, with the rational fit of Λ in B. Walter et al., EGSR 2007.
pub struct BeckmannGold(pub Gold);

impl BeckmannGold {
    fn lambda(&self, w: Vec3) -> f32 {
        let a = w.z / (self.0.alpha * (w.x * w.x + w.y * w.y).sqrt());
        if a >= 1.6 { 0.0 } else { (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a) }
    }

    fn d(&self, h: Vec3) -> f32 {
        let m2 = self.0.alpha * self.0.alpha;
        let cos2 = h.z * h.z;
        let tan2 = (h.x * h.x + h.y * h.y) / cos2;
        (-tan2 / m2).exp() / (PI * m2 * cos2 * cos2)
    }
}

impl Brdf for BeckmannGold {
    type Color = Vec3;

    fn eval(&self, wi: Vec3, wo: Vec3) -> Vec3 {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return Vec3::ZERO;
        }
        let h = (wi + wo).normalize();
        let g = 1.0 / (1.0 + self.lambda(wi) + self.lambda(wo));
        self.0.reflectance(wo.dot(h)) * (self.d(h) * g / (4.0 * wi.z * wo.z))
    }

    fn pdf(&self, wi: Vec3, wo: Vec3) -> f32 {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return 0.0;
        }
        let h = (wi + wo).normalize();
        self.d(h) / (4.0 * wo.z * (1.0 + self.lambda(wo)))
    }

    /// All normals, not only the visible ones.
    fn sample(&self, wo: Vec3, u: [f32; 2]) -> Sample<f32, Vec3> {
        if wo.z <= 0.0 {
            return NONE;
        }
        let tan2 = -self.0.alpha * self.0.alpha * (1.0 - u[0]).ln();
        let cos = 1.0 / (1.0 + tan2).sqrt();
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let (sin_phi, cos_phi) = (TAU * u[1]).sin_cos();
        let h = Vec3::new(sin * cos_phi, sin * sin_phi, cos);
        let cos_d = wo.dot(h);
        let wi = h * (2.0 * cos_d) - wo;
        if cos_d <= 0.0 || wi.z <= 0.0 {
            return NONE;
        }
        let g = 1.0 / (1.0 + self.lambda(wi) + self.lambda(wo));
        Sample {
            wi,
            weight: self.0.reflectance(cos_d) * (g * cos_d / (wo.z * h.z)),
            pdf: self.d(h) * h.z / (4.0 * cos_d),
        }
    }
}

/// Beckmann, V-cavities, Schlick.
pub struct Grooves {
    pub m: f32,
    pub f0: Vec3,
}

impl Brdf for Grooves {
    type Color = Vec3;

    fn eval(&self, wi: Vec3, wo: Vec3) -> Vec3 {
        cook_torrance(wi, wo, self.m, self.f0)
    }

    fn pdf(&self, wi: Vec3, wo: Vec3) -> f32 {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return 0.0;
        }
        let h = (wi + wo).normalize();
        let cos2 = h.z * h.z;
        let m2 = self.m * self.m;
        let tan2 = (h.x * h.x + h.y * h.y) / cos2;
        let d = (-tan2 / m2).exp() / (PI * m2 * cos2 * cos2);
        d * h.z / (4.0 * wo.dot(h))
    }

    /// All normals, not only the visible ones.
    fn sample(&self, wo: Vec3, u: [f32; 2]) -> Sample<f32, Vec3> {
        if wo.z <= 0.0 {
            return NONE;
        }
        let m2 = self.m * self.m;
        let tan2 = -m2 * (1.0 - u[0]).ln();
        let cos2 = 1.0 / (1.0 + tan2);
        let cos = cos2.sqrt();
        let sin = (1.0 - cos2).max(0.0).sqrt();
        let (sin_phi, cos_phi) = (TAU * u[1]).sin_cos();
        let h = Vec3::new(sin * cos_phi, sin * sin_phi, cos);
        let cos_d = wo.dot(h);
        let wi = h * (2.0 * cos_d) - wo;
        if cos_d <= 0.0 || wi.z <= 0.0 {
            return NONE;
        }
        let g = (2.0 * cos * wo.z / cos_d).min(2.0 * cos * wi.z / cos_d).min(1.0);
        let fresnel = self.f0 + (Vec3::ONE - self.f0) * (1.0 - cos_d).powi(5);
        Sample {
            wi,
            weight: fresnel * (g * cos_d / (wo.z * cos)),
            pdf: (-tan2 / m2).exp() / (PI * m2 * cos2 * cos2) * cos / (4.0 * cos_d),
        }
    }
}

/// Blinn–Phong.
pub struct Highlight {
    pub exponent: f32,
    pub specular: Vec3,
}

impl Highlight {
    fn factor(&self) -> f32 {
        (self.exponent + 8.0) / (8.0 * PI)
    }
}

impl Brdf for Highlight {
    type Color = Vec3;

    fn eval(&self, wi: Vec3, wo: Vec3) -> Vec3 {
        blinn_phong(wi, wo, self.exponent, self.specular * self.factor())
    }

    fn pdf(&self, wi: Vec3, wo: Vec3) -> f32 {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return 0.0;
        }
        let h = (wi + wo).normalize();
        (self.exponent + 1.0) / TAU * h.z.powf(self.exponent) / (4.0 * wo.dot(h))
    }

    fn sample(&self, wo: Vec3, u: [f32; 2]) -> Sample<f32, Vec3> {
        if wo.z <= 0.0 {
            return NONE;
        }
        let cos = (1.0 - u[0]).powf(1.0 / (self.exponent + 1.0));
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let (sin_phi, cos_phi) = (TAU * u[1]).sin_cos();
        let h = Vec3::new(sin * cos_phi, sin * sin_phi, cos);
        let cos_d = wo.dot(h);
        let wi = h * (2.0 * cos_d) - wo;
        if cos_d <= 0.0 || wi.z <= 0.0 {
            return NONE;
        }
        let pdf = (self.exponent + 1.0) / TAU * cos.powf(self.exponent) / (4.0 * cos_d);
        let scale = self.factor() * TAU * 4.0 * cos_d * wi.z / (self.exponent + 1.0);
        Sample { wi, weight: self.specular * scale, pdf }
    }
}

/// Oren–Nayar, sampled by the cosine.
pub struct Plaster {
    pub sigma: f32,
    pub albedo: Vec3,
}

impl Brdf for Plaster {
    type Color = Vec3;

    fn eval(&self, wi: Vec3, wo: Vec3) -> Vec3 {
        oren_nayar(wi, wo, self.sigma, self.albedo)
    }

    fn pdf(&self, wi: Vec3, wo: Vec3) -> f32 {
        if wi.z <= 0.0 || wo.z <= 0.0 { 0.0 } else { wi.z / PI }
    }

    fn sample(&self, wo: Vec3, u: [f32; 2]) -> Sample<f32, Vec3> {
        if wo.z <= 0.0 {
            return NONE;
        }
        let r = u[0].sqrt();
        let (sin, cos) = (TAU * u[1]).sin_cos();
        let wi = Vec3::new(r * cos, r * sin, (1.0 - u[0]).max(0.0).sqrt());
        let weight = oren_nayar(wi, wo, self.sigma, self.albedo) * PI;
        Sample { wi, weight, pdf: wi.z / PI }
    }
}
