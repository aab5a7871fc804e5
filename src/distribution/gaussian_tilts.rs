//! The distribution function of the tilt of the facets of [`Gaussian`](super::Gaussian).

use core::f64::consts::{FRAC_PI_2, PI};

use crate::real::{Real, iterate, lift};

/// Terms of the polynomial, and of the recursion it comes from: enough for `f64` at every
/// roughness.
const TERMS: usize = 22;
const RECURSION: usize = 30;

/// From this exponent κ on the exponential is kept out of the series.
const NARROW: f64 = 1.25;

/// A number that is 0 here and that every number can represent.
const TINY: f64 = 1e-37;

/// Coefficients (−π²)ᵏ/(2k + 1)! of sin(π√s)/(π√s) in powers of s.
const SINE: [f64; RECURSION] = {
    let mut coefficients = [1.0; RECURSION];
    let mut k = 1;
    while k < RECURSION {
        let even = 2.0 * k as f64;
        coefficients[k] = coefficients[k - 1] * -(PI * PI) / (even * (even + 1.0));
        k += 1;
    }
    coefficients
};

/// The part of the facets that are tilted by less, and by more, than an angle θ_h.
///
/// With s = (θ_h/(π/2))² and κ = (π/2)²/α² the parts are integrals of exp(−κs) sin(π√s)/(π√s), an
/// exponential times an entire function. The integral of such a product is of the same kind,
///
/// ```text
/// below(s) = A (1 − exp(−ρs)) + exp(−ρs) s P(s)
/// above(s) = exp(−ρs) (A − s P(s)) − exp(−ρ) (A − P(1))
/// ```
///
/// with a polynomial P whose coefficients follow from a recursion. Narrow distributions take
/// ρ = κ; for wide ones that recursion would cancel, and the exponential, which hardly falls, is
/// expanded into P too: ρ = 0. `below` is a sum of positive terms where it is small, so that it
/// keeps its digits there; so does `above` for narrow distributions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tilts<T> {
    /// κ.
    exponent: T,
    /// ρ/κ, 1 or 0.
    narrow: T,
    /// A.
    front: T,
    /// P, lowest power first.
    polynomial: [T; TERMS],
    /// exp(−ρ) (A − P(1)), what is beyond the horizon.
    beyond: T,
    /// The density of s at 0.
    density: T,
}

lift! {
    [T: Real] Tilts<T> => Tilts<U>:
    Tilts {
        exponent: number,
        narrow: number,
        front: number,
        polynomial: numbers,
        beyond: number,
        density: number
    }
}

impl<T: Real> Tilts<T> {
    /// For a given (π/2)/α. Also the integral over 0 … 1 before it is scaled to 1.
    pub(super) fn new(root: T) -> (Self, T) {
        let (zero, one) = (T::zero(), T::one());
        let exponent = root.squared();
        let narrow = exponent.gt(T::lit(NARROW));

        // exp(−κs) R(s)/κ with R = g + R′/κ is an integral of exp(−κs) g(s).
        let inverse = one / exponent.max(T::lit(NARROW));
        let mut first = zero;
        let mut with_exponential = [zero; TERMS];
        for k in (0..RECURSION).rev() {
            if k < TERMS {
                with_exponential[k] = -first * inverse;
            }
            first = T::lit(SINE[k]) + T::lit((k + 1) as f64) * first * inverse;
        }

        // Coefficients of exp(−κs), term by term, times those of the sine.
        let flat = exponent.min(T::lit(NARROW));
        let mut product = [zero; TERMS];
        let mut power = one;
        for j in 0..TERMS {
            for k in j..TERMS {
                product[k] = product[k] + power * T::lit(SINE[k - j] / (k + 1) as f64);
            }
            power = power * -flat * T::lit(1.0 / (j + 1) as f64);
        }

        let mut polynomial = [zero; TERMS];
        for k in 0..TERMS {
            polynomial[k] = T::select(narrow, with_exponential[k], product[k]);
        }
        let kept = one.only_where(narrow);
        let rate = kept * exponent;
        let end = evaluate(&polynomial, one);
        let front = T::select(narrow, first * inverse, end);
        let all = front * -(-rate).exp_m1() + (-rate).exp() * end;
        let scale = one / all;
        for coefficient in &mut polynomial {
            *coefficient = *coefficient * scale;
        }
        let (front, end) = (front * scale, end * scale);
        let beyond = (-rate).exp() * (front - end);
        (Self { exponent, narrow: kept, front, polynomial, beyond, density: scale }, all)
    }

