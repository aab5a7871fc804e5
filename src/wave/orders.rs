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

impl<T: Real> Orders<T> {
    /// Those that count in Σ gᵐ/(m! m) e^(−e/m); of e = 0 those with the masses.
    #[inline(always)]
    pub(super) fn new(g: T, e: T) -> Self {
        // The largest term solves y e^(2y) = e/g². Where the bounds count, there is none to speak of.
        let some = g.held().max(T::lit(1e-15));
        let spread = (e.held().min(T::lit(1e6) * some.max(T::one())) / some) / some;
        let peak = nearly(spread + spread).held() * T::lit(0.5);
        Self { g, many: g.ge(T::lit(Rule::of::<T>().many)), peak }
    }

    /// Where there are so many that they are taken in steps.
    #[inline(always)]
    pub(super) fn are_many(&self) -> T::Mask {
        self.many
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
        let (one, rule) = (T::one(), Rule::of::<T>());
        let g = self.g.min(T::lit(rule.many));
        let half = T::lit(f64::from(rule.count / 2));
        let first = (g.held() * self.peak.exp() - half).floor();
        let later = first.ge(T::lit(rule.least));
        let first = T::select(later, first, T::lit(rule.least));
        let some = g.max(T::lit(1e-30));
        let exponent = first * (some / first).ln() + first - some - stirling(one / first);
        let mass = exponent.exp() / (first * T::lit(TAU)).sqrt() / some;
        let mut factor = T::select(later, mass, (-g).exp()).only_where(self.many.not());
        let mut order = T::select(later, first, one);
        for _ in 0..rule.count {
            let inverse = one / order;
            visit(Order { inverse, factor, exponent: T::zero() });
            order = order + one;
            factor = factor * g / order;
        }
    }

    #[inline(always)]
    fn visit_many(&self, visit: &mut impl FnMut(Order<T>)) {
        let (one, half, rule) = (T::one(), T::lit(0.5), Rule::of::<T>());
        let g = self.g.max(T::lit(rule.many));
        let peak = self.peak;
        let root = (peak * half).exp();
        // −1 over the second derivative of the exponent is the square of the width.
        let width = one / (g.held().sqrt() * root * (one + peak + peak).sqrt());
        let step = width * T::lit(rule.step);
        // The mass of a step over 1/g: g m step/√(2π m) e^(−g φ − …).
        let scale = (g * step * g.sqrt() * T::lit(FRAC_1_SQRT_TAU)).only_where(self.many);
        let ratio = (step * half).exp();
        let mut one_side = |ratio: T, step: T, skipped: u32, count: u32| {
            let inverse_ratio = one / ratio;
            let (mut up, mut down, mut y) = (root, one / root, peak);
            for index in 0..=count {
                if index >= skipped {
                    let inverse = down * down / g;
                    let exponent = -(g * phi(y, up * up) + stirling(inverse));
                    visit(Order { inverse, factor: scale * up, exponent });
                }
                up = up * ratio;
                down = down * inverse_ratio;
                y = y + step;
            }
        };
        let [below, above] = rule.steps;
        one_side(one / ratio, -step, 0, below);
        one_side(ratio, step, 1, above);
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
    // Σ (k − 1) yᵏ/k! from k = 2 on.
    const TERMS: [f64; 12] = [
        1.0 / 2.0,
        2.0 / 6.0,
        3.0 / 24.0,
        4.0 / 120.0,
        5.0 / 720.0,
        6.0 / 5040.0,
        7.0 / 40320.0,
        8.0 / 362_880.0,
        9.0 / 3_628_800.0,
        10.0 / 39_916_800.0,
        11.0 / 479_001_600.0,
        12.0 / 6_227_020_800.0,
    ];
    let (terms, end) = if T::SPACING < 1e-10 { (&TERMS[..], 0.3) } else { (&TERMS[..10], 0.8) };
    let series = terms.iter().rev().fold(T::zero(), |sum, term| sum * y + T::lit(*term));
    let near = y.abs().lt(T::lit(end));
    T::select(near, series * y.squared(), power * (y - T::one()) + T::one())
}

/// Σ gᵐ e^(−g)/(m! m) e^(−e/m), over g of few orders, times g of [many](Orders::are_many): what a surface scatters of a
/// phase variance g in a direction with e = v_xy² τ²/4, but for a factor.
#[inline(always)]
pub(super) fn scattered<T: Real>(orders: &Orders<T>, e: T) -> T {
    let mut sum = T::zero();
    orders.visit(|Order { inverse, factor, exponent }| {
        sum = sum + factor * inverse * (exponent - e * inverse).exp();
    });
    sum
}

#[cfg(test)]
mod tests {
    use super::{Orders, scattered};
    use crate::real::Real;

