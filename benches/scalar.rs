//! One call per pair of directions, an array of pairs in, results stored: the crate against the
//! same formulas written by hand with the standard library's floats.

mod common;

use std::hint::black_box;

use brdf::{Beckmann, Brdf, Conductor, CookTorrance, Ggx, Schlick, SmithCorrelated, VCavity};
use common::{COUNT, by_hand, pairs, pairs_f32};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::{DVec3, Vec3};

const ALPHA: f32 = 0.3;
const F0: Vec3 = Vec3::new(1.0, 0.78, 0.34);
/// Gold at 650, 550 and 450 nm.
const ETA: Vec3 = Vec3::new(0.143, 0.374, 1.442);
const K: Vec3 = Vec3::new(3.983, 2.386, 1.603);

/// A call that the compiler can neither inline nor turn into SIMD code.
#[inline(never)]
fn call<A, B>(function: impl Fn(A, A) -> B, wi: A, wo: A) -> B {
    function(wi, wo)
}

fn cook_torrance(criterion: &mut Criterion) {
    let pairs = pairs_f32();
    let mut values = vec![Vec3::ZERO; COUNT];
    let mut group = criterion.benchmark_group("Cook–Torrance Beckmann V-cavity Schlick RGB f32");
    group.throughput(Throughput::Elements(COUNT as u64));
    let (m, f0) = black_box((ALPHA, F0));
    group.bench_function("by hand", |bencher| {
        bencher.iter(|| {
            for (value, (wi, wo)) in values.iter_mut().zip(&pairs) {
                *value = by_hand::cook_torrance(*wi, *wo, m, f0);
            }
            black_box(&mut values);
        });
    });
    let model = CookTorrance::from_parts(
        Beckmann::new(m).expect("the roughness is in range"),
        Schlick::new(f0).expect("the reflectance is in range"),
        VCavity,
    );
    group.bench_function("crate", |bencher| {
        bencher.iter(|| {
            for (value, (wi, wo)) in values.iter_mut().zip(&pairs) {
                *value = model.eval(*wi, *wo);
            }
            black_box(&mut values);
        });
    });
    group.bench_function("by hand, opaque calls", |bencher| {
        bencher.iter(|| {
            for (value, (wi, wo)) in values.iter_mut().zip(&pairs) {
                *value = call(|wi, wo| by_hand::cook_torrance(wi, wo, m, f0), *wi, *wo);
            }
            black_box(&mut values);
        });
    });
    group.bench_function("crate, opaque calls", |bencher| {
        bencher.iter(|| {
            for (value, (wi, wo)) in values.iter_mut().zip(&pairs) {
                *value = call(|wi, wo| model.eval(wi, wo), *wi, *wo);
            }
            black_box(&mut values);
        });
    });
    group.finish();
}

macro_rules! ggx_gold {
    ($function:ident, $name:literal, $pairs:expr, $alpha:expr, $eta:expr, $k:expr) => {
        fn $function(criterion: &mut Criterion) {
            let pairs = $pairs;
            let mut group = criterion.benchmark_group($name);
            group.throughput(Throughput::Elements(COUNT as u64));
            let (alpha, eta, k) = black_box(($alpha, $eta, $k));
            let model = CookTorrance::new(
                Ggx::new(alpha).expect("the roughness is in range"),
                Conductor::new(eta, k).expect("the index is in range"),
            )
            .with_shadowing(SmithCorrelated);
            let mut values = vec![model.eval(pairs[0].0, pairs[0].1); COUNT];
            group.bench_function("eval", |bencher| {
                bencher.iter(|| {
                    for (value, (wi, wo)) in values.iter_mut().zip(&pairs) {
                        *value = model.eval(*wi, *wo);
                    }
                    black_box(&mut values);
                });
            });
            group.bench_function("eval, opaque calls", |bencher| {
                bencher.iter(|| {
                    for (value, (wi, wo)) in values.iter_mut().zip(&pairs) {
                        *value = call(|wi, wo| model.eval(wi, wo), *wi, *wo);
                    }
                    black_box(&mut values);
                });
            });
            let mut densities = vec![0.0; COUNT];
            group.bench_function("pdf", |bencher| {
                bencher.iter(|| {
                    for (density, (wi, wo)) in densities.iter_mut().zip(&pairs) {
                        *density = model.pdf(*wi, *wo);
                    }
                    black_box(&mut densities);
                });
            });
            let mut samples = vec![model.sample(pairs[0].0, [0.5, 0.5]); COUNT];
            group.bench_function("sample", |bencher| {
                bencher.iter(|| {
                    for (sample, (wi, wo)) in samples.iter_mut().zip(&pairs) {
                        *sample = model.sample(*wo, [wi.x.abs(), wi.y.abs()]);
                    }
                    black_box(&mut samples);
                });
            });
            group.finish();
        }
    };
}
ggx_gold!(ggx_gold_f32, "GGX Smith gold RGB f32", pairs_f32(), ALPHA, ETA, K);
ggx_gold!(
    ggx_gold_f64,
    "GGX Smith gold RGB f64",
    pairs(),
    f64::from(ALPHA),
    DVec3::new(0.143, 0.374, 1.442),
    DVec3::new(3.983, 2.386, 1.603)
);

/// The yardstick of the machine: a chain of dependent multiply-adds, so that figures taken at
/// different clock speeds can be compared.
fn clock(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("clock");
    group.throughput(Throughput::Elements(COUNT as u64));
    group.bench_function("dependent multiply and add", |bencher| {
        bencher.iter(|| {
            let mut x = black_box(1.0_f32);
            for _ in 0..COUNT {
                x = x * 0.999 + 1e-3;
            }
            x
        });
    });
    group.finish();
}

criterion_group!(benches, clock, cook_torrance, ggx_gold_f32, ggx_gold_f64);
criterion_main!(benches);
