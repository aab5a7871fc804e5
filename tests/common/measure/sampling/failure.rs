//! The probability that a draw gives no direction.

use glam::DVec3;
use std::collections::BinaryHeap;

use super::Integral;
use super::rule::{NODES, nodes};
use crate::common::measure::Model64;

/// Two uniform numbers of which it is known whether they give no direction.
pub type Witness = ([f64; 2], bool);

/// The measure of the pairs of uniform numbers in [0, 1)² for which a sample fails: the length of
/// the failing part of lines of constant second number, integrated over that number.
///
/// Models choose their terms by the first number, so that the set may jump along it, and along it
/// lie the strips at the end of each term's range where the farthest tails fail. The lines are
/// looked at in equal steps, at both ends more closely, and where the witnesses failed; between
/// points that differ the edge is found by bisection.
pub fn probability(
    model: &Model64,
    wo: DVec3,
    witnesses: &[Witness],
    tolerance: f64,
    budget: u32,
) -> Integral {
    let mut lines = Lines { model, wo, points: points(witnesses), evaluations: 0 };
    let mut heap = BinaryHeap::new();
    for panel in panels(witnesses).windows(2) {
        heap.push(lines.panel([panel[0], panel[1]]));
    }
    let mut error: f64 = heap.iter().map(|panel| panel.error).sum();
    while error > tolerance && lines.evaluations < budget {
        let Some(Panel { ends: [from, to], error: worst, .. }) = heap.pop() else { break };
        error -= worst;
        let middle = 0.5 * (from + to);
        for ends in [[from, middle], [middle, to]] {
            let panel = lines.panel(ends);
            error += panel.error;
            heap.push(panel);
        }
    }
    Integral {
        value: heap.iter().map(|panel| panel.integral).sum(),
        error: heap.iter().map(|panel| panel.error).sum(),
        evaluations: lines.evaluations,
    }
}

/// At most about this many of the failed witnesses say where to look.
const FAILED: usize = 192;

fn failed(witnesses: &[Witness], axis: usize) -> Vec<f64> {
    let all = witnesses.iter().filter(|(_, failed)| *failed).map(|(u, _)| u[axis]);
    let mut sorted: Vec<f64> = all.collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let step = sorted.len().div_ceil(FAILED).max(1);
    sorted.into_iter().step_by(step).collect()
}

/// Where each line is looked at, from 0 to the last number below 1.
fn points(witnesses: &[Witness]) -> Vec<f64> {
    let mut points = failed(witnesses, 0);
    points.extend((0..=64).map(|step| {
        let t = f64::from(step) / 64.0;
        t * t * (3.0 - 2.0 * t)
    }));
    points.extend((1..64).map(|step| f64::from(step) / 64.0));
    for exponent in 2..16 {
        let small = 10.0_f64.powi(-exponent);
        points.extend([small, 1.0 - small]);
    }
    for point in &mut points {
        *point = point.min(1.0 - 0.5 * f64::EPSILON);
    }
    points.sort_unstable_by(f64::total_cmp);
    points.dedup();
    points
}

/// The ends of the first panels of the second number.
fn panels(witnesses: &[Witness]) -> Vec<f64> {
    let mut ends: Vec<f64> = (0..=16).map(|step| f64::from(step) / 16.0).collect();
    ends.extend(failed(witnesses, 1).into_iter().step_by(FAILED / 16));
    for exponent in 2..8 {
        let small = 10.0_f64.powi(-exponent);
        ends.extend([small, 1.0 - small]);
    }
    ends.sort_unstable_by(f64::total_cmp);
    ends.dedup();
    ends
}

struct Lines<'a> {
    model: &'a Model64,
    wo: DVec3,
    points: Vec<f64>,
    evaluations: u32,
}

impl Lines<'_> {
    fn fails(&mut self, u: [f64; 2]) -> bool {
        self.evaluations += 1;
        self.model.sample(self.wo, u).pdf == 0.0
    }

    fn panel(&mut self, ends: [f64; 2]) -> Panel {
        let half = 0.5 * (ends[1] - ends[0]);
        let places = nodes(ends[0], ends[1]);
        let lengths = places.map(|u1| self.length(u1));
        let sum = |weights: [f64; 7]| {
            half * weights.iter().zip(&lengths).map(|(weight, length)| weight * length).sum::<f64>()
        };
        let integral = sum(NODES.map(|node| node.1));
        // The difference to one rule alone is small at some places of a step: to Gauss's, and to
        // that of the other four nodes.
        let others = [0.197227, 0.0, 0.802773, 0.0, 0.802773, 0.0, 0.197227];
        let within = [NODES.map(|node| node.2), others].map(|rule| (integral - sum(rule)).abs());
        // A step between the last node and an end shows at the end.
        let beyond = [(0, 1, ends[0]), (6, 5, ends[1])].map(|(last, before, end)| {
            let inset = end + 1e-9 * (places[last] - end);
            let slope = (lengths[last] - lengths[before]) / (places[last] - places[before]);
            let expected = lengths[last] + slope * (inset - places[last]);
            (self.length(inset) - expected).abs() * (places[last] - end).abs()
        });
        let error = within.into_iter().chain(beyond).fold(0.0, f64::max);
        Panel { ends, integral, error }
    }

    /// The length of the failing part of a line.
    fn length(&mut self, u1: f64) -> f64 {
        let mut length = 0.0;
        let mut before = (self.points[0], self.fails([self.points[0], u1]));
        for index in 1..self.points.len() {
            let now = (self.points[index], self.fails([self.points[index], u1]));
            if now.1 == before.1 {
                length += if now.1 { now.0 - before.0 } else { 0.0 };
            } else {
                let edge = self.edge(before, now.0, u1);
                length += if now.1 { now.0 - edge } else { edge - before.0 };
            }
            before = now;
        }
        length
    }

    /// Where failure begins or ends between a place, of which it is known, and another.
    fn edge(&mut self, (mut from, fails): (f64, bool), mut to: f64, u1: f64) -> f64 {
        while to - from > 1e-11 {
            let middle = 0.5 * (from + to);
            if self.fails([middle, u1]) == fails {
                from = middle;
            } else {
                to = middle;
            }
        }
        0.5 * (from + to)
    }
}

struct Panel {
    ends: [f64; 2],
    integral: f64,
    error: f64,
}

impl Ord for Panel {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.error.total_cmp(&other.error)
    }
}
impl PartialOrd for Panel {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl PartialEq for Panel {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Panel {}
