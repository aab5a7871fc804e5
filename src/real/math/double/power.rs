//! xʸ = 2^(y log₂ x), with log₂ x and the product in two parts of 26 and 53 bits.
//!
//! log₂ m = 2/(3 ln 2) · s · (3 + s² + …) for √½ ≤ m < √2, s = (m − 1)/(m + 1).

use super::exponential::exp;
use super::logarithm::{ln_of_part, split_any};
use super::{ROUND, head, scale};

/// 2/(3 ln 2), its head and the rest.
const FACTOR: f64 = 0.9617966939259756;
const FACTOR_HEAD: f64 = 0.9617966860532761;
const FACTOR_REST: f64 = 7.872699542894897e-9;

/// log₂ x for positive finite x as a head of 26 bits and the rest.
#[inline(always)]
fn log2(x: f64) -> (f64, f64) {
    let (m, n) = split_any(x);
    let f = m - 1.0;
    // s = f/(m + 1)
    let sum = m + 1.0;
    let sum_head = head(sum);
    let sum_rest = m - (sum_head - 1.0);
    let reciprocal = 1.0 / sum;
    let s = f * reciprocal;
    let s_head = head(s);
    let s_rest = ((f - s_head * sum_head) - s_head * sum_rest) * reciprocal;
    // u = 3 + s² + …
    let square = s_head * s_head;
    let square_rest = s_rest * (s_head + s);
    let z = square + square_rest;
    let more = square_rest
        + z * z
            * polynomial!(
                z;
                0.5999999999999996, 0.42857142857168806, 0.3333333332602706, 0.2727272833961893,
                0.23076832972494607, 0.20004566058392592, 0.17510400106821625,
                0.1799875457444359
            );
    let u_head = head(3.0 + (square + more));
    let u_rest = (square - (u_head - 3.0)) + more;
    // s·u
    let product = s_head * u_head;
    let product_rest = s_head * u_rest + s_rest * (u_head + u_rest);
    let p_head = head(product + product_rest);
    let p_rest = (product - p_head) + product_rest;
    // Times the factor, plus n.
    let scaled = p_head * FACTOR_HEAD;
    let scaled_rest = p_head * FACTOR_REST + p_rest * FACTOR;
    let high = head(n + (scaled + scaled_rest));
    (high, (scaled - (high - n)) + scaled_rest)
}

#[inline(always)]
pub(in crate::real) fn powf(x: f64, exponent: f64) -> f64 {
    // 2⁶⁵: beyond, every base but 1 gives 0 or infinity already; a NaN passes.
    const LARGE: f64 = 36893488147419103232.0;
    let y = if exponent > LARGE { LARGE } else { exponent };
    let y = if y < -LARGE { -LARGE } else { y };
    let (log_head, log_rest) = log2(x);
    let y_head = head(y);
    let high = y_head * log_head;
    let low = y_head * log_rest + (y - y_head) * (log_head + log_rest);
    // Beyond ±1100 the result is infinity or 0 already.
    let (too_large, too_small) = (high > 1100.0, high < -1100.0);
    let high = if too_large { 1100.0 } else { high };
    let high = if too_small { -1100.0 } else { high };
    let low = if too_large | too_small { 0.0 } else { low };
    let shifted = (high + low) + ROUND;
    let r = (high - (shifted - ROUND)) + low;
    let power = r * polynomial!(
        r;
        0.6931471805599457, 0.240226506959101, 0.05550410866478795, 0.009618129107605584,
        0.001333355815393053, 0.0001540353044394993, 1.5252726989383575e-5,
        1.321544123143184e-6, 1.0180784759096702e-7, 7.072857970966077e-9, 4.061222526379557e-10
    );
    let result = scale(1.0 + power, shifted.to_bits().wrapping_sub(ROUND.to_bits() - 2046));
    // The ends of the base: 0 and infinity have no logarithm, negative numbers no power.
    let grows = (x == 0.0) == (exponent < 0.0);
    let end = if grows { f64::INFINITY } else { 0.0 };
    let inside = if x > 0.0 { result } else { f64::NAN };
    let at_end = (x == 0.0) | (x == f64::INFINITY);
    let result = if at_end { end } else { inside };
    if exponent == 0.0 { 1.0 } else { result }
}

#[inline(always)]
pub(in crate::real) fn power_of_part(x: f64, rest: f64, exponent: f64) -> f64 {
    exp(exponent * ln_of_part(x, rest))
}
