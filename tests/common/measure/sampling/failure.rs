//! The probability that a draw gives no direction.

use glam::DVec3;

use super::Integral;
use crate::common::measure::Model64;

/// The measure of the pairs of uniform numbers in [0, 1)² for which a sample fails.
///
/// A draw that fails tells its direction too, and how far that lies below the surface. So the edge
/// of the failing set is the line where the height is 0, and it can be seen coming: the unit
/// square is cut into cells, and cut again where the height changes sign or might, until what is
/// left of the edge is straight. Models choose their terms by the first number, and at the end of
/// each term's range lie its farthest tails: there, and at the ends of both numbers, cells are
/// narrow from the beginning.
pub fn probability(model: &Model64, wo: DVec3) -> Integral {
    let mut square = Square { model, wo, evaluations: 0, error: 0.0 };
    let steps = |count: u32| (0..=count).map(move |step| f64::from(step) / f64::from(count));
    let jumps = square.jumps(0.37).into_iter().chain(square.jumps(0.81));
    let around_jumps = jumps.flat_map(|jump| around(jump, 13));
    let columns =
        sorted(steps(64).chain(around(0.0, 13)).chain(around(1.0, 13)).chain(around_jumps));
    let rows = sorted(steps(64).chain(around(0.0, 9)).chain(around(1.0, 9)));
    let mut value = 0.0;
    for column in columns.windows(2) {
        // Just inside, since the height may jump at the ends.
        let inset = 1e-4 * (column[1] - column[0]).min(1e-9);
        let x = [column[0], column[1]];
        let sides = [x[0] + inset, x[1] - inset];
        let mut below = sides.map(|u0| square.height([u0, rows[0]]));
        for row in rows.windows(2) {
            let above = sides.map(|u0| square.height([u0, row[1]]));
            let corners = [below[0], below[1], above[0], above[1]];
            value += square.failing(sides, [row[0], row[1]], corners) * (x[1] - x[0])
                / (sides[1] - sides[0]);
            below = above;
        }
    }
    Integral { value, error: square.error, evaluations: square.evaluations }
}

/// The last number below 1.
const LAST: f64 = 1.0 - 0.5 * f64::EPSILON;
/// Steps in which a line is searched for jumps.
const FINE: u32 = 1024;
/// Cells of this area are not cut any more.
const LEAST: f64 = 3e-8;

/// A place and numbers ever closer to it from both sides.
fn around(place: f64, finest: i32) -> impl Iterator<Item = f64> {
    let distances = (2..finest).map(|exponent| 10.0_f64.powi(-exponent));
    distances.flat_map(move |distance| [place - distance, place + distance]).chain([place])
}

fn sorted(numbers: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sorted: Vec<f64> = numbers.map(|number| number.clamp(0.0, LAST)).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted.dedup_by(|a, b| *a - *b < 1e-13);
    sorted
}

struct Square<'a> {
    model: &'a Model64,
    wo: DVec3,
    evaluations: u32,
    error: f64,
}

impl Square<'_> {
    /// The height of the direction above the surface; a draw that fails has none above 0.
    fn height(&mut self, u: [f64; 2]) -> f64 {
        self.evaluations += 1;
        let sample = self.model.sample(self.wo, u);
        if sample.pdf == 0.0 { sample.wi.z.min(0.0) } else { sample.wi.z.max(f64::MIN_POSITIVE) }
    }

    /// Places where the height jumps along a line of constant second number: where halving a step
    /// does not halve the difference.
    fn jumps(&mut self, u1: f64) -> Vec<f64> {
        let place = |step: u32| (f64::from(step) / f64::from(FINE)).min(LAST);
        let heights: Vec<f64> = (0..=FINE).map(|step| self.height([place(step), u1])).collect();
        let mut jumps = Vec::new();
        for step in 0..FINE {
            let (mut from, mut to) = (place(step), place(step + 1));
            let mut ends = [heights[step as usize], heights[step as usize + 1]];
            let least = 0.5 * (ends[1] - ends[0]).abs().max(1e-3);
            while to - from > 1e-14 && (ends[1] - ends[0]).abs() > least {
                let middle = 0.5 * (from + to);
                let height = self.height([middle, u1]);
                if (height - ends[0]).abs() > (ends[1] - height).abs() {
                    (to, ends[1]) = (middle, height);
                } else {
                    (from, ends[0]) = (middle, height);
                }
            }
            if to - from <= 1e-14 {
                jumps.push(to);
            }
        }
        jumps
    }

    /// The failing part of a cell, from the heights at its corners: x first, then y.
    fn failing(&mut self, x: [f64; 2], y: [f64; 2], corners: [f64; 4]) -> f64 {
        let area = (x[1] - x[0]) * (y[1] - y[0]);
        let least = corners.into_iter().fold(f64::INFINITY, f64::min);
        let most = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let near = most - least;
        if least > near {
            return 0.0;
        }
        if most < -near {
            return area;
        }
        if area < LEAST {
            // Cut into triangles along either diagonal.
            let [a, b, c, d] = corners;
            let one = below(a, b, c) + below(b, c, d);
            let other = below(a, b, d) + below(a, c, d);
            self.error += 0.5 * area * (one - other).abs();
            return 0.25 * area * (one + other);
        }
        let (mx, my) = (0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]));
        let [a, b, c, d] = corners;
        let [bottom, top] = [self.height([mx, y[0]]), self.height([mx, y[1]])];
        let [left, right] = [self.height([x[0], my]), self.height([x[1], my])];
        let center = self.height([mx, my]);
        self.failing([x[0], mx], [y[0], my], [a, bottom, left, center])
            + self.failing([mx, x[1]], [y[0], my], [bottom, b, center, right])
            + self.failing([x[0], mx], [my, y[1]], [left, center, c, top])
            + self.failing([mx, x[1]], [my, y[1]], [center, right, top, d])
    }
}

/// The part of a triangle where a linear function is not above 0, by its values at the corners.
fn below(a: f64, b: f64, c: f64) -> f64 {
    let mut values = [a, b, c];
    values.sort_unstable_by(f64::total_cmp);
    let [low, middle, high] = values;
    if low > 0.0 {
        0.0
    } else if high <= 0.0 {
        1.0
    } else if middle > 0.0 {
        low * low / ((middle - low) * (high - low))
    } else {
        1.0 - high * high / ((high - low) * (high - middle))
    }
}
