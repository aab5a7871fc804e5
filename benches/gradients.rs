//! What gradients cost: a value over duals with 1, 4 and 8 derivatives beside the plain value in
//! `f64`. The ratios stand in `docs/numbers.md`.

mod common;

use std::hint::black_box;

use brdf::{Beckmann, Brdf, Conductor, CookTorrance, Dual, Ggx, OrenNayar, Real, SmithCorrelated};
use common::{COUNT, pairs, uniforms};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use glam::DVec3;

/// A model of numbers of any kind.
trait Built {
    const NAME: &'static str;

    fn build<T: Real>(numbers: impl Fn(usize, f64) -> T) -> impl Brdf<T, Color = T>;
}

struct Gold;
struct RoughGold;
struct Plaster;

const VALID: &str = "the parameters are in their ranges";

impl Built for Gold {
    const NAME: &'static str = "GGX, Smith, conductor";

    fn build<T: Real>(number: impl Fn(usize, f64) -> T) -> impl Brdf<T, Color = T> {
        let conductor = Conductor::new(number(1, 0.143), number(2, 3.983)).expect(VALID);
        CookTorrance::new(Ggx::new(number(0, 0.3)).expect(VALID), conductor)
            .with_shadowing(SmithCorrelated)
    }
}

impl Built for RoughGold {
    const NAME: &'static str = "Beckmann, V-cavity, conductor";

    fn build<T: Real>(number: impl Fn(usize, f64) -> T) -> impl Brdf<T, Color = T> {
        let conductor = Conductor::new(number(1, 0.143), number(2, 3.983)).expect(VALID);
        CookTorrance::new(Beckmann::new(number(0, 0.3)).expect(VALID), conductor)
    }
}

impl Built for Plaster {
    const NAME: &'static str = "Oren-Nayar";

    fn build<T: Real>(number: impl Fn(usize, f64) -> T) -> impl Brdf<T, Color = T> {
        OrenNayar::new(number(0, 0.8), number(1, 0.3)).expect(VALID)
    }
}

fn over<T: Real, M: Built>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    number: impl Fn(usize, f64) -> T,
    vector: impl Fn(DVec3) -> T::Vec3,
) {
    let model = black_box(M::build(number));
    let pairs: Vec<_> = pairs().into_iter().map(|(wi, wo)| (vector(wi), vector(wo))).collect();
    let uniforms: Vec<_> = uniforms().into_iter().map(|u| u.map(T::lit)).collect();
    let mut values = vec![T::zero(); COUNT];
    group.bench_function(format!("eval/{name}"), |bencher| {
        bencher.iter(|| {
            for (value, (wi, wo)) in values.iter_mut().zip(&pairs) {
                *value = model.eval(*wi, *wo);
            }
            black_box(&mut values);
        });
    });
    group.bench_function(format!("sample/{name}"), |bencher| {
        bencher.iter(|| {
            for ((value, (_, wo)), u) in values.iter_mut().zip(&pairs).zip(&uniforms) {
                *value = model.sample(*wo, *u).pdf;
            }
            black_box(&mut values);
        });
    });
}

fn duals<M: Built, const N: usize>(group: &mut BenchmarkGroup<'_, WallTime>) {
    let number = |place, value| Dual::<f64, N>::variable(value, place);
    over::<_, M>(group, &format!("{N} derivatives"), number, Dual::vector);
}

fn gradients<M: Built>(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group(M::NAME);
    group.throughput(Throughput::Elements(COUNT as u64));
    over::<f64, M>(&mut group, "f64", |_, value| value, |w| w);
    duals::<M, 1>(&mut group);
    duals::<M, 4>(&mut group);
    duals::<M, 8>(&mut group);
    group.finish();
}

fn all(criterion: &mut Criterion) {
    gradients::<Gold>(criterion);
    gradients::<RoughGold>(criterion);
    gradients::<Plaster>(criterion);
}

criterion_group!(benches, all);
criterion_main!(benches);
