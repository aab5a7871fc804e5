//! The crate's own elementary functions.
//!
//! Every one is a fixed sequence of additions, multiplications, divisions, square roots, integer
//! operations on the bit pattern and choices: no branch, no table, no fused multiply-add, no call
//! into a system library. So a result has the same bits on every machine, and a loop over lanes
//! becomes SIMD code. A formula computes both sides before it chooses: with the arithmetic inside
//! the `if`, the compiler would move it into a branch and the loop would stay scalar.
//!
//! The polynomials are minimax approximations made for this crate (Remez exchange with 60 digits,
//! coefficients rounded one after the other); each states what it approximates.
//!
//! The table of [`Real`] states their largest errors, asserted by
//! `tests/elementary.rs`.

use super::Real;

/// c₀ + c₁x + c₂x² + …: pairs of terms by Horner's rule in x², which halves the chain of
/// dependent operations.
macro_rules! polynomial {
    (@ $x:ident $square:ident $a:expr) => { $a };
    (@ $x:ident $square:ident $a:expr, $b:expr) => { $a + $b * $x };
    (@ $x:ident $square:ident $a:expr, $b:expr, $($rest:expr),+) => {
        ($a + $b * $x) + $square * polynomial!(@ $x $square $($rest),+)
    };
    ($x:expr; $($coefficient:expr),+) => {{
        let x = $x;
        let square = x * x;
        polynomial!(@ x square $($coefficient),+)
    }};
}

/// The same for any number: the terms but the last in pairs.
#[inline(always)]
fn of_pairs<T: Real>(x: T, pairs: &[[f64; 2]], last: f64) -> T {
    let square = x.squared();
    let mut polynomial = T::lit(last);
    for pair in pairs.iter().rev() {
        polynomial = polynomial * square + (T::lit(pair[0]) + T::lit(pair[1]) * x);
    }
    polynomial
}

pub(super) mod double;
mod erfcx;
mod ierfc;
mod mean_magnitude;
pub(super) mod single;

pub(super) use erfcx::erfcx;
pub(crate) use ierfc::{ierfc, ierfcx};
pub(super) use mean_magnitude::mean_magnitude;
