use core::f64::consts::FRAC_1_PI;

use super::spread::{Spread, Spreads};
use super::traits::Distribution;
use crate::parameter::model;
use crate::real::{Real, Vector};
use crate::sampling::uniform;

model! {
    /// The generalised distribution of Trowbridge and Reitz: the power γ of GGX's denominator, normalised.
    ///
    /// # Formula
    /// ```text
    /// D = (γ − 1)(α² − 1)/(π (1 − α^(2(1 − γ)))) (1 + (α² − 1) cos²θ_h)^(−γ)
    /// D = (α² − 1)/(π ln α²) (1 + (α² − 1) cos²θ_h)⁻¹                          γ = 1
    /// ```
    parameters {
        roughness: T, ROUGHNESS, "α", "roughness";
        gamma: T, GAMMA, "γ", "how short the tail is: 1 is Berry's distribution, 2 is GGX";
    }
    constants {
        let (one, rough) = (T::one(), T::one().lt(roughness));
        let logarithm = T::lit(2.0) * roughness.ln();
        let rising = (one - gamma) * logarithm;
        let squared = roughness.squared();
        /// D at the smaller of the densities at the normal and at grazing, inverted: see `density_along`.
        peak: T = T::lit(FRAC_1_PI) * T::select(rough, one, one / squared)
            * (slope(logarithm) / slope(T::select(rough, rising, -rising)));
        /// |1 − α²|, over α² for α < 1.
        excess: T = T::select(rough, squared, one / squared) - one;
        /// ln α².
        log_square: T = logarithm;
    }
    /// | θ_h | | angle between h and the normal | 0 … π/2 |
    ///
    /// γ = 1 and α = 1, where the printed forms are 0/0, are as good as their neighbours: both are
    /// quotients (eˣ − 1)/x, and D = 1/π for α = 1.
    ///
    /// # Energy
    /// Normalised, ∫ D cosθ_h dω = 1. Smith's shadowing is not known in closed form but for γ = 2.
    /// The albedo at the normal of a [`CookTorrance`](crate::CookTorrance) surface with V-cavities loses digits for the
    /// smallest roughnesses: with γ = 30 it is good to 10⁻⁶ from α = 10⁻⁶ on, and too small by 0.4 % at
    /// 10⁻⁷ and by 0.6 % at 10⁻⁸.
    ///
    /// # Sources
    /// B. Burley, *Physically-Based Shading at Disney*, SIGGRAPH 2012 course, appendix B. γ = 1: E. M.
    /// Berry 1923.
    ///
    /// ```
    /// use brdf::{Distribution, Ggx, Gtr};
    /// use glam::DVec3;
    ///
    /// let h = DVec3::new(0.6, 0.0, 0.8);
    /// let (gtr, ggx) = (Gtr::new(0.3_f64, 2.0)?, Ggx::new(0.3)?);
    /// assert!((gtr.density(h) / ggx.density(h) - 1.0).abs() < 1e-14);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("Berry", "GTR1"))]
    pub struct Gtr<T = f32>;

    /// The distribution with the given roughness and power.
    pub fn new;
}

/// (eˣ − 1)/x, 1 at 0.
fn slope<T: Real>(x: T) -> T {
    let (zero, one) = (T::zero(), T::one());
    let near = x.abs().lt(T::lit(1e-2));
    let series = [7.0, 6.0, 5.0, 4.0, 3.0, 2.0]
        .into_iter()
        .fold(one, |sum, divisor| one + x * T::lit(1.0 / divisor) * sum);
    let far = T::select(near, one, x);
    T::select(near, series, far.exp_m1() / far).max(zero)
}

impl<T: Real> Gtr<T> {
    /// 1 + (α² − 1) cos²θ_h, of h or of what is longer, as |h|² and what is added to its smallest multiple.
    #[inline(always)]
    fn rest(&self, along: T, across: T) -> T {
        self.excess * T::select(T::one().lt(self.roughness), along, across)
    }
}

impl<T: Real> Distribution<T> for Gtr<T> {
    #[inline(always)]
    fn density(&self, h: T::Vec3) -> T {
        self.density_along(h)
    }

    /// For α < 1, where D is largest at the normal, D = D(0) (1 + sin²θ_h (1 − α²)/α²)^(−γ), otherwise
    /// D = D(π/2) (1 + cos²θ_h (α² − 1))^(−γ): a power of a part of a whole.
    #[inline(always)]
    fn density_along(&self, m: T::Vec3) -> T {
        let (least, bound) = (T::lit(4.0) / T::max_finite(), T::lit(1e20));
        let (along, across) = (m.z().squared(), m.x().squared() + m.y().squared());
        let whole = (along + across).max(least).min(bound);
        let rest = self.rest(along, across).min(T::lit(1e37));
        // The power of a part that is no normal number is 0.
        let rest = rest.min(whole * T::lit(1e36));
        let power = whole.power_of_part(rest, self.gamma);
        (self.peak * power).min(T::max_finite()).only_where(m.z().gt(T::zero()))
    }

    /// q = 1 + (α² − 1) cos²θ_h goes from α² to 1, and q^(1 − γ) evenly. Of ln q the first number takes the part ψ
    /// from ln α² to 0: sin²θ_h is in proportion to α² (α^(−2ψ) − 1), cos²θ_h to 1 − α^(2(1 − ψ)).
    #[inline(always)]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        let ([u, turn], one) = (uniform(u), T::one());
        let part = self.part(u);
        let rest = one - part;
        let across = self.roughness.squared() * part * slope(-(self.log_square * part));
        let along = rest * slope(self.log_square * rest);
        let (sin_phi, cos_phi) = turn.sin_cos_turns();
        let scale = one / (across + along).max(T::lit(1e-36));
        let (sin, cos) = ((across * scale).sqrt(), (along * scale).sqrt());
        Vector::normalize_or_normal(Vector::new(sin * cos_phi, sin * sin_phi, cos))
    }

    fn spreads(&self) -> Option<Spreads<T>> {
        Spread::trowbridge(self.roughness, self.gamma, self.peak).of_all()
    }
}

impl<T: Real> Gtr<T> {
    /// ψ = ln(1 − u + u eᵗ)/t with t = (γ − 1) ln α², u where t is 0. What t > 0 has is 1 − ψ of 1 − u and −t.
    #[inline(always)]
    fn part(&self, u: T) -> T {
        let (one, half) = (T::one(), T::lit(0.5));
        let t = (self.gamma - one) * self.log_square;
        let positive = t.gt(T::zero());
        let t = T::select(positive, -t, t);
        let v = T::select(positive, one - u, u);
        let even = t.gt(T::lit(-1e-4));
        let steep = T::select(even, -one, t);
        let low = (v * steep.exp_m1()).max(T::lit(-0.9)).ln_1p();
        let high = ((one - v) + v * steep.exp()).max(T::lit(1e-37)).ln();
        let part = T::select(v.lt(half), low, high) / steep;
        let series =
            v * (one + (one - v) * half * t * (one + (one - v - v) * t * T::lit(1.0 / 3.0)));
        let part = T::select(even, series, part).clamp(T::zero(), one);
        T::select(positive, one - part, part)
    }
}
