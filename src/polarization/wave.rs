//! A wave that climbs through boundaries and films, from the last medium to the first.

use core::f64::consts::TAU;

use super::amplitudes::Amplitudes;
use super::complex::Complex;
use super::medium::{Incidence, Medium};
use super::polarized::Polarized;
use crate::real::Real;

/// What is known of all that lies below a plane in a medium.
#[derive(Clone, Copy)]
pub(super) struct Wave<T> {
    /// q of the medium.
    normal: Complex<T>,
    /// The amplitude reflected from below.
    pub(super) r: Polarized<Complex<T>>,
    /// The amplitude transmitted into the last medium, over 2q if the plane is a boundary.
    passed: Polarized<Complex<T>>,
}

impl<T: Real> Wave<T> {
    /// The last medium, from which nothing returns.
    #[inline(always)]
    pub(super) fn leaving(normal: Complex<T>) -> Self {
        let (zero, one) = (Complex::real(T::zero()), Complex::real(T::one()));
        Self { normal, r: Polarized { s: zero, p: zero }, passed: Polarized { s: one, p: one } }
    }

    /// Above the boundary of the medium `behind`, in which this wave is, to one in front.
    ///
    /// ```text
    /// ρ_s = (n₁² − n₂²)/(q₁ + q₂)²    ρ_p = −ρ_s (q₁q₂ − κ²)/(q₁q₂ + κ²)    κ = n₀ sinθ₀
    /// τ_s = 2q₁/(q₁ + q₂)             τ_p = τ_s n₁n₂/(q₁q₂ + κ²)
    /// ```
    ///
    /// where no near numbers are subtracted but those that make the light of Brewster's angle
    /// vanish.
    #[inline(always)]
    pub(super) fn above(
        self,
        incidence: &Incidence<T>,
        behind: &Medium<T>,
        index: Complex<T>,
        normal: Complex<T>,
    ) -> Self {
        let (product, tangential) = (normal * self.normal, incidence.tangential_squared);
        let sum = (normal + self.normal).inverse();
        let parallel = (product + tangential).inverse();
        let s = behind.contrast * sum * sum;
        let p = s * (tangential - product) * parallel;
        let one = Complex::real(T::one());
        let airy = |rho: Complex<T>, r: Complex<T>| {
            let inverse = (one + rho * r).inverse();
            ((rho + r) * inverse, inverse)
        };
        let ((r_s, inverse_s), (r_p, inverse_p)) = (airy(s, self.r.s), airy(p, self.r.p));
        Self {
            normal,
            r: Polarized { s: r_s, p: r_p },
            passed: Polarized {
                s: self.passed.s * sum * inverse_s,
                p: self.passed.p * sum * parallel * (index * behind.index) * inverse_p,
            },
        }
    }

    /// At the top of a layer that is this many wavelengths thick, from the boundary at its bottom.
    #[inline(always)]
    pub(super) fn across(self, waves: T) -> Self {
        // In a stack seen from an absorbing medium a wave may grow; the bound keeps it finite.
        let growth = (self.normal.im * (waves * T::lit(-TAU))).min(T::lit(20.0));
        let e = Complex::from_turns(growth.exp(), self.normal.re * waves);
        let (round_trip, through) = (e * e, e * (self.normal + self.normal));
        Self {
            normal: self.normal,
            r: self.r.map(
                #[inline(always)]
                |r| r * round_trip,
            ),
            passed: self.passed.map(
                #[inline(always)]
                |passed| passed * through,
            ),
        }
    }

    /// What the whole does, from above its first boundary; `bottom` is q in the last medium.
    #[inline(always)]
    pub(super) fn amplitudes(
        self,
        incidence: &Incidence<T>,
        first: Complex<T>,
        last: Complex<T>,
        bottom: Complex<T>,
    ) -> Amplitudes<T> {
        // |2q₀|²/Re q₀ = 4 cosθ |n₀|²/Re n₀, without a quotient that grazing makes 0/0.
        let scale = incidence.cos * T::lit(4.0) * first.norm_squared() / first.re;
        let carried = Polarized { s: bottom, p: bottom * last.conj() * last.inverse() };
        let power = |carried: Complex<T>, passed: Complex<T>| {
            (carried.re * scale * passed.norm_squared()).max(T::zero())
        };
        Amplitudes {
            r: self.r,
            t: self.passed.map(|passed| passed * (self.normal + self.normal)),
            transmittance: Polarized {
                s: power(carried.s, self.passed.s),
                p: power(carried.p, self.passed.p),
            },
        }
    }

    /// As numbers of a block; what has passed is left out.
    #[inline(always)]
    pub(super) fn planes(self) -> [T; 6] {
        let Self { normal, r, .. } = self;
        [normal.re, normal.im, r.s.re, r.s.im, r.p.re, r.p.im]
    }

    #[inline(always)]
    pub(super) fn of_planes([q_re, q_im, s_re, s_im, p_re, p_im]: [T; 6]) -> Self {
        let r = Polarized { s: Complex::new(s_re, s_im), p: Complex::new(p_re, p_im) };
        Self { r, ..Self::leaving(Complex::new(q_re, q_im)) }
    }
}
