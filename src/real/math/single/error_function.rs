//! Error functions: a series in x² near 0, e^(−x²) times a slow function elsewhere, and the
//! inverse from polynomials in −ln(1 − x²).

use super::{exp2_wide, ln, sqrt};

/// Where the two forms meet.
const SWITCH: f64 = 0.75;

/// erf x for |x| ≤ 0.75.
#[inline(always)]
fn central(x: f64) -> f64 {
    let series = polynomial!(
        x * x;
        0.1283791670677548, -0.3761263842684485, 0.11283778235641875, -0.026864741097608898,
        0.005216684588496402, -0.0008355273136372882, 9.460660557030089e-5
    );
    x + x * series
}

/// erfc x for x ≥ 0.74: e^(−x²)/(1 + 2x) times a polynomial in (x − 3)/(x + 3).
#[inline(always)]
fn tail(x: f64) -> f64 {
    let u = (x - 3.0) / (x + 3.0);
    let slow = polynomial!(
        u;
        1.2530080573481706, -0.1356210923464096, -0.047562159597453676, 0.12964447363603365,
        -0.11927681703933969, 0.06831755344400088, -0.023744613015510944, 0.0024755596369839855,
        0.0018013206258306628, -0.0006468530798043604
    );
    exp2_wide(-(x * x) * core::f64::consts::LOG2_E) * slow / (1.0 + 2.0 * x)
}

/// |x| up to 11, where erfc is 0 and erf is 1 in `f32`; a NaN passes.
#[inline(always)]
fn magnitude(x: f32) -> f64 {
    let a = f64::from(x.abs());
    if a > 11.0 { 11.0 } else { a }
}

#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the one rounding of the result")]
pub(in crate::real) fn erf(x: f32) -> f32 {
    let a = magnitude(x);
    let (inner, outer) = (central(a), 1.0 - tail(a));
    let y = if a < SWITCH { inner } else { outer };
    (y as f32).copysign(x)
}

#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the one rounding of the result")]
pub(in crate::real) fn erfc(x: f32) -> f32 {
    let a = magnitude(x);
    let inner = 1.0 - central(a).copysign(f64::from(x));
    let outer = tail(a);
    let outer = if x < 0.0 { 2.0 - outer } else { outer };
    (if a < SWITCH { inner } else { outer }) as f32
}

/// 1/(x + 1.5) times a polynomial in that reciprocal less ¼, made like that of [`ierfc`], for all
/// x ≥ 0: 3·10⁻⁸ of the value, and 3.5·10⁻⁷ with the rounding of the arithmetic.
#[inline(always)]
pub(in crate::real) fn erfcx(x: f32) -> f32 {
    let reciprocal = 1.0 / (x + 1.5);
    reciprocal
        * polynomial!(
            reciprocal - 0.25;
            0.8432255, 1.385328, 0.96226454, -0.9116541, -1.5798382, 1.8545727, 2.5311954,
            -5.7615867, -1.230081, 12.763466, -10.324772
        )
}

/// The square of a polynomial. It is one of √ierfc on 0 … 3.6, made by linear programming on 900
/// points so that the error relative to x + ierfc x is least, coefficients rounded one after the
/// other: 5·10⁻⁸, and 3·10⁻⁷ with the rounding of the arithmetic. From 3.6 on the sum is x.
#[inline(always)]
pub(in crate::real) fn ierfc(x: f32) -> f32 {
    let x = if x < 3.6 { x } else { 3.6 };
    let root = polynomial!(
        x;
        0.7511256, -0.66566753, 0.08058049, 0.07161661, -0.0045323656, -0.008595576,
        -0.00336008, 0.0041457643, -0.001311356, 0.00018358196, -9.860668e-6
    );
    root * root
}

#[inline(always)]
pub(in crate::real) fn erf_inv(x: f32) -> f32 {
    const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;
    let a = x.abs();
    let a = if a > BELOW_ONE { BELOW_ONE } else { a };
    let w = -ln((1.0 - a) * (1.0 + a));
    // erf⁻¹(a)/a, for w below and above 5.
    let inner = polynomial!(
        w;
        0.8862269, 0.23201485, 0.0115426285, -0.0023209122, -0.00014218294, 5.354599e-5,
        7.858214e-7, -1.3171839e-6, 1.4810193e-7, -5.4439213e-9
    );
    let s = sqrt(w) - 3.0;
    let outer = polynomial!(
        s;
        2.8329768, 1.0016748, 0.009444296, -0.0076348265, 0.005695254, -0.0036089558,
        0.0014637966, -3.4145338e-5, -0.00029267382, 9.9486824e-5
    );
    (a * if w < 5.0 { inner } else { outer }).copysign(x)
}
