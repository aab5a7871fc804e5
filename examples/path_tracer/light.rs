//! Lamps, and how to draw directions towards them.

use glam::Vec3;

use crate::shape::Ray;
use crate::spectral::Spectral;

/// A rectangle that shines from one side, with the same radiance in all directions.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    center: Vec3,
    /// From the centre to the middles of two edges.
    half: [Vec3; 2],
    /// The direction in which it shines.
    normal: Vec3,
    area: f32,
    radiance: Spectral,
}

impl Lamp {
    /// A lamp of a width and height that faces a point.
    pub fn facing(
        point: Vec3,
        center: Vec3,
        [width, height]: [f32; 2],
        radiance: Spectral,
    ) -> Self {
        let normal = (point - center).normalize();
        let across = Vec3::Y.cross(normal).normalize_or(Vec3::X);
        let half = [across * (0.5 * width), normal.cross(across) * (0.5 * height)];
        Self { center, half, normal, area: width * height, radiance }
    }

    /// The distance at which a ray meets the lamp, from either side.
    pub fn first(&self, ray: &Ray) -> Option<f32> {
        let toward = ray.direction.dot(self.normal);
        let distance = (self.center - ray.origin).dot(self.normal) / toward;
        let from_center = ray.at(distance) - self.center;
        let inside = |half: Vec3| from_center.dot(half).abs() <= half.length_squared();
        (distance > 0.0 && self.half.into_iter().all(inside)).then_some(distance)
    }

    /// What it sends against a direction: nothing from its back.
    pub fn radiance(&self, direction: Vec3) -> Spectral {
        let front = if direction.dot(self.normal) < 0.0 { 1.0 } else { 0.0 };
        self.radiance * front
    }

    /// Draws a direction from a point towards the lamp, by a uniform point of it.
    pub fn sample(&self, origin: Vec3, u: [f32; 2]) -> Vec3 {
        let [across, up] = self.half;
        let point = self.center + across * (2.0 * u[0] - 1.0) + up * (2.0 * u[1] - 1.0);
        (point - origin).normalize()
    }

    /// The density per steradian with which [`sample`](Self::sample) draws a direction: that of a
    /// uniform point, 1/area, in solid angle. Directions to the back count as never drawn: they
    /// bring nothing.
    pub fn pdf(&self, ray: &Ray) -> f32 {
        let cos = -ray.direction.dot(self.normal);
        match self.first(ray) {
            Some(distance) if cos > 0.0 => distance * distance / (cos * self.area),
            _ => 0.0,
        }
    }
}
