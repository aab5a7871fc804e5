//! What a model of shadowing and masking can do, and what it makes together with a distribution: a
//! surface of facets, all but the Fresnel term.

use alloc::boxed::Box;
use alloc::sync::Arc;
use core::array;

use crate::block::{DrawBlock, PairBlock, Plane};
use crate::direction::{Pair, above_or_normal, above_surface};
use crate::distribution::Distribution;
use crate::real::{Mask, Real, Vector, in_place};

/// The fraction of facets that are neither shadowed from the light nor masked from the viewer,
/// for a surface whose facets are distributed as `D`.
///
/// G(wi, wo, h) is that fraction for a pair of directions, G₁(w, h) the fraction that is not
/// hidden from `w` alone. Every answer is one quantity without a quotient of two vanishing ones,
/// finite also where the cosines and G go to zero together. The geometry of a [`Pair`] must have
/// `wo` above the surface; [`masking`](Self::masking) does not ask where `wi` is.
#[doc(alias("geometry term", "masking-shadowing", "G"))]
pub trait Shadowing<T: Real, D: Distribution<T>>: Send + Sync {
    /// G(wi, wo, h) / (4 (N·wi) (N·wo)): times D and F it is the BRDF.
    fn visibility(&self, distribution: &D, pair: &Pair<T>) -> T;

    /// G₁(wo, h) / (4 (N·wo)): times D it is the density per steradian of `wi`, the mirror image
    /// of `wo` in a normal that [`sample_visible`](Self::sample_visible) draws.
    fn masking(&self, distribution: &D, pair: &Pair<T>) -> T;

    /// G(wi, wo, h) / G₁(wo, h), in 0 … 1: of the facets that the viewer sees, the fraction that
    /// the light reaches. Times F it is the weight of a sample.
    fn unshadowed(&self, distribution: &D, pair: &Pair<T>) -> T;

    /// G(wi, wo, h) itself, in 0 … 1: zero where either direction lies below the surface.
    ///
    /// ```
    /// use brdf::{Beckmann, Pair, Shadowing, SmithCorrelated, VCavity};
    /// use glam::DVec3;
    ///
    /// let (beckmann, pair) = (Beckmann::new(0.8)?, Pair::new(DVec3::Z, DVec3::new(0.8, 0.0, 0.6)));
    /// assert!((VCavity.g(&beckmann, &pair) - 1.0).abs() < 1e-15);
    /// assert!((SmithCorrelated.g(&beckmann, &pair) - 0.968526).abs() < 1e-6);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[inline(always)]
    fn g(&self, distribution: &D, pair: &Pair<T>) -> T {
        let g = T::lit(4.0) * pair.cos_i * pair.cos_o * self.visibility(distribution, pair);
        g.min(T::one()).only_where(pair.above)
    }

    /// G₁(wo, h) itself, in 0 … 1: zero where the viewer lies below the surface.
    #[inline(always)]
    fn g1(&self, distribution: &D, pair: &Pair<T>) -> T {
        let g1 = T::lit(4.0) * pair.cos_o * self.masking(distribution, pair);
        g1.min(T::one()).only_where(above_surface::<T, _>(pair.wo))
    }

