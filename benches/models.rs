//! Every model: evaluations, densities and samples per second, through `dyn Brdf`, in `f32` and
//! `f64`; and a model from a description beside the same one written out.

mod common;

use std::hint::black_box;

use brdf::description::BrdfDescription;
use brdf::{Brdf, Conductor, CookTorrance, Ggx, SmithCorrelated};
use brdf_checks::models;
use common::{COUNT, pairs, pairs_f32, uniforms};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::Vec3;

macro_rules! bench_models {
    ($function:ident, $models:expr, $float:ident, $narrow:expr) => {
        fn $function(criterion: &mut Criterion) {
            let narrow = $narrow;
            let pairs: Vec<_> =
                pairs().into_iter().map(|(wi, wo)| (narrow(wi), narrow(wo))).collect();
            let uniforms: Vec<_> = uniforms().iter().map(|u| u.map(|u| u as $float)).collect();
            for entry in $models {
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
bench_models!(in_f32, models::single(), f32, |w: glam::DVec3| w.as_vec3());
bench_models!(in_f64, models::double(), f64, |w: glam::DVec3| w);

/// A described model beside the same model written out as a type: both behind one dispatch.
fn described(criterion: &mut Criterion) {
    const GOLD: &str = r#"{"cook_torrance": {"distribution": {"ggx": {"roughness": 0.3}},
        "fresnel": {"conductor": {"eta": [0.143, 0.374, 1.442], "k": [3.983, 2.386, 1.603]}},
        "shadowing": "smith"}}"#;
    let conductor = Conductor::new(Vec3::new(0.143, 0.374, 1.442), Vec3::new(3.983, 2.386, 1.603))
        .expect("gold is in range");
    let distribution = Ggx::new(0.3_f32).expect("in range");
    let gold = CookTorrance::new(distribution, conductor).with_shadowing(SmithCorrelated);
    let description: BrdfDescription = serde_json::from_str(GOLD).expect("a description");
    let described = description.build::<f32>().expect("in range");
    let pairs = pairs_f32();
    let mut group = criterion.benchmark_group("f32/GGX on gold, eval");
    group.throughput(Throughput::Elements(COUNT as u64));
    let models: [(&str, &dyn Brdf<Color = Vec3>); 2] =
        [("written", &gold), ("described", &described)];
    for (name, model) in models {
        let model = black_box(model);
        let mut values = vec![Vec3::ZERO; COUNT];
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                for (value, (wi, wo)) in values.iter_mut().zip(&pairs) {
                    *value = model.eval(*wi, *wo);
                }
                black_box(&mut values);
            });
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(std::time::Duration::from_millis(100))
        .measurement_time(std::time::Duration::from_millis(300));
    targets = described, in_f32, in_f64
}
criterion_main!(benches);
