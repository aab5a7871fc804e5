//! What a call costs.

use std::f32::consts::TAU;
use std::fmt;
use std::hint::black_box;
use std::time::Instant;

use brdf::TransportMode;
use glam::Vec3;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;

use crate::steps::{Model, Step};

/// Nanoseconds for a call of `eval`, `pdf` and `sample`, three channels.
#[derive(Clone, Copy, Debug)]
pub struct Cost(pub [f64; 3]);

impl fmt::Display for Cost {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [eval, pdf, sample] = self.0;
        write!(
            formatter,
            "A call takes: value {eval:.0} ns, density {pdf:.0} ns, sample {sample:.0} ns."
        )
    }
}

/// Light, viewer and the numbers of a sample.
type Call = (Vec3, Vec3, [f32; 3]);

/// A direction over the hemisphere, all alike.
fn direction(random: &mut Pcg32) -> Vec3 {
    let cos = random.random_range(1e-3..1.0_f32);
    let (sin, azimuth) = ((1.0 - cos * cos).sqrt(), random.random_range(0.0..TAU));
    Vec3::new(sin * azimuth.cos(), sin * azimuth.sin(), cos)
}

/// Medians of turns that the models take, through a pointer that the compiler does not see through, with
/// directions that it cannot group.
pub fn all(steps: &[Step], small: bool) -> Vec<Cost> {
    let (count, turns) = if small { (64, 3) } else { (4096, 31) };
    let mut random = Pcg32::seed_from_u64(1);
    let calls: Vec<Call> = (0..count)
        .map(|_| (direction(&mut random), direction(&mut random), random.random()))
        .collect();
    let mut times = vec![Vec::new(); steps.len()];
    for _ in 0..turns {
        for (step, times) in steps.iter().zip(&mut times) {
            times.push(turn(black_box(&step.model), &calls));
        }
    }
    let median = |times: &[[f64; 3]], what: usize| {
        let mut times: Vec<f64> = times.iter().map(|turn| turn[what]).collect();
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    };
    times.iter().map(|times| Cost([0, 1, 2].map(|what| median(times, what)))).collect()
}

/// Nanoseconds of a turn, for a call.
fn turn(model: &Model, calls: &[Call]) -> [f64; 3] {
    let mode = TransportMode::Radiance;
    let each = |call: &mut dyn FnMut(&Call)| {
        let start = Instant::now();
        calls.iter().for_each(call);
        start.elapsed().as_secs_f64() * 1e9 / calls.len() as f64
    };
    [
        each(&mut |(wi, wo, _)| {
            black_box(model.eval(*wi, *wo, mode));
        }),
        each(&mut |(wi, wo, _)| {
            black_box(model.pdf(*wi, *wo, mode));
        }),
        each(&mut |(_, wo, u)| {
            black_box(model.sample(*wo, *u, mode));
        }),
    ]
}
