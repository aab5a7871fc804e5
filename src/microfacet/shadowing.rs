//! What a model of shadowing and masking can do.

use alloc::boxed::Box;

use crate::direction::Pair;
use crate::real::Real;

/// The fraction of facets that are neither shadowed from the light nor masked from the viewer,
/// for a surface whose facets are distributed as `D`.
///
/// G(wi, wo, h) is that fraction for a pair of directions, G₁(w, h) the fraction that is not
/// hidden from `w` alone. Every answer is one quantity without a quotient of two vanishing ones,
/// finite also where the cosines and G go to zero together. The geometry of a [`Pair`] must have
/// `wo` above the surface; [`masking`](Self::masking) does not ask where `wi` is.
pub trait Shadowing<T: Real, D>: Send + Sync {
    /// G(wi, wo, h) / (4 (N·wi) (N·wo)): times D and F it is the BRDF.
    fn visibility(&self, distribution: &D, pair: &Pair<T>) -> T;

    /// G₁(wo, h) / (4 (N·wo)): times D it is the density per steradian of `wi`, the mirror image
    /// of `wo` in a normal that [`sample_visible`](Self::sample_visible) draws.
    fn masking(&self, distribution: &D, pair: &Pair<T>) -> T;

    /// G(wi, wo, h) / G₁(wo, h), in 0 … 1: of the facets that the viewer sees, the fraction that
    /// the light reaches. Times F it is the weight of a sample.
    fn unshadowed(&self, distribution: &D, pair: &Pair<T>) -> T;

    /// Draws `h` with the density of the normals visible from `wo`, G₁(wo, h) (wo·h)₊ D(h) / (N·wo).
    /// A `wo` that is no direction above the surface counts as the normal. The uniform numbers are
    /// taken as by [`Brdf::sample`](crate::Brdf::sample).
    fn sample_visible(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3;
}

macro_rules! forward {
    ($pointer:ty) => {
        impl<T: Real, D, S: Shadowing<T, D> + ?Sized> Shadowing<T, D> for $pointer {
            #[inline(always)]
            fn visibility(&self, distribution: &D, pair: &Pair<T>) -> T {
                (**self).visibility(distribution, pair)
            }
            #[inline(always)]
            fn masking(&self, distribution: &D, pair: &Pair<T>) -> T {
                (**self).masking(distribution, pair)
            }
            #[inline(always)]
            fn unshadowed(&self, distribution: &D, pair: &Pair<T>) -> T {
                (**self).unshadowed(distribution, pair)
            }
            #[inline(always)]
            fn sample_visible(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
                (**self).sample_visible(distribution, wo, u)
            }
        }
    };
}
forward!(Box<S>);
forward!(&S);