    /// g, e and the sum, by 40 digits.
    #[rustfmt::skip]
    const SUMS: [[f64; 3]; 78] = [
        [1e-12, 0.0, 9.9999999999925e-13],
        [1e-12, 0.1, 9.0483741803529254e-13],
        [1e-12, 2.0, 1.3533528323656933e-13],
        [1e-12, 12.0, 6.1442123539417536e-18],
        [1e-3, 0.0, 0.00099925030546876902],
        [1e-3, 0.1, 0.00090417065624416858],
        [1e-3, 2.0, 0.00013529192203584682],
        [1e-3, 12.0, 6.7581569146354075e-9],
        [0.25, 0.0, 0.20757800281243345],
        [0.25, 0.1, 0.18843338036958838],
        [0.25, 2.0, 0.031193638212116428],
        [0.25, 12.0, 4.5440699129228806e-5],
        [1.0, 0.0, 0.48482910699568765],
        [1.0, 0.1, 0.4445569713547588],
        [1.0, 2.0, 0.09691908696705369],
        [1.0, 12.0, 0.00086466144639931205],
        [4.0, 0.0, 0.32358906727260325],
        [4.0, 0.4, 0.26910828484499572],
        [4.0, 8.0, 0.028436949671448242],
        [4.0, 48.0, 4.1647209006650305e-5],
        [9.0, 0.0, 0.12774196339646911],
        [9.0, 0.9, 0.11120438724557905],
        [9.0, 18.0, 0.013668492697964775],
        [9.0, 108.0, 6.8563035887664216e-6],
        [16.0, 0.0, 0.067021184070577105],
        [16.0, 1.6, 0.059689699998295632],
        [16.0, 32.0, 0.007982062169701438],
        [16.0, 192.0, 2.0527029595246771e-6],
        [23.5, 0.0, 0.044542076281232919],
        [23.5, 2.35, 0.039911521185659533],
        [23.5, 47.0, 0.0055297946158077172],
        [23.5, 282.0, 9.7091206372704316e-7],
        [24.5, 0.0, 0.042638419011690879],
        [24.5, 2.45, 0.038223762538146467],
        [24.5, 49.0, 0.0053124071194192876],
        [24.5, 294.0, 8.9806719811719114e-7],
        [30.0, 0.0, 0.034527121791989561],
        [30.0, 3.0, 0.031012514529935244],
        [30.0, 60.0, 0.0043682788561642646],
        [30.0, 360.0, 6.2046359878093817e-7],
        [40.0, 0.0, 0.025658862785975127],
        [40.0, 4.0, 0.023093588378377963],
        [40.0, 80.0, 0.003301877288989628],
        [40.0, 480.0, 3.768879395058451e-7],
        [55.5, 0.0, 0.018355048627813273],
        [55.5, 5.550000000000001, 0.016546277551764596],
        [55.5, 111.0, 0.002395664806991259],
        [55.5, 666.0, 2.2189024758923585e-7],
        [56.5, 0.0, 0.018024097127459863],
        [56.5, 5.65, 0.016249086483802355],
        [56.5, 113.0, 0.0023539875346525602],
        [56.5, 678.0, 2.1581363535742163e-7],
        [80.0, 0.0, 0.012660310554032884],
        [80.0, 8.0, 0.011426402813732953],
        [80.0, 160.0, 0.0016709143706323191],
        [80.0, 960.0, 1.2841550458041287e-7],
        [300.0, 0.0, 0.0033445192693037826],
        [300.0, 30.0, 0.0030242575606648312],
        [300.0, 600.0, 0.00044962065704422588],
        [300.0, 3600.0, 2.3915374210563504e-8],
        [5000.0, 0.0, 0.00020004001600960769],
        [5000.0, 500.0, 0.0001809966278675616],
        [5000.0, 10000.0, 2.7061644680723761e-5],
        [5000.0, 60000.0, 1.2409046757328358e-9],
        [1e5, 0.0, 1.000010000200006e-5],
        [1e5, 10000.0, 9.0484470208333041e-6],
        [1e5, 200000.0, 1.3533392990182575e-6],
        [1e5, 1200000.0, 6.1472232619120345e-11],
        [1e6, 0.0, 1.000001000002e-6],
        [1e6, 100000.0, 9.0483814643114263e-7],
        [1e6, 2000000.0, 1.353351479015099e-7],
        [1e6, 12000000.0, 6.1445134221789104e-12],
        [0.5, 300.0, 4.5785639615587416e-24],
        [1.0, 2000.0, 7.8979795335578869e-62],
        [20.0, 2000.0, 8.2267336904660981e-27],
        [50.0, 9000.0, 4.3721445794965691e-50],
        [60.0, 9000.0, 1.4626153564886885e-45],
        [1000.0, 200000.0, 5.2076225070918705e-84],
    ];

    fn sum<T: Real + Into<f64>>(g: f64, e: f64) -> f64 {
        let orders = Orders::new(T::lit(g), T::lit(e));
        let series: f64 = scattered(&orders, T::lit(e)).into();
        let many: f64 = T::select(orders.are_many(), T::one(), T::zero()).into();
        if many > 0.0 { series / g } else { series * g }
    }

    #[test]
    fn sums_have_their_values() {
        let mut worst = [0.0_f64; 2];
        for [g, e, want] in SUMS {
            let off = (sum::<f64>(g, e) / want - 1.0).abs();
            worst[0] = worst[0].max(off);
            assert!(off < 5e-14, "{g} {e}: {off:e}");
            if want > 1e-30 {
                // The exponents of single numbers have their own rounding.
                let exponent = (want / g.min(1.0 / g)).ln().abs();
                let off = (sum::<f32>(g, e) / want - 1.0).abs() / (1.0 + exponent);
                worst[1] = worst[1].max(off);
                assert!(off < 4e-7, "{g} {e}: {off:e}");
            }
        }
        println!("{worst:?}");
    }
}
