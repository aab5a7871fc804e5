//! The mean magnitude of a normally distributed number, for any number.

use core::f64::consts::PI;

use crate::real::Real;

/// z + √S ierfc ν with ν = z/√S and S = π Q, since erf ν is 1 − erfc ν. A root of S is made of its
/// reciprocal.
#[inline(always)]
pub(in crate::real) fn mean_magnitude<T: Real>(z: T, square_at_zero: T) -> T {
    let square = square_at_zero * T::lit(PI);
    let inverse = square.rsqrt();
    z + square * inverse * (z * inverse).ierfc()
}
