//! Spheres that light passes through: balls of glass and bubbles.

use std::f32::consts::FRAC_PI_2;

use brdf::{Bsdf, Color, Frame, TransportMode, reflect};
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

/// A ball with an interface that refracts, clear inside.
pub struct Ball<M>(pub M);

/// The most times that light meets the surface: of a smooth ball of index 1.5 less than 10⁻⁵ is left.
const BOUNCES: usize = 16;
/// Paths for each ray into a rough ball.
const PATHS: u16 = 4;

/// A place of a path: its point, where it came from, and what has become of its light.
#[derive(Clone, Copy)]
struct Vertex {
    point: Vec3,
    wo: Vec3,
    weight: Vec3,
}

/// What a place sends to the viewer from outside, and where the path goes on inside.
type Step = (Vec3, Option<Vertex>);

impl<M: Bsdf<f32, Color = Vec3>> Ball<M> {
    /// Both lobes of a smooth surface: one of them leads outside, the other inside.
    fn lobes(&self, environment: &Environment, at: Vertex) -> Option<Step> {
        let frame = at.frame();
        let lobes = self.0.specular(frame.to_local::<f32>(at.wo), TransportMode::Radiance);
        let (mut light, mut next, mut any) = (Vec3::ZERO, None, false);
        for lobe in [lobes.reflected, lobes.transmitted] {
            if lobe.weight == Vec3::ZERO {
                continue;
            }
            any = true;
            let direction = frame.to_world::<f32>(lobe.wi);
            if lobe.wi.z > 0.0 {
                light += at.weight * lobe.weight * environment.radiance(direction);
            } else {
                next = Some(at.onwards(direction, lobe.weight));
            }
        }
        any.then_some((light, next))
    }

    /// One direction drawn from the light and one from the surface, weighed by their densities.
    fn drawn(&self, environment: &Environment, at: Vertex, random: &mut Pcg32) -> Step {
        let (frame, mode) = (at.frame(), TransportMode::Radiance);
        let wo = frame.to_local::<f32>(at.wo);
        let (direction, light_pdf) = environment.sample(random.random());
        let wi = frame.to_local::<f32>(direction);
        let mut light = Vec3::ZERO;
        if wi.z > 0.0 {
            let (value, pdf) = self.0.eval_pdf(wi, wo, mode);
            light = value * environment.radiance(direction) * (wi.z / (light_pdf + pdf));
        }
        let sample = self.0.sample(wo, random.random(), mode);
        if sample.pdf <= 0.0 {
            return (at.weight * light, None);
        }
        let direction = frame.to_world::<f32>(sample.wi);
        if sample.wi.z <= 0.0 {
            return (at.weight * light, Some(at.onwards(direction, sample.weight)));
        }
        let share = 1.0 / (1.0 + environment.pdf(direction) / sample.pdf);
        (at.weight * (light + sample.weight * environment.radiance(direction) * share), None)
    }
}

impl Vertex {
    fn frame(&self) -> Frame<Vec3> {
        Frame::from_normal_and_tangent::<f32>(self.point, Vec3::Y.cross(self.point))
    }

    /// Through the ball to the next place.
    fn onwards(&self, direction: Vec3, weight: Vec3) -> Self {
        let point = across(self.point, direction);
        Self { point, wo: -direction, weight: self.weight * weight }
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
        let start = Vertex { point, wo: toward_viewer, weight: Vec3::ONE };
        let smooth = self.lobes(environment, start).is_some();
        let paths = if smooth { 1 } else { PATHS };
        let mut sum = Vec3::ZERO;
        for _ in 0..paths {
            let mut place = Some(start);
            for _ in 0..BOUNCES {
                let Some(at) = place else { break };
                let step = self.lobes(environment, at);
                let (light, next) = step.unwrap_or_else(|| self.drawn(environment, at, random));
                sum += light;
                place = next;
            }
        }
        sum / f32::from(paths)
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
