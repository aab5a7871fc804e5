//! Error functions: a series in x² near 0, e^(−x²) times a slow function elsewhere; the inverse
//! from polynomials in −ln(1 − x²) and one step of Halley's method.

use super::exponential::parts;
use super::{head, ln, scale, sqrt};

/// Where the two forms meet.
const SWITCH: f64 = 0.47;

/// erf x for |x| ≤ 0.47.
#[inline(always)]
fn central(x: f64) -> f64 {
    let series = polynomial!(
        x * x;
        0.1283791670955126, -0.37612638903183754, 0.11283791670955028, -0.026866170645074332,
        0.005223977623770638, -0.0008548326741180265, 0.00012055303923115115,
        -1.492379502985338e-5, 1.6390255706502182e-6, -1.481092393316433e-7
    );
    x + x * series
}

/// erfc x and e^(−x²) for 0.46 ≤ x ≤ 28.
///
/// erfc x = e^(−x²)(1.25 + w)/(1 + 2x), with w a polynomial in (x − 4)/(x + 4). What the square,
/// the sums and the quotient lose is carried along.
#[inline(always)]
fn tail(x: f64) -> (f64, f64) {
    let x_head = head(x);
    let (grown, power) = parts(-(x_head * x_head), -(x - x_head) * (x + x_head));
    let exponential = 1.0 + grown;
    let exponential_low = (1.0 - exponential) + grown;
    let u = (x - 4.0) / (x + 4.0);
    let w = polynomial!(
        u;
        -0.017004881374447486, -0.1396211168405625, 0.015379652102618822, 0.06809705425469086,
        -0.10103906603624083, 0.09373283499842881, -0.06633036581391823, 0.03716751553585899,
        -0.016197734034505192, 0.005031969996794441, -0.0007577734745512521,
        -0.00019925682957513602, 0.00015062260270950998, -2.4398583372848258e-5,
        -1.1225007459061223e-5, 5.707767783644644e-6, 2.9998124271169553e-7,
        -8.2138300781353e-7, 6.666548766081793e-8, 1.047916347571008e-7,
        -1.2095075597864449e-8, -1.0188050796093692e-8
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
    // erf⁻¹(a)/a to 10⁻⁶, for w below and above 5.
    let inner = polynomial!(
        w;
        0.8862268424884655, 0.2320166505476213, 0.01153214025402237, -0.0022978701476517433,
        -0.0001672196803583368, 6.868250201035077e-5, -4.550549673293812e-6,
        -2.269601710344591e-7, 2.853428709915724e-8
    );
    let outer = polynomial!(
        sqrt(w) - 4.0;
        3.8397821746016376, 1.0095094097835144, 0.0012847654203919198, -0.0009391057060254834,
        0.00026969601746062966, -2.889249145284434e-5, 8.380758015132012e-5,
        -7.882877895319201e-5, 1.8841836027636793e-5
    );
    let y = a * if w < 5.0 { inner } else { outer };
    let (complement, exponential) = tail(y);
    let (excess, outer_excess) = (central(y) - a, (1.0 - a) - complement);
    let excess = if y < SWITCH { excess } else { outer_excess };
    // Newton's step is excess/erf′; Halley's divides it by 1 + y·step, as erf″/erf′ = −2y.
    let step = excess / (core::f64::consts::FRAC_2_SQRT_PI * exponential);
    (y - step / (1.0 + y * step)).copysign(x)
}
