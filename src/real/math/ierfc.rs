//! The integral of erfc from x ≥ 0 to infinity, for any number.

use super::of_pairs;
use crate::real::Real;

/// exp(−x²)/√π − x erfc x with a relative error of 7·10⁻¹⁶ plus that of the exponential, in the
/// tail too, where the difference cancels.
///
/// The polynomial is the Chebyshev interpolation of (1 + x)² exp(x²) ierfc x in
/// (x − 3)/(x + 3), which runs from −1 to 1, computed with 60 digits.
#[inline(always)]
pub(crate) fn ierfc<T: Real>(x: T) -> T {
    // exp(−40²) is zero in every number; the bound keeps infinity out of the quotient.
    let x = x.min(T::lit(40.0));
    (-x.squared()).exp() * polynomial(x) / (T::lit(1.0) + x).squared()
}

/// ierfc x without its exponential, exp(x²) ierfc x: half of how fast erfcx falls.
#[inline(always)]
pub(crate) fn ierfcx<T: Real>(x: T) -> T {
    let inverse = T::lit(1.0) / (T::lit(1.0) + x);
    polynomial(x) * inverse * inverse
}

/// (1 + x)² exp(x²) ierfc x.
#[inline(always)]
fn polynomial<T: Real>(x: T) -> T {
    let t = (x - T::lit(3.0)) / (x + T::lit(3.0));
    of_pairs(t, &PAIRS, LAST)
}

const PAIRS: [[f64; 2]; 12] = [
    [0.43497808005738303, -0.21996539117550237],
    [0.054264794784573, 0.05451007980598061],
    [-0.06948519976404241, 0.03290912185493064],
    [-0.00010455855890709797, -0.008775245175071018],
    [0.0041741888057270525, 0.0001950131147005132],
    [-0.0008012323667662196, 0.0001027543611657003],
    [0.00013805714589913842, -2.8232300787708312e-05],
    [-2.668554218554301e-05, 5.079262811461616e-06],
    [5.830478972288471e-06, -5.759833901604646e-07],
    [-1.3225254993661134e-06, -2.144251244802458e-08],
    [2.756879269193618e-07, 2.5848802237235974e-08],
    [-4.4501370924781884e-08, -4.058066627398352e-09],
];
const LAST: f64 = 3.959107435392204e-09;

#[cfg(test)]
mod tests {
    use core::f64::consts::FRAC_2_SQRT_PI;

    use super::*;

    #[test]
    fn ierfc_is_the_difference_it_replaces() {
        for i in 0..=60 {
            let nu = 0.05 * f64::from(i);
            let difference = Real::exp(-nu * nu) * 0.5 * FRAC_2_SQRT_PI - nu * Real::erfc(nu);
            // The difference loses a factor of 2ν² of its digits.
            let allowed = 1e-15 * (1.0 + 2.0 * nu * nu);
            assert!((ierfc(nu) / difference - 1.0).abs() < allowed, "{nu}");
        }
        for i in 0..=50 {
            let x = 0.1 * f64::from(i);
            let want = Real::exp(x * x) * ierfc(x);
            assert!((ierfcx(x) / want - 1.0).abs() < 1e-14, "{x}");
        }
        // The first terms of the asymptotic series, where the next is below 10⁻¹³.
        for nu in [24.5_f64, 26.0] {
            let z = 1.0 / (4.0 * nu * nu);
            let series =
                1.0 + z * (-6.0 + z * (60.0 + z * (-840.0 + z * (15120.0 - z * 332640.0))));
            let want = Real::exp(-nu * nu) * 0.5 * FRAC_2_SQRT_PI * 2.0 * z * series;
            assert!((ierfc(nu) / want - 1.0).abs() < 1e-13, "{nu}");
        }
    }
}
