//! Every model: evaluations, densities and samples per second, through `dyn Brdf`, in `f32` and
//! `f64`.

mod common;
#[path = "../tests/common/models/mod.rs"]
#[allow(dead_code, reason = "what the tests need beyond names and models")]
mod models;

use std::hint::black_box;

use common::{COUNT, pairs, uniforms};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

macro_rules! bench_models {
    ($function:ident, $float:ident, $narrow:expr) => {
        fn $function(criterion: &mut Criterion) {
            let narrow = $narrow;
            let pairs: Vec<_> =
                pairs().into_iter().map(|(wi, wo)| (narrow(wi), narrow(wo))).collect();
            let uniforms: Vec<_> = uniforms().iter().map(|u| u.map(|u| u as $float)).collect();
            for entry in models::all::<$float>() {
                let name = format!("{}/{}", stringify!($float), entry.name);
                let mut group = criterion.benchmark_group(name);
                group.throughput(Throughput::Elements(COUNT as u64));
                let model = black_box(&entry.model);
                let mut values = vec![model.eval(pairs[0].0, pairs[0].1); COUNT];
                group.bench_function("eval", |bencher| {
                    bencher.iter(|| {
                        for (value, (wi, wo)) in values.iter_mut().zip(&pairs) {
                            *value = model.eval(*wi, *wo);
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
                let mut samples = vec![model.sample(pairs[0].1, uniforms[0]); COUNT];
                group.bench_function("sample", |bencher| {
                    bencher.iter(|| {
                        for ((sample, (_, wo)), u) in samples.iter_mut().zip(&pairs).zip(&uniforms)
                        {
                            *sample = model.sample(*wo, *u);
                        }
                        black_box(&mut samples);
                    });
                });
                group.finish();
            }
        }
    };
}
bench_models!(in_f32, f32, |w: glam::DVec3| w.as_vec3());
bench_models!(in_f64, f64, |w: glam::DVec3| w);

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(std::time::Duration::from_millis(100))
        .measurement_time(std::time::Duration::from_millis(300));
    targets = in_f32, in_f64
}
criterion_main!(benches);
