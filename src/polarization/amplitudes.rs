use super::complex::Complex;
use super::jones::Jones;
use super::mueller::Mueller;
use super::polarized::Polarized;
use crate::real::Real;

/// What a surface makes of a plane wave: how much field and how much power it reflects and
/// transmits in each polarisation.
///
/// Answered by [`Interface`](super::Interface) and [`Layers`](super::Layers).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amplitudes<T> {
    /// r_s and r_p, the reflected electric field over the incident one. At normal incidence
    /// r_p = −r_s.
    pub r: Polarized<Complex<T>>,
    /// t_s and t_p, the transmitted electric field over the incident one.
    pub t: Polarized<Complex<T>>,
    /// T_s and T_p, the fraction of the power that is transmitted, which is not |t|².
    pub transmittance: Polarized<T>,
}

impl<T: Real> Amplitudes<T> {
    /// R_s and R_p, the fraction of the power that is reflected, |r|².
    #[inline(always)]
    #[must_use]
    pub fn reflectance(self) -> Polarized<T> {
        self.r.map(Complex::norm_squared)
    }

    /// The Jones matrix of the reflection, diag(r_s, r_p).
    #[inline(always)]
    #[must_use]
    pub fn reflection(self) -> Jones<T> {
        Jones::diagonal(self.r.s, self.r.p)
    }

    /// The Jones matrix of the transmission, diag(t_s, t_p) scaled by √(T/|t|²), so that it carries
    /// power.
    #[must_use]
    pub fn transmission(self) -> Jones<T> {
        let scaled = |t: Complex<T>, power: T| {
            let some = power.gt(T::zero());
            let quotient = power / t.norm_squared().max(T::lit(1e-37));
            (t * T::select(some, quotient, T::one()).sqrt()).only_where(some)
        };
        let (s, p) =
            (scaled(self.t.s, self.transmittance.s), scaled(self.t.p, self.transmittance.p));
        Jones::diagonal(s, p)
    }

    /// The Mueller matrix of the reflection.
    #[must_use]
    pub fn mueller_reflection(self) -> Mueller<T> {
        self.reflection().mueller()
    }

    /// The Mueller matrix of the transmission.
    #[must_use]
    pub fn mueller_transmission(self) -> Mueller<T> {
        self.transmission().mueller()
    }
}
