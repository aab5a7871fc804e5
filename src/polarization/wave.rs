//! A wave that climbs through boundaries and films, from the last medium to the first.

use core::f64::consts::TAU;

use super::amplitude::Amplitude;
use super::amplitudes::Amplitudes;
use super::complex::Complex;
use super::medium::{Incidence, Medium};
use super::polarized::Polarized;
use crate::real::{Mask, Real};

/// What a boundary does to a wave.
///
/// ```text
/// ρ_s = (n₁² − n₂²)/(q₁ + q₂)²    ρ_p = −ρ_s (q₁q₂ − κ²)/(q₁q₂ + κ²)    κ = n₀ sinθ₀
/// τ_s = 2q₁/(q₁ + q₂)             τ_p = τ_s n₁n₂/(q₁q₂ + κ²)
/// ```
///
/// where no near numbers are subtracted but those that make the light of Brewster's angle vanish.
struct Boundary<T: Real> {
    /// ρ.
    s: Complex<T>,
    p: Complex<T>,
    /// τ/2q₁.
    through_s: Complex<T>,
    through_p: Complex<T>,
    /// Whether both media are the same.
    none: T::Mask,
}

impl<T: Real> Boundary<T> {
    #[inline(always)]
    fn new(
        incidence: &Incidence<T>,
        behind: &Medium<T>,
        bottom: Complex<T>,
        index: Complex<T>,
        normal: Complex<T>,
    ) -> Self {
        let (Polarized { s, p }, parallel) =
            reflected(behind.contrast, incidence.tangential_squared, [normal, bottom]);
        // Where the reflection is asked for alone, this is not computed.
        let through_s = (normal + bottom).inverse();
        let through_p = through_s * parallel * (index * behind.index);
        let contrast = behind.contrast.re.abs() + behind.contrast.im.abs();
        Self { s, p, through_s, through_p, none: contrast.le(T::zero()) }
    }
}

/// ρ of a boundary of a contrast n₁² − n₂², of κ² and both q, and 1/(q₁q₂ + κ²).
#[inline(always)]
pub(super) fn reflected<T: Real, Z: Amplitude<T>>(
    contrast: Z,
    tangential: Z,
    [normal, bottom]: [Z; 2],
) -> (Polarized<Z>, Z) {
    let product = normal * bottom;
    let [inverse, parallel] = inverses((normal + bottom).squared(), product + tangential);
    let s = contrast * inverse;
    (Polarized { s, p: s * (tangential - product) * parallel }, parallel)
}

/// (R_s + R_p)/2 of a boundary that reflects ρ in front of what returns `r`.
#[inline(always)]
pub(super) fn reflectance<T: Real, Z: Amplitude<T>>(
    Polarized { s, p }: Polarized<Z>,
    r: Polarized<Complex<T>>,
) -> T {
    let one = T::one();
    let above = [s.plus(r.s).norm_squared(), p.plus(r.p).norm_squared()];
    let below = [one.plus(s.times(r.s)).norm_squared(), one.plus(p.times(r.p)).norm_squared()];
    let sum = above[0] * below[1] + above[1] * below[0];
    sum * T::lit(0.5) / (below[0] * below[1]).max(Complex::floor())
}

/// 1/a and 1/b by one division, of numbers whose squares neither overflow nor underflow together.
#[inline(always)]
fn inverses<T: Real, Z: Amplitude<T>>(a: Z, b: Z) -> [Z; 2] {
    // No boundary of passive media comes near the bound, which keeps the product finite.
    let bound = T::lit(1e18);
    let (a_squared, b_squared) = (a.length_squared().min(bound), b.length_squared().min(bound));
    let scale = T::one() / (a_squared * b_squared).max(Complex::floor());
    // Where the floor acts, one of them is next to 0 and the quotient must stay finite.
    let most = T::max_finite();
    [a.mirrored((b_squared * scale).min(most)), b.mirrored((a_squared * scale).min(most))]
}

