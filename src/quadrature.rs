//! Integrals: Gauss–Legendre nodes on a line, a lattice on the unit square.

use core::ops::{Add, Mul};

use crate::real::Real;

/// The positive nodes of the Legendre polynomial of degree 48 on [−1, 1], with their weights.
const NODES: [(f64, f64); 24] = [
    (0.03238017096286936, 0.06473769681268392),
    (0.0970046992094627, 0.06446616443595009),
    (0.1612223560688917, 0.06392423858464819),
    (0.22476379039468905, 0.06311419228625402),
    (0.28736248735545555, 0.062039423159892665),
    (0.34875588629216075, 0.06070443916589388),
    (0.4086864819907167, 0.059114839698395635),
    (0.4669029047509584, 0.057277292100403214),
    (0.523160974722233, 0.055199503699984165),
    (0.5772247260839727, 0.05289018948519367),
    (0.6288673967765136, 0.05035903555385447),
    (0.6778723796326639, 0.04761665849249048),
    (0.7240341309238146, 0.04467456085669428),
    (0.7671590325157404, 0.04154508294346475),
    (0.8070662040294426, 0.03824135106583071),
    (0.8435882616243935, 0.03477722256477044),
    (0.8765720202742479, 0.03116722783279809),
    (0.9058791367155696, 0.027426509708356948),
    (0.9313866907065543, 0.02357076083932438),
    (0.9529877031604309, 0.01961616045735553),
    (0.9705915925462473, 0.015579315722943849),
    (0.9841245837228269, 0.01147723457923454),
    (0.9935301722663508, 0.0073275539012762625),
    (0.9987710072524261, 0.0031533460523058385),
];

/// ∫ `formula` from `lower` to `upper`, by 48 Gauss–Legendre nodes: exact for polynomials up to
/// degree 95, good to the last digits for formulas without kinks.
///
/// ```
/// use brdf::quadrature::integrate;
///
/// let quarter_circle = integrate(0.0, 1.0, |x: f64| x.acos());
/// assert!((quarter_circle - 1.0).abs() < 1e-5);
/// ```
#[inline(always)]
pub fn integrate<T, A>(lower: T, upper: T, formula: impl Fn(T) -> A) -> A
where
    T: Real,
    A: Copy + Add<Output = A> + Mul<T, Output = A>,
{
    let center = (lower + upper) * T::lit(0.5);
    let half = (upper - lower) * T::lit(0.5);
    let pair = |(node, weight): (f64, f64)| {
        let offset = half * T::lit(node);
        (formula(center - offset) + formula(center + offset)) * T::lit(weight)
    };
    let mut sum = pair(NODES[0]);
    for &node in &NODES[1..] {
        sum = sum + pair(node);
    }
    sum * half
}

/// Points of the lattice of [`mean_over_square`] and its step: neighbours in Fibonacci's sequence.
pub(crate) const LATTICE: u32 = 4181;
pub(crate) const STEP: u32 = 2584;
/// A row of the sum. The lattice has 37 of them; short sums lose fewer digits than a long one.
pub(crate) const ROW: u32 = 113;

/// The mean of `formula` over the unit square, by the 4181 points of a Fibonacci lattice.
///
/// For formulas that are smooth, or jump along a few lines, as samples do at the horizon. All
/// points weigh the same, so that the mean leaves the range of the formula by no
/// more than rounding.
///
/// ```
/// use brdf::quadrature::mean_over_square;
///
/// let quarter_disk = mean_over_square(|[x, y]: [f64; 2]| f64::from(u8::from(x * x + y * y < 1.0)));
/// assert!((quarter_disk - std::f64::consts::FRAC_PI_4).abs() < 2e-3);
/// ```
#[inline(always)]
pub fn mean_over_square<T, A>(formula: impl Fn([T; 2]) -> A) -> A
where
    T: Real,
    A: Copy + Add<Output = A> + Mul<T, Output = A>,
{
    let at = |index: u32| {
        let place = |number: u32| T::lit((f64::from(number) + 0.5) / f64::from(LATTICE));
        formula([place(index), place(index * STEP % LATTICE)])
    };
    let row = |row: u32| {
        let first = row * ROW;
        (first + 1..first + ROW).fold(at(first), |sum, index| sum + at(index))
    };
    let sum = (1..LATTICE / ROW).fold(row(0), |sum, index| sum + row(index));
    sum * T::lit(1.0 / f64::from(LATTICE))
}
