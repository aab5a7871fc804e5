use core::f64::consts::{FRAC_1_PI, TAU};

use super::mirror::{around_mirror, mean_cosine, mirror_versine, unit_viewer};
use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above};
use crate::parameter::model;
use crate::quadrature::integrate;
use crate::real::{Color, Mask, Real, Vector};
use crate::sampling::uniform;

model! {
    /// Schlick's rational lobe in place of Phong's power.
    ///
    /// # Formula
    /// ```text
    /// f = kₛ C · S/(h − hS + S)        S = max(0, R·V)        R = 2N(N·L) − L
    /// C = 1/(2πJ)        J = ∫₀¹ S²/(h − hS + S) dS        C = 1 in the unnormalised form
    /// ```
    parameters {
        specular: C, UNIT, "kₛ", "directional albedo at normal incidence";
        exponent: T, EXPONENT, "h", "exponent of the power that is replaced";
    }
    flags {
        normalized: true, "false is [`unnormalized`](Self::unnormalized)";
    }
    constants {
        let (y, excess) = artanh_excess(exponent);
        let twice_j = (T::one() + (T::one() + y).squared() * excess) / (exponent + T::one());
        /// C.
        c: T = if normalized { T::lit(FRAC_1_PI) / twice_j } else { T::one() };
    }
    ///
    /// Meant for h ≥ 1, where Sʰ ≈ S/(h − hS + S) has the same value at S = 0 and the same value and
    /// slope at S = 1; it stays well behaved down to h = 0, a constant. The tail is much heavier than
    /// the power's: half of the peak is reached at S = h/(h + 1).
    ///
    /// J = h² ln h/(h − 1)³ − h/(h − 1)² − 1/(2(h − 1)) cancels around h = 1, where it is ⅓. It is
    /// computed as J = (1 + (1 + y)² A)/(2(h + 1)) with y = (h − 1)/(h + 1) and
    /// A = (artanh y − y)/y³ = ⅓ + y²/5 + y⁴/7 + …, where nothing cancels.
    ///
    /// # Energy
    /// Reciprocal, to the last bit. Conserving with its own constant: the directional albedo is kₛ at
    /// normal incidence and lower elsewhere. Phong's constant (n + 2)/(2π) does not fit it: 1.64 kₛ
    /// for h = 10, 3.29 kₛ for h = 100. The [`unnormalized`](Self::unnormalized) form is **not**
    /// conserving for small h: kₛ/C is πkₛ for h = 0, 2.09 kₛ for h = 1, 0.86 kₛ for h = 10.
    ///
    /// The directional albedo is an integral over the angle to the mirror direction, the one around
    /// it being elementary; it is good to the last digits for h = 0 and h ≥ ½, to 10⁻⁷ between, where
    /// the lobe has a steep rim.
    ///
    /// # Sampling
    /// Around the mirror direction with density (h − 1)/(2π ln h) / (h − hS + S), which leaves the
    /// factor S to the weight and can be drawn exactly. Below h = 1 the density is that of h = 1, 1/2π,
    /// and the weight has the rest; so h = 1 is a kink of samples and densities, not of values.
    ///
    /// # Sources
    /// C. Schlick, *A Fast Alternative to Phong's Specular Model*, Graphics Gems IV, 1994, 385–387.
    ///
    /// ```
    /// use brdf::{Brdf, SchlickPower};
    /// use glam::DVec3;
    ///
    /// let plastic = SchlickPower::new(DVec3::ONE, 10.0)?;
    /// assert!((plastic.eval(DVec3::Z, DVec3::Z).x - 1.1630481883582457).abs() < 1e-14);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct SchlickPower<C = glam::Vec3, T = f32>;

    /// A lobe with the given albedo at normal incidence and exponent.
    pub fn new(normalized: true);
    /// The lobe f = kₛ S/(h − hS + S).
    pub fn unnormalized(normalized: false);
}

/// y = (h − 1)/(h + 1) and (artanh y − y)/y³, where artanh y = ½ ln h.
#[inline(always)]
fn artanh_excess<T: Real>(h: T) -> (T, T) {
    let one = T::one();
    let y = (h - one) / (h + one);
    let y_squared = y * y;
    // The series to the last digit for |y| < ½, the difference beyond, where it keeps its digits.
    let small = y.abs().lt(T::lit(0.5));
    let reduced = y_squared.only_where(small);
    let series = (0..26)
        .rev()
        .fold(T::zero(), |sum, term| sum * reduced + T::lit(1.0 / f64::from(2 * term + 3)));
    let y_large = T::select(small, one, y);
    // At h = 0 the logarithm meets a factor (1 + y)² = 0.
    let artanh = T::select(small, one, h.max(T::lit(1e-30))).ln() * T::lit(0.5);
    (y, T::select(small, series, (artanh - y_large) / (y_large * y_large * y_large)))
}

/// ln h/(h − 1), which is 1 for h = 1: ∫₀¹ dS/(h − hS + S).
#[inline(always)]
fn logarithm_over_growth<T: Real>(h: T) -> T {
    let (y, excess) = artanh_excess(h);
    T::lit(2.0) / (h + T::one()) * (T::one() + y * y * excess)
}

