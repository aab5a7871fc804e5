//! Integrals over cells of the plane, refined wherever their error is largest.
//!
//! The integrands here end at curves: a density at the edge of what can be drawn, an indicator
//! at the edge of its set. A rectangle that such an edge crosses is integrated line by line, see
//! [`lines`](super::lines). Kinks are met by refinement alone.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::partition::{Partition, Rectangle};
use super::rule::{NODES, likely_error, nodes};

/// Integrals of K functions over each of some cells.
pub struct Cubature<const K: usize> {
    /// In the order of the cells.
    pub integrals: Vec<[f64; K]>,
    /// Estimates of the error in each cell, of all functions together.
    pub errors: Vec<f64>,
}

impl<const K: usize> Cubature<K> {
    /// The integral over all cells together.
    pub fn total(&self) -> [f64; K] {
        std::array::from_fn(|k| self.integrals.iter().map(|cell| cell[k]).sum())
    }
}

/// Integrates over each cell, which begins in `pieces` along either axis, until the error of the sum is about
/// `tolerance` or the evaluations exceed the `budget`. The formula gives K functions, all zero where the first is, and the area
/// that belongs to a unit of the plane; it may vanish at the edges of the plane, the functions
/// need not.
pub fn integrate<const K: usize>(
    partition: &Partition,
    pieces: u32,
    tolerance: f64,
    budget: u32,
    formula: impl Fn([f64; 2]) -> ([f64; K], f64),
) -> Cubature<K> {
    let mut integrand = Integrand { formula, evaluations: 0 };
    let negligible = 1e-3 * tolerance;
    let cells = partition.cells();
    let mut heap = BinaryHeap::with_capacity(2 * cells.len());
    for (cell, &rectangle) in cells.iter().enumerate() {
        for piece in rectangle.cut_evenly(pieces) {
            heap.push(Part::new(&mut integrand, negligible, cell, piece, false));
        }
    }
    let mut error: f64 = heap.iter().map(|part| part.piece.error()).sum();
    while error > tolerance && integrand.evaluations < budget {
        let Some(Part { cell, rectangle, piece, whole, .. }) = heap.pop() else { break };
        error -= piece.error();
        for half in rectangle.cut_in_half(piece.axis) {
            let part = Part::new(&mut integrand, negligible, cell, half, whole);
            error += part.piece.error();
            heap.push(part);
        }
    }
    let (mut integrals, mut errors) = (vec![[0.0; K]; cells.len()], vec![0.0; cells.len()]);
    for part in &heap {
        errors[part.cell] += part.piece.error() + part.neglected;
        for (sum, value) in integrals[part.cell].iter_mut().zip(part.piece.integral) {
            *sum += value;
        }
    }
    Cubature { integrals, errors }
}

/// The functions, with a count of how often they were asked.
pub struct Integrand<F> {
    formula: F,
    evaluations: u32,
}

impl<const K: usize, F: Fn([f64; 2]) -> ([f64; K], f64)> Integrand<F> {
    pub fn at(&mut self, place: [f64; 2]) -> ([f64; K], f64) {
        self.evaluations += 1;
        (self.formula)(place)
    }

    pub fn inside(&mut self, place: [f64; 2]) -> bool {
        self.at(place).0[0] > 0.0
    }
}

/// The integrals over a rectangle.
pub struct Piece<const K: usize> {
    pub integral: [f64; K],
    /// Estimates of the error along the axes.
    pub errors: [f64; 2],
    /// The axis across which to cut.
    pub axis: usize,
}

impl<const K: usize> Piece<K> {
    pub fn new(integral: [f64; K], errors: [f64; 2]) -> Self {
        Self { integral, errors, axis: usize::from(errors[1] > errors[0]) }
    }

    fn error(&self) -> f64 {
        self.errors[0] + self.errors[1]
    }
}

/// A part of a cell.
struct Part<const K: usize> {
    cell: usize,
    rectangle: Rectangle,
    piece: Piece<K>,
    /// Whether the first function seems positive all over.
    whole: bool,
    /// What is at most beyond an edge that was not looked for.
    neglected: f64,
}

impl<const K: usize> Ord for Part<K> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.piece.error().total_cmp(&other.piece.error())
    }
}
impl<const K: usize> PartialOrd for Part<K> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl<const K: usize> PartialEq for Part<K> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl<const K: usize> Eq for Part<K> {}

