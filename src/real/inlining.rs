//! Where a formula stands in the compiled code.

use super::traits::Real;

/// Runs a formula: in place for the numbers of SIMD loops, which need all of it in one function,
/// through a call for the others, whose code is large.
#[inline(always)]
pub(crate) fn in_place<T: Real, R>(formula: impl FnOnce() -> R) -> R {
    if T::VECTORIZES { formula() } else { call(formula) }
}

/// Runs a formula through a call.
#[inline(never)]
pub(crate) fn call<R>(formula: impl FnOnce() -> R) -> R {
    formula()
}

/// `step` applied `N` times, at most four.
///
/// A loop inside a formula would keep the loop over many directions from becoming SIMD code, and
/// the compiler does not unroll a long body by itself.
#[inline(always)]
pub(crate) fn iterate<const N: usize, T: Real>(start: T, step: impl Fn(T) -> T) -> T {
    const { assert!(N <= 4) }
    let mut x = start;
    if !T::VECTORIZES {
        for _ in 0..N {
            x = step(x);
        }
        return x;
    }
    if N > 0 {
        x = step(x);
    }
    if N > 1 {
        x = step(x);
    }
    if N > 2 {
        x = step(x);
    }
    if N > 3 {
        x = step(x);
    }
    x
}
