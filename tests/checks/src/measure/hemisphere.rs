//! Integrals over the hemisphere of light, for lobes of any width: adaptive cubature of cells that
//! start small where a model's samples fall.
//!
//! A direction is (s, φ): s² = 1 − cosθ, so that the pole is no special place and the horizon a
//! straight edge s = 1; φ is the azimuth from that of the mirror direction.

use std::collections::BinaryHeap;
use std::f64::consts::{FRAC_PI_2, PI};

use brdf::{Brdf, Color};
use glam::{DVec2, DVec3};

/// Positive nodes of Kronrod's rule of 15, with its weight and that of Gauss's rule of 7.
const NODES: [(f64, f64, f64); 8] = [
    (0.0, 0.209482141084727828012999174891714, 0.417959183673469387755102040816327),
    (0.207784955007898467600689403773245, 0.204432940075298892414161999234649, 0.0),
    (
        0.405845151377397166906606412076961,
        0.190350578064785409913256402421014,
        0.381830050505118944950369775488975,
    ),
    (0.586087235467691130294144691693013, 0.169004726639267902826583426598550, 0.0),
    (
        0.741531185599394439863864773280788,
        0.140653259715525918745189590510238,
        0.279705391489276667901467771423780,
    ),
    (0.864864423359769072789712788640926, 0.104790010322250183839876322541518, 0.0),
    (
        0.949107912342758524526189684047851,
        0.063092092629978553290700663189204,
        0.129484966168869693270611432679082,
    ),
    (0.991455371120812639206854697526329, 0.022935322010529224963732008058970, 0.0),
];

/// How many cells an integral may take. What it could not do with them shows in its error.
const MOST_CELLS: usize = 20_000;

/// An integral over the hemisphere.
#[derive(Clone, Copy, Debug)]
pub struct Integral {
    pub value: DVec3,
    /// An estimate of the largest error of a channel, mostly far too large.
    pub error: f64,
    pub cells: usize,
}

/// Directions to the light around the mirror direction of `wo`, as (s, φ).
#[derive(Clone, Copy, Debug)]
pub struct Chart {
    cos: f64,
    sin: f64,
}

impl Chart {
    pub fn new(wo: DVec3) -> Self {
        let length = wo.x.hypot(wo.y);
        if length > 0.0 {
            Self { cos: -wo.x / length, sin: -wo.y / length }
        } else {
            Self { cos: 1.0, sin: 0.0 }
        }
    }

    /// The direction at (s, φ). A solid angle is 2s ds dφ.
    pub fn direction(&self, s: f64, phi: f64) -> DVec3 {
        let sin_theta = s * (2.0 - s * s).sqrt();
        let (sin, cos) = phi.sin_cos();
        let (x, y) = (self.cos * cos - self.sin * sin, self.sin * cos + self.cos * sin);
        DVec3::new(sin_theta * x, sin_theta * y, (1.0 - s) * (1.0 + s))
    }

    /// (s, φ) of a direction above the surface.
    pub fn coordinates(&self, wi: DVec3) -> DVec2 {
        let s = ((wi.x * wi.x + wi.y * wi.y) / (1.0 + wi.z)).sqrt();
        let along = wi.x * self.cos + wi.y * self.sin;
        DVec2::new(s.min(1.0), (wi.y * self.cos - wi.x * self.sin).atan2(along))
    }
}

/// Points of a Fibonacci lattice on the unit square, and its step.
const PILOTS: u32 = 1597;
const STEP: u32 = 987;

/// Cells that each hold a few of a model's samples for `wo`, each [low corner, high corner].
pub fn cells<C: Color<f64>>(model: &dyn Brdf<f64, Color = C>, wo: DVec3) -> Vec<[DVec2; 2]> {
    let chart = Chart::new(wo);
    let place = |number: u32| (f64::from(number) + 0.5) / f64::from(PILOTS);
    let samples =
        (0..PILOTS).map(|index| model.sample(wo, [place(index), place(index * STEP % PILOTS)]));
    let points: Vec<DVec2> = samples
        .filter(|sample| sample.pdf > 0.0)
        .map(|sample| chart.coordinates(sample.wi))
        .collect();
    let below_horizon = 1.0 - chart.coordinates(wo).x;
    let rows = graded(below_horizon).map(|width| 1.0 - width).chain([0.0, 1.0]);
    let around_mirror = graded(wo.z).filter(|width| *width < FRAC_PI_2);
    let columns = around_mirror.flat_map(|width| [-width, width]);
    let columns = columns.chain([-PI, -FRAC_PI_2, 0.0, FRAC_PI_2, PI]);
    // A lobe that ends at a right angle from the mirror direction ends there seen from a viewer
    // that grazes, or this much before.
    let side = [-FRAC_PI_2, FRAC_PI_2].into_iter();
    let columns = columns.chain(side.flat_map(|side| [side - wo.z, side + wo.z]));
    let mut cells = Vec::new();
    for [low, high] in intervals(rows) {
        for [from, to] in intervals(columns.clone()) {
            divide([DVec2::new(low, from), DVec2::new(high, to)], &points, &mut cells);
        }
    }
    cells
}

/// Ever wider distances from where the viewer is. Models that ask for the taller of two directions
/// have a kink at the height of the viewer; what depends on the ratio of the two heights, and the
/// facets that mirror one grazing direction into another, take up as little of the hemisphere as
/// the viewer is high. None for a viewer on the horizon.
fn graded(height: f64) -> impl Iterator<Item = f64> + Clone {
    let first = (height > 0.0).then_some(height);
    std::iter::successors(first, |width| Some(8.0 * width)).take_while(|width| *width < 0.9)
}

