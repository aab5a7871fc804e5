//! Schlick's rational stand-ins of 1994 for parts of microfacet models.

use crate::real::Real;

/// √(2/π).
const ROOT: f64 = 0.7978845608028654;

/// Schlick's rational function in the place of π times Beckmann's distribution,
/// m³x/(t(mx² − x² + m²)²) with x = t + m − 1, 0 where x is not positive.
///
/// `roughness` is m in 0 … 1, `cos` t = N·H. Peak and norm, 2∫ D t dt = 1, are exact; the error is up to
/// 14 % of the peak for m ≤ 0.5 and more beyond.
///
/// ```
/// let value = brdf::glossy::schlick_beckmann(0.4_f64, 0.99);
/// assert!((value - 5.33568682270334).abs() < 1e-13);
/// ```
#[must_use]
pub fn schlick_beckmann<T: Real>(roughness: T, cos: T) -> T {
    let one = T::one();
    let x = cos + roughness - one;
    let there = x.gt(T::zero());
    let x = T::select(there, x, one);
    let squared = roughness.squared();
    let below = squared - (one - roughness) * x.squared();
    let value = roughness * squared * x / (T::select(there, cos, one) * below.squared());
    value.min(T::max_finite()).only_where(there)
}

/// Schlick's rational function in the place of Smith's masking, v/(v − kv + k) with k = √(2m²/π).
///
/// `roughness` is m, `cos` v = N·V. It was fitted to Smith's form without the exponential, with m as the slope
/// along one axis, and is off by up to 0.098 (m = 0.1), 0.074 (0.2), 0.053 (0.3), 0.046 (0.5).
///
/// ```
/// let value = brdf::glossy::schlick_masking(0.4_f64, 0.9);
/// assert!((value - 0.965752918093463).abs() < 1e-14);
/// ```
#[must_use]
pub fn schlick_masking<T: Real>(roughness: T, cos: T) -> T {
    let k = roughness * T::lit(ROOT);
    cos / (cos + k * (T::one() - cos))
}
