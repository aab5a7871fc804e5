//! Every Fresnel term: how much faster than the exact formulas are the approximations?
//!
//! Throughput: a loop over independent cosines. Latency: each cosine depends on the last result.

mod common;

use std::hint::black_box;

use brdf::fresnel::Constant;
use brdf::{Conductor, Cook, Dielectric, Fresnel, Hall, Schlick};
use common::{COUNT, pairs};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};

macro_rules! bench_fresnel {
    ($bench:ident, $all:ident, $float:ident) => {
        fn $bench(
            group: &mut BenchmarkGroup<'_, WallTime>,
            name: &str,
            term: impl Fresnel<$float, Color = $float>,
        ) {
            let cosines: Vec<$float> = pairs().iter().map(|(w, _)| w.z as $float).collect();
            let mut reflectances: Vec<$float> = vec![0.0; COUNT];
            let term = black_box(term);
            group.bench_function(format!("throughput/{name}"), |bencher| {
                bencher.iter(|| {
                    for (reflectance, cosine) in reflectances.iter_mut().zip(&cosines) {
                        *reflectance = term.reflectance(*cosine);
                    }
                    black_box(&mut reflectances);
                });
            });
            group.bench_function(format!("latency/{name}"), |bencher| {
                bencher.iter(|| {
                    let mut chain: $float = 0.0;
                    for cosine in &cosines {
                        chain = term.reflectance(*cosine + chain * 1e-20);
                    }
                    chain
                });
            });
        }

        fn $all(criterion: &mut Criterion) {
            let mut group = criterion.benchmark_group(concat!("fresnel ", stringify!($float)));
            group.throughput(Throughput::Elements(COUNT as u64));
            const IN_RANGE: &str = "the parameter is in range";
            $bench(&mut group, "constant", Constant::new(0.5).expect(IN_RANGE));
            $bench(&mut group, "Schlick", Schlick::new(0.04).expect(IN_RANGE));
            $bench(&mut group, "dielectric", Dielectric::new(1.5).expect(IN_RANGE));
            $bench(&mut group, "conductor", Conductor::new(0.37, 2.39).expect(IN_RANGE));
            $bench(&mut group, "Hall", Hall::new(0.9, 1.5).expect(IN_RANGE));
            $bench(&mut group, "Cook", Cook::new(0.9, 1.0, 1.5).expect(IN_RANGE));
            group.finish();
        }
    };
}
bench_fresnel!(bench_f32, in_f32, f32);
bench_fresnel!(bench_f64, in_f64, f64);

criterion_group!(benches, in_f32, in_f64);
criterion_main!(benches);
