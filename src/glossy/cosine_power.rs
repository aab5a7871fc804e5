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
    let (zero, one) = (T::lit(0.0), T::lit(1.0));
    let positive = versine.lt(one);
    let logarithm = T::select(positive, -versine, zero).ln_1p();
    T::select(positive, (exponent * logarithm).exp(), zero)
}

/// cosⁿ of a unit vector's height and of the square of its sine; zero where the cosine is not
/// positive. Below 45° the sine is the smaller one and has the digits, above the cosine.
#[inline(always)]
pub(super) fn power_of_cosine<T: Real>(cos: T, sin_squared: T, exponent: T) -> T {
    let (zero, half, one) = (T::lit(0.0), T::lit(0.5), T::lit(1.0));
    let positive = cos.gt(zero);
    let near = sin_squared.lt(half);
    let logarithm = T::select(
        near,
        T::select(near, -sin_squared, zero).ln_1p() * half,
        T::select(positive, cos, one).ln(),
    );
    T::select(positive, (exponent * logarithm).exp(), zero)
}

/// The fraction of the weights cosⁿ, over a quarter turn, that lies below the angle
/// asin(`sin`): ∫₀^angle cosⁿ / ∫₀^π/2 cosⁿ, and the second of these integrals.
#[inline(always)]
pub(super) fn quarter_turn<T: Real>(exponent: T, sin: T, cos: T) -> (T, T) {
    // Farther out the power is below the last digit: (cos x)ⁿ < e^(−n x²/2).
    let reach = T::lit(9.0) / (exponent + T::lit(1.0)).sqrt();
    let integral = |upper: T| {
        integrate(T::lit(0.0), upper.min(reach), |angle| {
            let (sin, cos) = angle.sin_cos();
            power_of_cosine(cos, sin * sin, exponent)
        })
    };
    let whole = integral(T::lit(FRAC_PI_2));
    (integral(sin.atan2(cos)) / whole, whole)
}
