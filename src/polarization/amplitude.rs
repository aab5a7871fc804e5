//! What the amplitudes of waves are written over: complex numbers, and real ones where no part is
//! imaginary.

use core::ops::{Add, Mul, Sub};

use super::complex::Complex;
use crate::real::Real;

/// A number of a formula for amplitudes: complex, or a real number in the place of one whose imaginary
/// part is 0. Both have the same bits, but for signs of zeros.
pub(super) trait Amplitude<T: Real>:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// z².
    fn squared(self) -> Self;
    /// |z|².
    fn length_squared(self) -> T;
    /// Its conjugate times a number.
    fn mirrored(self, scale: T) -> Self;
    /// The sum with a complex number.
    fn plus(self, other: Complex<T>) -> Complex<T>;
    /// The product with a complex number.
    fn times(self, other: Complex<T>) -> Complex<T>;
}

impl<T: Real> Amplitude<T> for Complex<T> {
    #[inline(always)]
    fn squared(self) -> Self {
        self.squared()
    }
    #[inline(always)]
    fn length_squared(self) -> T {
        self.norm_squared()
    }
    #[inline(always)]
    fn mirrored(self, scale: T) -> Self {
        self.conj() * scale
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        self + other
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        self * other
    }
}

impl<T: Real> Amplitude<T> for T {
    #[inline(always)]
    fn squared(self) -> Self {
        Real::squared(self)
    }
    #[inline(always)]
    fn length_squared(self) -> T {
        Real::squared(self)
    }
    #[inline(always)]
    fn mirrored(self, scale: T) -> Self {
        self * scale
    }
    #[inline(always)]
    fn plus(self, other: Complex<T>) -> Complex<T> {
        Complex { re: self + other.re, im: other.im }
    }
    #[inline(always)]
    fn times(self, other: Complex<T>) -> Complex<T> {
        other * self
    }
}
