//! What a renderer pays at a hit: `cargo bench --bench calls`.
//!
//! Nanoseconds for a call of `eval`, `pdf` and `sample` through `dyn Brdf`, with directions that no
//! compiler can group, of every model of the registry; and, before them, of models that are written by
//! hand, called in the same way, in turns. Each figure is the median of the turns, each ratio that of by
//! hand over the crate: above 1 the crate is faster.

mod common;

use std::hint::black_box;
use std::time::Instant;

use brdf::{
    Beckmann, BlinnPhong, Brdf, Conductor, CookTorrance, Ggx, OrenNayar, Sample, Schlick, VCavity,
};
use brdf_checks::models;
use common::by_hand_models::{BeckmannGold, GgxGold, Gold, Grooves, Highlight, Plaster};
use common::{COUNT, pairs_f32, uniforms};
use glam::Vec3;

type Model<'a> = &'a dyn Brdf<Color = Vec3>;

struct Inputs {
    pairs: Vec<(Vec3, Vec3)>,
    u: Vec<[f32; 2]>,
    values: Vec<Vec3>,
    densities: Vec<f32>,
    samples: Vec<Sample<f32, Vec3>>,
}

impl Inputs {
    fn new() -> Self {
        let sample = Sample { wi: Vec3::Z, weight: Vec3::ZERO, pdf: 0.0 };
        Self {
            pairs: pairs_f32(),
            u: uniforms().iter().map(|u| u.map(|u| u as f32)).collect(),
            values: vec![Vec3::ZERO; COUNT],
            densities: vec![0.0; COUNT],
            samples: vec![sample; COUNT],
        }
    }

    /// Nanoseconds of a turn, per call: `eval`, `pdf`, `sample`.
    fn turn(&mut self, model: Model<'_>) -> [f64; 3] {
        let model = black_box(model);
        let eval = per_call(|| {
            for (value, (wi, wo)) in self.values.iter_mut().zip(&self.pairs) {
                *value = model.eval(*wi, *wo);
            }
        });
        let pdf = per_call(|| {
            for (density, (wi, wo)) in self.densities.iter_mut().zip(&self.pairs) {
                *density = model.pdf(*wi, *wo);
            }
        });
        let sample = per_call(|| {
            for ((sample, (_, wo)), u) in self.samples.iter_mut().zip(&self.pairs).zip(&self.u) {
                *sample = model.sample(*wo, *u);
            }
        });
        black_box((&self.values, &self.densities, &self.samples));
        [eval, pdf, sample]
    }

    /// Medians of models that take turns.
    fn medians<const N: usize>(&mut self, models: [Model<'_>; N]) -> [[f64; 3]; N] {
        const TURNS: usize = 151;
        let mut times = vec![[[0.0; 3]; N]; TURNS];
        for turn in &mut times {
            *turn = models.map(|model| self.turn(model));
        }
        let median = |model: usize, what: usize| {
            let mut times: Vec<f64> = times.iter().map(|turn| turn[model][what]).collect();
            times.sort_by(f64::total_cmp);
            times[TURNS / 2]
        };
        std::array::from_fn(|model| std::array::from_fn(|what| median(model, what)))
    }
}

fn per_call(mut work: impl FnMut()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64() * 1e9 / COUNT as f64
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut inputs = Inputs::new();
    let gold = || Gold {
        alpha: black_box(0.3),
        eta: black_box(Vec3::new(0.143, 0.374, 1.442)),
        k: black_box(Vec3::new(3.983, 2.386, 1.603)),
    };
    let Gold { alpha, eta, k } = gold();
    let metal = Conductor::new(eta, k)?;
    let f0 = black_box(Vec3::new(1.0, 0.78, 0.34));
    let (exponent, sigma) = black_box((40.0, 0.3));
    let pairs: [(&str, Model<'_>, Model<'_>); 5] = [
        ("GGX, Smith, gold", &GgxGold(gold()), &CookTorrance::new(Ggx::new(alpha)?, metal)),
        (
            "Beckmann, Smith, gold",
            &BeckmannGold(gold()),
            &CookTorrance::new(Beckmann::new(alpha)?, metal),
        ),
        (
            "Beckmann, V-cavity, Schlick",
            &Grooves { m: alpha, f0 },
            &CookTorrance::from_parts(Beckmann::new(alpha)?, Schlick::new(f0)?, VCavity),
        ),
        ("Blinn–Phong", &Highlight { exponent, specular: f0 }, &BlinnPhong::new(f0, exponent)?),
        ("Oren–Nayar", &Plaster { sigma, albedo: f0 }, &OrenNayar::new(f0, sigma)?),
    ];
    println!("ns per call: by hand, crate, ratio\n");
    println!("| | `eval` | | | `pdf` | | | `sample` | | |");
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for (name, by_hand, model) in pairs {
        let [by_hand, model] = inputs.medians([by_hand, model]);
        let cells = [0, 1, 2].map(|what| {
            let (by_hand, model) = (by_hand[what], model[what]);
            format!("{by_hand:.1} | {model:.1} | {:.2} ×", by_hand / model)
        });
        println!("| {name} | {} |", cells.join(" | "));
    }
    println!("\n| every model, as described | `eval` | `pdf` | `sample` |");
    println!("|---|---|---|---|");
    for entry in models::single() {
        let [[eval, pdf, sample]] = inputs.medians([&entry.model]);
        println!("| {} | {eval:.1} | {pdf:.1} | {sample:.1} |", entry.name);
    }
    Ok(())
}
