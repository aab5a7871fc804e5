//! Batches: one core, all cores, lanes, and a loop by hand, per model; from a hundred pairs to ten
//! million.

mod common;

use std::cell::Cell;
use std::hint::black_box;

use brdf::batch::{eval_each, parallel};
use brdf::{
    Beckmann, BlinnPhong, Brdf, Conductor, CookTorrance, Dielectric, Ggx, Lanes, Lift, OrenNayar,
    ParameterError, Schlick, VCavity, Vector3,
};
use common::metallic_roughness::MetallicRoughness;
use common::planes::Planes;
use common::{COUNT, by_hand, pairs, uniforms};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use glam::Vec3;

const F0: Vec3 = Vec3::new(1.0, 0.78, 0.34);
const ETA: Vec3 = Vec3::new(0.143, 0.374, 1.442);
const K: Vec3 = Vec3::new(3.983, 2.386, 1.603);
const IN_RANGE: &str = "the parameters are in range";
const SAME_LENGTH: &str = "the lengths agree";

type Wide = Lanes<f32, 16>;

fn model<M>(criterion: &mut Criterion, name: &str, model: &M, by_hand: impl Fn(Vec3, Vec3) -> Vec3)
where
    M: Brdf<f32, Color = Vec3> + Lift<f32>,
    M::Over<Wide>: Brdf<Wide, Color = Vector3<Wide>>,
{
    let mut planes = Planes::new(&pairs(), &uniforms());
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(COUNT as u64));
    group.bench_function("scalar", |bencher| {
        bencher.iter(|| black_box(&mut planes).each(&by_hand));
    });
    group.bench_function("calls", |bencher| {
        bencher.iter(|| black_box(&mut planes).each(|wi, wo| model.eval(wi, wo)));
    });
    let lifted = model.lift(|parameter| Lanes([parameter; 16]));
    let mut values = vec![[Lanes([0.0; 16]); 3]; COUNT / 16];
    let gather = |at: &dyn Fn(usize) -> Vec3, block: usize| {
        let lanes = |axis: usize| Lanes(std::array::from_fn(|lane| at(16 * block + lane)[axis]));
        Vector3 { x: lanes(0), y: lanes(1), z: lanes(2) }
    };
    let blocks: Vec<[Vector3<Wide>; 2]> = (0..COUNT / 16)
        .map(|block| {
            [gather(&|index| planes.wi(index), block), gather(&|index| planes.wo(index), block)]
        })
        .collect();
    group.bench_function("lanes", |bencher| {
        bencher.iter(|| {
            for (value, [wi, wo]) in values.iter_mut().zip(&blocks) {
                let color = lifted.eval(*wi, *wo);
                *value = [color.x, color.y, color.z];
            }
            black_box(&mut values);
        });
    });
    group.bench_function("batch", |bencher| {
        bencher.iter(|| {
            let (wi, wo, values) = black_box(&mut planes).eval();
            model.eval_batch(wi, wo, values).expect(SAME_LENGTH);
        });
    });
    group.bench_function("batch of vectors", |bencher| {
        let vectors = |at: &dyn Fn(usize) -> Vec3| (0..COUNT).map(at).collect::<Vec<Vec3>>();
        let (wi, wo) = (vectors(&|index| planes.wi(index)), vectors(&|index| planes.wo(index)));
        let mut values = vec![Vec3::ZERO; COUNT];
        bencher.iter(|| {
            let (wi, wo) = black_box((&wi, &wo));
            model.eval_batch(wi.into(), wo.into(), (&mut values).into()).expect(SAME_LENGTH);
        });
    });
    group.bench_function("batch on all cores", |bencher| {
        bencher.iter(|| {
            let (wi, wo, values) = black_box(&mut planes).eval();
            parallel::eval(model, wi, wo, values).expect(SAME_LENGTH);
        });
    });
    group.bench_function("pdf, batch", |bencher| {
        bencher.iter(|| {
            let (wi, wo, pdf) = black_box(&mut planes).pdf();
            model.pdf_batch(wi, wo, pdf).expect(SAME_LENGTH);
        });
    });
    group.bench_function("sample, batch", |bencher| {
        bencher.iter(|| {
            let (wo, u, samples) = black_box(&mut planes).sample();
            model.sample_batch(wo, u, samples).expect(SAME_LENGTH);
        });
    });
    group.finish();
}

fn models(criterion: &mut Criterion) {
    let (alpha, f0, eta, k, exponent) = black_box((0.3, F0, ETA, K, 40.0));
    let gold = Conductor::new(eta, k).expect(IN_RANGE);
    let beckmann = Beckmann::new(alpha).expect(IN_RANGE);
    let facets = CookTorrance::from_parts(beckmann, Schlick::new(f0).expect(IN_RANGE), VCavity);
    model(criterion, "Cook–Torrance Beckmann V-cavity Schlick", &facets, |wi, wo| {
        by_hand::cook_torrance(wi, wo, alpha, f0)
    });
    let ggx = CookTorrance::new(Ggx::new(alpha).expect(IN_RANGE), gold);
    model(criterion, "GGX Smith gold", &ggx, |wi, wo| by_hand::ggx(wi, wo, alpha, eta, k));
    let phong = BlinnPhong::new(f0, exponent).expect(IN_RANGE);
    model(criterion, "Blinn–Phong", &phong, |wi, wo| by_hand::blinn_phong(wi, wo, exponent, f0));
    let rough = OrenNayar::new(f0, alpha).expect(IN_RANGE);
    model(criterion, "Oren–Nayar", &rough, |wi, wo| by_hand::oren_nayar(wi, wo, alpha, f0));
}

