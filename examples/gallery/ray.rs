//! What a ray of the camera meets, and the light that comes back along it.

use brdf::{Bsdf, BsdfSample, Frame, TransportMode};
use glam::{Vec2, Vec3};
use rand::SeedableRng;
use rand_pcg::Pcg32;

use crate::environment::Environment;
use crate::light::Light;
use crate::solid::Solid;

/// Height of the camera above the horizon, radians: the upper pole is in view.
const ELEVATION: f32 = 0.35;
/// The normal of a disc in the camera's frame: some way from the one that mirrors the lamp to the viewer.
const DISC: Vec3 = Vec3::new(0.06, -0.06, 1.0);

/// A surface of any kind, with its specular lobes.
pub type Surface<'a> = &'a dyn Bsdf<Color = Vec3>;

/// A ray that meets a surface.
pub struct Ray {
    normal: Vec3,
    /// Along the grain.
    tangent: Vec3,
    toward_viewer: Vec3,
}

/// From the camera's frame (x right, y up, z to the viewer).
fn to_world(v: Vec3) -> Vec3 {
    let (sin, cos) = ELEVATION.sin_cos();
    Vec3::new(v.x, v.y * cos + v.z * sin, v.z * cos - v.y * sin)
}

impl Ray {
    /// That of a place in the picture, if it meets the unit sphere. The grain runs along the parallels of
    /// latitude.
    pub fn at_sphere(position: Vec2) -> Option<Self> {
        if position.length_squared() >= 1.0 {
            return None;
        }
        let depth = (1.0 - position.length_squared()).max(0.0).sqrt();
        let normal = to_world(position.extend(depth));
        Some(Self { normal, tangent: Vec3::Y.cross(normal), toward_viewer: to_world(Vec3::Z) })
    }

    /// The same of a disc, which was turned: the grain runs in circles.
    pub fn at_disc(position: Vec2) -> Option<Self> {
        let normal = DISC.normalize();
        let point = position.extend(-position.dot(normal.truncate()) / normal.z);
        let tangent = to_world(normal.cross(point));
        let ray = Self { normal: to_world(normal), tangent, toward_viewer: to_world(Vec3::Z) };
        (point.length_squared() < 1.0).then_some(ray)
    }
}

/// Of a sphere that light passes through; it knows no other light than that from all around.
pub fn through(solid: &dyn Solid, light: Light, ray: &Ray, u: [f32; 5]) -> Vec3 {
    let Light::Around(environment) = light else {
        return Vec3::ZERO;
    };
    let [a, b, ..] = u.map(f32::to_bits);
    let mut random = Pcg32::seed_from_u64(u64::from(a) << 32 | u64::from(b));
    solid.radiance(environment, ray.normal, ray.toward_viewer, &mut random)
}

/// Of a surface that reflects.
pub fn radiance(surface: Surface<'_>, light: Light, ray: &Ray, u: [f32; 5]) -> Vec3 {
    let frame = Frame::from_normal_and_tangent::<f32>(ray.normal, ray.tangent);
    let wo = frame.to_local::<f32>(ray.toward_viewer);
    let lit = |towards: Vec3, irradiance: f32| {
        let wi = frame.to_local::<f32>(to_world(towards));
        surface.eval(wi, wo, TransportMode::Radiance) * wi.z.max(0.0) * irradiance
    };
    match light {
        Light::Distant { towards, irradiance } => lit(towards, irradiance),
        Light::Sun { phase, irradiance } => {
            let (sin, cos) = phase.sin_cos();
            lit(Vec3::new(sin, 0.0, cos), irradiance)
        }
        Light::Furnace => {
            let [.., u2, u3, u4] = u;
            let sample = surface.sample(wo, [u2, u3, u4], TransportMode::Radiance);
            let lobe = surface.specular(wo, TransportMode::Radiance).reflected.weight;
            if sample.specular { lobe } else { lobe + sample.weight }
        }
        Light::Around(environment) => reflected(surface, environment, &frame, wo, u),
    }
}

/// The specular lobe, and ∫ f L cosθ dω from one direction drawn from the light and one from the surface,
/// weighed by their densities (the balance heuristic: E. Veach, L. Guibas, SIGGRAPH 1995).
fn reflected(
    surface: Surface<'_>,
    environment: &Environment,
    frame: &Frame<Vec3>,
    wo: Vec3,
    [u0, u1, u2, u3, u4]: [f32; 5],
) -> Vec3 {
    let mode = TransportMode::Radiance;
    let mut light = Vec3::ZERO;
    let (direction, light_pdf) = environment.sample([u0, u1]);
    let wi = frame.to_local::<f32>(direction);
    if wi.z > 0.0 {
        let (value, pdf) = surface.eval_pdf(wi, wo, mode);
        light += value * environment.radiance(direction) * (wi.z / (light_pdf + pdf));
    }
    let lobe = surface.specular(wo, mode).reflected;
    if lobe.weight != Vec3::ZERO {
        light += lobe.weight * environment.radiance(frame.to_world::<f32>(lobe.wi));
    }
    let BsdfSample { wi, weight, pdf, specular } = surface.sample(wo, [u2, u3, u4], mode);
    if pdf > 0.0 && !specular {
        let direction = frame.to_world::<f32>(wi);
        let share = 1.0 / (1.0 + environment.pdf(direction) / pdf);
        light += weight * environment.radiance(direction) * share;
    }
    light
}
