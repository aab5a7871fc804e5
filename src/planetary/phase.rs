//! Henyey and Greenstein's phase function: how the light that a grain scatters spreads over the sphere.

use core::f64::consts::FRAC_1_PI;

use crate::real::{Real, Vector};

/// p(g)/4π of a phase angle g: the density per steradian of the scattered light.
///
/// ```text
/// p = (1 − ξ²)/(1 + 2ξ cos g + ξ²)^(3/2)    cos g = L·V
/// ```
///
/// L points against the way of the light, so that ξ < 0 scatters back. The sum under the root is
/// (1 − |ξ|)² + 2|ξ| v with v = 1 + cos g = |L + V|²/2 for ξ > 0 and v = 1 − cos g = |L − V|²/2 for
/// ξ < 0, in which nothing cancels.
#[inline(always)]
pub(super) fn density<T: Real>(xi: T, l: T::Vec3, v: T::Vec3) -> T {
    let (one, two) = (T::one(), T::lit(2.0));
    let forward = xi.gt(T::zero());
    let far = Vector::length_squared(Vector::select(forward, l + v, l - v)) * T::lit(0.5);
    let steepness = steepness(xi, forward);
    let root = ((one - steepness).squared() + two * steepness * far).sqrt();
    let p = (one - xi) * (one + xi) / (root.squared() * root);
    p * T::lit(0.25 * FRAC_1_PI)
}

/// |ξ|, of the side that the formula is chosen for, so that it has its slope at 0 too.
#[inline(always)]
fn steepness<T: Real>(xi: T, forward: T::Mask) -> T {
    T::select(forward, xi, -xi)
}

/// 1 − cos g and 1 + cos g of a phase angle that is drawn with this density by a number in 0 … 1:
/// both as products, so that both ends keep their digits.
#[inline(always)]
pub(super) fn sample<T: Real>(xi: T, u: T) -> (T, T) {
    let (one, two) = (T::one(), T::lit(2.0));
    let rest = one - u;
    let s = one + xi - two * xi * u;
    let versine = two * rest * (one - xi * u) * ((one + xi) / s).squared();
    let antiversine = two * u * (one + xi * rest) * ((one - xi) / s).squared();
    (versine, antiversine)
}

/// The number for which [`sample`] answers this 1 − cos g and 1 + cos g.
#[inline(always)]
pub(super) fn distribution<T: Real>(xi: T, (versine, antiversine): (T, T)) -> T {
    let (one, forward) = (T::one(), xi.gt(T::zero()));
    let steepness = steepness(xi, forward);
    // 1 + 2ξ cos g + ξ², as in the density.
    let far = T::select(forward, antiversine, versine);
    let root = ((one - steepness).squared() + T::lit(2.0) * steepness * far).sqrt();
    (one + xi) * antiversine / (root * (one - xi + root))
}