/// A model of another crate: its batch, and the loop of calls that its author would write.
fn foreign(criterion: &mut Criterion) {
    let (color, roughness) = black_box((F0, 0.5));
    let model = MetallicRoughness::new(color, 0.3, roughness).expect(IN_RANGE);
    let mut planes = Planes::new(&pairs(), &uniforms());
    let mut group = criterion.benchmark_group("a model of another crate");
    group.throughput(Throughput::Elements(COUNT as u64));
    group.bench_function("loop of calls", |bencher| {
        bencher.iter(|| black_box(&mut planes).each(|wi, wo| model.eval(wi, wo)));
    });
    group.bench_function("loop of calls not inlined", |bencher| {
        bencher.iter(|| black_box(&mut planes).each(|wi, wo| call(&model, wi, wo)));
    });
    group.bench_function("batch", |bencher| {
        bencher.iter(|| {
            let (wi, wo, values) = black_box(&mut planes).eval();
            model.eval_batch(wi, wo, values).expect(SAME_LENGTH);
        });
    });
    group.finish();
}

#[inline(never)]
fn call<M: Brdf<Color = Vec3>>(model: &M, wi: Vec3, wo: Vec3) -> Vec3 {
    model.eval(wi, wo)
}

/// A model for each element from textures of roughness and color, made in the loop of calls and by
/// [`eval_each`].
fn each<M: Brdf<Color = Vec3> + Copy>(
    criterion: &mut Criterion,
    name: &str,
    model: impl Fn(f32, Vec3) -> Result<M, ParameterError>,
) {
    let mut planes = Planes::new(&pairs(), &uniforms());
    let uniforms = uniforms();
    let texels: Vec<(f32, Vec3)> =
        uniforms.iter().map(|u| (0.1 + 0.9 * u[0] as f32, F0 * u[1] as f32)).collect();
    let model = |index: usize| {
        let (roughness, color) = texels[index];
        model(roughness, color)
    };
    let mut group = criterion.benchmark_group(format!("a model for each element, {name}"));
    group.throughput(Throughput::Elements(COUNT as u64));
    group.bench_function("loop of calls", |bencher| {
        bencher.iter(|| {
            let next = Cell::new(0);
            black_box(&mut planes).each(|wi, wo| {
                let index = next.replace(next.get() + 1);
                model(index).map_or(Vec3::ZERO, |model| model.eval(wi, wo))
            });
        });
    });
    group.bench_function("eval_each", |bencher| {
        bencher.iter(|| {
            let (wi, wo, values) = black_box(&mut planes).eval();
            eval_each(model, wi, wo, values).expect(SAME_LENGTH);
        });
    });
    group.finish();
}

fn each_model(criterion: &mut Criterion) {
    each(criterion, "GGX Smith Schlick", |alpha, f0| {
        Ok(CookTorrance::new(Ggx::new(alpha)?, Schlick::new(f0)?))
    });
    each(criterion, "Beckmann V-cavity Schlick", |alpha, f0| {
        Ok(CookTorrance::from_parts(Beckmann::new(alpha)?, Schlick::new(f0)?, VCavity))
    });
    each(criterion, "GGX Smith dielectric", |alpha, f0| {
        Ok(CookTorrance::new(Ggx::new(alpha)?, Dielectric::new(f0 + Vec3::ONE)?))
    });
}

/// Time per pair from a hundred to ten million pairs, on one core and on all.
fn scaling(criterion: &mut Criterion) {
    let gold = Conductor::new(ETA, K).expect(IN_RANGE);
    let ggx = CookTorrance::new(Ggx::new(0.3).expect(IN_RANGE), gold);
    let mut group = criterion.benchmark_group("GGX Smith gold, number of pairs");
    group.sample_size(10);
    for power in 2..=7 {
        let count = 10_usize.pow(power);
        let pairs: Vec<_> = pairs().into_iter().cycle().take(count).collect();
        let mut planes = Planes::new(&pairs, &uniforms());
        group.throughput(Throughput::Elements(count as u64));
        group.bench_function(BenchmarkId::new("batch", count), |bencher| {
            bencher.iter(|| {
                let (wi, wo, values) = black_box(&mut planes).eval();
                ggx.eval_batch(wi, wo, values).expect(SAME_LENGTH);
            });
        });
        group.bench_function(BenchmarkId::new("batch on all cores", count), |bencher| {
            bencher.iter(|| {
                let (wi, wo, values) = black_box(&mut planes).eval();
                parallel::eval(&ggx, wi, wo, values).expect(SAME_LENGTH);
            });
        });
    }
    group.finish();
}

criterion_group!(benches, models, foreign, each_model, scaling);
criterion_main!(benches);