    /// Draws `h` with the density of the normals visible from `wo`, G₁(wo, h) (wo·h)₊ D(h) / (N·wo).
    /// A `wo` that is no direction above the surface counts as the normal. The uniform numbers are
    /// taken as by [`Brdf::sample`](crate::Brdf::sample).
    fn sample_visible(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3;

    /// A vector of any length along [`sample_visible`](Self::sample_visible) of a viewer above the
    /// surface; any answer for another.
    #[doc(hidden)]
    #[inline(always)]
    fn sample_visible_along(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        self.sample_visible(distribution, wo, u)
    }

    /// Where G is not smooth as a function of the facet's normal, if that is known: what a quadrature
    /// over facets has to know of it.
    #[doc(hidden)]
    fn kinks(&self, distribution: &D) -> Option<Kinks> {
        let _ = distribution;
        None
    }

    /// [`sample_visible`](Self::sample_visible) for a block of viewers: the components of a vector of
    /// any length along `h` fill the first three planes.
    fn sample_visible_block(
        &self,
        distribution: &D,
        draws: DrawBlock<'_, T>,
        h: &mut [Plane<T>; 4],
    ) {
        draws.numbers(
            h,
            #[inline(always)]
            |index| {
                let h = self.sample_visible_along(distribution, draws.wo(index), draws.u(index));
                [h.x(), h.y(), h.z(), T::zero()]
            },
        );
    }

    /// [`Mirrored`] of a pair.
    #[doc(hidden)]
    #[inline(always)]
    fn mirrored(&self, distribution: &D, wi: T::Vec3, wo: T::Vec3) -> Mirrored<T> {
        mirrored(distribution, self, wi, wo)
    }

    /// The density of samples.
    #[doc(hidden)]
    #[inline(always)]
    fn pdf(&self, distribution: &D, wi: T::Vec3, wo: T::Vec3) -> T {
        pdf(distribution, self, wi, wo)
    }

    /// Both.
    #[doc(hidden)]
    #[inline(always)]
    fn mirrored_pdf(&self, distribution: &D, wi: T::Vec3, wo: T::Vec3) -> (Mirrored<T>, T) {
        in_place!(
            T,
            #[inline(always)]
            || {
                let pair = Pair::new(wi, wo);
                let density = distribution.density_along(pair.sum);
                let visibility = self.visibility(distribution, &pair);
                let masking = self.masking(distribution, &pair);
                (Mirrored::of(&pair, density, visibility), pdf_of(&pair, density, masking))
            },
        )
    }

    /// [`Draw`] from a normal.
    #[doc(hidden)]
    #[inline(always)]
    fn mirror(&self, distribution: &D, wo: T::Vec3, h: T::Vec3) -> Draw<T> {
        mirror(distribution, self, wo, h)
    }

    /// [`Mirrored`] for a block of pairs.
    #[doc(hidden)]
    #[inline(never)]
    fn mirrored_block(
        &self,
        distribution: &D,
        pairs: PairBlock<'_, T>,
        mirrored: &mut [Plane<T>; 2],
    ) {
        pairs.numbers(
            mirrored,
            #[inline(always)]
            |index| self.mirrored(distribution, pairs.wi(index), pairs.wo(index)).planes(),
        );
    }

    /// The density of samples for a block of pairs.
    #[doc(hidden)]
    #[inline(never)]
    fn pdf_block(&self, distribution: &D, pairs: PairBlock<'_, T>, densities: &mut Plane<T>) {
        pairs.numbers(
            array::from_mut(densities),
            #[inline(always)]
            |index| [self.pdf(distribution, pairs.wi(index), pairs.wo(index))],
        );
    }

    /// Both for a block of pairs.
    #[doc(hidden)]
    #[inline(never)]
    fn mirrored_pdf_block(
        &self,
        distribution: &D,
        pairs: PairBlock<'_, T>,
        mirrored: &mut [Plane<T>; 2],
        densities: &mut Plane<T>,
    ) {
        pairs.changed(
            array::from_mut(densities),
            mirrored,
            #[inline(always)]
            |index, _| {
                let (wi, wo) = (pairs.wi(index), pairs.wo(index));
                let (mirrored, pdf) = self.mirrored_pdf(distribution, wi, wo);
                ([pdf], mirrored.planes())
            },
        );
    }

    /// [`Draw`] for a block of viewers, from normals in the first three planes, in whose place
    /// come direction and density.
    #[doc(hidden)]
    #[inline(never)]
    fn mirror_block(
        &self,
        distribution: &D,
        draws: DrawBlock<'_, T>,
        wi_pdf: &mut [Plane<T>; 4],
        weight: &mut [Plane<T>; 2],
    ) {
        draws.changed(
            wi_pdf,
            weight,
            #[inline(always)]
            |index, [x, y, z, _]| {
                self.mirror(distribution, draws.wo(index), Vector::new(x, y, z)).planes()
            },
        );
    }
}

/// Where G is not smooth as a function of the facet's normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kinks {
    /// Nowhere.
    None,
    /// Where one of the three terms of [`VCavity`](super::VCavity) takes over from another.
    Grooves,
}

