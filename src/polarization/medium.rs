//! Media and the directions of waves in them.

use super::complex::Complex;
use crate::error::{ParameterError, range};
use crate::real::{Mask, Real};

/// Whether both parts of an index are in their ranges.
pub(crate) fn check_index<T: Real>(
    parameter: &'static str,
    index: Complex<T>,
) -> Result<(), ParameterError> {
    range::ETA.check::<T, _>(parameter, index.re)?;
    range::K.check::<T, _>(parameter, index.im)
}

/// The direction of the incident wave, in the medium it comes from.
#[derive(Clone, Copy)]
pub(super) struct Incidence<T> {
    /// cos θ₀.
    pub(super) cos: T,
    /// (n₀ cosθ₀)².
    normal_squared: Complex<T>,
    /// (n₀ sinθ₀)², the same in all media by Snell's law.
    pub(super) tangential_squared: Complex<T>,
    /// |n₀²|²/4.
    quarter: T,
}

impl<T: Real> Incidence<T> {
    #[inline(always)]
    pub(super) fn new(outside: Complex<T>, cos_theta: T) -> Self {
        let (one, outside_squared) = (T::one(), outside.squared());
        // At most 1, although rounding of a scalar product may have made it larger.
        let cos = cos_theta.abs().min(one);
        Self {
            cos,
            normal_squared: outside_squared * cos.squared(),
            tangential_squared: outside_squared * ((one - cos) * (one + cos)),
            quarter: outside_squared.norm_squared() * T::lit(0.25),
        }
    }
}

/// A medium behind another one, all that formulas need of its index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Medium<T> {
    /// n.
    pub(super) index: Complex<T>,
    /// n².
    squared: Complex<T>,
    /// n² − n₀², from the index of the medium of the incident wave.
    above_outside: Complex<T>,
    /// The n² of the medium in front minus this one.
    pub(super) contrast: Complex<T>,
}

impl<T: Real> Medium<T> {
    #[inline(always)]
    pub(super) fn new(outside: Complex<T>, front: Complex<T>, index: Complex<T>) -> Self {
        Self {
            index,
            squared: index.squared(),
            above_outside: (index - outside) * (index + outside),
            contrast: (front - index) * (front + index),
        }
    }

    pub(super) fn lift<U: Real>(self, lift: impl Fn(T) -> U + Copy) -> Medium<U> {
        Medium {
            index: self.index.lift(lift),
            squared: self.squared.lift(lift),
            above_outside: self.above_outside.lift(lift),
            contrast: self.contrast.lift(lift),
        }
    }

    /// q = n cosθ = √(n² − n₀² sin²θ₀), of which the wave in this medium is e^(2πi q z/λ).
    #[inline(always)]
    pub(super) fn normal(&self, incidence: &Incidence<T>) -> Complex<T> {
        // By whichever of two equal forms cancels less, as for a dielectric.
        let small = self.squared.norm_squared().lt(incidence.quarter);
        Complex::select(
            small,
            self.squared - incidence.tangential_squared,
            self.above_outside + incidence.normal_squared,
        )
        .root()
    }

    /// Whether q is real at every angle: in no number of which more is asked than its value.
    #[inline(always)]
    pub(super) fn is_clear(&self, outside: Complex<T>) -> bool {
        let (zero, index) = (T::zero(), self.index);
        let clear = index.im.le(zero).and(outside.im.le(zero)).and(index.re.ge(outside.re));
        T::VECTORIZES && clear.not().is_never()
    }

    /// The real part of [`normal`](Self::normal) where the medium [is clear](Self::is_clear), with the
    /// same bits.
    #[inline(always)]
    pub(super) fn clear_normal(&self, incidence: &Incidence<T>) -> T {
        let squared = self.above_outside.re + incidence.normal_squared.re;
        // √x² = x.
        let modulus = squared.max(Complex::<T>::floor().sqrt());
        ((modulus + squared) * T::lit(0.5)).sqrt()
    }
}