    /// The part tilted by less, or, if not `below`, by more than the angle with t = θ_h²/α² = κs.
    #[inline(always)]
    fn part(&self, t: T, below: T::Mask) -> T {
        let s = t / self.exponent;
        let falling = -self.narrow * t;
        let sum = s * evaluate(&self.polynomial, s);
        let exponential = falling.exp();
        let less = exponential * sum - self.front * falling.exp_m1();
        let more = exponential * (self.front - sum) - self.beyond;
        T::select(below, less, more)
    }

    /// The density of s at t = κs, at least a tiny number, and 1 − s.
    #[inline(always)]
    fn density_at(&self, t: T) -> (T, T) {
        let (one, tiny) = (T::one(), T::lit(TINY));
        let s = t / self.exponent;
        let to_end = (self.exponent - t) / self.exponent;
        // sin(π√s), from the nearer end, and over π√s.
        let root = s.sqrt();
        let near_end = s.gt(T::lit(0.25));
        let angle = T::lit(PI) * T::select(near_end, to_end / (one + root), root);
        let sine = T::select(root.gt(tiny), angle.sin() / (T::lit(PI) * root).max(tiny), one);
        (((-t).exp() * sine * self.density).max(tiny), to_end)
    }

    /// The angle, as a multiple of α, up to which the part `u` of the facets lies.
    ///
    /// The unknown is t = θ_h²/α², whose density exp(−t) sin(2θ_h)/(2θ_h) is nearly exponential. The
    /// smaller of the two parts is followed, so that each end keeps its digits. Above the median
    /// Newton's method needs a straight line: the logarithm of the part for narrow distributions,
    /// the square root for wide ones, which end at π/2 in a parabola.
    #[inline(always)]
    pub(super) fn angle(&self, u: T) -> T {
        let (zero, one, two, tiny) = (T::zero(), T::one(), T::lit(2.0), T::lit(TINY));
        let exponent = self.exponent;
        // Beyond t = 49 lies less than 10⁻²¹ of the facets.
        let last = exponent.min(T::lit(49.0));
        let lower_half = u.lt(T::lit(0.5));
        let narrow = exponent.gt(T::lit(27.0));
        let part = T::select(lower_half, u, one - u).max(tiny);

        // An exponential cut off at the last angle. Its rate takes in the fall of sin(2θ_h)/(2θ_h).
        let rate = one + T::lit(0.9 * FRAC_PI_2 * FRAC_PI_2) / exponent;
        let inside = -(-rate * last).exp_m1();
        let first = -(-part * inside).ln_1p();
        let second = -((one - inside) + inside * part).ln();
        let start = T::select(lower_half, first, second) / rate;

        // Short of the end, where the density is zero.
        let last = last * T::lit(1.0 - 1e-7);
        let t = iterate::<4, _>(
            start,
            #[inline(always)]
            |t: T| {
                let t = t.clamp(zero, last);
                let (density, to_end) = self.density_at(t);
                // The density bounds the part beyond from both sides. At the end, where that is a
                // difference of equal numbers, Newton's method would be lost without.
                let most = T::select(lower_half, one, density * to_end);
                let least = T::select(lower_half, tiny, most / (T::lit(3.0) + exponent - t));
                let facets = self.part(t, lower_half).min(most).max(least).max(tiny);
                let straight = T::select(
                    narrow,
                    facets * (facets / part).ln(),
                    two * (facets - (facets * part).sqrt()),
                );
                t + T::select(lower_half, part - facets, straight) * (exponent / density)
            },
        );
        let t = t.clamp(zero, last).as_solution_of(|t| {
            let slope = self.density_at(t).0 / exponent;
            (self.part(t, lower_half) - part, T::select(lower_half, slope, -slope))
        });
        t.sqrt()
    }
}

