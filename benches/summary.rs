//! The summary in `docs/speed.md`: `cargo bench --bench summary`.
//!
//! Nanoseconds per pair of directions, structure of arrays, each the median of five runs of at least
//! 50 ms; all cells of a row within seconds of each other. 4096 pairs stay in the cache; 2²⁰ pairs
//! come from memory and go there.

mod common;

use std::hint::black_box;
use std::time::{Duration, Instant};

use brdf::batch::{InstructionSet, parallel};
use brdf::{
    Beckmann, BlinnPhong, Brdf, Conductor, CookTorrance, Dielectric, Distribution, Fresnel,
    Gaussian, Ggx, OrenNayar, Schlick, SmithCorrelated, VCavity,
};
use common::planes::{DoublePlanes, Planes};
use common::{COUNT, by_hand, pairs, uniforms};
use glam::{DVec3, Vec3};

const ALPHA: f32 = 0.3;
const F0: Vec3 = Vec3::new(1.0, 0.78, 0.34);
/// Gold at 650, 550 and 450 nm.
const ETA: Vec3 = Vec3::new(0.143, 0.374, 1.442);
const K: Vec3 = Vec3::new(3.983, 2.386, 1.603);

/// Pairs that no cache holds.
const MANY: usize = 1 << 20;

const SAME_LENGTH: &str = "the lengths agree";

/// Something done with every pair.
type Work<'a, P> = &'a dyn Fn(&mut P);

/// What is measured of one formula.
struct Row<'a, P> {
    by_hand: Option<Work<'a, P>>,
    calls: Work<'a, P>,
    /// Calls through a pointer that the compiler does not see through, as a renderer makes them.
    single: Option<Work<'a, P>>,
    batch: Work<'a, P>,
    cores: Option<Work<'a, P>>,
}

/// Few pairs and many.
struct Inputs<P> {
    few: P,
    many: P,
}

impl<P> Inputs<P> {
    fn row(&mut self, what: &str, row: &Row<'_, P>) {
        let works = [row.by_hand, Some(row.calls), row.single, Some(row.batch)];
        let [by_hand, calls, single, batch] = times(SHORT, COUNT, &mut self.few, works);
        let [one, cores] = times(LONG, MANY, &mut self.many, [Some(row.batch), row.cores]);
        let cell = |time: Option<f64>| time.map_or("–".to_string(), |time| format!("{time:.2}"));
        let ratio = |of: Option<f64>, to: Option<f64>, digits: usize| {
            of.zip(to).map_or("–".to_string(), |(of, to)| format!("{:.digits$} ×", of / to))
        };
        println!(
            "| {what} | {} | {} | {} | {} | {} | {} | {} | {} |",
            cell(single),
            cell(by_hand),
            cell(calls),
            cell(batch),
            ratio(by_hand, batch, 1),
            cell(one),
            cell(cores),
            ratio(one, cores, 2),
        );
    }
}

/// How often works take turns, and how long a turn lasts at least.
type Turns = (usize, Duration);
const SHORT: Turns = (41, Duration::from_millis(3));
/// Threads sleep while they have nothing to do, and need a moment to wake up.
const LONG: Turns = (9, Duration::from_millis(50));

/// Nanoseconds per element of each work: the median of turns, one after the other, so that what
/// neighbours take from the machine they take from all works alike.
fn times<P, const N: usize>(
    (count_of_turns, length): Turns,
    count: usize,
    input: &mut P,
    works: [Option<Work<'_, P>>; N],
) -> [Option<f64>; N] {
    let mut turn = |work: Work<'_, P>, calls: u32| {
        let start = Instant::now();
        for _ in 0..calls {
            work(black_box(&mut *input));
        }
        start.elapsed()
    };
    let calls = works.map(|work| {
        let mut calls = 1;
        while work.is_some_and(|work| turn(work, calls) < length) {
            calls *= 2;
        }
        calls
    });
    let mut turns = [const { Vec::new() }; N];
    for _ in 0..count_of_turns {
        for ((turns, work), calls) in turns.iter_mut().zip(works).zip(calls) {
            turns.extend(work.map(|work| turn(work, calls) / calls));
        }
    }
    turns.map(|mut turns| {
        turns.sort();
        turns.get(count_of_turns / 2).map(|median| median.as_secs_f64() * 1e9 / count as f64)
    })
}

/// A sample for every pair.
#[inline(always)]
fn draw(planes: &mut Planes, model: &impl Brdf<Color = Vec3>) {
    planes.each(|wi, wo| {
        let sample = model.sample(wo, [wi.x.abs(), wi.y.abs()]);
        sample.wi + sample.weight * sample.pdf
    });
}

