//! Lambert's W.

use crate::real::Real;

/// The W with W e^W = `w` for 10⁻³⁰ ≤ `w` ≤ 10³⁶, to rounding.
///
/// The steps are those of F. N. Fritsch, R. E. Shafer and W. P. Crowley, "Algorithm 443: Solution of the
/// transcendental equation weʷ = x", CACM 16(2), 1973, of fourth order.
#[inline(always)]
pub(super) fn lambert_w<T: Real>(w: T) -> T {
    let one = T::one();
    let start = fritsch(w, nearly(w.held()).held());
    let root = if T::SPACING < 1e-10 { fritsch(w, start) } else { start };
    root.as_solution_of(
        #[inline(always)]
        |x| ((w / x).ln() - x, -one - one / x),
    )
}

/// A step towards the root.
#[inline(always)]
fn fritsch<T: Real>(w: T, x: T) -> T {
    let (one, two) = (T::one(), T::lit(2.0));
    let z = (w / x).ln() - x;
    let q = two * (one + x) * (one + x + T::lit(2.0 / 3.0) * z);
    x + x * (z / (one + x)) * ((q - z) / (q - two * z))
}

/// The same to 1.5 %.
///
/// S. Winitzki, "Uniform approximations for transcendental functions", ICCSA 2003.
#[inline(always)]
pub(super) fn nearly<T: Real>(w: T) -> T {
    let log = w.ln_1p();
    log * (T::one() - log.ln_1p() / (T::lit(2.0) + log))
}

#[cfg(test)]
mod tests {
    use super::lambert_w;

    #[test]
    fn it_solves_its_equation() {
        for index in -300..=360 {
            let w = 10_f64.powf(f64::from(index) * 0.1);
            let root = lambert_w(w);
            // In logarithms, as eᵂ has an error of W times that of W.
            let off = (root.ln() + root - w.ln()) / (1.0 + 1.0 / root);
            assert!(off.abs() <= 4e-16 * root.max(root * w.ln().abs()), "{w}: {root} {off}");
            let single = lambert_w(w as f32);
            assert!((f64::from(single) / root - 1.0).abs() < 6e-6, "{w}: {single}");
        }
        assert!((lambert_w(1.0_f64) - 0.567_143_290_409_783_8).abs() < 2e-16);
        assert!((lambert_w(1.0_f32) - 0.567_143_3).abs() < 1e-7);
    }
}
