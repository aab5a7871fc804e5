//! The formulas as one would write them for one's own renderer, with the standard library's floats
//! and a branch where a direction lies below the surface: the baseline of all ratios.

use glam::Vec3;

/// Cook–Torrance with Beckmann facets, V-cavity shadowing and Schlick's Fresnel term.
#[inline]
pub fn cook_torrance(wi: Vec3, wo: Vec3, m: f32, f0: Vec3) -> Vec3 {
    if wi.z <= 0.0 || wo.z <= 0.0 {
        return Vec3::ZERO;
    }
    let h = (wi + wo).normalize();
    let cos_d = wo.dot(h);
    let cos2 = h.z * h.z;
    let tan2 = (h.x * h.x + h.y * h.y) / cos2;
    let d = (-tan2 / (m * m)).exp() / (std::f32::consts::PI * m * m * cos2 * cos2);
    let g = (2.0 * h.z * wo.z / cos_d).min(2.0 * h.z * wi.z / cos_d).min(1.0);
    let fresnel = f0 + (Vec3::ONE - f0) * (1.0 - cos_d).powi(5);
    fresnel * (d * g / (4.0 * wi.z * wo.z))
}

/// The same in double precision.
#[inline]
pub fn cook_torrance_f64(wi: glam::DVec3, wo: glam::DVec3, m: f64, f0: glam::DVec3) -> glam::DVec3 {
    if wi.z <= 0.0 || wo.z <= 0.0 {
        return glam::DVec3::ZERO;
    }
    let h = (wi + wo).normalize();
    let cos_d = wo.dot(h);
    let cos2 = h.z * h.z;
    let tan2 = (h.x * h.x + h.y * h.y) / cos2;
    let d = (-tan2 / (m * m)).exp() / (std::f64::consts::PI * m * m * cos2 * cos2);
    let g = (2.0 * h.z * wo.z / cos_d).min(2.0 * h.z * wi.z / cos_d).min(1.0);
    let fresnel = f0 + (glam::DVec3::ONE - f0) * (1.0 - cos_d).powi(5);
    fresnel * (d * g / (4.0 * wi.z * wo.z))
}

/// Blinn–Phong with the given factor.
#[inline]
pub fn blinn_phong(wi: Vec3, wo: Vec3, exponent: f32, specular: Vec3) -> Vec3 {
    if wi.z <= 0.0 || wo.z <= 0.0 {
        return Vec3::ZERO;
    }
    let h = (wi + wo).normalize();
    specular * h.z.max(0.0).powf(exponent)
}

/// exp(−(α/m)²) with the angle α.
#[inline]
pub fn gaussian(h: Vec3, m: f32, peak: f32) -> f32 {
    if h.z <= 0.0 {
        return 0.0;
    }
    let angle = h.z.min(1.0).acos();
    peak * (-(angle / m) * (angle / m)).exp()
}

/// Oren–Nayar, the qualitative form.
#[inline]
pub fn oren_nayar(wi: Vec3, wo: Vec3, sigma: f32, albedo: Vec3) -> Vec3 {
    if wi.z <= 0.0 || wo.z <= 0.0 {
        return Vec3::ZERO;
    }
    let s2 = sigma * sigma;
    let a = 1.0 - 0.5 * s2 / (s2 + 0.33);
    let b = 0.45 * s2 / (s2 + 0.09);
    let s = wi.x * wo.x + wi.y * wo.y;
    let t = if s > 0.0 { s / wi.z.max(wo.z) } else { 0.0 };
    albedo * ((a + b * t) / std::f32::consts::PI)
}

/// Fresnel's equations for a conductor, one channel.
#[inline]
pub fn conductor(eta: f32, k: f32, cos: f32) -> f32 {
    let (cos2, sin2) = (cos * cos, 1.0 - cos * cos);
    let x = eta * eta - k * k - sin2;
    let modulus = (x * x + 4.0 * eta * eta * k * k).sqrt();
    let a = (0.5 * (modulus + x)).max(0.0).sqrt();
    let s = (modulus + cos2 - 2.0 * a * cos) / (modulus + cos2 + 2.0 * a * cos);
    let p = (cos2 * modulus + sin2 * sin2 - 2.0 * a * cos * sin2)
        / (cos2 * modulus + sin2 * sin2 + 2.0 * a * cos * sin2);
    0.5 * s * (1.0 + p)
}

/// Fresnel's equations for a dielectric, from above.
#[inline]
pub fn dielectric(ior: f32, cos: f32) -> f32 {
    let sin2_t = (1.0 - cos * cos) / (ior * ior);
    if sin2_t >= 1.0 {
        return 1.0;
    }
    let cos_t = (1.0 - sin2_t).sqrt();
    let s = (cos - ior * cos_t) / (cos + ior * cos_t);
    let p = (ior * cos - cos_t) / (ior * cos + cos_t);
    0.5 * (s * s + p * p)
}

/// Schlick's approximation.
#[inline]
pub fn schlick(f0: f32, cos: f32) -> f32 {
    f0 + (1.0 - f0) * (1.0 - cos).powi(5)
}

/// GGX with height-correlated Smith shadowing and a conductor in three channels.
#[inline]
pub fn ggx(wi: Vec3, wo: Vec3, alpha: f32, eta: Vec3, k: Vec3) -> Vec3 {
    if wi.z <= 0.0 || wo.z <= 0.0 {
        return Vec3::ZERO;
    }
    let h = (wi + wo).normalize();
    let cos_d = wo.dot(h);
    let a2 = alpha * alpha;
    let t = h.z * h.z * (a2 - 1.0) + 1.0;
    let d = a2 / (std::f32::consts::PI * t * t);
    let lambda = |w: Vec3| 0.5 * ((1.0 + a2 * (w.x * w.x + w.y * w.y) / (w.z * w.z)).sqrt() - 1.0);
    let g = 1.0 / (1.0 + lambda(wi) + lambda(wo));
    let scale = d * g / (4.0 * wi.z * wo.z);
    Vec3::new(
        conductor(eta.x, k.x, cos_d),
        conductor(eta.y, k.y, cos_d),
        conductor(eta.z, k.z, cos_d),
    ) * scale
}