/// Light that facets mirror: what the Fresnel term is asked, and what its answer is multiplied by.
#[derive(Clone, Copy, Debug)]
pub struct Mirrored<T> {
    /// The cosine of the angle of incidence on the facet, at most 1.
    pub(crate) cos: T,
    /// Zero where there is no reflection.
    pub(crate) scale: T,
}

impl<T: Real> Mirrored<T> {
    /// From D and G/(4 (N·wi) (N·wo)).
    #[inline(always)]
    pub(super) fn of(pair: &Pair<T>, density: T, visibility: T) -> Self {
        let value = (density * visibility).min(T::max_finite());
        Self { cos: cos_d(pair), scale: value.only_where(pair.above) }
    }

    #[inline(always)]
    pub(super) fn planes(self) -> [T; 2] {
        [self.cos, self.scale]
    }
}

/// A direction drawn by visible normals.
#[derive(Clone, Copy, Debug)]
pub struct Draw<T: Real> {
    pub(crate) wi: T::Vec3,
    pub(crate) pdf: T,
    /// What the weight consists of.
    pub(crate) weight: Mirrored<T>,
}

impl<T: Real> Draw<T> {
    /// From D, G₁/(4 N·wo) and G/G₁ of the pair, so that the density is that of `pdf` to the last bit.
    #[inline(always)]
    pub(super) fn of(pair: &Pair<T>, density: T, masking: T, unshadowed: T) -> Self {
        Self {
            wi: pair.wi,
            pdf: pdf_of(pair, density, masking),
            weight: Mirrored { cos: cos_d(pair), scale: unshadowed.only_where(pair.above) },
        }
    }

    /// Direction and density, and beside them the rest.
    #[inline(always)]
    pub(super) fn planes(self) -> ([T; 4], [T; 2]) {
        let Self { wi, pdf, weight } = self;
        ([wi.x(), wi.y(), wi.z(), pdf], weight.planes())
    }
}

/// D G / (4 (N·wi) (N·wo)).
#[inline(always)]
fn mirrored<T: Real, D: Distribution<T>, S: Shadowing<T, D> + ?Sized>(
    distribution: &D,
    shadowing: &S,
    wi: T::Vec3,
    wo: T::Vec3,
) -> Mirrored<T> {
    in_place!(
        T,
        #[inline(always)]
        || {
            let pair = Pair::new(wi, wo);
            let visibility = shadowing.visibility(distribution, &pair);
            Mirrored::of(&pair, distribution.density_along(pair.sum), visibility)
        },
    )
}

/// D G₁ / (4 N·wo).
#[inline(always)]
fn pdf<T: Real, D: Distribution<T>, S: Shadowing<T, D> + ?Sized>(
    distribution: &D,
    shadowing: &S,
    wi: T::Vec3,
    wo: T::Vec3,
) -> T {
    in_place!(
        T,
        #[inline(always)]
        || {
            let pair = Pair::new(wi, wo);
            let masking = shadowing.masking(distribution, &pair);
            pdf_of(&pair, distribution.density_along(pair.sum), masking)
        },
    )
}

/// What a facet of the drawn normal `h` mirrors to the viewer.
#[inline(always)]
fn mirror<T: Real, D: Distribution<T>, S: Shadowing<T, D> + ?Sized>(
    distribution: &D,
    shadowing: &S,
    wo: T::Vec3,
    h: T::Vec3,
) -> Draw<T> {
    in_place!(
        T,
        #[inline(always)]
        || {
            let pair = &mirror_pair::<T>(wo, h);
            let unshadowed = shadowing.unshadowed(distribution, pair);
            let masking = shadowing.masking(distribution, pair);
            Draw::of(pair, distribution.density_along(pair.sum), masking, unshadowed)
        },
    )
}

