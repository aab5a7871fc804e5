//! The azimuth of the facets of V-shaped grooves that a viewer sees.

use core::f64::consts::PI;

use crate::real::{Real, iterate};

/// Cosine and sine of an azimuth ψ₀ + φ for the viewer's azimuth ψ₀, given by the same, and a number in [0, 1]:
/// of two opposite facets with areas (1 ± K cosφ)₊ one is chosen in proportion to the areas. φ in [−π, π] grows
/// with the number. K is given by its square, which is not 0.
#[inline(always)]
pub(super) fn visible_azimuth<T: Real>(k_squared: T, (cos_0, sin_0): (T, T), u: T) -> (T, T) {
    let (zero, one) = (T::zero(), T::one());
    // Both halves are alike. Counted from behind, at ε = π − |φ|, the probability is τ/π. A smaller one
    // makes no difference that could be seen.
    let signed = u + u - one;
    let tau = ((one - signed.abs()) * T::lit(PI)).max(T::lit(1e-18));
    // No facet is visible for ε < first = arccos(1/K); one of two for ε > π − first, and there
    // ε = π/2 + τ/2. Those are the azimuths where a facet with K = 1/sin(τ/2) begins to be the only one.
    let (sin_half, _) = sin_cos_of_half(tau);
    let k_squared = k_squared.min(one / sin_half.squared().max(T::lit(1e-30)));
    let k = k_squared.sqrt();
    // Between them ∫(1 − K cosε)dε = τ, or with x = ε − first and (a, b) = K (cos first, sin first):
    // x − a sin x + b (1 − cos x) = τ. With K < 1 first is 0, and a is K.
    let b = (k_squared - one).max(zero).sqrt();
    let (sin, cos) = Kepler { a: k.min(one), b, target: tau }.sin_cos_of_solution();
    // ψ = ψ₀ ± (π − first − x), of which all but x is known before.
    let cos_first = one / k.max(one);
    let (sin_first, side) = (b * cos_first, one.copysign(signed));
    let (cos_behind, sin_behind) = (-cos_first, sin_first * side);
    let cos_end = cos_0 * cos_behind - sin_0 * sin_behind;
    let sin_end = sin_0 * cos_behind + cos_0 * sin_behind;
    let across = sin * side;
    (cos_end * cos + sin_end * across, sin_end * cos - cos_end * across)
}

/// The equation x − a sin x + b (1 − cos x) = `target` for x in 0 … π, where a is 1 or b is 0: Kepler's
/// equation, for a planet that starts where it is closest or, with a = 1, elsewhere.
struct Kepler<T> {
    a: T,
    b: T,
    target: T,
}

impl<T: Real> Kepler<T> {
    /// Sine and cosine of the solution: a step of third order from a good guess leaves 5·10⁻⁹ of the target,
    /// two leave nothing in `f64`. The last moves sine and cosine by a small angle.
    #[inline(always)]
    fn sin_cos_of_solution(&self) -> (T, T) {
        let first = self.first_guess().held();
        let x = if T::SPACING > 1e-9 {
            first
        } else {
            iterate::<1, _>(
                first,
                #[inline(always)]
                |x| (x + self.step(x, sine_and_versine(x))).max(T::zero()).held(),
            )
        };
        let one = T::one();
        let (sin, versine) = sine_and_versine(x);
        let step = self.step(x, (sin, versine)).max(-x);
        let solution = (x + step).as_solution_of(|x| {
            let (sin, versine) = sine_and_versine(x);
            (self.difference(x, sin, versine), self.slope(sin, versine))
        });
        let step = step.with_derivatives_of(solution - x);
        let (cos, squared) = (one - versine, step.squared());
        let sin_step = step - step * squared * T::lit(1.0 / 6.0);
        let versine_step = squared * (T::lit(0.5) - squared * T::lit(1.0 / 24.0));
        (sin + (cos * sin_step - sin * versine_step), cos - (sin * sin_step + cos * versine_step))
    }

    /// The solution to 2 %.
    ///
    /// With a = 1 and b = 0 it is X(τ), here to 0.7 % a rational function of the fourth root. Elsewhere x = ΦX,
    /// where 2lΦ + qΦ² + aΦ³ is nearly 1, with a power closer to Φ² than to Φ³ where X is close to π: what
    /// is between the roots of quadratic equations for small and for large l and q.
    #[inline(always)]
    fn first_guess(&self) -> T {
        let (half, one) = (T::lit(0.5), T::one());
        let root = self.target.sqrt().sqrt().max(T::lit(1e-3));
        let end = root * (T::lit(0.38474) + T::lit(9.7423) * root)
            / (one + root * (T::lit(6.3183) - T::lit(2.104) * root));
        let inverse = end / self.target;
        let bend = T::lit(0.836) * (one - T::lit(0.123) * end.squared());
        let linear = (one - self.a) * (half * inverse);
        let quadratic = self.b * (half * inverse * end);
        let cubic = self.a / (one + (bend * linear + T::lit(0.375) * quadratic));
        end / (linear + ((linear.squared() + quadratic) + cubic).sqrt())
    }

