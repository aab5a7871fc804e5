//! Samples of a model from one direction, counted and held against what the model says of them.

use brdf::{Brdf, Color, Real, Vector};
use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::chart::Chart;
use super::partition::Partition;

/// What was drawn.
pub struct Draws {
    pub count: u32,
    /// In each cell, and last those that gave no direction.
    pub counts: Vec<u32>,
    /// Mean of the weights.
    pub mean: DVec3,
    /// The largest weight of a channel.
    pub largest: f64,
    /// Largest difference of a sample's pdf from `pdf`, and of its weight times `pdf` from `eval`
    /// times the cosine, relative to the larger one, in units of the precision's epsilon.
    pub pdf_ulps: f64,
    pub weight_ulps: f64,
}

/// Draws from `wo` in the precision of the model, with uniform numbers of 53 bits that `below`
/// rounds down to it.
///
/// In single precision a generator in steps of 2⁻²⁴ would answer 0 itself once in 1.7·10⁷ times,
/// where the number stands for all below 2⁻²⁴. But 0 is the very end of a tail: Beckmann's visible
/// slopes end at −9.2 there, with density exp(−85). In 10⁶ draws such a direction turns up with a
/// chance of 6 %, in a cell that expects nothing. It would say something of the generator and
/// nothing of the sampler, which rounded numbers of full length ask for all of its tail.
pub fn draw<T: Real + Into<f64>>(
    model: &dyn Brdf<T, Color = T::Vec3>,
    wo: T::Vec3,
    below: impl Fn(f64) -> T,
    (chart, cells): (&Chart, &Partition),
    seed: u64,
    count: u32,
) -> Draws
where
    T::Vec3: Color<T>,
{
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let failed = cells.cells().len();
    let mut draws = Draws {
        count,
        counts: vec![0; failed + 1],
        mean: DVec3::ZERO,
        largest: 0.0,
        pdf_ulps: 0.0,
        weight_ulps: 0.0,
    };
    let epsilon = epsilon::<T>();
    let ulps =
        |a: f64, b: f64| (a - b).abs() / (a.abs().max(b.abs()).max(f64::MIN_POSITIVE) * epsilon);
    for _ in 0..count {
        let u: [f64; 2] = [rng.random(), rng.random()];
        let sample = model.sample(wo, u.map(&below));
        let (weight, pdf): (DVec3, f64) = (wide::<T>(sample.weight), sample.pdf.into());
        draws.mean += weight;
        draws.largest = draws.largest.max(weight.max_element());
        if pdf == 0.0 {
            draws.counts[failed] += 1;
            continue;
        }
        let wi = wide::<T>(sample.wi);
        draws.counts[cells.locate(chart.place(wi))] += 1;
        let own: f64 = model.pdf(sample.wi, wo).into();
        draws.pdf_ulps = draws.pdf_ulps.max(ulps(pdf, own));
        let value = wide::<T>(model.eval(sample.wi, wo)) * wi.z;
        for channel in 0..3 {
            let difference = ulps(weight[channel] * own, value[channel]);
            draws.weight_ulps = draws.weight_ulps.max(difference);
        }
    }
    draws.mean /= f64::from(count);
    draws
}

/// The largest number of single precision that is not larger.
#[allow(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
pub fn single_below(u: f64) -> f32 {
    let nearest = u as f32;
    if f64::from(nearest) > u { nearest.next_down() } else { nearest }
}

fn wide<T: Real + Into<f64>>(vector: T::Vec3) -> DVec3 {
    DVec3::new(vector.x().into(), vector.y().into(), vector.z().into())
}

/// The distance of 1 from the next number.
pub fn epsilon<T: Real + Into<f64>>() -> f64 {
    let one = T::lit(1.0);
    let mut epsilon = 1.0;
    while (one + T::lit(0.5 * epsilon)).into() > 1.0 {
        epsilon *= 0.5;
    }
    epsilon
}
