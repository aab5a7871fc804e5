//! What there is: objects, lamps, and light from all around.

use brdf::{Brdf, Frame};
use glam::Vec3;

use crate::light::Lamp;
use crate::shape::{Ray, Shape};
use crate::spectral::{BLACK, Spectral};

/// Any model, of this crate or another.
pub type Material = Box<dyn Brdf<Color = Spectral>>;

pub struct Object {
    pub shape: Shape,
    pub center: Vec3,
    pub material: Material,
}

pub struct Scene {
    pub objects: Vec<Object>,
    pub lamps: Vec<Lamp>,
    /// The same radiance from everywhere that nothing covers.
    pub surroundings: Spectral,
}

/// A point of a surface.
pub struct Surface<'a> {
    pub point: Vec3,
    pub frame: Frame<Vec3>,
    pub material: &'a Material,
}

/// What a ray meets first.
pub enum Met<'a> {
    Surface(Surface<'a>),
    /// A lamp or the surroundings, with their radiance towards the origin of the ray.
    Light(Spectral),
}

impl Surface<'_> {
    /// A ray that leaves the surface, from a little above it: so it does not meet the same point.
    pub fn ray(&self, direction: Vec3) -> Ray {
        Ray { origin: self.point + self.frame.normal() * 1e-3, direction }
    }
}

impl Scene {
    pub fn first(&self, ray: &Ray) -> Met<'_> {
        let mut nearest = f32::INFINITY;
        let mut object = None;
        for candidate in &self.objects {
            let local = Ray { origin: ray.origin - candidate.center, ..*ray };
            if let Some(distance) = candidate.shape.first(&local).filter(|at| *at < nearest) {
                (nearest, object) = (distance, Some(candidate));
            }
        }
        let mut light = self.surroundings;
        for lamp in &self.lamps {
            if let Some(distance) = lamp.first(ray).filter(|at| *at < nearest) {
                (nearest, object, light) = (distance, None, lamp.radiance(ray.direction));
            }
        }
        let Some(Object { shape, center, material }) = object else {
            return Met::Light(light);
        };
        let point = ray.at(nearest);
        let normal = shape.normal(point - *center);
        // The tangent runs around the vertical, as the grooves of a lathe do.
        let frame = Frame::from_normal_and_tangent(normal, Vec3::Y.cross(point - *center));
        Met::Surface(Surface { point, frame, material })
    }

    /// The light that comes along a ray, if no surface is in the way.
    pub fn light(&self, ray: &Ray) -> Spectral {
        match self.first(ray) {
            Met::Light(radiance) => radiance,
            Met::Surface(_) => BLACK,
        }
    }

    /// Draws a direction towards a lamp, each as likely as another.
    pub fn sample_lamps(&self, origin: Vec3, choice: f32, u: [f32; 2]) -> Option<Vec3> {
        let index = (choice * self.lamps.len() as f32) as usize;
        self.lamps.get(index).map(|lamp| lamp.sample(origin, u))
    }

    /// The density of [`sample_lamps`](Self::sample_lamps): a direction may lead to several lamps,
    /// one behind another.
    pub fn lamps_pdf(&self, ray: &Ray) -> f32 {
        let sum: f32 = self.lamps.iter().map(|lamp| lamp.pdf(ray)).sum();
        sum / self.lamps.len().max(1) as f32
    }
}
