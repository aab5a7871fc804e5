//! The orders of scattering at a rough surface, which are distributed as Poisson says.

use core::f64::consts::TAU;

use super::lambert_w::nearly;
use crate::real::{Mask, Real};

/// The orders m = 1, 2, … of a phase variance g, and their masses e^(−g) gᵐ/m!.
///
/// Few of them are visited, however large g is. Below a g of 24 in `f32`, 56 in `f64`, these are orders one by one, in a window
/// around the largest term of the sum in question. Above, the sum over m is an integral to rounding, as its
/// terms are smooth; it is taken in equal steps of y = ln(m/g) around the largest term, at which there
/// are no logarithms to take: m ln(m/g) − m + g = g φ(y) with φ = eʸ (y − 1) + 1, and Stirling's series is
/// good for all the masses that count.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orders<T: Real> {
    g: T,
    many: T::Mask,
    /// The y of the largest term.
    peak: T,
}

/// What is visited: an order or a step, and how much it counts.
pub(super) struct Order<T> {
    /// 1/m.
    pub(super) inverse: T,
    /// Its mass is this times the power of e to that: in units of g of few, of 1/g of many.
    ///
    /// So Σ gᵐ e^(−g)/(m! m) e^(−e/m) keeps its digits, which is g times a sum near 1 or that over g.
    pub(super) factor: T,
    pub(super) exponent: T,
}

/// 1/√(2π).
const FRAC_1_SQRT_TAU: f64 = 0.398_942_280_401_432_7;

/// How finely a number has to be summed.
struct Rule {
    /// From this g on there are many orders.
    many: f64,
    /// Orders one by one, of few.
    count: u32,
    /// The least beginning of the window beside 1: Stirling's series is good from there.
    least: f64,
    /// Steps below and above the largest term, of many.
    steps: [u32; 2],
    /// A step over the width of the term.
    step: f64,
}

const SINGLE: Rule = Rule { many: 24.0, count: 54, least: 4.0, steps: [11, 6], step: 0.9 };
const DOUBLE: Rule = Rule { many: 56.0, count: 144, least: 16.0, steps: [23, 16], step: 0.6 };

impl Rule {
    const fn of<T: Real>() -> &'static Self {
        if T::SPACING < 1e-10 { &DOUBLE } else { &SINGLE }
    }
}

/// Where there are so many that they are taken in steps.
#[inline(always)]
pub(super) fn are_many<T: Real>(g: T) -> T::Mask {
    g.ge(T::lit(Rule::of::<T>().many))
}

impl<T: Real> Orders<T> {
    /// Those that count in Σ gᵐ/(m! m) e^(−e/m); of e = 0 those with the masses.
    #[inline(always)]
    pub(super) fn new(g: T, e: T) -> Self {
        // The largest term solves y e^(2y) = e/g². Where the bounds count, there is none to speak of.
        let some = g.held().max(T::lit(1e-15));
        let spread = (e.held().min(T::lit(1e6) * some.max(T::one())) / some) / some;
        let peak = nearly(spread + spread).held() * T::lit(0.5);
        Self::around(g, peak)
    }

    /// Those of a g, with the y of the largest term.
    #[inline(always)]
    pub(super) fn around(g: T, peak: T) -> Self {
        Self { g, many: are_many(g), peak }
    }

    #[inline(always)]
    pub(super) fn peak(&self) -> T {
        self.peak
    }

    #[inline(always)]
    pub(super) fn visit(&self, mut visit: impl FnMut(Order<T>)) {
        if !self.many.not().is_never() {
            self.visit_few(&mut visit);
        }
        if !self.many.is_never() {
            self.visit_many(&mut visit);
        }
    }

    #[inline(always)]
    fn visit_few(&self, visit: &mut impl FnMut(Order<T>)) {
        let mut few = Few::first(self);
        for _ in 0..Few::<T>::COUNT {
            visit(few.order());
            few = few.next();
        }
    }

    #[inline(always)]
    fn visit_many(&self, visit: &mut impl FnMut(Order<T>)) {
        for side in Many::<T>::SIDES {
            let mut many = Many::first(self, side);
            for _ in 0..side.count {
                visit(many.order());
                many = many.next();
            }
        }
    }
}

/// Where a number is at in orders that are taken one by one.
#[derive(Clone, Copy)]
pub(super) struct Few<T> {
    /// The order, one over it, and its factor.
    pub(super) at: [T; 3],
    /// g and one over it.
    pub(super) g: [T; 2],
}

impl<T: Real> Few<T> {
    /// How many are taken.
    pub(super) const COUNT: u32 = Rule::of::<T>().count;

    #[inline(always)]
    pub(super) fn first(orders: &Orders<T>) -> Self {
        let (one, rule) = (T::one(), Rule::of::<T>());
        let g = orders.g.min(T::lit(rule.many));
        let half = T::lit(f64::from(rule.count / 2));
        let first = (g.held() * orders.peak.exp() - half).floor();
        let later = first.ge(T::lit(rule.least));
        let first = T::select(later, first, T::lit(rule.least));
        let some = g.max(T::lit(1e-30));
        let exponent = first * (some / first).ln() + first - some - stirling(one / first);
        let mass = exponent.exp() / (first * T::lit(TAU)).sqrt() / some;
        let factor = T::select(later, mass, (-g).exp()).only_where(orders.many.not());
        let order = T::select(later, first, one);
        Self { at: [order, one / order, factor], g: [g, one / some] }
    }