/// The density of samples from D and G₁/(4 N·wo).
#[inline(always)]
pub(super) fn pdf_of<T: Real>(pair: &Pair<T>, density: T, masking: T) -> T {
    (density * masking).min(T::max_finite()).only_where(pair.above)
}

/// A viewer and what a facet of a normal of any length mirrors to it. Nothing waits for the normal's root.
#[inline(always)]
pub(super) fn mirror_pair<T: Real>(viewer: T::Vec3, normal: T::Vec3) -> Pair<T> {
    let above = above_surface::<T, _>(viewer);
    let wo = above_or_normal::<T, _>(viewer);
    let length_squared = Vector::length_squared(normal);
    let usable = length_squared.gt(T::lit(1e-37)).and(above);
    let length_squared = T::select(usable, length_squared, T::one());
    let along = Vector::dot(viewer, normal);
    let wi = normal * ((along + along) / length_squared) - viewer;
    // The surface itself is the facet where there is none.
    let wi = <T::Vec3 as Vector<T>>::select(usable, wi, T::Vec3::new(-wo.x(), -wo.y(), wo.z()));
    Pair::where_above(wi, wo, above_surface::<T, _>(wi).and(above))
}

/// The cosine that the Fresnel term is asked for. That of a pair exceeds 1 by the rounding of the
/// directions' lengths.
#[inline(always)]
fn cos_d<T: Real>(pair: &Pair<T>) -> T {
    pair.cos_d.at_most(T::one())
}

macro_rules! forward {
    ($pointer:ty) => {
        impl<T: Real, D: Distribution<T>, S: Shadowing<T, D> + ?Sized> Shadowing<T, D>
            for $pointer
        {
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
            #[inline(always)]
            fn sample_visible_along(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
                (**self).sample_visible_along(distribution, wo, u)
            }
            fn kinks(&self, distribution: &D) -> Option<Kinks> {
                (**self).kinks(distribution)
            }
            fn sample_visible_block(
                &self,
                distribution: &D,
                draws: DrawBlock<'_, T>,
                h: &mut [Plane<T>; 4],
            ) {
                (**self).sample_visible_block(distribution, draws, h);
            }
            #[inline(always)]
            fn mirrored(&self, distribution: &D, wi: T::Vec3, wo: T::Vec3) -> Mirrored<T> {
                (**self).mirrored(distribution, wi, wo)
            }
            #[inline(always)]
            fn pdf(&self, distribution: &D, wi: T::Vec3, wo: T::Vec3) -> T {
                (**self).pdf(distribution, wi, wo)
            }
            #[inline(always)]
            fn mirrored_pdf(&self, distribution: &D, wi: T::Vec3, wo: T::Vec3) -> (Mirrored<T>, T) {
                (**self).mirrored_pdf(distribution, wi, wo)
            }
            #[inline(always)]
            fn mirror(&self, distribution: &D, wo: T::Vec3, h: T::Vec3) -> Draw<T> {
                (**self).mirror(distribution, wo, h)
            }
            fn mirrored_block(
                &self,
                distribution: &D,
                pairs: PairBlock<'_, T>,
                mirrored: &mut [Plane<T>; 2],
            ) {
                (**self).mirrored_block(distribution, pairs, mirrored);
            }
            fn pdf_block(
                &self,
                distribution: &D,
                pairs: PairBlock<'_, T>,
                densities: &mut Plane<T>,
            ) {
                (**self).pdf_block(distribution, pairs, densities);
            }
            fn mirrored_pdf_block(
                &self,
                distribution: &D,
                pairs: PairBlock<'_, T>,
                mirrored: &mut [Plane<T>; 2],
                densities: &mut Plane<T>,
            ) {
                (**self).mirrored_pdf_block(distribution, pairs, mirrored, densities);
            }
            fn mirror_block(
                &self,
                distribution: &D,
                draws: DrawBlock<'_, T>,
                wi_pdf: &mut [Plane<T>; 4],
                weight: &mut [Plane<T>; 2],
            ) {
                (**self).mirror_block(distribution, draws, wi_pdf, weight);
            }
        }
    };
}
forward!(Arc<S>);
forward!(Box<S>);
forward!(&S);
