//! A single film, one reflection after the other.

use super::complex::Complex;
use super::medium::{Incidence, Medium};
use super::polarized::Polarized;
use super::wave::Wave;
use crate::real::Real;

/// What the boundaries of a film do to the light inside and outside of it.
pub(crate) struct Bounces<T> {
    /// q in the film.
    pub(crate) normal: Complex<T>,
    /// The amplitudes reflected by the upper boundary, from outside.
    pub(crate) upper: Polarized<Complex<T>>,
    /// The power that passes it.
    pub(crate) entering: Polarized<T>,
    /// The amplitudes reflected by the lower boundary.
    pub(crate) lower: Polarized<Complex<T>>,
}

impl<T: Real> Bounces<T> {
    /// At the given cosine of the angle of incidence in the medium outside.
    #[inline(always)]
    pub(crate) fn new(
        outside: Complex<T>,
        film: Complex<T>,
        substrate: Complex<T>,
        cos_theta: T,
    ) -> Self {
        let first = Medium::new(outside, outside, film);
        let second = Medium::new(outside, film, substrate);
        let incidence = Incidence::new(outside, cos_theta);
        let normal = first.normal(&incidence);
        let front = outside * incidence.cos;
        let upper = Wave::bare(&incidence, &first, normal, outside, front)
            .amplitudes(&incidence, outside, film, normal);
        let lower = Wave::bare(&incidence, &second, second.normal(&incidence), film, normal);
        Self { normal, upper: upper.r, entering: upper.transmittance, lower: lower.r }
    }
}
