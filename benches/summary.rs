//! The table of the README: `cargo bench --bench summary`.
//!
//! Nanoseconds per pair of directions, median of five runs, each run as long as it takes to be
//! measured well; all cells of a row within seconds of each other. Structure of arrays, 4096 pairs; for all cores 2²⁰.

mod common;

use std::hint::black_box;
use std::time::{Duration, Instant};

use brdf::batch::{InstructionSet, parallel};
use brdf::{
    Beckmann, BlinnPhong, Brdf, Conductor, CookTorrance, Dielectric, Distribution, Fresnel,
    Gaussian, Ggx, OrenNayar, Schlick, SmithCorrelated,
};
use common::planes::{DoublePlanes, Planes};
use common::{COUNT, by_hand, pairs, uniforms};
use glam::{DVec3, Vec3};

const ALPHA: f32 = 0.3;
const F0: Vec3 = Vec3::new(1.0, 0.78, 0.34);
/// Gold at 650, 550 and 450 nm.
const ETA: Vec3 = Vec3::new(0.143, 0.374, 1.442);
const K: Vec3 = Vec3::new(3.983, 2.386, 1.603);

/// Pairs for all cores together: many times what one core does at once.
const MANY: usize = 1 << 20;

/// Nanoseconds per element: the median of five runs of at least 50 ms.
fn time(work: impl FnMut()) -> f64 {
    time_of(COUNT, work)
}

fn time_of(count: usize, mut work: impl FnMut()) -> f64 {
    work();
    let mut rounds = 1_u32;
    let mut run = || loop {
        let start = Instant::now();
        for _ in 0..rounds {
            work();
        }
        let elapsed = start.elapsed();
        if elapsed >= Duration::from_millis(50) {
            break elapsed.as_secs_f64() * 1e9 / f64::from(rounds) / count as f64;
        }
        rounds *= 2;
    };
    let mut runs = [(); 5].map(|()| run());
    runs.sort_by(f64::total_cmp);
    runs[2]
}

fn row(what: &str, by_hand: Option<f64>, calls: f64, batch: f64, cores: Option<f64>) {
    let cell = |time: Option<f64>| time.map_or("–".to_string(), |time| format!("{time:.2}"));
    let ratio = by_hand.map_or("–".to_string(), |by_hand| format!("{:.1} ×", by_hand / batch));
    let (by_hand, cores) = (cell(by_hand), cell(cores));
    println!("| {what} | {by_hand} | {calls:.2} | {batch:.2} | {ratio} | {cores} |");
}

fn eval(
    what: &str,
    planes: &mut Planes,
    model: &impl Brdf<f32, Color = Vec3>,
    by_hand: impl Fn(Vec3, Vec3) -> Vec3,
) {
    let by_hand = time(|| black_box(&mut *planes).each(&by_hand));
    let calls = time(|| black_box(&mut *planes).each(|wi, wo| model.eval(wi, wo)));
    let batch = time(|| {
        let (wi, wo, values) = black_box(&mut *planes).eval();
        model.eval_batch(wi, wo, values).expect("the lengths agree");
    });
    let many: Vec<_> = pairs().into_iter().cycle().take(MANY).collect();
    let mut many = Planes::new(&many, &uniforms());
    let cores = time_of(MANY, || {
        let (wi, wo, values) = black_box(&mut many).eval();
        parallel::eval(model, wi, wo, values).expect("the lengths agree");
    });
    row(&format!("{what}: `eval`"), Some(by_hand), calls, batch, Some(cores));
}

fn pdf_and_sample(what: &str, planes: &mut Planes, model: &impl Brdf<f32, Color = Vec3>) {
    let calls = time(|| black_box(&mut *planes).each_number(|wi, wo| model.pdf(wi, wo)));
    let batch = time(|| {
        let (wi, wo, pdf) = black_box(&mut *planes).pdf();
        model.pdf_batch(wi, wo, pdf).expect("the lengths agree");
    });
    row(&format!("{what}: `pdf`"), None, calls, batch, None);
    let calls = time(|| {
        black_box(&mut *planes).each(|wi, wo| {
            let sample = model.sample(wo, [wi.x.abs(), wi.y.abs()]);
            sample.wi + sample.weight * sample.pdf
        });
    });
    let batch = time(|| {
        let (wo, u, samples) = black_box(&mut *planes).sample();
        model.sample_batch(wo, u, samples).expect("the lengths agree");
    });
    row(&format!("{what}: `sample`"), None, calls, batch, None);
}

