//! What the samples of a model from one direction do: whether they follow the density, whether
//! the density leaves nothing out, whether weights are what they say.

mod chart;
pub mod chi_squared;
mod cubature;
pub mod draws;
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
use draws::{Draws, draw, epsilon, single_below};
use partition::Partition;

/// How much is drawn and integrated.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    /// Draws that decide the cells.
    pub pilot: u32,
    /// Draws that are counted, in each precision.
    pub draws: u32,
    /// The error that is asked for: of ∫ pdf, as a whole and over the cells together, of the
    /// probability of failure and of the albedo. Estimates of errors are larger than errors, often
    /// by far, where functions are smooth.
    pub tolerance: f64,
    /// The most points at which an integral may take its functions.
    pub budget: u32,
}

/// A model seen from one direction.
#[derive(Debug)]
pub struct Sampling {
    /// Cells of the chart in which draws are counted.
    pub cells: usize,
    /// The sum of what is expected in them of one draw; another cubature of ∫ pdf dω.
    pub expected: f64,
    /// ∫ pdf dω.
    pub mass: Integral,
    /// The probability that a draw gives no direction, by quadrature over the uniform numbers.
    pub failure: Integral,
    /// ∫ f cosθ dω per channel.
    pub albedo: hemisphere::Integral,
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

/// The largest |∫ pdf dω + P(no direction) − 1|. See the test for what misses by how much.
pub const EXCESS: f64 = 2e-6;

/// The largest error of a weight, in units in the last place. Weight · pdf and eval · cosθ are the
/// same product of numbers that are computed once or alike; what differs are roundings, each of
/// half a unit at most. The most have the models of 1977: 6 in the value (N·H times the smaller
/// cosine, times the larger, the quotient, D, F, the constant), 2 in the density (the quotient, D),
/// 6 in the weight (N·L/N·V, N·H times a cosine, the quotient, the product, F, the constant). Two
/// more are those of the comparison, in double precision: 16 halves.
pub const WEIGHT_ULPS: f64 = 8.0;

/// The largest distance of a mean weight, in standard errors.
pub const ALBEDO_Z: f64 = 4.0;

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
    let draws = draw(double, wo, |u| u, room, seed, size.draws);
    let single_seed = seed ^ 0xd1b5_4a32_d192_ed03;
    let single_draws = draw(single, wo.as_vec3(), single_below, room, single_seed, size.draws);
    let failure = failure::probability(double, wo, size.tolerance, size.budget);
    // The cells of the counts follow the draws, not the shapes of density and value: the integrals
    // of all have cells of their own.
    let own_cells = hemisphere::cells(double, wo);
    let whole = |formula: &dyn Fn(DVec3) -> DVec3| {
        hemisphere::integrate(wo, &own_cells, formula, |_, error| error < size.tolerance)
    };
    let mass = whole(&|wi| DVec3::splat(double.pdf(wi, wo)));
    let density = integrals(double, wo, &chart, &cells, size, mass.value.x);
    let albedo = whole(&|wi| double.eval(wi, wo) * wi.z);

    let [expected, squares @ ..] = density.total();
    let of_cells = density.integrals.iter().map(|cell| cell[0]).zip(density.errors);
    let references = References {
        probabilities: of_cells.chain([(failure.value, failure.error)]).collect(),
        albedo: albedo.value,
        variance: (DVec3::from(squares) / SECOND - albedo.value * albedo.value).max(DVec3::ZERO),
        tolerance: albedo.error,
    };
    Sampling {
        cells: cells.cells().len(),
        expected,
        mass: Integral { value: mass.value.x, error: mass.error },
        failure,
        albedo,
        own_albedo: double.albedo(wo),
        double: references.compare(&draws, epsilon::<f64>()),
        single: references.compare(&single_draws, epsilon::<f32>()),
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

/// What an error of the second moment of the weights counts for.
const SECOND: f64 = 1e-3;

/// Over each cell, pdf and, less precisely, (f cosθ)²/pdf, the second moment of the weights. `mass` is the integral
/// of the pdf over all.
fn integrals(
    model: &Model64,
    wo: DVec3,
    chart: &Chart,
    cells: &Partition,
    size: Size,
    mass: f64,
) -> Cubature<4> {
    let of_pieces = |pieces: u32| {
        integrate(cells, pieces, size.tolerance, size.budget * pieces * pieces, |place| {
            let (wi, area) = chart.direction(place);
            let pdf = model.pdf(wi, wo);
            let value = model.eval(wi, wo) * wi.z;
            let square = if pdf > 0.0 { value * (value / pdf) * SECOND } else { DVec3::ZERO };
            ([pdf, square.x, square.y, square.z], area)
        })
    };
    // A ridge that no node of a cell meets is not seen: the integral of all, which has other cells, tells.
    let sees_all = |seen: &Cubature<4>| (seen.total()[0] - mass).abs() <= SEEN;
    let first = of_pieces(1);
    if sees_all(&first) { first } else { of_pieces(PIECES) }
}

/// How far the sum over cells may be from the integral of all, which is 20 of a million draws.
const SEEN: f64 = 2e-5;
/// In how many parts along either axis a cell begins if it is farther.
const PIECES: u32 = 8;

/// What draws are held against.
struct References {
    /// Of each cell, and of no direction, with their errors.
    probabilities: Vec<(f64, f64)>,
    /// Mean and variance of the weights.
    albedo: DVec3,
    variance: DVec3,
    /// The error of the albedo.
    tolerance: f64,
}

impl References {
    fn compare(&self, draws: &Draws, epsilon: f64) -> Samples {
        let number = f64::from(draws.count);
        let expectations: Vec<(f64, f64)> =
            self.probabilities.iter().map(|&(p, error)| (p * number, error * number)).collect();
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
