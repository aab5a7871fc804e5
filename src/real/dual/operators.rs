//! Sums, products, quotients.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::super::traits::Real;
use super::{Dual, each, zip};

impl<T: Real, const N: usize> Add for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            derivatives: zip(self.derivatives, other.derivatives, |a, b| a + b),
        }
    }
}

impl<T: Real, const N: usize> Sub for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            derivatives: zip(self.derivatives, other.derivatives, |a, b| a - b),
        }
    }
}

impl<T: Real, const N: usize> Mul for Dual<T, N> {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl, reason = "the rule of products")]
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let product = |a, b| a * other.value + b * self.value;
        Self {
            value: self.value * other.value,
            derivatives: zip(self.derivatives, other.derivatives, product),
        }
    }
}

impl<T: Real, const N: usize> Div for Dual<T, N> {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl, reason = "the rule of quotients")]
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        // One quotient for all. That of the smallest numbers would overflow, and has to stay a number.
        let largest = T::max_finite();
        let inverse = (T::one() / other.value).clamp(-largest, largest);
        Self {
            value,
            derivatives: zip(self.derivatives, other.derivatives, |a, b| (a - value * b) * inverse),
        }
    }
}

impl<T: Real, const N: usize> Neg for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, derivatives: each(self.derivatives, Neg::neg) }
    }
}