/// What is known of all that lies below a plane in a medium.
#[derive(Clone, Copy)]
pub(super) struct Wave<T: Real> {
    /// q of the medium.
    normal: Complex<T>,
    /// The amplitude reflected from below.
    pub(super) r: Polarized<Complex<T>>,
    /// The amplitude transmitted into the last medium, over 2q if the plane is a boundary.
    passed: Polarized<Complex<T>>,
    /// Whether all media from here on are the same.
    clear: T::Mask,
    /// What passes then: phase and absorption of the layers.
    straight: Complex<T>,
}

impl<T: Real> Wave<T> {
    /// Above the boundary to the last medium, from which nothing returns; `behind` is that medium and
    /// `bottom` its q, the others are those of the medium in front.
    #[inline(always)]
    pub(super) fn bare(
        incidence: &Incidence<T>,
        behind: &Medium<T>,
        bottom: Complex<T>,
        index: Complex<T>,
        normal: Complex<T>,
    ) -> Self {
        let Boundary { s, p, through_s, through_p, none } =
            Boundary::new(incidence, behind, bottom, index, normal);
        Self {
            normal,
            r: Polarized { s, p },
            passed: Polarized { s: through_s, p: through_p },
            clear: none,
            straight: Complex::real(T::one()),
        }
    }

    /// Above the boundary of the medium `behind`, in which this wave is, to one in front.
    #[inline(always)]
    pub(super) fn above(
        self,
        incidence: &Incidence<T>,
        behind: &Medium<T>,
        index: Complex<T>,
        normal: Complex<T>,
    ) -> Self {
        let Boundary { s, p, through_s, through_p, none } =
            Boundary::new(incidence, behind, self.normal, index, normal);
        let one = Complex::real(T::one());
        let [inverse_s, inverse_p] = inverses(one + s * self.r.s, one + p * self.r.p);
        Self {
            normal,
            r: Polarized { s: (s + self.r.s) * inverse_s, p: (p + self.r.p) * inverse_p },
            passed: Polarized {
                s: self.passed.s * through_s * inverse_s,
                p: self.passed.p * through_p * inverse_p,
            },
            clear: self.clear.and(none),
            straight: self.straight,
        }
    }

    /// (R_s + R_p)/2 of what [`above`](Self::above) would answer.
    #[inline(always)]
    pub(super) fn reflectance_above(
        self,
        incidence: &Incidence<T>,
        behind: &Medium<T>,
        index: Complex<T>,
        normal: Complex<T>,
    ) -> T {
        let Boundary { s, p, .. } = Boundary::new(incidence, behind, self.normal, index, normal);
        reflectance(Polarized { s, p }, self.r)
    }

    /// At the top of a layer that is this many wavelengths thick, from the boundary at its bottom.
    #[inline(always)]
    pub(super) fn across(self, waves: T) -> Self {
        // In a stack seen from an absorbing medium a wave may grow; the bound keeps it finite.
        let growth = (self.normal.im * (waves * T::lit(-TAU))).min(T::lit(5.0));
        let turns = self.normal.re * waves;
        // Each of its own: where the reflection is asked for alone, nothing else is computed.
        let round_trip = Complex::from_turns((growth + growth).exp(), turns + turns);
        let layer = Complex::from_turns(growth.exp(), turns);
        let through = layer * (self.normal + self.normal);
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
            clear: self.clear,
            straight: self.straight * layer,
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
        let Self { clear, straight, .. } = self;
        let power = |carried: Complex<T>, passed: Complex<T>| {
            let power = (carried.re * scale * passed.norm_squared()).max(T::zero());
            let whole = straight.norm_squared().with_derivatives_of(power);
            T::select(clear, whole, power)
        };
        // Where there is no boundary the cosine is in no term; the quotients would lose it at grazing.
        let field = |passed: Complex<T>| {
            let t = passed * (self.normal + self.normal);
            let whole = Complex::new(
                straight.re.with_derivatives_of(t.re),
                straight.im.with_derivatives_of(t.im),
            );
            Complex::select(clear, whole, t)
        };
        Amplitudes {
            r: self.r,
            t: self.passed.map(field),
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
        let one = Complex::real(T::one());
        let (normal, zero) = (Complex::new(q_re, q_im), T::zero());
        let passed = Polarized { s: one, p: one };
        Self { normal, r, passed, clear: zero.lt(zero), straight: one }
    }
}
