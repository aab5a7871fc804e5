//! The failing part of a line of constant second number.

use std::cell::Cell;

use glam::DVec3;

use super::search::{Point, crossing, dip};
use crate::measure::Model64;

/// How high draws end: a function of the two numbers that is not positive where they fail.
pub struct Heights<'a> {
    model: &'a Model64,
    wo: DVec3,
    evaluations: Cell<u32>,
}

impl<'a> Heights<'a> {
    pub fn new(model: &'a Model64, wo: DVec3) -> Self {
        Self { model, wo, evaluations: Cell::new(0) }
    }

    pub fn evaluations(&self) -> u32 {
        self.evaluations.get()
    }

    /// The direction, and its height: a draw that fails says where it went too, mostly below the
    /// surface. It counts as below it in any case.
    fn draw(&self, u: [f64; 2]) -> (DVec3, f64) {
        self.evaluations.set(self.evaluations.get() + 1);
        let sample = self.model.sample(self.wo, u);
        let height = sample.wi.z;
        (sample.wi, if sample.pdf > 0.0 { height } else { -height.abs() })
    }

    /// The ranges of the first number on which directions depend continuously. Sums and mixtures
    /// choose a term by the first number, with probabilities that depend on the viewer alone: a
    /// jump on one line is a jump on all.
    pub fn ranges(&self) -> Vec<[f64; 2]> {
        let mut jumps: Vec<[f64; 2]> = Vec::new();
        for u1 in [0.06, 0.31, 0.56, 0.81] {
            for step in 0..64_u32 {
                let [low, high] = [step, step + 1].map(|step| f64::from(step) / 64.0);
                let jump = self.jump([low, high.min(LAST)], u1);
                jumps.extend(jump.filter(|ends| ends[0] > 1e-9 && ends[1] < 1.0 - 1e-9));
            }
        }
        jumps.sort_by(|a, b| a[0].total_cmp(&b[0]));
        jumps.dedup_by(|a, b| a[0] - b[1] < 1e-12);
        let starts = std::iter::once(0.0).chain(jumps.iter().map(|jump| jump[1]));
        let ends = jumps.iter().map(|jump| jump[0]).chain([LAST]);
        starts.zip(ends).map(|(start, end)| [start, end]).collect()
    }

    /// The two sides of a jump between two first numbers, by bisection towards the larger change.
    fn jump(&self, [mut low, mut high]: [f64; 2], u1: f64) -> Option<[f64; 2]> {
        let (mut below, mut above) = (self.draw([low, u1]).0, self.draw([high, u1]).0);
        while high - low > 1e-15 {
            let middle = 0.5 * (low + high);
            let here = self.draw([middle, u1]).0;
            if here.distance(below) < here.distance(above) {
                (low, below) = (middle, here);
            } else {
                (high, above) = (middle, here);
            }
            if below.distance(above) < 1e-5 {
                return None;
            }
        }
        Some([low, high])
    }

    /// Looks at a line, at the given first numbers and wherever the height may dip through zero
    /// between them.
    pub fn line(&self, places: &[f64], u1: f64) -> Line {
        let height = |u0: f64| self.draw([u0, u1]).1;
        let mut points: Vec<Point> = places.iter().map(|&u0| (u0, height(u0))).collect();
        let dips: Vec<Point> = points
            .windows(3)
            .filter_map(|three| {
                // Where all fail, a strip that does not is looked for in the same way.
                let sign = if three[1].1 > 0.0 { 1.0 } else { -1.0 };
                let three = [0, 1, 2].map(|index| (three[index].0, sign * three[index].1));
                let [low, middle, high] = three.map(|point| point.1);
                if middle > low.min(high) || middle <= 0.0 {
                    return None;
                }
                let (u0, least) = dip(|u0| sign * height(u0), three);
                Some((u0, sign * least))
            })
            .collect();
        points.extend(dips);
        points.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));

        let fails = |point: Point| point.1 <= 0.0;
        let ends = [points[0], points[points.len() - 1]].map(fails);
        let least = points.iter().map(|point| point.1).fold(f64::INFINITY, f64::min);
        let mut line = Line { length: 0.0, least, edges: 0, ends };
        for pair in points.windows(2) {
            let (before, now) = (pair[0], pair[1]);
            match (fails(before), fails(now)) {
                (false, false) => {}
                (true, true) => line.length += now.0 - before.0,
                (fails, _) => {
                    let edge = crossing(height, before, now);
                    line.length += if fails { edge - before.0 } else { now.0 - edge };
                    line.edges += 1;
                }
            }
        }
        line
    }
}

/// The last number below 1.
const LAST: f64 = 1.0 - 0.5 * f64::EPSILON;

/// What a line shows.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// The length of the failing part.
    pub length: f64,
    /// The least height.
    pub least: f64,
    /// How often failure begins or ends, and whether the two ends fail.
    edges: u32,
    ends: [bool; 2],
}

impl Line {
    /// Whether the failing parts of both lines correspond.
    pub fn resembles(&self, other: &Self) -> bool {
        (self.edges, self.ends) == (other.edges, other.ends)
    }
}
