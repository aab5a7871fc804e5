//! Error functions: a series in x² near 0, e^(−x²) times a slow function elsewhere; the inverse
//! from polynomials in −ln(1 − x²) and one step of Halley's method.

use super::exponential::parts;
use super::{head, ln, scale, sqrt};

/// Where the two forms meet.
const SWITCH: f64 = 0.51;

/// erf x for |x| ≤ 0.51.
#[inline(always)]
fn central(x: f64) -> f64 {
    let series = polynomial!(
        x * x;
        0.1283791670955126, -0.3761263890318375, 0.11283791670954767, -0.026866170644955112,
        0.0052239776210498854, -0.0008548326393526408, 0.00012055277893735083,
        -1.4922661369707417e-5, 1.636366750206414e-6, -1.455135583077009e-7
    );
    x + x * series
}

/// erfc x and e^(−x²) for 0.5 ≤ x ≤ 28.
///
/// erfc x = e^(−x²)(1.25 + w)/(1 + 2x), with w a polynomial in (x − 3.5)/(x + 3.5). What the square,
/// the sums and the quotient lose is carried along.
#[inline(always)]
fn tail(x: f64) -> (f64, f64) {
    let x_head = head(x);
    let (grown, power) = parts(-(x_head * x_head), -(x - x_head) * (x + x_head));
    let exponential = 1.0 + grown;
    let exponential_low = (1.0 - exponential) + grown;
    let u = (x - 3.5) / (x + 3.5);
    let w = polynomial!(
        u;
        -0.00765075512884562, -0.14000918013761943, -0.010555596332218342, 0.09751909515325892,
        -0.11508959816018857, 0.08798315382485232, -0.04882332582798048, 0.019099330942693737,
        -0.004215019906955227, -0.0003022678811252317, 0.0005643844133902923,
        -0.00012151239321123077, -4.2782221371483486e-5, 2.4260805996198797e-5,
        2.3283061408120412e-6, -3.814049201844159e-6, -4.426369454411786e-8, 5.99638160902045e-7,
        -7.888120603167688e-9, -9.258593512073881e-8, 5.528643402488802e-10, 1.0247157892461623e-8
    );
    let slow = 1.25 + w;
    let slow_low = (1.25 - slow) + w;
    let (slow_head, exponential_head) = (head(slow), head(exponential));
    let product = slow_head * exponential_head;
    let product_low = slow_head * (exponential - exponential_head)
        + (slow - slow_head) * exponential
        + (slow_low * exponential + slow * exponential_low);
    let divisor = 1.0 + 2.0 * x;
    let divisor_head = head(divisor);
    let divisor_rest = (divisor - divisor_head) + (1.0 - (divisor - 2.0 * x));
    let reciprocal = 1.0 / divisor;
    let quotient = head((product + product_low) * reciprocal);
    let remainder = ((product - quotient * divisor_head) - quotient * divisor_rest) + product_low;
    (scale(quotient + remainder * reciprocal, power), scale(exponential, power))
}

/// |x| up to 28, where erfc is 0 and erf is 1; a NaN passes.
#[inline(always)]
fn magnitude(x: f64) -> f64 {
    let a = x.abs();
    if a > 28.0 { 28.0 } else { a }
}

#[inline(always)]
pub(in crate::real) fn erf(x: f64) -> f64 {
    let a = magnitude(x);
    let (inner, outer) = (central(a), 1.0 - tail(a).0);
    (if a < SWITCH { inner } else { outer }).copysign(x)
}

#[inline(always)]
pub(in crate::real) fn erfc(x: f64) -> f64 {
    let a = magnitude(x);
    let inner = 1.0 - central(a).copysign(x);
    let outer = tail(a).0;
    let outer = if x < 0.0 { 2.0 - outer } else { outer };
    if a < SWITCH { inner } else { outer }
}

#[inline(always)]
pub(in crate::real) fn erf_inv(x: f64) -> f64 {
    const BELOW_ONE: f64 = 1.0 - f64::EPSILON / 2.0;
    let a = x.abs();
    let a = if a > BELOW_ONE { BELOW_ONE } else { a };
    let w = -ln((1.0 - a) * (1.0 + a));
    // erf⁻¹(a)/a to 3·10⁻⁸, for w below and above 5.
    let inner = polynomial!(
        w;
        0.8862269204957183, 0.23201381804053275, 0.011548653856969952, -0.0023342960617039102,
        -0.00012748180275293534, 4.456532139644307e-5, 3.983196887820481e-6, -1.976452193100388e-6,
        2.210294495142335e-7, -8.790965924405135e-9
    );
    let outer = polynomial!(
        sqrt(w) - 4.0;
        3.8397838418876105, 1.0094927337265909, 0.0012585931106968021, -0.0008646855307448612,
        0.00032631185768970726, -0.00012848852390945679, 4.771141432712164e-5,
        -2.071801349383229e-5, 2.364048743945507e-5, -1.5699295485054925e-5, 1.945153285425566e-6,
        1.6119809762418105e-6, -4.3728099763885806e-7
    );
    let y = a * if w < 5.0 { inner } else { outer };
    let (complement, exponential) = tail(y);
    let (excess, outer_excess) = (central(y) - a, (1.0 - a) - complement);
    let excess = if y < SWITCH { excess } else { outer_excess };
    // Newton's step is excess/erf′; Halley's divides it by 1 + y·step, as erf″/erf′ = −2y.
    let step = excess / (core::f64::consts::FRAC_2_SQRT_PI * exponential);
    (y - step / (1.0 + y * step)).copysign(x)
}
