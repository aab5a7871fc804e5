//! The crate's own elementary functions.
//!
//! Every one is a fixed sequence of additions, multiplications, divisions, square roots, integer
//! operations on the bit pattern and choices: no branch, no table, no fused multiply-add, no call
//! into a system library. So a result has the same bits on every machine, and a loop over lanes
//! becomes SIMD code.

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
