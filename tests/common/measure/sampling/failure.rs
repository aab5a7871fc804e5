//! The probability that a draw gives no direction.

use glam::DVec3;

use super::cubature::{Cubature, Witness, integrate};
use super::partition::{Partition, Rectangle};
use crate::common::measure::Model64;

/// The measure of the pairs of uniform numbers in [0, 1)² for which a sample fails, by quadrature
/// that looks for the edge of the set. The witnesses are pairs of which it is known.
///
/// Integrated over t with u = t² (3 − 2t): directions move fastest where a number is close to 0 or
/// 1, and this spreads the ends.
pub fn probability(
    model: &Model64,
    wo: DVec3,
    witnesses: &[Witness],
    tolerance: f64,
    budget: u32,
) -> Cubature<1> {
    let spread: Vec<Witness> =
        witnesses.iter().map(|&(u, failed)| (u.map(inverse), failed)).collect();
    let points: Vec<[f64; 2]> = spread.iter().map(|witness| witness.0).take(16_000).collect();
    let most = points.len() / 192;
    let square = Rectangle { from: [0.0; 2], to: [1.0; 2] };
    let cells = Partition::grow(square, points, most, [1.0; 2]);
    integrate(&cells, &spread, tolerance, budget, |t| {
        let u = t.map(|t| (t * t * (3.0 - 2.0 * t)).min(1.0 - 0.5 * f64::EPSILON));
        let fails = model.sample(wo, u).pdf == 0.0;
        ([f64::from(u8::from(fails))], t.map(|t| 6.0 * t * (1.0 - t)).iter().product())
    })
}

/// The t in [0, 1] with t² (3 − 2t) = u.
fn inverse(u: f64) -> f64 {
    0.5 - ((1.0 - 2.0 * u).asin() / 3.0).sin()
}