impl<const K: usize> Part<K> {
    /// Integrates over a rectangle; an edge worth less than `negligible` is not looked for.
    fn new(
        integrand: &mut Integrand<impl Fn([f64; 2]) -> ([f64; K], f64)>,
        negligible: f64,
        cell: usize,
        rectangle: Rectangle,
        of_whole: bool,
    ) -> Self {
        let [xs, ys] = [0, 1].map(|axis| nodes(rectangle.from[axis], rectangle.to[axis]));
        let grid = xs.map(|x| ys.map(|y| integrand.at([x, y])));
        let inside = grid.map(|row| row.map(|(values, _)| values[0] > 0.0));
        let count = inside.iter().flatten().filter(|inside| **inside).count();
        // A part of what seemed whole is not asked again.
        let rim = if of_whole && count == 49 {
            Rim { inside: true, outside: false, largest: 0.0, area: 0.0 }
        } else {
            Rim::look(integrand, &rectangle)
        };
        let flat = || grid.iter().flatten();
        let largest = flat().map(|(values, _)| values[0]).fold(rim.largest, f64::max);
        let most =
            largest * flat().map(|(_, area)| *area).fold(rim.area, f64::max) * rectangle.area();
        let whole = count == 49 && !rim.outside;
        let empty = count == 0 && !rim.inside;
        if !whole && !empty && most > negligible {
            // Lines run along the axis on which neighbours differ more often.
            let along_y =
                inside.iter().flat_map(|row| row.windows(2)).filter(|pair| pair[0] != pair[1]);
            let along_x = inside
                .windows(2)
                .flat_map(|rows| rows[0].iter().zip(&rows[1]))
                .filter(|(a, b)| a != b);
            let axis = usize::from(along_y.count() > along_x.count());
            let piece = super::lines::integrate(integrand, &rectangle, axis, most);
            return Self { cell, rectangle, piece, whole, neglected: 0.0 };
        }
        let neglected = if whole || empty { 0.0 } else { most };
        Self { cell, rectangle, piece: of_grid(&rectangle, &grid), whole, neglected }
    }
}

/// What is seen along the sides of a rectangle.
struct Rim {
    inside: bool,
    outside: bool,
    largest: f64,
    area: f64,
}

/// Points on each side.
pub const SIDE: u32 = 14;

impl Rim {
    fn look<const K: usize>(
        integrand: &mut Integrand<impl Fn([f64; 2]) -> ([f64; K], f64)>,
        rectangle: &Rectangle,
    ) -> Self {
        let ends = [0, 1].map(|axis| rectangle.inset(axis));
        let mut rim = Self { inside: false, outside: false, largest: 0.0, area: 0.0 };
        for axis in 0..2 {
            for side in ends[1 - axis] {
                for along in points(ends[axis]) {
                    let place = if axis == 0 { [along, side] } else { [side, along] };
                    let (values, area) = integrand.at(place);
                    rim.inside |= values[0] > 0.0;
                    rim.outside |= values[0] <= 0.0;
                    rim.largest = rim.largest.max(values[0]);
                    rim.area = rim.area.max(area);
                }
            }
        }
        rim
    }
}

/// Points on a line, its ends among them, at which an edge is looked for.
pub fn points([from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    (0..SIDE).map(move |step| from + (to - from) * f64::from(step) / f64::from(SIDE - 1))
}

/// The integrals by the values and areas at all pairs of nodes.
fn of_grid<const K: usize>(rectangle: &Rectangle, grid: &[[([f64; K], f64); 7]; 7]) -> Piece<K> {
    let scale = 0.25 * rectangle.area();
    let (mut integral, mut errors) = ([0.0; K], [0.0; 2]);
    for k in 0..K {
        let (mut fine, mut coarse_x, mut coarse_y) = (0.0, 0.0, 0.0);
        for (row, x) in grid.iter().zip(&NODES) {
            for ((values, area), y) in row.iter().zip(&NODES) {
                let value = values[k] * area;
                fine += x.1 * y.1 * value;
                coarse_x += x.2 * y.1 * value;
                coarse_y += x.1 * y.2 * value;
            }
        }
        let mean = 0.25 * fine;
        let mut variation = 0.0;
        for (row, x) in grid.iter().zip(&NODES) {
            for ((values, area), y) in row.iter().zip(&NODES) {
                variation += x.1 * y.1 * (values[k] * area - mean).abs();
            }
        }
        integral[k] = scale * fine;
        errors[0] += likely_error(scale * (fine - coarse_x), scale * variation);
        errors[1] += likely_error(scale * (fine - coarse_y), scale * variation);
    }
    Piece::new(integral, errors)
}