    #[inline(always)]
    pub(super) fn order(&self) -> Order<T> {
        let [_, inverse, factor] = self.at;
        Order { inverse, factor, exponent: T::zero() }
    }

    #[inline(always)]
    pub(super) fn next(self) -> Self {
        let Self { at: [order, _, factor], g: [g, inverse_g] } = self;
        let order = order + T::one();
        // One quotient, and two roundings of the factor a step. Where g is next to 0 so is the factor.
        let ratio = g / order;
        Self { at: [order, ratio * inverse_g, factor * ratio], ..self }
    }
}

/// One of the sides of the largest term.
#[derive(Clone, Copy)]
pub(super) struct Side {
    below: bool,
    pub(super) count: u32,
}

/// Where a number is at in many orders, taken in steps.
#[derive(Clone, Copy)]
pub(super) struct Many<T> {
    /// √eʸ, one over it, and y.
    pub(super) at: [T; 3],
    pub(super) pace: Pace<T>,
}

/// What stays the same from step to step.
#[derive(Clone, Copy)]
pub(super) struct Pace<T> {
    pub(super) g: T,
    pub(super) inverse_g: T,
    pub(super) scale: T,
    /// What every step multiplies √eʸ by and its inverse by, and adds to y.
    pub(super) ratio: T,
    pub(super) inverse_ratio: T,
    pub(super) step: T,
}

impl<T: Real> Many<T> {
    pub(super) const SIDES: [Side; 2] = {
        let [below, above] = Rule::of::<T>().steps;
        [Side { below: true, count: below + 1 }, Side { below: false, count: above }]
    };

    /// The largest term itself, and below it; or the first above it.
    #[inline(always)]
    pub(super) fn first(orders: &Orders<T>, side: Side) -> Self {
        let (one, half, rule) = (T::one(), T::lit(0.5), Rule::of::<T>());
        let g = orders.g.max(T::lit(rule.many));
        let peak = orders.peak;
        let root = (peak * half).exp();
        // −1 over the second derivative of the exponent is the square of the width.
        let width = one / (g.held().sqrt() * root * (one + peak + peak).sqrt());
        let step = width * T::lit(rule.step);
        // The mass of a step over 1/g: g m step/√(2π m) e^(−g φ − …).
        let scale = (g * step * g.sqrt() * T::lit(FRAC_1_SQRT_TAU)).only_where(orders.many);
        let up = (step * half).exp();
        let (down, inverse_g) = (one / up, one / g);
        let at = [root, one / root, peak];
        if side.below {
            let pace = Pace { g, inverse_g, scale, ratio: down, inverse_ratio: up, step: -step };
            Self { at, pace }
        } else {
            Self { at, pace: Pace { g, inverse_g, scale, ratio: up, inverse_ratio: down, step } }
                .next()
        }
    }

    #[inline(always)]
    pub(super) fn order(&self) -> Order<T> {
        let Self { at: [up, down, y], pace: Pace { g, inverse_g, scale, .. } } = *self;
        let inverse = down * down * inverse_g;
        let exponent = -(g * phi(y, up * up) + stirling(inverse));
        Order { inverse, factor: scale * up, exponent }
    }

    #[inline(always)]
    pub(super) fn next(self) -> Self {
        let Self { at: [up, down, y], pace } = self;
        Self { at: [up * pace.ratio, down * pace.inverse_ratio, y + pace.step], pace }
    }
}

/// ln m! − (m ln m − m + ln √(2π m)) of 1/m.
#[inline(always)]
fn stirling<T: Real>(inverse: T) -> T {
    let square = inverse.squared();
    let lit = T::lit;
    let rest = lit(1.0 / 1260.0) - square * (lit(1.0 / 1680.0) - square * lit(1.0 / 1188.0));
    inverse * (lit(1.0 / 12.0) - square * (lit(1.0 / 360.0) - square * rest))
}

/// eʸ (y − 1) + 1 of y and eʸ.
#[inline(always)]
fn phi<T: Real>(y: T, power: T) -> T {
    let (series, end) = if T::SPACING < 1e-10 {
        (phi_series::<_, 12>(y), 0.3)
    } else {
        (phi_series::<_, 10>(y), 0.8)
    };
    let near = y.abs().lt(T::lit(end));
    T::select(near, series * y.squared(), power * (y - T::one()) + T::one())
}

/// `N` terms of Σ (k − 1) yᵏ⁻²/k! from k = 2 on.
#[inline(always)]
fn phi_series<T: Real, const N: usize>(y: T) -> T {
    let terms = const { phi_terms::<N>() };
    let mut sum = T::zero();
    for index in (0..N).rev() {
        sum = sum * y + T::lit(terms[index]);
    }
    sum
}

const fn phi_terms<const N: usize>() -> [f64; N] {
    let (mut terms, mut index, mut factorial) = ([0.0; N], 0, 1.0);
    while index < N {
        let before = (index + 1) as f64;
        factorial *= before + 1.0;
        terms[index] = before / factorial;
        index += 1;
    }
    terms
}
