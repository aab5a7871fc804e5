//! Complex numbers over any [`Real`].

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::real::Real;

/// A complex number: an amplitude, a refractive index n + ik.
///
/// No operation branches on a value; a division neither overflows nor underflows on the way for divisors
/// from 10⁻³⁷ in `f32` and 10⁻³⁰⁰ in `f64`, and a quotient by 0 is 0. The parts may be colours, where it only holds them.
///
/// ```
/// use brdf::polarization::Complex;
///
/// let i = Complex::new(0.0_f64, 1.0);
/// assert_eq!(i * i, Complex::real(-1.0));
/// assert_eq!(Complex::real(-4.0).root(), Complex::new(0.0, 2.0));
/// assert_eq!(Complex::new(3.0, 4.0) / Complex::new(0.0, 1.0), Complex::new(4.0, -3.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex<V = f32> {
    /// The real part.
    pub re: V,
    /// The imaginary part.
    pub im: V,
}

impl<V> Complex<V> {
    /// `re` + i `im`.
    #[inline(always)]
    #[must_use]
    pub const fn new(re: V, im: V) -> Self {
        Self { re, im }
    }
}

impl<T: Real> Complex<T> {
    /// A real number.
    #[inline(always)]
    #[must_use]
    pub fn real(re: T) -> Self {
        Self { re, im: T::zero() }
    }

    /// `length` e^(2πi `turns`), the angle as a number of turns.
    #[inline(always)]
    #[must_use]
    pub fn from_turns(length: T, turns: T) -> Self {
        let (sin, cos) = turns.sin_cos_turns();
        Self { re: length * cos, im: length * sin }
    }

    /// The number with the imaginary part of the other sign.
    #[inline(always)]
    #[must_use]
    pub fn conj(self) -> Self {
        Self { re: self.re, im: -self.im }
    }

    /// |z|².
    #[inline(always)]
    #[must_use]
    pub fn norm_squared(self) -> T {
        self.re.squared() + self.im.squared()
    }

    /// z².
    #[inline(always)]
    #[must_use]
    pub fn squared(self) -> Self {
        let product = self.re * self.im;
        Self { re: (self.re - self.im) * (self.re + self.im), im: product + product }
    }

    /// The angle from the positive real axis in [−π, π], radians; 0 of 0.
    #[inline(always)]
    #[must_use]
    pub fn arg(self) -> T {
        self.im.atan2(self.re)
    }

    /// 1/z; 0 of 0, and of what is too small for its inverse.
    #[inline(always)]
    #[must_use]
    pub fn inverse(self) -> Self {
        let scale = T::one() / self.larger();
        let (re, im) = (self.re * scale, self.im * scale);
        // Between 1 and 2, but for parts below the floor of `larger`.
        let quotient = scale / (re.squared() + im.squared()).max(T::lit(1e-37));
        let quotient = quotient.min(T::max_finite());
        Self { re: re * quotient, im: -(im * quotient) }
    }

    /// That of the two square roots with the sum of its parts positive. It is the one that a wave in
    /// a medium takes, which travels away from the surface and decays.
    ///
    /// The root of 0, which would have no derivative, is a small number instead. |z|² must fit into the
    /// number.
    #[inline(always)]
    #[must_use]
    pub fn root(self) -> Self {
        let modulus = self.norm_squared().max(Self::floor()).sqrt();
        let larger = ((modulus + self.re.abs()) * T::lit(0.5)).sqrt();
        let smaller = self.im / (larger + larger);
        let propagates = self.re.ge(T::zero());
        Self {
            re: T::select(propagates, larger, smaller),
            im: T::select(propagates, smaller, larger),
        }
    }

    /// The smallest number that has all its digits and an inverse.
    #[inline(always)]
    pub(super) fn floor() -> T {
        T::lit(if T::SPACING < 1e-10 { 1e-300 } else { 1e-37 })
    }

    /// The larger of the absolute values of both parts, at least the floor.
    #[inline(always)]
    fn larger(self) -> T {
        self.re.abs().max(self.im.abs()).max(Self::floor())
    }

    /// This number where the mask is true, zero elsewhere.
    #[inline(always)]
    #[must_use]
    pub fn only_where(self, mask: T::Mask) -> Self {
        Self { re: self.re.only_where(mask), im: self.im.only_where(mask) }
    }

    /// `yes` where the mask is true, `no` elsewhere.
    #[inline(always)]
    #[must_use]
    pub fn select(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self { re: T::select(mask, yes.re, no.re), im: T::select(mask, yes.im, no.im) }
    }

    /// The same number in another kind of numbers.
    #[inline(always)]
    pub(crate) fn lift<U: Real>(self, lift: impl Fn(T) -> U) -> Complex<U> {
        Complex { re: lift(self.re), im: lift(self.im) }
    }
}

impl<T: Real> Add for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl<T: Real> Sub for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl<T: Real> Neg for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { re: -self.re, im: -self.im }
    }
}

impl<T: Real> Mul for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}

impl<T: Real> Mul<T> for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, scale: T) -> Self {
        Self { re: self.re * scale, im: self.im * scale }
    }
}

impl<T: Real> Div for Complex<T> {
    type Output = Self;
    #[inline(always)]
    #[allow(clippy::suspicious_arithmetic_impl, reason = "the inverse guards the division")]
    fn div(self, other: Self) -> Self {
        self * other.inverse()
    }
}
