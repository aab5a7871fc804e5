//! A single film, one reflection after the other.

use super::complex::Complex;
use super::medium::{Incidence, Medium};
use super::polarized::Polarized;
use super::wave::Wave;
use crate::real::{Lift, Real};

/// The two boundaries of a film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Film<T> {
    outside: Complex<T>,
    film: Medium<T>,
    substrate: Medium<T>,
}

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

impl<T: Real> Film<T> {
    pub(crate) fn new(outside: Complex<T>, film: Complex<T>, substrate: Complex<T>) -> Self {
        Self {
            outside,
            film: Medium::new(outside, outside, film),
            substrate: Medium::new(outside, film, substrate),
        }
    }

    #[inline(always)]
    pub(crate) fn bounces(&self, cos_theta: T) -> Bounces<T> {
        let Self { outside, film, substrate } = self;
        let incidence = Incidence::new(*outside, cos_theta);
        let normal = film.normal(&incidence);
        let upper = Wave::leaving(normal)
            .above(&incidence, film, *outside, *outside * incidence.cos)
            .amplitudes(&incidence, *outside, film.index, normal);
        let lower = Wave::leaving(substrate.normal(&incidence))
            .above(&incidence, substrate, film.index, normal);
        Bounces { normal, upper: upper.r, entering: upper.transmittance, lower: lower.r }
    }
}

impl<T: Real> Lift<T> for Film<T> {
    type Over<U: Real> = Film<U>;

    fn lift<U: Real>(&self, lift: impl Fn(T) -> U + Copy) -> Film<U> {
        Film {
            outside: self.outside.lift(lift),
            film: self.film.lift(lift),
            substrate: self.substrate.lift(lift),
        }
    }
}
