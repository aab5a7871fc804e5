//! The mean magnitude of a normally distributed number without error function and exponential.

use super::sqrt;

/// √(z² + Q ψ(z²/Q)), since the mean, z erf ν + √Q exp(−ν²) with ν² = z²/(π Q), is even in z.
///
/// ψ falls from 1 to 0 like an exponential. Its eighth root is a polynomial on 0 … 12.4 π, constant from
/// there on, made by linear programming on 460 points so that the error relative to the mean is least, 1 at
/// 0, coefficients rounded one after the other: 4.8·10⁻⁸, and 3.8·10⁻⁷ with the rounding of the arithmetic.
#[inline(always)]
pub(in crate::real) fn mean_magnitude(z: f32, square_at_zero: f32) -> f32 {
    let square = z * z;
    let u = square / square_at_zero;
    let u = if u < 38.95575 { u } else { 38.95575 };
    let root = polynomial!(
        u;
        1.0, -0.04542241, 0.0012219314, -3.0250325e-5, 7.701781e-7, -1.5674877e-8, 1.5747569e-10
    );
    let second = root * root;
    let fourth = second * second;
    let sum = square + square_at_zero * (fourth * fourth);
    sqrt(if sum < f32::MAX { sum } else { f32::MAX })
}
