//! The complement of the error function without its exponential, for any number.

use super::of_pairs;
use crate::real::Real;

/// exp(x²) erfc x for x ≥ 0, to 10⁻¹⁵ of its size.
///
/// The polynomial is the Chebyshev interpolation of (1 + 2x) exp(x²) erfc x in (x − 3)/(x + 3),
/// which runs from −1 to 1, computed with 80 digits.
#[inline(always)]
pub(crate) fn erfcx<T: Real>(x: T) -> T {
    let (one, three) = (T::lit(1.0), T::lit(3.0));
    let t = one - (three + three) / (x + three);
    let polynomial = of_pairs(t, &PAIRS, LAST);
    polynomial / (one + (x + x))
}

const PAIRS: [[f64; 2]; 12] = [
    [1.2530080582697296, -0.13562110612458117],
    [-0.04756229435345087, 0.1296451587027606],
    [-0.11927366341530699, 0.06830802734397848],
    [-0.023770514918645888, 0.002529391816066239],
    [0.0018886903591561553, -0.0007798322721083991],
    [-0.00010515979981501177, 0.00012509935235563107],
    [4.949484992570595e-06, -2.0100567931289227e-05],
    [-7.315105164159062e-07, 3.472414602875686e-06],
    [3.5683839153992204e-07, -6.166496077604353e-07],
    [-1.4160064940265987e-07, 1.0187000600072885e-07],
    [4.180784698845582e-08, -1.3326364813003834e-08],
    [-8.500397929772615e-09, 9.885798831139365e-10],
];
const LAST: f64 = 8.864219016427092e-10;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn erfcx_is_the_product_it_replaces() {
        for i in 0..=250 {
            let x = 0.1 * f64::from(i);
            // The rounding of the square counts as often as the exponential grows with it.
            let allowed = 2e-15 + 2e-16 * x * x;
            let product = Real::exp(x * x) * Real::erfc(x);
            assert!((erfcx(x) / product - 1.0).abs() < allowed, "{x}");
        }
        assert!((erfcx(1e9_f64) * 1e9 * core::f64::consts::PI.sqrt() - 1.0).abs() < 1e-15);
        assert_eq!(erfcx(f64::MAX) * 0.0, 0.0);
    }
}
