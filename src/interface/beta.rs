//! Euler's beta function, of numbers of 1 and more.

use crate::real::Real;

/// x y B(x, y) for 1 ≤ x, y ≤ 10⁹, in 0 … 1; symmetric to the last bit.
///
/// By Stirling's formula, whose powers B(x, y) ~ √(2π (x + y)/(x y)) (x/(x + y))ˣ (y/(x + y))ʸ keep their
/// digits for every size of x and y, and what it lacks: E(x) = Γ(x) eˣ x^(½ − x)/√(2π). Of numbers two
/// larger in `f64`, to about 10⁻¹⁵ where the function is not small, one larger in single precision, to
/// 7·10⁻⁶ where it is above 10⁻⁵; in the tail to ε times its logarithm.
#[inline(always)]
pub(super) fn scaled_beta<T: Real>(x: T, y: T) -> T {
    let single = T::SPACING > 1e-10;
    let (one, p) = (T::one(), x + y);
    let step = if single { one } else { T::lit(2.0) };
    let (a, b) = (x + step, y + step);
    let (q, product) = (a + b, a * b);
    let powers = a.power_of_part(b, a) * b.power_of_part(a, b);
    // One root serves that of the formula and the inverses of a, b and q.
    let root = (product * q).rsqrt();
    let inverse = root.squared();
    let inverses = [inverse * (b * q), inverse * (a * q), inverse * product];
    let formula = powers * (T::lit(ROOT_OF_TAU) * q * root);
    let rest = p * (p + one);
    // x y B(x, y) = p (p + 1) B(x + 1, y + 1) = p (p + 1) (p + 2) (p + 3)/((x + 1) (y + 1)) B(x + 2, y + 2)
    let rest = if single {
        rest * lacking_single(inverses)
    } else {
        let steps = (p + T::lit(2.0)) * (p + T::lit(3.0));
        rest / ((x + one) * (y + one)) * (steps * lacking(inverses))
    };
    (formula * rest).at_most(one)
}

/// √(2π).
const ROOT_OF_TAU: f64 = 2.5066282746310005024;

/// E(1/u) E(1/v)/E(1/w) for u, v ≤ ½, w ≤ ¼, with an error of 2·10⁻⁸: interpolated at Chebyshev's nodes.
#[inline(always)]
fn lacking_single<T: Real>([u, v, w]: [T; 3]) -> T {
    let e = |v: T| {
        let sum = T::lit(0.00036008243) * v + T::lit(6.9915164e-5);
        let sum = (sum * v - T::lit(0.0027638534)) * v + T::lit(0.0034821080);
        (sum * v + T::lit(0.083332904)) * v + T::one()
    };
    let inverse = (T::lit(-0.00065776455) * w + T::lit(0.0027694330)) * w + T::lit(0.0034646038);
    e(u) * e(v) * ((inverse * w - T::lit(0.083333097)) * w + T::one())
}

/// E(1/u) E(1/v)/E(1/w) for u, v, w ≤ 1/3.
#[inline(always)]
fn lacking<T: Real>(inverses: [T; 3]) -> T {
    let [a, b, q] = inverses.map(
        #[inline(always)]
        |v| stirling(v),
    );
    (a[0] * b[0] * q[1]) / (a[1] * b[1] * q[0])
}

/// Numerator and denominator of E(1/v) for 0 ≤ v ≤ 1/3, with an error of 4·10⁻¹⁶: interpolated at
/// Chebyshev's nodes.
#[inline(always)]
fn stirling<T: Real>(v: T) -> [T; 2] {
    let sum = |terms: [f64; 6]| {
        let step = |sum: T, term: f64| sum * v + T::lit(term);
        step(
            step(step(step(step(T::lit(terms[5]), terms[4]), terms[3]), terms[2]), terms[1]),
            terms[0],
        )
    };
    [
        sum([
            0.99999999999999968642,
            1.9712217495735860638,
            3.0521179961675113757,
            1.9021721483129602997,
            0.71221517743831451459,
            0.064829838649697829441,
        ]),
        sum([
            1.0,
            1.8878884162400239823,
            2.8913217392867330084,
            1.6573548277134621271,
            0.56935451730494556329,
            0.01903014392518808995,
        ]),
    ]
}

#[cfg(test)]
mod tests {
    use super::scaled_beta;

    #[test]
    fn known_values() {
        for (x, y, beta) in [
            (1.0, 1.0, 1.0),
            (1.0, 7.5, 1.0 / 7.5),
            (2.0, 3.0, 1.0 / 12.0),
            (1.5, 1.5, core::f64::consts::PI / 8.0),
            (5.0, 1.0, 0.2),
            (1e9, 1.0, 1e-9),
        ] {
            let got: f64 = scaled_beta(x, y) / (x * y);
            assert!((got / beta - 1.0).abs() < 3e-15, "{x} {y}: {got} for {beta}");
            assert_eq!(scaled_beta(x, y), scaled_beta(y, x));
            let single = scaled_beta(x as f32, y as f32);
            assert!((f64::from(single) / (x * y * beta) - 1.0).abs() < 2e-6, "{x} {y}: {single}");
        }
    }
}
