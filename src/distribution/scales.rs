//! The roughness of editors and files in terms of the α of the literature.

use crate::real::Real;

/// α = r²: the roughness r of Disney's material and of those that followed it (Blender, glTF, USD,
/// Filament, Unreal), often called perceptual. r from 0 to 1; the distributions want α ≥ 10⁻⁸.
///
/// ```
/// use brdf::{Ggx, distribution::alpha_of_perceptual_roughness};
///
/// let ggx = Ggx::new(alpha_of_perceptual_roughness(0.5_f32))?;
/// assert_eq!(ggx.roughness(), [0.25, 0.25]);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
///
/// # Sources
/// B. Burley, "Physically based shading at Disney", SIGGRAPH 2012 course, section 5.4.
#[doc(alias("perceptual roughness"))]
#[inline]
#[must_use]
pub fn alpha_of_perceptual_roughness<T: Real>(roughness: T) -> T {
    roughness.squared()
}

/// α = √r: the roughness r of pbrt-v4's materials where `remaproughness` is true, its default. r from
/// 0 to 1; the distributions want α ≥ 10⁻⁸.
///
/// ```
/// use brdf::distribution::alpha_of_pbrt_roughness;
///
/// assert_eq!(alpha_of_pbrt_roughness(0.25_f32), 0.5);
/// ```
///
/// # Sources
/// M. Pharr, W. Jakob, G. Humphreys, "Physically Based Rendering", 4th edition, 2023, section 9.6.
#[doc(alias("remaproughness", "RoughnessToAlpha"))]
#[inline]
#[must_use]
pub fn alpha_of_pbrt_roughness<T: Real>(roughness: T) -> T {
    roughness.sqrt()
}
