//! Where a formula stands in the compiled code.

use super::traits::Real;

/// Runs a formula through a call, of the module where it stands: compilers make one unit of what a module has.
macro_rules! call {
    ($formula:expr) => {{
        #[inline(never)]
        fn call<R>(formula: impl FnOnce() -> R) -> R {
            formula()
        }
        call($formula)
    }};
}
pub(crate) use call;

/// Runs a formula: in place for the numbers of SIMD loops, which need all of it in one function,
/// through a call for the others, whose code is large.
macro_rules! in_place {
    ($number:ty, $formula:expr $(,)?) => {{
        #[inline(always)]
        fn in_place<T: $crate::real::Real, R>(formula: impl FnOnce() -> R) -> R {
            if T::VECTORIZES { formula() } else { $crate::real::call!(formula) }
        }
        in_place::<$number, _>($formula)
    }};
}
pub(crate) use in_place;

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