/// (eˣ − 1)/x, which is 1 for x = 0.
#[inline(always)]
fn growth_over_logarithm<T: Real>(x: T) -> T {
    let one = T::one();
    // The series to the last digit for |x| < ½, as above. The quotient has no derivative at 0 and
    // loses that of its digits around it.
    let small = x.abs().lt(T::lit(0.5));
    let reduced = x.only_where(small);
    let series =
        (2..16).rev().fold(one, |sum, term| one + sum * reduced * T::lit(1.0 / f64::from(term)));
    let large = T::select(small, one, x);
    T::select(small, series, large.exp_m1() / large)
}

impl<T: Real, C> SchlickPower<C, T> {
    /// The exponent of the density of the samples. Below 1 the lobe is broader than a hemisphere
    /// of equal density, which then serves.
    #[inline(always)]
    fn sampled_exponent(&self) -> T {
        self.exponent.max(T::one())
    }

    /// ln h/(h − 1) of the sampled exponent: ∫₀¹ dS/(h − hS + S).
    #[inline(always)]
    fn sampled_integral(&self) -> T {
        logarithm_over_growth(self.sampled_exponent())
    }

    /// 1/(h − hS + S) of the sampled exponent, from 1 − S.
    #[inline(always)]
    fn sampled_shape(&self, versine: T) -> T {
        let one = T::one();
        one / (one + (self.sampled_exponent() - one) * versine)
    }

    /// 1 − S = (hᵘ − 1)/(h − 1) of the sampled exponent, which is u for h = 1.
    #[inline(always)]
    fn sampled_versine(&self, u: T) -> T {
        let growth = self.sampled_exponent() - T::one();
        let part = u * self.sampled_integral();
        // The lobe ends at a right angle from the mirror direction.
        (part * growth_over_logarithm(part * growth)).at_most(T::one())
    }

    /// The u for which [`sampled_versine`](Self::sampled_versine) answers this.
    #[inline(always)]
    fn uniform_of_versine(&self, versine: T) -> T {
        let growth = self.sampled_exponent() - T::one();
        let part = versine * logarithm_over_growth(T::one() + growth * versine);
        (part / self.sampled_integral()).at_most(T::one())
    }

    /// f cosθᵢ/pdf for kₛ = 1, for a direction at height `cos_i`.
    #[inline(always)]
    fn weight(&self, versine: T, cos_i: T) -> T {
        let scale = self.c * T::lit(TAU) * self.sampled_integral();
        scale * self.shape(versine) / self.sampled_shape(versine) * cos_i
    }

    /// S/(h − hS + S) from 1 − S; zero for S ≤ 0.
    #[inline(always)]
    fn shape(&self, versine: T) -> T {
        let one = T::one();
        let positive = versine.lt(one);
        let versine = versine.only_where(positive);
        let cos = one - versine;
        (cos / (self.exponent * versine + cos)).only_where(positive)
    }
}

impl<T: Real, C: Color<T>> Brdf<T> for SchlickPower<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let above = both_above::<T>(wi, wo);
        let value = self.c * self.shape(mirror_versine::<T>(wi, wo));
        (self.specular * value).only_where(above)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let versine = mirror_versine::<T>(wi, wo);
        let inside = both_above::<T>(wi, wo).and(versine.lt(T::one()));
        let versine = versine.only_where(inside);
        let density = self.sampled_shape(versine) / (T::lit(TAU) * self.sampled_integral());
        density.only_where(inside)
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let [u, turn] = uniform(u);
        let wi = around_mirror::<T>(wo, self.sampled_versine(u), turn);
        let pdf = self.pdf(wi, wo);
        // That of the rounded direction, for which `eval` and `pdf` answer: at the rim of the lobe
        // S is close to zero and its relative error large.
        let versine = mirror_versine::<T>(wi, wo);
        Sample { wi, weight: self.specular * self.weight(versine, wi.z()), pdf }
            .only_where(pdf.gt(T::zero()))
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        let (zero, one) = (T::zero(), T::one());
        let w = unit_viewer::<T>(wo);
        let sin = (w.x() * w.x() + w.y() * w.y()).sqrt();
        let mean_weight = |u: T| {
            let versine = self.sampled_versine(u);
            self.weight(versine, mean_cosine(sin, w.z(), versine))
        };
        // From 1 − S = 1 − sinθ = cos²θ/(1 + sinθ) on, part of the lobe is below the surface. The
        // integrand begins there like a power 3/2, which a square smooths.
        let first = self.uniform_of_versine(w.z() * w.z() / (one + sin));
        let rest = one - first;
        let whole = integrate(zero, first, mean_weight);
        let cut = integrate(zero, one, |t: T| {
            mean_weight(first + rest * t * t) * (rest * t * T::lit(2.0))
        });
        let albedo = self.specular * (whole + cut);
        albedo.only_where(above_surface::<T, _>(wo))
    }
}