impl Inputs<Planes> {
    fn eval(
        &mut self,
        what: &str,
        model: &impl Brdf<f32, Color = Vec3>,
        by_hand: Option<Work<'_, Planes>>,
    ) {
        let row = Row::<Planes> {
            by_hand,
            calls: &|planes| planes.each(|wi, wo| model.eval(wi, wo)),
            single: Some(&|planes| {
                let model: &dyn Brdf<Color = Vec3> = black_box(model);
                planes.each(|wi, wo| model.eval(wi, wo));
            }),
            batch: &|planes| {
                let (wi, wo, values) = planes.eval();
                model.eval_batch(wi, wo, values).expect(SAME_LENGTH);
            },
            cores: Some(&|planes| {
                let (wi, wo, values) = planes.eval();
                parallel::eval(model, wi, wo, values).expect(SAME_LENGTH);
            }),
        };
        self.row(&format!("{what}: `eval`"), &row);
    }

    fn pdf_and_sample(&mut self, what: &str, model: &impl Brdf<f32, Color = Vec3>) {
        let pdf = Row::<Planes> {
            by_hand: None,
            calls: &|planes| planes.each_number(|wi, wo| model.pdf(wi, wo)),
            single: Some(&|planes| {
                let model: &dyn Brdf<Color = Vec3> = black_box(model);
                planes.each_number(|wi, wo| model.pdf(wi, wo));
            }),
            batch: &|planes| {
                let (wi, wo, pdf) = planes.pdf();
                model.pdf_batch(wi, wo, pdf).expect(SAME_LENGTH);
            },
            cores: Some(&|planes| {
                let (wi, wo, pdf) = planes.pdf();
                parallel::pdf(model, wi, wo, pdf).expect(SAME_LENGTH);
            }),
        };
        self.row(&format!("{what}: `pdf`"), &pdf);
        let sample = Row::<Planes> {
            by_hand: None,
            calls: &|planes| draw(planes, model),
            single: Some(&|planes| {
                let model: &dyn Brdf<Color = Vec3> = black_box(model);
                draw(planes, &model);
            }),
            batch: &|planes| {
                let (wo, u, samples) = planes.sample();
                model.sample_batch(wo, u, samples).expect(SAME_LENGTH);
            },
            cores: Some(&|planes| {
                let (wo, u, samples) = planes.sample();
                parallel::sample(model, wo, u, samples).expect(SAME_LENGTH);
            }),
        };
        self.row(&format!("{what}: `sample`"), &sample);
    }

