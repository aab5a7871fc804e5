//! The integral over a rectangle that the edge of a support crosses, line by line: each line from
//! edge to edge, which are found by bisection.

use super::cubature::{Integrand, Piece, points};
use super::partition::Rectangle;
use super::rule::{NODES, nodes};

/// Integrates along an axis; `most` is the largest value times the area.
pub fn integrate<const K: usize>(
    integrand: &mut Integrand<impl Fn([f64; 2]) -> ([f64; K], f64)>,
    rectangle: &Rectangle,
    axis: usize,
    most: f64,
) -> Piece<K> {
    let across = 1 - axis;
    let half = 0.5 * rectangle.width(across);
    let ends = [rectangle.from[axis], rectangle.to[axis]];
    let lines = nodes(rectangle.from[across], rectangle.to[across]).map(|place| {
        let at = |along: f64| if axis == 0 { [along, place] } else { [place, along] };
        Line::integrate(integrand, ends, rectangle.inset(axis), at)
    });
    let (mut integral, mut errors) = ([0.0; K], [0.0; 2]);
    for (k, integral) in integral.iter_mut().enumerate() {
        let values = lines.each_ref().map(|line| line.integral[k]);
        let (fine, coarse) = by_rule(half, values);
        *integral = fine;
        errors[across] += (fine - coarse).abs();
    }
    errors[axis] = by_rule(half, lines.each_ref().map(|line| line.error)).0;
    let mut piece = Piece::new(integral, errors);
    // What lies between the outer lines and the sides is a fiftieth of each, and a strip may fall
    // between the points: where the lines lie inside, or outside, but for less than that, they may
    // have missed the edge that was seen elsewhere.
    let inside = by_rule(0.5, lines.each_ref().map(|line| line.inside)).0 / (ends[1] - ends[0]);
    if !(0.02..=0.98).contains(&inside) {
        piece.axis = rectangle.longer();
        piece.errors[piece.axis] = piece.errors[piece.axis].max(0.02 * most);
    }
    piece
}

/// The sums of both rules.
fn by_rule(half: f64, values: [f64; 7]) -> (f64, f64) {
    let terms = || NODES.iter().zip(&values);
    (
        half * terms().map(|(node, value)| node.1 * value).sum::<f64>(),
        half * terms().map(|(node, value)| node.2 * value).sum::<f64>(),
    )
}

struct Line<const K: usize> {
    integral: [f64; K],
    error: f64,
    /// The length inside the support.
    inside: f64,
}

impl<const K: usize> Line<K> {
    fn integrate(
        integrand: &mut Integrand<impl Fn([f64; 2]) -> ([f64; K], f64)>,
        ends: [f64; 2],
        inset: [f64; 2],
        at: impl Fn(f64) -> [f64; 2],
    ) -> Self {
        let mut line = Self { integral: [0.0; K], error: 0.0, inside: 0.0 };
        let mut start = ends[0];
        let mut before = (start, integrand.inside(at(inset[0])));
        for place in points(inset).skip(1) {
            let now = (place, integrand.inside(at(place)));
            if now.1 != before.1 {
                let edge = edge(integrand, before, place, &at);
                if before.1 {
                    line.add(integrand, [start, edge], &at);
                }
                start = edge;
            }
            before = now;
        }
        if before.1 {
            line.add(integrand, [start, ends[1]], &at);
        }
        line
    }

    /// Adds a segment within the support.
    fn add(
        &mut self,
        integrand: &mut Integrand<impl Fn([f64; 2]) -> ([f64; K], f64)>,
        [from, to]: [f64; 2],
        at: impl Fn(f64) -> [f64; 2],
    ) {
        self.inside += to - from;
        let values = nodes(from, to).map(|place| integrand.at(at(place)));
        for k in 0..K {
            let of_function = values.map(|(values, area)| values[k] * area);
            let (fine, coarse) = by_rule(0.5 * (to - from), of_function);
            self.integral[k] += fine;
            self.error += (fine - coarse).abs();
        }
    }
}

/// Where the support begins or ends between a place, of which it is known on which side it lies,
/// and another.
fn edge<const K: usize>(
    integrand: &mut Integrand<impl Fn([f64; 2]) -> ([f64; K], f64)>,
    (mut from, inside): (f64, bool),
    mut to: f64,
    at: impl Fn(f64) -> [f64; 2],
) -> f64 {
    for _ in 0..36 {
        let middle = 0.5 * (from + to);
        if integrand.inside(at(middle)) == inside {
            from = middle;
        } else {
            to = middle;
        }
    }
    0.5 * (from + to)
}