    /// One step of Householder's method of third order.
    #[inline(always)]
    fn step(&self, x: T, (sin, versine): (T, T)) -> T {
        let half = T::lit(0.5);
        let cos = T::one() - versine;
        let (value, slope) = (self.difference(x, sin, versine), self.slope(sin, versine));
        let (second, third) = (self.a * sin + self.b * cos, self.a * cos - self.b * sin);
        let (squared, bent) = (slope.squared(), value * second);
        let denominator = slope * (squared - bent) + value.squared() * third * T::lit(1.0 / 6.0);
        // Both are zero only at the solution x = 0, where the value is zero too.
        -value * (squared - half * bent) / denominator.max(T::lit(1e-37))
    }

    /// How far the left side is above the right one.
    #[inline(always)]
    fn difference(&self, x: T, sin: T, versine: T) -> T {
        x - self.a * sin + self.b * versine - self.target
    }

    /// How fast the left side grows.
    #[inline(always)]
    fn slope(&self, sin: T, versine: T) -> T {
        (T::one() - self.a) + self.a * versine + self.b * sin
    }
}

/// sin x and 1 − cos x for x in 0 … π.
#[inline(always)]
fn sine_and_versine<T: Real>(x: T) -> (T, T) {
    let (sin, cos) = sin_cos_of_half(x);
    let twice = sin + sin;
    (twice * cos, twice * sin)
}

/// Sine and cosine of half an angle in 0 … π. Polynomials are enough for the rounding of `f32`, and sooner
/// there than what reduces the angle first.
#[inline(always)]
fn sin_cos_of_half<T: Real>(x: T) -> (T, T) {
    let half = x * T::lit(0.5);
    if T::SPACING < 1e-9 {
        return half.sin_cos();
    }
    let z = half.squared();
    let square = z.squared();
    let of_sine = (T::lit(-1.66666555e-1) + T::lit(8.33297797e-3) * z)
        + square * (T::lit(-1.98038108e-4) + T::lit(2.59393547e-6) * z);
    let of_cosine = (T::lit(4.99999995e-1) - T::lit(4.16666363e-2) * z)
        + square
            * ((T::lit(1.38883431e-3) - T::lit(2.47586704e-5) * z)
                + square * T::lit(2.60188378e-7));
    (half + half * z * of_sine, T::one() - z * of_cosine)
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use super::visible_azimuth;

    /// The probability that the azimuth is at most φ, by the closed integral of its density.
    fn probability(k: f64, cos: f64, sin: f64) -> f64 {
        let behind = sin.abs().atan2(-cos);
        let half_width = 1.0_f64.atan2(((k - 1.0) * (k + 1.0)).max(0.0).sqrt());
        let first = FRAC_PI_2 - half_width;
        let tail = if behind > PI - first {
            2.0 * behind / PI - 1.0
        } else {
            let ends = |angle: f64| angle - k * angle.sin();
            (ends(behind) - ends(first)).max(0.0) / PI
        };
        if sin.is_sign_negative() { 0.5 * tail } else { 1.0 - 0.5 * tail }
    }

    /// Flat, mildly tilted, just not and just hidden, almost vertical facets.
    const K: [f64; 14] =
        [1e-18, 1e-9, 0.1, 0.5, 0.9, 0.99, 0.999999, 1.0, 1.000001, 1.01, 1.1, 2.0, 30.0, 1e4];

    #[test]
    fn the_azimuth_inverts_its_probability() {
        let (mut worst_f32, mut worst_f64) = (0.0_f64, 0.0_f64);
        for k in K {
            let even = (0..=4096_u16).map(|step| f64::from(step) / 4096.0);
            let small = (0..=512_u16).map(|step| (-f64::from(step) / 16.0).exp());
            for u in even.chain(small) {
                let (cos, sin) = visible_azimuth(k * k, (1.0, 0.0), u);
                worst_f64 = worst_f64.max((probability(k, cos, sin) - u).abs());
                #[allow(clippy::cast_possible_truncation, reason = "single precision is tested")]
                let (single_k, single_u) = (k as f32, u as f32);
                let (cos, sin) = visible_azimuth(single_k * single_k, (1.0, 0.0), single_u);
                let got = probability(f64::from(single_k), f64::from(cos), f64::from(sin));
                worst_f32 = worst_f32.max((got - f64::from(single_u)).abs());
            }
        }
        assert!(worst_f64 < 5e-13, "{worst_f64:e}");
        assert!(worst_f32 < 4e-7, "{worst_f32:e}");
    }

    #[test]
    fn the_azimuth_grows_with_the_number() {
        for k in K {
            let angle = |step: u16| {
                let (cos, sin) = visible_azimuth(k * k, (1.0, 0.0), f64::from(step) / 4096.0);
                sin.atan2(cos)
            };
            for step in 1..=4095 {
                assert!(angle(step) > angle(step - 1) - 1e-15 || step == 1, "{k} {step}");
            }
        }
    }

    #[test]
    fn vertical_facets_and_the_ends_of_the_numbers_are_harmless() {
        for k in [1e10, 1e15, 1e30, f64::MAX, f64::INFINITY] {
            for u in [0.0, 1e-300, 1e-16, 0.25, 0.5, 0.75, 1.0 - 1e-16, 1.0] {
                let (cos, sin) = visible_azimuth(k * k, (1.0, 0.0), u);
                assert!((cos * cos + sin * sin - 1.0).abs() < 1e-15, "{k} {u}");
                assert!(cos > -1e-9, "{k} {u}: faces away by {cos}");
            }
        }
    }
}
