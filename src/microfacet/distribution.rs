//! What a distribution of facet normals can do.

use crate::real::Real;

/// A distribution of facet normals, D(h) in sr⁻¹, normalised to ∫ D(h) (N·h) dω_h = 1.
///
/// D(h) is the same for `h` and its mirror image across the normal, (−h_x, −h_y, h_z).
pub trait Distribution<T: Real = f32>: Send + Sync {
    /// D(h) for a unit `h`; zero where `h` lies below the surface.
    fn density(&self, h: T::Vec3) -> T;

    /// Draws `h` with density D(h) (N·h) from two uniform numbers in [0, 1).
    ///
    /// The first number decides the slopes s_x and s_y, the second is the azimuth:
    /// (h_x, h_y)/h_z = (s_x cos 2πu₁, s_y sin 2πu₁). [`VCavity`](crate::VCavity) draws visible
    /// normals of any distribution by this.
    fn sample(&self, u: [T; 2]) -> T::Vec3;
}

/// A distribution for which Smith's shadowing is known in closed form.
pub trait Smith<T: Real = f32>: Distribution<T> {
    /// Λ(w) cosθ of a direction above the surface: what Smith's Λ (the ratio of hidden to visible
    /// projected facet area) becomes when multiplied by N·w. Stays finite at grazing.
    fn lambda_cos(&self, w: T::Vec3) -> T;

    /// Draws `h` with the density of the normals visible from `wo`, G₁(wo) (wo·h) D(h) / (N·wo).
    fn sample_visible(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3;
}
