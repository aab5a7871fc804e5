//! Shapes, and where a ray meets them.

use glam::{Vec2, Vec3, Vec3Swizzles};

/// A half line.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub origin: Vec3,
    /// Of length 1.
    pub direction: Vec3,
}

impl Ray {
    pub fn at(&self, distance: f32) -> Vec3 {
        self.origin + self.direction * distance
    }
}

/// A surface around the origin, +y up, known by the distance of any point from it.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// All below the origin.
    Floor,
    Sphere {
        radius: f32,
    },
    /// An upright cylinder with a rounded edge.
    Disc {
        radius: f32,
        half_height: f32,
        edge: f32,
    },
    /// A part of a hollow sphere, open above the height of its lip over the centre.
    Bowl {
        radius: f32,
        lip: f32,
        half_wall: f32,
    },
}

/// On a surface within this distance; about a tenth of what shadows begin with.
const NEAR: f32 = 1e-4;

impl Shape {
    /// Distance from the surface, negative inside.
    pub fn distance(&self, p: Vec3) -> f32 {
        // Radius and height: the plane of the profile.
        let profile = || Vec2::new(p.xz().length(), p.y);
        match *self {
            Self::Sphere { radius } => p.length() - radius,
            Self::Disc { radius, half_height, edge } => {
                let corner = Vec2::new(radius - edge, half_height - edge);
                let beyond = profile().abs() - corner;
                beyond.max(Vec2::ZERO).length() + beyond.max_element().min(0.0) - edge
            }
            Self::Bowl { radius, lip, half_wall } => {
                let end = Vec2::new((radius * radius - lip * lip).sqrt(), lip);
                let profile = profile();
                let below_lip = profile.y * end.x <= profile.x * end.y;
                let from_arc = (profile.length() - radius).abs();
                if below_lip { from_arc - half_wall } else { profile.distance(end) - half_wall }
            }
            Self::Floor => p.y,
        }
    }

    /// Radius of a sphere around the origin that contains the shape.
    fn bound(&self) -> f32 {
        match *self {
            Self::Sphere { radius } => radius,
            Self::Disc { radius, half_height, .. } => radius.hypot(half_height),
            Self::Bowl { radius, half_wall, .. } => radius + half_wall,
            Self::Floor => f32::INFINITY,
        }
    }

    /// The normal at a point of the surface: the gradient of the distance.
    pub fn normal(&self, p: Vec3) -> Vec3 {
        let along = |step: Vec3| self.distance(p + step) - self.distance(p - step);
        const STEP: f32 = 1e-3;
        Vec3::new(along(Vec3::X * STEP), along(Vec3::Y * STEP), along(Vec3::Z * STEP)).normalize()
    }

    /// Distance along the ray to the first point of the surface: as far as the surface is away, the
    /// ray may go without missing it (J. C. Hart, *Sphere tracing*, The Visual Computer 12, 1996).
    pub fn first(&self, ray: &Ray) -> Option<f32> {
        if let Self::Floor = self {
            return Some(-ray.origin.y / ray.direction.y).filter(|at| *at > 0.0);
        }
        let middle = -ray.origin.dot(ray.direction);
        let across_squared = ray.at(middle).length_squared();
        let half = (self.bound().powi(2) - across_squared).max(0.0).sqrt();
        let (mut at, end) = ((middle - half).max(0.0), middle + half);
        for _ in 0..256 {
            if at >= end {
                return None;
            }
            let distance = self.distance(ray.at(at));
            if distance < NEAR {
                return Some(at);
            }
            at += distance;
        }
        None
    }
}
