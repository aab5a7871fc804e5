//! Spheres that light passes through: balls of glass and bubbles.

use std::f32::consts::FRAC_PI_2;

use brdf::{Bsdf, Color, Dielectric, Frame, Fresnel, Lobes, TransportMode, reflect};
use glam::Vec3;
use rand::RngExt;
use rand_pcg::Pcg32;

use crate::environment::Environment;

/// A unit sphere that sends on light from all around.
pub trait Solid: Send + Sync {
    /// Radiance towards the viewer from a point of the surface, which is its normal too.
    fn radiance(
        &self,
        environment: &Environment,
        point: Vec3,
        toward_viewer: Vec3,
        random: &mut Pcg32,
    ) -> Vec3;
}

/// A ball with an interface that refracts, clear inside, and its index.
pub struct Ball<M> {
    pub surface: M,
    pub glass: Dielectric<f32>,
}

/// The most times that light meets the surface: of a smooth ball of index 1.5 less than 10⁻⁵ is left.
const BOUNCES: u32 = 16;
/// How often both what is reflected and what is refracted is followed: inside, one in twenty-five
/// is reflected, and may be what meets the lamp.
const SPLITS: u32 = 2;
/// Paths for each ray: between two rough surfaces few of them meet the lamp, which is small and bright.
const PATHS: u16 = 6;

/// A place of a path: its point, and where it came from.
#[derive(Clone, Copy)]
struct Vertex {
    point: Vec3,
    wo: Vec3,
    /// How often light met the surface before.
    depth: u32,
}

impl Vertex {
    fn frame(&self) -> Frame<Vec3> {
        Frame::from_normal_and_tangent::<f32>(self.point, Vec3::Y.cross(self.point))
    }
}

impl<M: Bsdf<f32, Color = Vec3>> Ball<M> {
    /// Radiance from a place to where the path came from.
    fn light(&self, environment: &Environment, at: Vertex, random: &mut Pcg32) -> Vec3 {
        if at.depth == BOUNCES {
            return Vec3::ZERO;
        }
        let frame = at.frame();
        let wo = frame.to_local::<f32>(at.wo);
        let Lobes { reflected, transmitted } = self.surface.specular(wo, TransportMode::Radiance);
        let lobes = [reflected, transmitted].map(|lobe| (lobe.weight, lobe.wi, 1.0));
        let mut light = Vec3::ZERO;
        let drawn = match lobes.iter().any(|(weight, ..)| *weight != Vec3::ZERO) {
            true => lobes,
            false => {
                light = self.found(environment, &frame, wo, random.random());
                self.drawn(environment, &frame, wo, at.depth < SPLITS, random.random())
            }
        };
        for (weight, wi, share) in drawn {
            if weight == Vec3::ZERO {
                continue;
            }
            let direction = frame.to_world::<f32>(wi);
            light += weight
                * match wi.z > 0.0 {
                    true => environment.radiance(direction) * share,
                    false => {
                        let point = across(at.point, direction);
                        let next = Vertex { point, wo: -direction, depth: at.depth + 1 };
                        self.light(environment, next, random)
                    }
                };
        }
        light
    }

    /// From a direction drawn from the light, weighed by both densities.
    fn found(&self, environment: &Environment, frame: &Frame<Vec3>, wo: Vec3, u: [f32; 2]) -> Vec3 {
        let (direction, light_pdf) = environment.sample(u);
        let wi = frame.to_local::<f32>(direction);
        if wi.z <= 0.0 {
            return Vec3::ZERO;
        }
        let (value, pdf) = self.surface.eval_pdf(wi, wo, TransportMode::Radiance);
        value * environment.radiance(direction) * (wi.z / (light_pdf + pdf))
    }

    /// Directions drawn from the surface, with their weights and their shares beside the light's: one, or
    /// both that a facet has, each by its probability.
    fn drawn(
        &self,
        environment: &Environment,
        frame: &Frame<Vec3>,
        wo: Vec3,
        split: bool,
        [u0, u1, u2]: [f32; 3],
    ) -> [(Vec3, Vec3, f32); 2] {
        let draw = |event: f32, probability: f32| {
            let sample = self.surface.sample(wo, [u0, u1, event], TransportMode::Radiance);
            if sample.pdf <= 0.0 {
                return (Vec3::ZERO, wo, 0.0);
            }
            let light_pdf = environment.pdf(frame.to_world::<f32>(sample.wi));
            (sample.weight * probability, sample.wi, 1.0 / (1.0 + light_pdf / sample.pdf))
        };
        if !split {
            return [draw(u2, 1.0), (Vec3::ZERO, wo, 0.0)];
        }
        let (_, mirrored, _) = draw(0.0, 1.0);
        let cos = wo.dot((wo + mirrored).normalize_or(wo)).abs();
        let reflected = self.glass.reflectance(if wo.z < 0.0 { -cos } else { cos });
        [draw(0.0, reflected), draw(1.0 - f32::EPSILON, 1.0 - reflected)]
    }
}

