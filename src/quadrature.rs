//! Integrals: Gauss–Legendre nodes on a line, a lattice on the unit square.

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use core::ops::{Add, Mul};

use crate::direction::above_or_normal;
use crate::real::{Color, Real, Vector};

/// The positive nodes of the Legendre polynomial of degree 48 on [−1, 1], with their weights.
pub(crate) const NODES_48: [(f64, f64); 24] = [
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

/// The same for degree 32.
pub(crate) const NODES_32: [(f64, f64); 16] = [
    (0.04830766568773832, 0.0965400885147278),
    (0.1444719615827965, 0.09563872007927486),
    (0.23928736225213706, 0.09384439908080457),
    (0.33186860228212767, 0.09117387869576389),
    (0.42135127613063533, 0.08765209300440381),
    (0.5068999089322294, 0.08331192422694675),
    (0.5877157572407623, 0.07819389578707031),
    (0.6630442669302152, 0.0723457941088485),
    (0.7321821187402897, 0.06582222277636185),
    (0.7944837959679424, 0.058684093478535544),
    (0.84936761373257, 0.050998059262376175),
    (0.8963211557660521, 0.04283589802222668),
    (0.9349060759377397, 0.03427386291302143),
    (0.9647622555875064, 0.02539206530926206),
    (0.9856115115452684, 0.01627439473090567),
    (0.9972638618494816, 0.007018610009470096),
];

/// The same for degree 24.
pub(crate) const NODES_24: [(f64, f64); 12] = [
    (0.06405689286260563, 0.12793819534675216),
    (0.1911188674736163, 0.1258374563468283),
    (0.3150426796961634, 0.12167047292780339),
    (0.4337935076260451, 0.1155056680537256),
    (0.5454214713888396, 0.10744427011596563),
    (0.6480936519369755, 0.09761865210411388),
    (0.7401241915785544, 0.08619016153195327),
    (0.820001985973903, 0.0733464814110803),
    (0.8864155270044011, 0.05929858491543678),
    (0.9382745520027328, 0.04427743881741981),
    (0.9747285559713095, 0.028531388628933663),
    (0.9951872199970213, 0.0123412297999872),
];

/// The same for degree 16.
pub(crate) const NODES_16: [(f64, f64); 8] = [
    (0.09501250983763744, 0.1894506104550685),
    (0.2816035507792589, 0.18260341504492358),
    (0.45801677765722737, 0.16915651939500254),
    (0.6178762444026438, 0.14959598881657674),
    (0.755404408355003, 0.12462897125553388),
    (0.8656312023878318, 0.09515851168249279),
    (0.9445750230732326, 0.062253523938647894),
    (0.9894009349916499, 0.027152459411754096),
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
    integrate_with(&NODES_48, lower, upper, formula)
}

/// The same by other nodes.
#[inline(always)]
pub(crate) fn integrate_with<T, A, const N: usize>(
    nodes: &[(f64, f64); N],
    lower: T,
    upper: T,
    formula: impl Fn(T) -> A,
) -> A
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
    let mut sum = pair(nodes[0]);
    for &node in &nodes[1..] {
        sum = sum + pair(node);
    }
    sum * half
}

/// ∫ `formula` dωᵢ over the hemisphere, of light and viewer, for what does not change when the surface is turned or
/// mirrored.
///
/// Cut where light and viewer are equally high. What is narrow may be so where an azimuth or a height has its end:
/// around the viewer, around the mirror direction, and at the horizon.
pub(crate) fn over_hemisphere<T: Real, C: Color<T>>(
    wo: T::Vec3,
    formula: impl Fn(T::Vec3, T::Vec3) -> C,
) -> C {
    let (zero, one) = (T::zero(), T::one());
    let w = Vector::normalize_or_normal(above_or_normal::<T, T::Vec3>(wo));
    let sin = (w.x().squared() + w.y().squared()).sqrt();
    let (theta, viewer) = (sin.atan2(w.z()), Vector::new(sin, zero, w.z()));
    let part = |from: T, to: T| {
        integrate(zero, one, |s: T| {
            let (step, slope) = crowded(s);
            let (sin, cos) = (from + (to - from) * step).sin_cos();
            let ring = integrate(zero, one, |t: T| {
                let (turn, density) = crowded(t);
                let (sin_phi, cos_phi) = (turn * T::lit(PI)).sin_cos();
                let wi = Vector::new(sin * cos_phi, sin * sin_phi, cos.max(T::lit(1e-18)));
                formula(wi, viewer) * density
            });
            ring * (T::lit(TAU) * sin * slope * (to - from))
        })
    };
    part(zero, theta) + part(theta, T::lit(FRAC_PI_2))
}

/// t³(10 − 15t + 6t²), which crowds next to both ends, and its slope.
#[inline(always)]
fn crowded<T: Real>(t: T) -> (T, T) {
    let (ten, fifteen, six) = (T::lit(10.0), T::lit(15.0), T::lit(6.0));
    let rest = t * (T::one() - t);
    (t.squared() * t * (ten - t * (fifteen - six * t)), T::lit(30.0) * rest.squared())
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