fn fresnel(
    what: &str,
    planes: &mut Planes,
    term: &impl Fresnel<f32, Color = f32>,
    by_hand: impl Fn(f32) -> f32,
) {
    let mut each = |formula: &dyn Fn(&mut Planes)| time(|| formula(black_box(&mut *planes)));
    let loop_over = |planes: &mut Planes, formula: &dyn Fn(&[f32], &mut [f32])| {
        let (cosines, values) = planes.cosines();
        formula(cosines, values);
    };
    let by_hand = each(&|planes| {
        loop_over(planes, &|cosines, values| {
            for (value, cos) in values.iter_mut().zip(cosines) {
                *value = by_hand(*cos);
            }
        });
    });
    let calls = each(&|planes| {
        loop_over(planes, &|cosines, values| {
            for (value, cos) in values.iter_mut().zip(cosines) {
                *value = term.reflectance(*cos);
            }
        });
    });
    let batch = each(&|planes| {
        loop_over(planes, &|cosines, values| {
            term.reflectance_batch(cosines, values.into()).expect("the lengths agree");
        });
    });
    row(what, Some(by_hand), calls, batch, None);
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let threads = rayon::current_num_threads();
    println!("{:?}, {threads} threads\n", InstructionSet::selected());
    println!("| ns per pair, RGB `f32` | by hand | calls | batch | by hand/batch | all cores |");
    println!("|---|---|---|---|---|---|");
    let planes = &mut Planes::new(&pairs(), &uniforms());
    let (alpha, f0, eta, k) = black_box((ALPHA, F0, ETA, K));
    let gold = Conductor::new(eta, k)?;

    let beckmann = CookTorrance::new(Beckmann::new(alpha)?, Schlick::new(f0)?);
    let name = "Cook–Torrance, Beckmann, V-cavity, Schlick";
    eval(name, planes, &beckmann, |wi, wo| by_hand::cook_torrance(wi, wo, alpha, f0));
    pdf_and_sample(name, planes, &beckmann);

    let ggx = CookTorrance::new(Ggx::new(alpha)?, gold).with_shadowing(SmithCorrelated);
    let name = "GGX, Smith, gold";
    eval(name, planes, &ggx, |wi, wo| by_hand::ggx(wi, wo, alpha, eta, k));
    pdf_and_sample(name, planes, &ggx);

    let smith = CookTorrance::new(Beckmann::new(alpha)?, gold).with_shadowing(SmithCorrelated);
    let name = "Beckmann, Smith, gold";
    let calls = time(|| black_box(&mut *planes).each(|wi, wo| smith.eval(wi, wo)));
    let batch = time(|| {
        let (wi, wo, values) = black_box(&mut *planes).eval();
        smith.eval_batch(wi, wo, values).expect("the lengths agree");
    });
    row(&format!("{name}: `eval`"), None, calls, batch, None);
    pdf_and_sample(name, planes, &smith);

    let exponent = black_box(40.0);
    let phong = BlinnPhong::new(f0, exponent)?;
    eval("Blinn–Phong", planes, &phong, |wi, wo| by_hand::blinn_phong(wi, wo, exponent, f0));
    let sigma = black_box(0.3);
    let rough = OrenNayar::new(f0, sigma)?;
    eval("Oren–Nayar", planes, &rough, |wi, wo| by_hand::oren_nayar(wi, wo, sigma, f0));

    let gaussian = Gaussian::new(alpha)?;
    let peak = gaussian.density(Vec3::Z);
    let hand = time(|| {
        black_box(&mut *planes).each_number(|h, _| by_hand::gaussian(h, alpha, peak));
    });
    let calls = time(|| black_box(&mut *planes).each_number(|h, _| gaussian.density(h)));
    let batch = time(|| {
        let (h, _, densities) = black_box(&mut *planes).pdf();
        gaussian.density_batch(h, densities).expect("the lengths agree");
    });
    row("Gaussian D", Some(hand), calls, batch, None);

    let of_rgb = |cos: f32| {
        Vec3::new(
            by_hand::conductor(eta.x, k.x, cos),
            by_hand::conductor(eta.y, k.y, cos),
            by_hand::conductor(eta.z, k.z, cos),
        )
    };
    let hand = time(|| black_box(&mut *planes).each(|w, _| of_rgb(w.z)));
    let calls = time(|| black_box(&mut *planes).each(|w, _| gold.reflectance(w.z)));
    let cosines: Vec<f32> = (0..COUNT).map(|index| planes.wi(index).z).collect();
    let batch = time(|| {
        let (_, _, values) = black_box(&mut *planes).eval();
        gold.reflectance_batch(&cosines, values).expect("the lengths agree");
    });
    row("exact conductor, RGB", Some(hand), calls, batch, None);
    let (eta, k, ior) = black_box((0.374, 2.386, 1.5));
    let term = Conductor::new(eta, k)?;
    fresnel("exact conductor, one channel", planes, &term, |cos| by_hand::conductor(eta, k, cos));
    let term = Dielectric::new(ior)?;
    fresnel("exact dielectric", planes, &term, |cos| by_hand::dielectric(ior, cos));
    let f0 = black_box(0.04);
    fresnel("Schlick", planes, &Schlick::new(f0)?, |cos| by_hand::schlick(f0, cos));

    let planes = &mut DoublePlanes::new(&pairs(), &uniforms());
    let (alpha, f0) = black_box((0.3, DVec3::new(1.0, 0.78, 0.34)));
    let model = CookTorrance::new(Beckmann::new(alpha)?, Schlick::new(f0)?);
    let hand = time(|| {
        black_box(&mut *planes).each(|wi, wo| by_hand::cook_torrance_f64(wi, wo, alpha, f0));
    });
    let calls = time(|| black_box(&mut *planes).each(|wi, wo| model.eval(wi, wo)));
    let batch = time(|| {
        let (wi, wo, values) = black_box(&mut *planes).eval();
        model.eval_batch(wi, wo, values).expect("the lengths agree");
    });
    row("Cook–Torrance as above, `f64`: `eval`", Some(hand), calls, batch, None);

    clock();
    Ok(())
}

/// The yardstick of the machine: a chain of dependent multiply-adds.
fn clock() {
    let step = time(|| {
        let mut x = black_box(1.0_f32);
        for _ in 0..COUNT {
            x = x * 0.999 + 1e-3;
        }
        black_box(x);
    });
    println!("\nA dependent multiply and add takes {step:.2} ns.");
}
