//! The probability that a draw gives no direction.

mod line;
mod search;

use std::collections::BinaryHeap;

use glam::DVec3;

use super::Integral;
use super::rule::{NODES, nodes};
use crate::measure::Model64;
use line::{Heights, Line};
use search::dip;

/// The measure of the pairs of uniform numbers in [0, 1)² for which a sample fails: the length of
/// the failing part of lines of constant second number, integrated over that number.
///
/// The height of the direction says how far a draw is from failing. It is continuous but for the
/// jumps from term to term of a sum or mixture; so strips between the lines and points that are
/// looked at show as dips of the height, and are searched for. The integral goes from line to line
/// where failure begins, ends or changes its shape.
pub fn probability(model: &Model64, wo: DVec3, tolerance: f64, budget: u32) -> Integral {
    let heights = Heights::new(model, wo);
    let ranges: Vec<Range> =
        heights.ranges().into_iter().map(|ends| Range::new(&heights, ends)).collect();
    let mut heap = BinaryHeap::new();
    for range in &ranges {
        for ends in range.bands() {
            heap.extend(
                [[0.0, 0.25], [0.25, 0.5], [0.5, 0.75], [0.75, 1.0]]
                    .map(|part| Panel::new(range, ends, part)),
            );
        }
    }
    let mut error: f64 = heap.iter().map(|panel| panel.error).sum();
    while error > tolerance && heights.evaluations() < budget {
        let Some(Panel { range, band, part: [from, to], error: worst, .. }) = heap.pop() else {
            break;
        };
        error -= worst;
        let middle = 0.5 * (from + to);
        for part in [[from, middle], [middle, to]] {
            let panel = Panel::new(range, band, part);
            error += panel.error;
            heap.push(panel);
        }
    }
    Integral {
        value: heap.iter().map(|panel| panel.integral).sum(),
        error: heap.iter().map(|panel| panel.error).sum(),
    }
}

/// Places between 0 and 1: even steps that become ever smaller towards both ends.
fn graded(steps: u32) -> Vec<f64> {
    let even = (0..=steps).map(|step| f64::from(step) / f64::from(steps));
    let mut places: Vec<f64> = even.map(|t| t * t * (3.0 - 2.0 * t)).collect();
    for exponent in 3..14 {
        let small = 10.0_f64.powi(-exponent);
        places.extend([small, 1.0 - small]);
    }
    places.sort_unstable_by(f64::total_cmp);
    places
}

/// A range of the first number on which directions depend continuously.
struct Range<'a> {
    heights: &'a Heights<'a>,
    places: Vec<f64>,
}

impl<'a> Range<'a> {
    fn new(heights: &'a Heights<'a>, [start, end]: [f64; 2]) -> Self {
        let places = graded(96).into_iter().map(|t| (1.0 - t) * start + t * end).collect();
        Self { heights, places }
    }

    fn line(&self, u1: f64) -> Line {
        self.heights.line(&self.places, u1)
    }

    /// The intervals of the second number that hold failing lines, each of them of lines that
    /// resemble each other.
    fn bands(&self) -> Vec<[f64; 2]> {
        let mut lines: Vec<(f64, Line)> =
            graded(96).into_iter().map(|u1| (u1, self.line(u1))).collect();
        let dips: Vec<(f64, Line)> = lines
            .windows(3)
            .filter_map(|three| {
                let points = [0, 1, 2].map(|index| (three[index].0, three[index].1.least));
                let [low, middle, high] = points.map(|point| point.1);
                let searched = middle > 0.0 && middle <= low.min(high);
                let (u1, _) = searched.then(|| dip(|u1| self.line(u1).least, points))?;
                Some((u1, self.line(u1)))
            })
            .collect();
        lines.extend(dips);
        lines.sort_by(|a, b| a.0.total_cmp(&b.0));

        let (mut bands, mut start) = (Vec::new(), lines[0].0);
        let mut add = |from: f64, to: f64, line: &Line| {
            if line.length > 0.0 && to > from {
                bands.push([from, to]);
            }
        };
        for pair in lines.windows(2) {
            let (mut low, high) = (pair[0], &pair[1]);
            // Several changes may follow each other.
            for _ in 0..8 {
                if low.1.resembles(&high.1) {
                    break;
                }
                let [edge, next] = self.change(&low, high);
                add(start, edge, &low.1);
                start = edge;
                low = (next, self.line(next));
            }
        }
        let last = &lines[lines.len() - 1];
        add(start, last.0, &last.1);
        bands
    }

    /// Where between two lines lines cease to resemble the first, before and after the change.
    fn change(&self, low: &(f64, Line), high: &(f64, Line)) -> [f64; 2] {
        let (mut from, mut to) = (low.0, high.0);
        while to - from > 1e-10 {
            let middle = 0.5 * (from + to);
            if self.line(middle).resembles(&low.1) {
                from = middle;
            } else {
                to = middle;
            }
        }
        [from, to]
    }
}

/// The integral over a part of a band. Lengths begin and end like roots at its ends; in t with
/// u = t²(3 − 2t) they do not.
struct Panel<'a> {
    range: &'a Range<'a>,
    band: [f64; 2],
    part: [f64; 2],
    integral: f64,
    error: f64,
}

impl<'a> Panel<'a> {
    fn new(range: &'a Range<'a>, band: [f64; 2], part: [f64; 2]) -> Self {
        let width = band[1] - band[0];
        let values = nodes(part[0], part[1]).map(|t| {
            let u1 = band[0] + width * (t * t * (3.0 - 2.0 * t));
            range.line(u1).length * (width * 6.0 * t * (1.0 - t))
        });
        let half = 0.5 * (part[1] - part[0]);
        let sum = |weights: [f64; 7]| {
            half * weights.iter().zip(&values).map(|(weight, value)| weight * value).sum::<f64>()
        };
        let integral = sum(NODES.map(|node| node.1));
        // The difference to one rule alone is small at some places of a step: to Gauss's, and to
        // that of the other four nodes.
        let others = [0.197227, 0.0, 0.802773, 0.0, 0.802773, 0.0, 0.197227];
        let errors = [NODES.map(|node| node.2), others].map(|rule| (integral - sum(rule)).abs());
        Self { range, band, part, integral, error: errors[0].max(errors[1]) }
    }
}

impl Ord for Panel<'_> {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.error.total_cmp(&other.error)
    }
}
impl PartialOrd for Panel<'_> {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl PartialEq for Panel<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Panel<'_> {}
