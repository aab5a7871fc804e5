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
//! Largest error in units in the last place (ulp) of the exact result, asserted by
//! `tests/elementary.rs`:
//!
//! | function | `f32` | `f64` | remarks |
//! |---|---|---|---|
//! | `exp` | 1.0 | 1.0 | |
//! | `exp_m1` | 1.1 | 1.25 | |
//! | `ln` | 0.8 | 0.8 | −∞ at 0, NaN below |
//! | `ln_1p` | 1.4 | 1.4 | −∞ at −1, NaN below |
//! | `powf` | 0.55 | 1.4 | NaN for a negative base |
//! | `sin`, `cos` | 1.1 | 1.0 | for \|x\| ≤ 10⁴; beyond, in [−1, 1] but less and less precise |
//! | `tan` | 0.55 | 1.3 | for \|x\| ≤ 10⁴ |
//! | `asin` | 0.55 | 1.0 | |
//! | `acos` | 1.2 | 1.25 | |
//! | `atan2` | 1.5 | 1.4 | |
//! | `erf` | 0.55 | 1.25 | |
//! | `erfc` | 0.6 | 1.5 | in the tail too, down to underflow |
//! | `erf_inv` | 3.5 | 2.0 | beyond ±1 the value at the largest number below 1 |
//! | `sqrt`, `floor` | exact | exact | correctly rounded |

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

pub(super) mod double;
pub(super) mod single;