    fn fresnel(
        &mut self,
        what: &str,
        term: &impl Fresnel<f32, Color = f32>,
        by_hand: impl Fn(f32) -> f32,
    ) {
        fn each(planes: &mut Planes, formula: impl Fn(f32) -> f32) {
            let (cosines, values) = planes.cosines();
            for (value, cos) in values.iter_mut().zip(cosines) {
                *value = formula(*cos);
            }
        }
        let row = Row::<Planes> {
            by_hand: Some(&|planes| each(planes, &by_hand)),
            calls: &|planes| each(planes, |cos| term.reflectance(cos)),
            single: Some(&|planes| {
                let term: &dyn Fresnel<f32, Color = f32> = black_box(term);
                each(planes, |cos| term.reflectance(cos));
            }),
            batch: &|planes| {
                let (cosines, values) = planes.cosines();
                term.reflectance_batch(cosines, values.into()).expect(SAME_LENGTH);
            },
            cores: None,
        };
        self.row(what, &row);
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let threads = rayon::current_num_threads();
    println!(
        "{:?}, {threads} threads, ns per pair, RGB `f32` if nothing else is said\n",
        InstructionSet::selected()
    );
    println!(
        "| | single calls | by hand | calls in a loop | batch | by hand/batch | batch of 2²⁰ | on all cores | cores |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let many: Vec<_> = pairs().into_iter().cycle().take(MANY).collect();
    let mut inputs =
        Inputs { few: Planes::new(&pairs(), &uniforms()), many: Planes::new(&many, &uniforms()) };
    let (alpha, f0, eta, k) = black_box((ALPHA, F0, ETA, K));
    let gold = Conductor::new(eta, k)?;

    let beckmann = CookTorrance::from_parts(Beckmann::new(alpha)?, Schlick::new(f0)?, VCavity);
    let name = "Cook–Torrance, Beckmann, V-cavity, Schlick";
    let by_hand: Work<'_, Planes> =
        &|planes| planes.each(|wi, wo| by_hand::cook_torrance(wi, wo, alpha, f0));
    inputs.eval(name, &beckmann, Some(by_hand));
    inputs.pdf_and_sample(name, &beckmann);

    let ggx = CookTorrance::new(Ggx::new(alpha)?, gold).with_shadowing(SmithCorrelated);
    let name = "GGX, Smith, gold";
    let by_hand: Work<'_, Planes> =
        &|planes| planes.each(|wi, wo| by_hand::ggx(wi, wo, alpha, eta, k));
    inputs.eval(name, &ggx, Some(by_hand));
    inputs.pdf_and_sample(name, &ggx);

    let smith = CookTorrance::new(Beckmann::new(alpha)?, gold).with_shadowing(SmithCorrelated);
    let name = "Beckmann, Smith, gold";
    inputs.eval(name, &smith, None);
    inputs.pdf_and_sample(name, &smith);

    let (exponent, sigma) = black_box((40.0, 0.3));
    let phong = BlinnPhong::new(f0, exponent)?;
    let by_hand: Work<'_, Planes> =
        &|planes| planes.each(|wi, wo| by_hand::blinn_phong(wi, wo, exponent, f0));
    inputs.eval("Blinn–Phong", &phong, Some(by_hand));
    let rough = OrenNayar::new(f0, sigma)?;
    let by_hand: Work<'_, Planes> =
        &|planes| planes.each(|wi, wo| by_hand::oren_nayar(wi, wo, sigma, f0));
    inputs.eval("Oren–Nayar", &rough, Some(by_hand));

    let gaussian = Gaussian::new(alpha)?;
    let peak = gaussian.density(Vec3::Z);
    let row = Row::<Planes> {
        by_hand: Some(&|planes| planes.each_number(|h, _| by_hand::gaussian(h, alpha, peak))),
        calls: &|planes| planes.each_number(|h, _| gaussian.density(h)),
        single: Some(&|planes| {
            let distribution: &dyn Distribution = black_box(&gaussian);
            planes.each_number(|h, _| distribution.density(h));
        }),
        batch: &|planes| {
            let (h, _, densities) = planes.pdf();
            gaussian.density_batch(h, densities).expect(SAME_LENGTH);
        },
        cores: None,
    };
    inputs.row("Gaussian D", &row);

    let of_rgb = |cos: f32| {
        Vec3::new(
            by_hand::conductor(eta.x, k.x, cos),
            by_hand::conductor(eta.y, k.y, cos),
            by_hand::conductor(eta.z, k.z, cos),
        )
    };
    let row = Row::<Planes> {
        by_hand: Some(&|planes| planes.each(|w, _| of_rgb(w.z))),
        calls: &|planes| planes.each(|w, _| gold.reflectance(w.z)),
        single: Some(&|planes| {
            let term: &dyn Fresnel<f32, Color = Vec3> = black_box(&gold);
            planes.each(|w, _| term.reflectance(w.z));
        }),
        batch: &|planes| {
            let (cosines, values) = planes.cosines_and_colors();
            gold.reflectance_batch(cosines, values).expect(SAME_LENGTH);
        },
        cores: None,
    };
    inputs.row("exact conductor", &row);
    let (eta, k, ior) = black_box((0.374, 2.386, 1.5));
    let one = Conductor::new(eta, k)?;
    inputs.fresnel("exact conductor, one channel", &one, |cos| by_hand::conductor(eta, k, cos));
    inputs.fresnel("exact dielectric, one channel", &Dielectric::new(ior)?, |cos| {
        by_hand::dielectric(ior, cos)
    });
    let f0 = black_box(0.04);
    inputs.fresnel("Schlick, one channel", &Schlick::new(f0)?, |cos| by_hand::schlick(f0, cos));

    let mut inputs = Inputs {
        few: DoublePlanes::new(&pairs(), &uniforms()),
        many: DoublePlanes::new(&many, &uniforms()),
    };
    let (alpha, f0) = black_box((0.3, DVec3::new(1.0, 0.78, 0.34)));
    let model = CookTorrance::from_parts(Beckmann::new(alpha)?, Schlick::new(f0)?, VCavity);
    let row = Row::<DoublePlanes> {
        by_hand: Some(&|planes| {
            planes.each(|wi, wo| by_hand::cook_torrance_f64(wi, wo, alpha, f0));
        }),
        calls: &|planes| planes.each(|wi, wo| model.eval(wi, wo)),
        single: Some(&|planes| {
            let model: &dyn Brdf<f64, Color = DVec3> = black_box(&model);
            planes.each(|wi, wo| model.eval(wi, wo));
        }),
        batch: &|planes| {
            let (wi, wo, values) = planes.eval();
            model.eval_batch(wi, wo, values).expect(SAME_LENGTH);
        },
        cores: Some(&|planes| {
            let (wi, wo, values) = planes.eval();
            parallel::eval(&model, wi, wo, values).expect(SAME_LENGTH);
        }),
    };
    inputs.row("Cook–Torrance as above, `f64`: `eval`", &row);

    clock();
    Ok(())
}

/// The yardstick of the machine: a chain of dependent multiplications and additions.
fn clock() {
    let chain = |_: &mut ()| {
        let mut x = black_box(1.0_f32);
        for _ in 0..COUNT {
            x = x * 0.999 + 1e-3;
        }
        black_box(x);
    };
    let [step] = times(SHORT, COUNT, &mut (), [Some(&chain)]);
    let step = step.unwrap_or_default();
    println!("\nA dependent multiplication and addition take {step:.2} ns.");
}