impl<M: Bsdf<f32, Color = Vec3>> Solid for Ball<M> {
    fn radiance(
        &self,
        environment: &Environment,
        point: Vec3,
        toward_viewer: Vec3,
        random: &mut Pcg32,
    ) -> Vec3 {
        let start = Vertex { point, wo: toward_viewer, depth: 0 };
        let paths = (0..PATHS).map(|_| self.light(environment, start, random));
        paths.sum::<Vec3>() / f32::from(PATHS)
    }
}

/// Where a straight line from a point of the unit sphere meets it again.
fn across(point: Vec3, direction: Vec3) -> Vec3 {
    (point - direction * (2.0 * point.dot(direction))).normalize()
}

/// Reflectance of a film over the cosine of the angle of incidence and the thickness, in channels of
/// any kind.
pub struct Film<C> {
    /// Row by row; each is one thickness.
    values: Vec<C>,
    thickest: f32,
}

const COSINES: u16 = 128;
const THICKNESSES: u16 = 512;

impl<C: Color<f32>> Film<C> {
    /// Tabulates reflectances up to a thickness in nanometres, at squares of even steps of the cosine:
    /// closer towards grazing.
    pub fn new<F, E>(
        thickest: f32,
        at: impl Fn(f32) -> Result<F, E>,
        reflectance: impl Fn(&F, f32) -> C,
    ) -> Result<Self, E> {
        let mut values = Vec::new();
        for row in 0..THICKNESSES {
            let film = at(thickest * f32::from(row) / f32::from(THICKNESSES - 1))?;
            let cos = |column: u16| (f32::from(column) / f32::from(COSINES - 1)).powi(2);
            values.extend((0..COSINES).map(|column| reflectance(&film, cos(column))));
        }
        Ok(Self { values, thickest })
    }

    fn reflectance(&self, cos: f32, thickness: f32) -> C {
        let (width, height) = (usize::from(COSINES), usize::from(THICKNESSES));
        let place = |part: f32, count: usize| {
            let at = part.clamp(0.0, 1.0) * (count - 1) as f32;
            let below = (at as usize).min(count - 2);
            (below, at - below as f32)
        };
        let (column, x) = place(cos.max(0.0).sqrt(), width);
        let (row, y) = place(thickness / self.thickest, height);
        let value = |dy: usize, dx: usize| self.values[(row + dy) * width + column + dx];
        let across = |dy| value(dy, 0) * (1.0 - x) + value(dy, 1) * x;
        across(0) * (1.0 - y) + across(1) * y
    }
}

/// A bubble of a film with air on both sides, thin at the top and thick at the bottom.
pub struct Bubble<C, S> {
    pub film: Film<C>,
    /// Thickness at the top and at the bottom, nm.
    pub thickness: [f32; 2],
    /// What a reflectance or transmittance is to the eye.
    pub seen: S,
}

impl<C, S> Bubble<C, S> {
    /// With a swirl of a twelfth of the difference.
    fn thickness(&self, point: Vec3) -> f32 {
        let [top, bottom] = self.thickness;
        let depth = (0.5 - 0.5 * point.y).clamp(0.0, 1.0);
        let azimuth = point.z.atan2(point.x);
        let swirl = (3.0 * azimuth + 5.0 * point.y).sin() * (FRAC_PI_2 * point.y).cos();
        top + (bottom - top) * (depth + swirl / 12.0).clamp(0.0, 1.0)
    }
}

impl<C, S> Solid for Bubble<C, S>
where
    C: Color<f32> + Send + Sync,
    S: Fn(C) -> Vec3 + Send + Sync,
{
    /// What the near wall reflects, what passes both walls, and what passes the near wall, is
    /// reflected by the far one and passes a third place. Later reflections are left out.
    fn radiance(
        &self,
        environment: &Environment,
        point: Vec3,
        toward_viewer: Vec3,
        _: &mut Pcg32,
    ) -> Vec3 {
        let onwards = -toward_viewer;
        let cos = toward_viewer.dot(point);
        let at = |point| self.film.reflectance(cos, self.thickness(point));
        let passing = |reflectance: C| reflectance.map(|reflectance| 1.0 - reflectance);
        let far = across(point, onwards);
        let (near_wall, far_wall) = (at(point), at(far));
        let outside = reflect::<f32, Vec3>(toward_viewer, point);
        let inside = reflect::<f32, Vec3>(-onwards, -far);
        let third = at(across(far, inside));
        let light = |weight: C, from: Vec3| (self.seen)(weight) * environment.radiance(from);
        light(near_wall, outside)
            + light(passing(near_wall) * passing(far_wall), onwards)
            + light(passing(near_wall) * far_wall * passing(third), inside)
    }
}