/// A polynomial, lowest power first.
#[inline(always)]
fn evaluate<T: Real>(coefficients: &[T; TERMS], s: T) -> T {
    coefficients.iter().rev().fold(T::zero(), |sum, &coefficient| sum * s + coefficient)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::integrate;

    /// ∫ exp(−κs) sin(π√s)/(π√s) ds by quadrature over x = θ_h/α, in which it is smooth.
    fn integral(exponent: f64, from: f64, to: f64) -> f64 {
        let root = exponent.sqrt();
        let ends = [from, to].map(|s: f64| (root * s.sqrt()).min(7.0));
        let sum = integrate(ends[0], ends[1], |x: f64| (-x * x).exp() * (PI * x / root).sin());
        2.0 / PI * sum / root
    }

    fn roughnesses() -> impl Iterator<Item = f64> {
        (0..=48).map(f64::from).flat_map(|i| [10.0_f64.powf(-8.0 + 0.25 * i), 0.1 + i / 24.0])
    }

    #[test]
    fn the_closed_form_is_the_integral() {
        for m in roughnesses() {
            let (tilts, all) = Tilts::new(FRAC_PI_2 / m);
            let whole = integral(tilts.exponent, 0.0, 1.0);
            assert!((all / whole - 1.0).abs() < 1e-14, "{m}: {all:e} {whole:e}");
            for step in 1..=40 {
                let s = (f64::from(step) / 40.0).powi(4) * (49.0 / tilts.exponent).min(1.0);
                let below = integral(tilts.exponent, 0.0, s) / whole;
                let above = integral(tilts.exponent, s, 1.0) / whole;
                assert!(
                    (tilts.part(s * tilts.exponent, true) / below - 1.0).abs() < 1e-13,
                    "{m} {s}"
                );
                assert!((tilts.part(s * tilts.exponent, false) - above).abs() < 1e-14, "{m} {s}");
                // The bounds between which the search keeps the part above.
                let sine = (PI * s.sqrt()).sin() / (PI * s.sqrt());
                let most = (1.0 - s) * (-tilts.exponent * s).exp() * sine * tilts.density;
                let least = most / (3.0 + tilts.exponent * (1.0 - s));
                let above = above + 1e-14;
                assert!(least <= above && above <= most + 2e-14, "{m} {s}: {least} {above} {most}");
            }
        }
    }

    /// The largest error of the distribution function: relative below the median, absolute above.
    fn worst_inversion<T: Real + Into<f64>>(epsilon: f64) -> f64 {
        let mut worst = 0.0_f64;
        for m in roughnesses() {
            let root = T::lit(FRAC_PI_2) / T::lit(m);
            let (tilts, _) = Tilts::new(root);
            let exponent = root.into().powi(2);
            let whole = integral(exponent, 0.0, 1.0);
            for j in 0..40 {
                let part = f64::from(j) / 40.0;
                for u in [part, 1e-30_f64.powf(part), 1.0 - epsilon.powf(part)] {
                    let u = T::lit(u.max(1e-30));
                    let s = tilts.angle(u).into().powi(2) / exponent;
                    let got = integral(exponent, 0.0, s) / whole;
                    let u: f64 = u.into();
                    let scale = if u < 0.5 { u } else { 1.0 };
                    worst = worst.max((got - u).abs() / scale);
                }
            }
        }
        worst
    }

    #[test]
    fn angles_invert_their_distribution_function() {
        let double = worst_inversion::<f64>(1e-16);
        assert!(double < 1e-13, "{double:e}");
        let single = worst_inversion::<f32>(6e-8);
        assert!(single < 2e-6, "{single:e}");
    }
}
