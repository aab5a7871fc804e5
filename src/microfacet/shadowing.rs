//! What a model of shadowing and masking can do.

use crate::direction::Pair;
use crate::real::Real;

/// The fraction of facets that are neither shadowed from the light nor masked from the viewer,
/// for a surface whose facets are distributed as `D`.
pub trait Shadowing<T: Real, D>: Send + Sync {
    /// G(wi, wo) / (4 (N·wi) (N·wo)), one quantity because it stays finite where G and the
    /// cosines vanish together.
    fn visibility(&self, distribution: &D, pair: &Pair<T>) -> T;

    /// G₁(w, h) / (4 (N·w)): the same for one direction. Times D(h) it is the density with which
    /// [`sample_visible`](Self::sample_visible) makes `w` reflect.
    fn masking(&self, distribution: &D, w: T::Vec3, h: T::Vec3) -> T;

    /// Draws `h` with the density of the normals visible from `wo`, G₁(wo, h) (wo·h) D(h) / (N·wo).
    fn sample_visible(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3;
}
