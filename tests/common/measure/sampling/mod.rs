//! What the samples of a model from one direction do: whether they follow the density, whether
//! the density leaves nothing out, whether weights are what they say.

mod chart;
pub mod chi_squared;
mod cubature;
mod draws;
mod failure;
mod lines;
mod partition;
mod rule;
pub mod viewers;

use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{Model32, Model64, hemisphere};
use chart::Chart;
use chi_squared::{Verdict, compare};
use cubature::{Cubature, integrate};
use draws::{Draws, draw, epsilon};
use partition::Partition;

/// How much is drawn and integrated.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    /// Draws that decide the cells.
    pub pilot: u32,
    /// Draws that are counted, in each precision.
    pub draws: u32,
    /// The error of ∫ pdf, as a whole and over the cells together, and of the probability of
    /// failure that is asked for; ten times as much is allowed to the albedo. Estimates of errors are larger than errors, often by far.
    pub tolerance: f64,
    /// The most points at which an integral may take its functions.
    pub budget: u32,
}

/// A model seen from one direction.
#[derive(Debug)]
pub struct Sampling {
    /// Cells of the chart in which draws are counted.
    pub cells: usize,
    /// ∫ pdf dω.
    pub mass: Integral,
    /// The probability that a draw gives no direction, by quadrature over the uniform numbers.
    pub failure: Integral,
    /// ∫ f cosθ dω per channel.
    pub albedo: DVec3,
    /// What the model's own `albedo` says.
    pub own_albedo: DVec3,
    pub double: Samples,
    pub single: Samples,
}

impl Sampling {
    /// ∫ pdf dω + P(no direction) − 1.
    pub fn excess(&self) -> f64 {
        self.mass.value + self.failure.value - 1.0
    }
}

/// The value of an integral and the estimate of its error.
#[derive(Clone, Copy, Debug)]
pub struct Integral {
    pub value: f64,
    pub error: f64,
}

/// Samples in one precision.
#[derive(Debug)]
pub struct Samples {
    /// Draws that gave no direction.
    pub failures: u32,
    /// Counts in the cells, failures being one more, against ∫ pdf in double precision.
    pub verdict: Verdict,
    /// See [`Draws`].
    pub pdf_ulps: f64,
    pub weight_ulps: f64,
    /// Largest distance of the mean weight from ∫ f cosθ dω, over channels, in standard errors.
    pub albedo_z: f64,
}

/// Measures a model, given in both precisions, from `wo`.
///
/// The cells, and what is expected in them, are the same for both precisions: the rounding of a
/// direction in single precision, 6·10⁻⁸, is far below the width of a cell even of a lobe of
/// roughness 10⁻³.
pub fn measure(double: &Model64, single: &Model32, wo: DVec3, seed: u64, size: Size) -> Sampling {
    let chart = Chart::new(wo);
    let cells = cells(double, wo, &chart, seed ^ 0x9e37_79b9_7f4a_7c15, size.pilot);
    let room = (&chart, &cells);
    let draws = draw::<f64>(double, wo, room, seed, size.draws);
    let single_draws = draw::<f32>(single, wo.as_vec3(), room, seed, size.draws);
    let failure = failure::probability(double, wo, size.tolerance, size.budget);
    let density = integrals(double, wo, &chart, &cells, size);

    let [_, moments @ ..] = density.total();
    let [first, second] = [([0, 1, 2], FIRST), ([3, 4, 5], SECOND)]
        .map(|(channels, scale)| DVec3::from(channels.map(|channel| moments[channel] / scale)));
    let probabilities = density.integrals.iter().map(|cell| cell[0]).chain([failure.value]);
    let expected = Expected {
        probabilities: probabilities.collect(),
        albedo: first,
        variance: (second - first * first).max(DVec3::ZERO),
        tolerance: size.tolerance / FIRST,
    };
    // The cells of the counts follow the draws, not the shape of the density: the integral of all
    // has cells of its own.
    let mass = hemisphere::integrate(
        wo,
        &hemisphere::cells(double, wo),
        |wi| DVec3::splat(double.pdf(wi, wo)),
        |_, error| error < size.tolerance,
    );
    Sampling {
        cells: cells.cells().len(),
        mass: Integral { value: mass.value.x, error: mass.error },
        failure,
        albedo: first,
        own_albedo: double.albedo(wo),
        double: expected.compare(&draws, epsilon::<f64>()),
        single: expected.compare(&single_draws, epsilon::<f32>()),
    }
}

/// About 256 cells of the chart with about as many draws in each.
fn cells(model: &Model64, wo: DVec3, chart: &Chart, seed: u64, count: u32) -> Partition {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let samples = (0..count).map(|_| model.sample(wo, [rng.random(), rng.random()]));
    let places: Vec<[f64; 2]> =
        samples.filter(|sample| sample.pdf > 0.0).map(|sample| chart.place(sample.wi)).collect();
    // Steps in both coordinates are compared by their lengths at the mean height.
    let mean = places.iter().map(|place| place[0]).sum::<f64>() / places.len().max(1) as f64;
    let most = places.len() / 192;
    let s = mean * (2.0 - mean);
    let root = (2.0 - s * s).sqrt();
    let lengths = [4.0 * (1.0 - mean) / root, s * root];
    Partition::grow(Chart::WHOLE, places, most, lengths)
}

/// What errors of the first and the second moment of the weights count for.
const FIRST: f64 = 0.1;
const SECOND: f64 = 1e-3;

/// Over each cell, pdf and, less precisely, f cosθ and (f cosθ)²/pdf, the moments of the weights.
fn integrals(
    model: &Model64,
    wo: DVec3,
    chart: &Chart,
    cells: &Partition,
    size: Size,
) -> Cubature<7> {
    integrate(cells, size.tolerance, size.budget, |place| {
        let (wi, area) = chart.direction(place);
        let pdf = model.pdf(wi, wo);
        let value = model.eval(wi, wo) * wi.z;
        let first = value * FIRST;
        let second = if pdf > 0.0 { value * (value / pdf) * SECOND } else { DVec3::ZERO };
        ([pdf, first.x, first.y, first.z, second.x, second.y, second.z], area)
    })
}

/// What draws are held against.
struct Expected {
    /// Of each cell, and of no direction.
    probabilities: Vec<f64>,
    /// Mean and variance of the weights.
    albedo: DVec3,
    variance: DVec3,
    /// The error of the albedo.
    tolerance: f64,
}

impl Expected {
    fn compare(&self, draws: &Draws, epsilon: f64) -> Samples {
        let number = f64::from(draws.count);
        let expectations: Vec<f64> =
            self.probabilities.iter().map(|probability| probability * number).collect();
        // The standard error. By Bernstein's inequality four of them do not hold weights together
        // that are rare and large: those add a third of the logarithm of the probability, 9.7,
        // times the largest over the number. The rest is the rounding of the weights and the
        // error of the integral.
        let deviation = DVec3::from(self.variance.to_array().map(|v| (v / number).sqrt()))
            + DVec3::splat(0.8 * draws.largest / number)
            + self.albedo * (4.0 * epsilon)
            + DVec3::splat(0.25 * self.tolerance);
        Samples {
            failures: draws.counts.last().copied().unwrap_or(0),
            verdict: compare(&draws.counts, &expectations),
            pdf_ulps: draws.pdf_ulps,
            weight_ulps: draws.weight_ulps,
            albedo_z: ((draws.mean - self.albedo).abs() / deviation).max_element(),
        }
    }
}
