//! The radiance along a ray, by following one path backwards.
//!
//! What a surface sends towards the viewer at ωₒ is the integral of f(ωᵢ, ωₒ) L(ωᵢ) cosθᵢ over the
//! directions ωᵢ of the light L (J. T. Kajiya, *The rendering equation*, SIGGRAPH 1986). Each
//! estimate f L cosθᵢ/p of it needs directions of a known density p. The lamps are good at drawing
//! them where they are small and the surface is dull, the surface where it is glossy and the lamps
//! are large; each is very bad where the other is good. So both draw one, and the power heuristic
//! weighs each by its density among the two (E. Veach, L. J. Guibas, *Optimally combining sampling
//! techniques for Monte Carlo rendering*, SIGGRAPH 1995).

use brdf::Brdf;

use crate::draws::Draws;
use crate::scene::{Met, Scene};
use crate::shape::Ray;
use crate::spectral::{BLACK, Spectral, WHITE, largest};

/// Which directions count: those drawn from the lamps, from the surface, or both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawn {
    Lamps,
    Surface,
    Both,
}

/// No path is followed with certainty after this many surfaces.
const CERTAIN: usize = 3;
/// The largest probability to follow a path after that.
const LIKELY: f32 = 0.95;

pub fn radiance(scene: &Scene, ray: Ray, draws: &mut Draws) -> Spectral {
    radiance_by(Drawn::Both, scene, ray, draws)
}

pub fn radiance_by(drawn: Drawn, scene: &Scene, mut ray: Ray, draws: &mut Draws) -> Spectral {
    let (mut sum, mut throughput) = (BLACK, WHITE);
    // The density with which the ray was drawn; that of the camera has no rival.
    let mut ray_pdf = f32::INFINITY;
    for surfaces in 0.. {
        let surface = match scene.first(&ray) {
            Met::Surface(surface) => surface,
            Met::Light(light) => {
                let lamps_pdf = scene.lamps_pdf(&ray);
                let share = match drawn {
                    Drawn::Both => power_heuristic(ray_pdf, lamps_pdf),
                    // What the lamps can draw is theirs.
                    Drawn::Lamps if lamps_pdf > 0.0 && ray_pdf.is_finite() => 0.0,
                    Drawn::Lamps | Drawn::Surface => 1.0,
                };
                return sum + throughput * light * share;
            }
        };
        let wo = surface.frame.to_local(-ray.direction);

        let [choice, u0, u1, chance] = draws.four();

        // A direction from the lamps: f and the surface's own density of it in one call.
        if drawn != Drawn::Surface
            && let Some(direction) = scene.sample_lamps(surface.point, choice, [u0, u1])
        {
            let to_lamp = surface.ray(direction);
            let wi = surface.frame.to_local(direction);
            let (pdf, (f, surface_pdf)) =
                (scene.lamps_pdf(&to_lamp), surface.material.eval_pdf(wi, wo));
            // Below the surface f is zero, and a ray in vain is saved.
            if pdf > 0.0 && largest(f) > 0.0 {
                let share =
                    if drawn == Drawn::Both { power_heuristic(pdf, surface_pdf) } else { 1.0 };
                let weight = share * wi.z / pdf;
                sum = sum + throughput * f * scene.light(&to_lamp) * weight;
            }
        }

        // A direction from the surface: its weight f cosθᵢ/p is ready.
        let [v0, v1, ..] = draws.four();
        let sample = surface.material.sample(wo, [v0, v1]);
        throughput = throughput * sample.weight;
        // So narrow a lobe that no density can be told is a mirror's, which has no rival.
        ray_pdf = if sample.pdf > 0.0 { sample.pdf } else { f32::INFINITY };
        ray = surface.ray(surface.frame.to_world(sample.wi));

        // Dim paths end by chance, and those that do not count for the others: Russian roulette.
        let follow = if surfaces < CERTAIN { 1.0 } else { largest(throughput).min(LIKELY) };
        if largest(throughput) <= 0.0 || chance >= follow {
            return sum;
        }
        throughput = throughput * (1.0 / follow);
    }
    sum
}

/// p²/(p² + q²).
fn power_heuristic(pdf: f32, other: f32) -> f32 {
    1.0 / (1.0 + (other / pdf).powi(2))
}
