//! Models over the whole sphere: values, densities and samples, one call after the other through `dyn Bsdf`
//! and in batches; a film beside the exact dielectric, rough glass beside rough metal.

mod common;

use std::hint::black_box;

use brdf::batch::{BsdfSampleBuffer, Directions};
use brdf::polarization::{Complex, Layer};
use brdf::{
    BelcourBarla, Brdf, Bsdf, Conductor, CookTorrance, Dielectric, Fresnel, Ggx, RoughDielectric,
    SmithCorrelated, Stack, TransportMode,
};
use brdf_checks::interfaces;
use common::{COUNT, pairs_f32, uniforms};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::Vec3;

const MODE: TransportMode = TransportMode::Radiance;
const IN_RANGE: &str = "the parameters are in range";
const SAME_LENGTH: &str = "the lengths agree";

/// Pairs of which every second crosses the surface.
fn sphere() -> (Vec<Vec3>, Vec<Vec3>) {
    let turned = |(index, (wi, wo)): (usize, (Vec3, Vec3))| {
        (if index % 2 == 0 { wi } else { Vec3::new(wi.x, wi.y, -wi.z) }, wo)
    };
    pairs_f32().into_iter().enumerate().map(turned).unzip()
}

fn models(criterion: &mut Criterion) {
    let (wi, wo) = sphere();
    let u: Vec<[f32; 3]> =
        (uniforms().iter().zip(&wi)).map(|(u, w)| [u[0] as f32, u[1] as f32, w.x.abs()]).collect();
    let (wi_in, wo_in) = (Directions::from(&wi), Directions::from(&wo));
    let (mut values, mut drawn) = (vec![Vec3::ZERO; COUNT], vec![Vec3::ZERO; COUNT]);
    let (mut pdf, mut specular) = (vec![0.0; COUNT], vec![false; COUNT]);
    for entry in interfaces::single() {
        let mut group = criterion.benchmark_group(format!("f32/{}", entry.row.name));
        group.throughput(Throughput::Elements(COUNT as u64));
        let model = black_box(&entry.model);
        group.bench_function("eval", |bencher| {
            bencher.iter(|| {
                for ((value, wi), wo) in values.iter_mut().zip(&wi).zip(&wo) {
                    *value = model.eval(*wi, *wo, MODE);
                }
                black_box(&mut values);
            });
        });
        group.bench_function("pdf", |bencher| {
            bencher.iter(|| {
                for ((pdf, wi), wo) in pdf.iter_mut().zip(&wi).zip(&wo) {
                    *pdf = model.pdf(*wi, *wo, MODE);
                }
                black_box(&mut pdf);
            });
        });
        group.bench_function("sample", |bencher| {
            bencher.iter(|| {
                for ((wi, u), wo) in drawn.iter_mut().zip(&u).zip(&wo) {
                    *wi = model.sample(*wo, *u, MODE).wi;
                }
                black_box(&mut drawn);
            });
        });
        group.bench_function("eval, batch", |bencher| {
            bencher.iter(|| {
                let values = black_box(&mut values).into();
                model.eval_batch(wi_in, wo_in, MODE, values).expect(SAME_LENGTH);
            });
        });
        group.bench_function("sample, batch", |bencher| {
            bencher.iter(|| {
                let samples = BsdfSampleBuffer {
                    wi: (&mut drawn).into(),
                    weight: (&mut values).into(),
                    pdf: &mut pdf,
                    specular: &mut specular,
                };
                model.sample_batch(wo_in, (&u).into(), MODE, samples).expect(SAME_LENGTH);
            });
        });
        group.finish();
    }
}

/// In RGB, in batches.
fn films(criterion: &mut Criterion) {
    let gray = |n: f32| Complex::new(Vec3::splat(n), Vec3::ZERO);
    let coat = Layer { index: gray(1.38), thickness: 99.6 };
    let lines = Vec3::new(650.0, 550.0, 450.0);
    let stack = Stack::new(gray(1.0), &[coat], gray(1.52), lines).expect(IN_RANGE);
    let fast: BelcourBarla = BelcourBarla::new(1.38, 300.0, [1.52, 0.0], 1.0).expect(IN_RANGE);
    let exact = Dielectric::new(Vec3::new(1.51, 1.52, 1.53)).expect(IN_RANGE);
    let terms: [(&str, &dyn Fresnel<f32, Color = Vec3>); 3] =
        [("dielectric", &exact), ("film", &stack), ("film, Belcour and Barla", &fast)];
    let cosines: Vec<f32> = pairs_f32().iter().map(|(w, _)| w.z).collect();
    let mut values = vec![Vec3::ZERO; COUNT];
    let mut group = criterion.benchmark_group("Fresnel of a film, batch");
    group.throughput(Throughput::Elements(COUNT as u64));
    for (name, term) in terms {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let values = black_box(&mut values).into();
                term.reflectance_batch(&cosines, values).expect(SAME_LENGTH);
            });
        });
    }
    group.finish();
}

/// GGX with Smith's shadowing on gold and on glass.
fn rough(criterion: &mut Criterion) {
    let (eta, k) = (Vec3::new(0.143, 0.374, 1.442), Vec3::new(3.983, 2.386, 1.603));
    let facets = Ggx::new(black_box(0.3_f32)).expect(IN_RANGE);
    let gold = CookTorrance::new(facets, Conductor::new(eta, k).expect(IN_RANGE))
        .with_shadowing(SmithCorrelated);
    let glass = RoughDielectric::new(facets, black_box(1.5)).expect(IN_RANGE);
    let above = pairs_f32();
    let (wi, wo) = sphere();
    let mut values = vec![Vec3::ZERO; COUNT];
    let mut group = criterion.benchmark_group("GGX, rough glass beside rough gold");
    group.throughput(Throughput::Elements(COUNT as u64));
    let (gold_in, glass_in): (&dyn Brdf<Color = Vec3>, &dyn Bsdf<Color = Vec3>) =
        black_box((&gold, &glass));
    group.bench_function("gold", |bencher| {
        bencher.iter(|| {
            for (value, (wi, wo)) in values.iter_mut().zip(&above) {
                *value = gold_in.eval(*wi, *wo);
            }
            black_box(&mut values);
        });
    });
    group.bench_function("glass", |bencher| {
        bencher.iter(|| {
            for ((value, wi), wo) in values.iter_mut().zip(&wi).zip(&wo) {
                *value = glass_in.eval(*wi, *wo, MODE);
            }
            black_box(&mut values);
        });
    });
    let (gold_wi, gold_wo): (Vec<Vec3>, Vec<Vec3>) = above.iter().copied().unzip();
    group.bench_function("gold, batch", |bencher| {
        bencher.iter(|| {
            let values = black_box(&mut values).into();
            gold.eval_batch((&gold_wi).into(), (&gold_wo).into(), values).expect(SAME_LENGTH);
        });
    });
    group.bench_function("glass, batch", |bencher| {
        bencher.iter(|| {
            let values = black_box(&mut values).into();
            glass.eval_batch((&wi).into(), (&wo).into(), MODE, values).expect(SAME_LENGTH);
        });
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(std::time::Duration::from_millis(100))
        .measurement_time(std::time::Duration::from_millis(300));
    targets = films, rough, models
}
criterion_main!(benches);
