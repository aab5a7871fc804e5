//! Powers of a cosine that keep their digits for exponents up to 10⁸.
//!
//! A cosine close to 1 has no digits left that a large exponent could magnify. What has digits
//! there is 1 − cos, or sin².

use core::f64::consts::FRAC_PI_2;

use crate::quadrature::integrate;
use crate::real::Real;

/// (1 − q)ⁿ of q = 1 − cos; zero where the cosine is not positive.
#[inline(always)]
pub(super) fn power_of_versine<T: Real>(versine: T, exponent: T) -> T {
    let one = T::one();
    let positive = versine.lt(one);
    let versine = versine.only_where(positive);
    ((one - versine).power_of_part(versine, exponent)).only_where(positive)
}

/// cosⁿ of a unit vector's height and of the square of its sine; zero where the cosine is not
/// positive. The power of a part of cos² + sin², whichever of the two has the digits.
#[inline(always)]
pub(super) fn power_of_cosine<T: Real>(cos: T, sin_squared: T, exponent: T) -> T {
    let (zero, half, one) = (T::zero(), T::lit(0.5), T::one());
    // The square of a smaller one is no normal number.
    let least = T::lit(2.0) / T::max_finite().sqrt();
    let positive = cos.gt(zero);
    let cos = T::select(positive, cos, one).max(least);
    cos.squared().power_of_part(sin_squared, exponent * half).only_where(positive)
}

/// The fraction of the weights cosⁿ, over a quarter turn, that lies below the angle
/// asin(`sin`): ∫₀^angle cosⁿ / ∫₀^π/2 cosⁿ, and the second of these integrals.
#[inline(always)]
pub(super) fn quarter_turn<T: Real>(exponent: T, sin: T, cos: T) -> (T, T) {
    // Farther out the power is below the last digit: (cos x)ⁿ < e^(−n x²/2).
    let reach = T::lit(9.0) / (exponent + T::one()).sqrt();
    let integral = |upper: T| {
        integrate(T::zero(), upper.min(reach), |angle| {
            let (sin, cos) = angle.sin_cos();
            power_of_cosine(cos, sin * sin, exponent)
        })
    };
    let whole = integral(T::lit(FRAC_PI_2));
    (integral(sin.atan2(cos)) / whole, whole)
}