fn intervals(edges: impl Iterator<Item = f64>) -> Vec<[f64; 2]> {
    let mut edges: Vec<f64> = edges.collect();
    edges.sort_by(f64::total_cmp);
    edges.windows(2).map(|ends| [ends[0], ends[1]]).collect()
}

/// Halves a cell until few samples are left in it, or fill it evenly.
fn divide([low, high]: [DVec2; 2], points: &[DVec2], cells: &mut Vec<[DVec2; 2]>) {
    let inside: Vec<DVec2> = points
        .iter()
        .copied()
        .filter(|point| point.cmpge(low).all() && point.cmplt(high).all())
        .collect();
    let size = high - low;
    let count = inside.len() as f64;
    let mean = inside.iter().sum::<DVec2>() / count;
    let spread = inside.iter().map(|point| (point - mean).abs()).sum::<DVec2>() / (size * count);
    // Samples that fill a cell evenly deviate by a quarter of it.
    let crowded = inside.len() > PILOTS as usize / 32;
    let huddled = inside.len() > 2 && spread.min_element() < 0.05;
    if size.min_element() < 1e-10 || !(crowded || huddled) {
        cells.push([low, high]);
        return;
    }
    // Across the axis along which they take up the smaller part.
    for half in halves([low, high], usize::from(spread.y < spread.x)) {
        divide(half, &inside, cells);
    }
}

fn halves([low, high]: [DVec2; 2], axis: usize) -> [[DVec2; 2]; 2] {
    let (mut end, mut start) = (high, low);
    end[axis] = 0.5 * (low[axis] + high[axis]);
    start[axis] = end[axis];
    [[low, end], [start, high]]
}

/// A cell with its integral.
struct Done {
    corners: [DVec2; 2],
    value: DVec3,
    error: f64,
    /// The axis along which more nodes changed more.
    axis: usize,
}

impl Done {
    fn new(corners: [DVec2; 2], formula: &impl Fn(f64, f64) -> DVec3) -> Self {
        let [low, high] = corners;
        let (center, half) = (0.5 * (low + high), 0.5 * (high - low));
        let (mut value, mut coarse_s, mut coarse_phi) = (DVec3::ZERO, DVec3::ZERO, DVec3::ZERO);
        let mut size = DVec3::ZERO;
        for (s, kronrod_s, gauss_s) in both_sides() {
            let s = center.x + half.x * s;
            let (mut ring, mut coarse) = (DVec3::ZERO, DVec3::ZERO);
            for (phi, kronrod, gauss) in both_sides() {
                let here = formula(s, center.y + half.y * phi);
                ring += here * kronrod;
                coarse += here * gauss;
            }
            let solid_angle = 2.0 * s * half.x * half.y;
            value += ring * (kronrod_s * solid_angle);
            size += ring.abs() * (kronrod_s * solid_angle);
            coarse_s += ring * (gauss_s * solid_angle);
            coarse_phi += coarse * (kronrod_s * solid_angle);
        }
        let errors = [coarse_s, coarse_phi].map(|coarse| (value - coarse).abs().max_element());
        // The error is that of Gauss's rule. Where that is small, Kronrod's rule of twice the
        // degree is better by far: the estimate of QUADPACK.
        let size = size.max_element();
        let better = |error: f64| {
            if size > 0.0 { error.min(size * (200.0 * error / size).powf(1.5)) } else { 0.0 }
        };
        Self {
            corners,
            value,
            error: better(errors[0]) + better(errors[1]),
            axis: usize::from(errors[1] > errors[0]),
        }
    }
}

pub(super) fn both_sides() -> impl Iterator<Item = (f64, f64, f64)> {
    let (center, others) = (NODES[0], &NODES[1..]);
    let mirrored =
        others.iter().flat_map(|&(x, kronrod, gauss)| [(x, kronrod, gauss), (-x, kronrod, gauss)]);
    std::iter::once(center).chain(mirrored)
}

impl PartialEq for Done {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Done {}
impl PartialOrd for Done {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Done {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.error.total_cmp(&other.error)
    }
}

/// ∫ `formula`(wi) dωᵢ over the given cells around the mirror direction of `wo`, dividing the
/// worst of them until `enough`(value, error) says so.
pub fn integrate(
    wo: DVec3,
    cells: &[[DVec2; 2]],
    formula: impl Fn(DVec3) -> DVec3,
    enough: impl Fn(DVec3, f64) -> bool,
) -> Integral {
    let chart = Chart::new(wo);
    let formula = |s, phi| formula(chart.direction(s, phi));
    let mut heap: BinaryHeap<Done> = cells.iter().map(|&cell| Done::new(cell, &formula)).collect();
    let sum = |heap: &BinaryHeap<Done>| Integral {
        value: heap.iter().map(|cell| cell.value).sum(),
        error: heap.iter().map(|cell| cell.error).sum(),
        cells: heap.len(),
    };
    loop {
        // Sums from scratch, since differences would keep the rounding of the first large cells;
        // after each quarter more cells, so that sums take no time.
        let total = sum(&heap);
        if enough(total.value, total.error) || total.cells >= MOST_CELLS {
            return total;
        }
        for _ in 0..total.cells / 4 + 1 {
            let Some(worst) = heap.pop() else { break };
            heap.extend(halves(worst.corners, worst.axis).map(|half| Done::new(half, &formula)));
        }
    }
}
