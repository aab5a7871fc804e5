//! Pictures of lit spheres.

use brdf::{Brdf, Frame};
use glam::{Vec2, Vec3};
use image::RgbImage;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use rayon::prelude::*;

use crate::environment::Environment;

/// A model of any kind.
pub type Material = Box<dyn Brdf<Color = Vec3>>;

/// What lights the spheres.
#[derive(Clone, Copy, Debug)]
pub enum Light<'a> {
    /// Radiance from all around.
    Around(&'a Environment),
    /// Parallel light from a direction in the camera's frame (x right, y up, z to the viewer),
    /// with the irradiance of a surface that faces it.
    Distant {
        /// Towards the light; of length 1.
        towards: Vec3,
        /// For all three channels.
        irradiance: f32,
    },
}

/// Width of a sphere's square in pixels and rays per pixel.
#[derive(Clone, Copy, Debug)]
pub struct Quality {
    /// Pixels.
    pub tile: u32,
    /// Rays per pixel.
    pub rays: u16,
}

/// Radius of a sphere over half the width of its square.
const RADIUS: f32 = 0.88;
/// Height of the camera above the horizon, radians: the upper pole is in view.
const ELEVATION: f32 = 0.35;
/// The background at the top and at the bottom, linear display values.
const BACKGROUND: [f32; 2] = [0.10, 0.035];

/// A row of spheres of unit radius, one per square, seen by a distant camera (parallel rays). Each
/// is alone in its light: no shadow or reflection of another.
pub fn render(materials: &[Material], light: Light, quality: Quality) -> RgbImage {
    let (width, height) = (quality.tile * materials.len() as u32, quality.tile);
    let mut picture = RgbImage::new(width, height);
    picture.par_chunks_exact_mut(3).enumerate().for_each(|(index, pixel)| {
        let (x, y) = (index as u32 % width, index as u32 / width);
        let material = &materials[(x / quality.tile) as usize];
        let corner = Vec2::new((x % quality.tile) as f32, y as f32);
        let mut random = Pcg32::seed_from_u64(index as u64);
        let linear = pixel_color(material, light, corner, quality, random.random());
        pixel.copy_from_slice(&linear.to_array().map(encode));
    });
    picture
}

/// Linear display colour of one pixel. Sphere and background are averaged apart and joined after
/// the tone curve, so that bright edges are smooth.
fn pixel_color(
    material: &Material,
    light: Light,
    corner: Vec2,
    quality: Quality,
    offset: [f32; 6],
) -> Vec3 {
    let tile = quality.tile as f32;
    let (mut sum, mut hits) = (Vec3::ZERO, 0.0);
    for index in 0..quality.rays {
        // Three even point sets, each in another order, so that they do not follow each other.
        let shuffled = |factor: u32| u32::from(index) * factor % u32::from(quality.rays);
        let [ax, ay] = point(shuffled(1), Vec2::new(offset[0], offset[1]));
        let [u0, u1] = point(shuffled(29), Vec2::new(offset[2], offset[3]));
        let [u2, u3] = point(shuffled(43), Vec2::new(offset[4], offset[5]));
        let u = [u0, u1, u2, u3];
        let position = (corner + Vec2::new(ax, ay)) * (2.0 / tile) - 1.0;
        let position = Vec2::new(position.x, -position.y) / RADIUS;
        if position.length_squared() < 1.0 {
            sum += radiance(material, light, position, u);
            hits += 1.0;
        }
    }
    let [top, bottom] = BACKGROUND;
    let background = Vec3::splat(top + (bottom - top) * corner.y / tile);
    if hits == 0.0 {
        return background;
    }
    background.lerp(tone(sum / hits), hits / f32::from(quality.rays))
}

/// A point of the unit square: additive recurrence with powers of the root of x³ = x + 1
/// (M. Roberts, *The unreasonable effectiveness of quasirandom sequences*, 2018), shifted.
fn point(index: u32, offset: Vec2) -> [f32; 2] {
    const ROOT: f64 = 1.324717957244746;
    let turn = |shift: f32, step: f64| {
        let value = f64::from(shift) + step * f64::from(index);
        // Rounding to single precision may reach 1.
        ((value - value.floor()) as f32).min(1.0 - f32::EPSILON)
    };
    [turn(offset.x, 1.0 / ROOT), turn(offset.y, 1.0 / (ROOT * ROOT))]
}

/// Radiance towards the camera from the point of the unit sphere at a place in the picture.
fn radiance(material: &Material, light: Light, position: Vec2, u: [f32; 4]) -> Vec3 {
    let (sin, cos) = ELEVATION.sin_cos();
    let to_world = |v: Vec3| Vec3::new(v.x, v.y * cos + v.z * sin, v.z * cos - v.y * sin);
    let toward_viewer = to_world(Vec3::Z);
    let depth = (1.0 - position.length_squared()).max(0.0).sqrt();
    let normal = to_world(position.extend(depth));
    // The tangent runs along the parallels of latitude.
    let frame = Frame::from_normal_and_tangent::<f32>(normal, Vec3::Y.cross(normal));
    let wo = frame.to_local::<f32>(toward_viewer);
    match light {
        Light::Distant { towards, irradiance } => {
            let wi = frame.to_local::<f32>(to_world(towards));
            material.eval(wi, wo) * wi.z.max(0.0) * irradiance
        }
        Light::Around(environment) => reflected(material, environment, &frame, wo, u),
    }
}

/// ∫ f L cosθ dω from one direction drawn from the light and one from the material, weighed by
/// their densities (the balance heuristic: E. Veach, L. Guibas, SIGGRAPH 1995).
fn reflected(
    material: &Material,
    environment: &Environment,
    frame: &Frame<Vec3>,
    wo: Vec3,
    [u0, u1, u2, u3]: [f32; 4],
) -> Vec3 {
    let (direction, light_pdf) = environment.sample([u0, u1]);
    let wi = frame.to_local::<f32>(direction);
    let from_light = if wi.z > 0.0 {
        let density = light_pdf + material.pdf(wi, wo);
        material.eval(wi, wo) * environment.radiance(direction) * (wi.z / density)
    } else {
        Vec3::ZERO
    };
    let sample = material.sample(wo, [u2, u3]);
    if sample.pdf <= 0.0 {
        return from_light;
    }
    let direction = frame.to_world::<f32>(sample.wi);
    let share = 1.0 / (1.0 + environment.pdf(direction) / sample.pdf);
    from_light + sample.weight * environment.radiance(direction) * share
}

/// The tone curve: the largest channel M becomes M/(1 + M), the others keep their ratio to it, so
/// that bright metal keeps its colour.
fn tone(radiance: Vec3) -> Vec3 {
    radiance / (1.0 + radiance.max_element())
}

/// The sRGB transfer function, 8 bits.
fn encode(linear: f32) -> u8 {
    let value =
        if linear <= 0.0031308 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (value.clamp(0.0, 1.0) * 255.0).round() as u8
}
