//! What distribution and shadowing make together, without the Fresnel term.
//!
//! For batches this is a stage of its own. It is compiled once for each pair of distribution and
//! shadowing and not once more for each Fresnel term, and its loops keep to fewer registers.

use super::distribution::Distribution;
use super::shadowing::Shadowing;
use crate::block::planes::{Answers, BLOCK, Components, Plane, Planes, within};
use crate::block::{BatchError, Directions, InstructionSet, run};
use crate::direction::{Pair, above_or_normal, above_surface, reflect};
use crate::real::{Mask, Real, in_place};

/// The facets of a surface.
#[derive(Clone, Copy)]
pub(super) struct Facets<'a, D, S> {
    pub(super) distribution: &'a D,
    pub(super) shadowing: &'a S,
}

/// Light that facets mirror: what the Fresnel term is asked, and what its answer is multiplied by.
#[derive(Clone, Copy)]
pub(super) struct Mirrored<T> {
    /// The cosine of the angle of incidence on the facet, at most 1.
    pub(super) cos: T,
    /// Zero where there is no reflection.
    pub(super) scale: T,
}

/// A direction drawn by visible normals.
#[derive(Clone, Copy)]
pub(super) struct Draw<T: Real> {
    pub(super) wi: T::Vec3,
    pub(super) pdf: T,
    /// What the weight consists of.
    pub(super) weight: Mirrored<T>,
}

/// [`Mirrored`] for a block.
pub(super) struct MirroredBlock<T> {
    cos: Plane<T>,
    scale: Plane<T>,
}

impl<T: Real> MirroredBlock<T> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self { cos: [T::lit(0.0); BLOCK], scale: [T::lit(0.0); BLOCK] }
    }

    #[inline(always)]
    pub(super) fn at(&self, index: usize) -> Mirrored<T> {
        Mirrored { cos: self.cos[index], scale: self.scale[index] }
    }
}

impl<T: Real> Answers for MirroredBlock<T> {
    type Answer = Mirrored<T>;
    type Strip = [<Plane<T> as Answers>::Strip; 2];

    #[inline(always)]
    fn strip() -> Self::Strip {
        [Plane::strip(), Plane::strip()]
    }
    #[inline(always)]
    fn put([cos, scale]: &mut Self::Strip, lane: usize, answer: Mirrored<T>) {
        Plane::put(cos, lane, answer.cos);
        Plane::put(scale, lane, answer.scale);
    }
    #[inline(always)]
    fn store(&mut self, start: usize, [cos, scale]: &Self::Strip) {
        self.cos.store(start, cos);
        self.scale.store(start, scale);
    }
}

impl<D, S> Facets<'_, D, S> {
    /// D G / (4 (N·wi) (N·wo)).
    #[inline(always)]
    pub(super) fn mirrored<T: Real>(&self, wi: T::Vec3, wo: T::Vec3) -> Mirrored<T>
    where
        D: Distribution<T>,
        S: Shadowing<T, D>,
    {
        in_place::<T, _>(
            #[inline(always)]
            || {
                let pair = Pair::new(wi, wo);
                let visibility = self.shadowing.visibility(self.distribution, &pair);
                let value =
                    (self.distribution.density_along(pair.sum) * visibility).min(T::max_finite());
                Mirrored { cos: cos_d(&pair), scale: T::select(pair.above, value, T::lit(0.0)) }
            },
        )
    }

    #[inline(always)]
    pub(super) fn pdf<T: Real>(&self, wi: T::Vec3, wo: T::Vec3) -> T
    where
        D: Distribution<T>,
        S: Shadowing<T, D>,
    {
        in_place::<T, _>(
            #[inline(always)]
            || {
                let pair = Pair::new(wi, wo);
                T::select(pair.above, self.density(&pair), T::lit(0.0))
            },
        )
    }

    #[inline(always)]
    pub(super) fn draw<T: Real>(&self, wo: T::Vec3, u: [T; 2]) -> Draw<T>
    where
        D: Distribution<T>,
        S: Shadowing<T, D>,
    {
        in_place::<T, _>(
            #[inline(always)]
            || self.mirror(wo, self.visible(wo, u)),
        )
    }

    /// The normal of a facet that the viewer sees.
    #[inline(always)]
    fn visible<T: Real>(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3
    where
        D: Distribution<T>,
        S: Shadowing<T, D>,
    {
        self.shadowing.sample_visible(self.distribution, above_or_normal::<T, _>(wo), u)
    }

    /// What a facet of the drawn normal `h` mirrors to the viewer.
    #[inline(always)]
    fn mirror<T: Real>(&self, wo: T::Vec3, h: T::Vec3) -> Draw<T>
    where
        D: Distribution<T>,
        S: Shadowing<T, D>,
    {
        let (zero, above) = (T::lit(0.0), above_surface::<T, _>(wo));
        let wo = above_or_normal::<T, _>(wo);
        let wi = reflect(wo, h);
        // Everything else from the pair, so that it agrees with `eval` and `pdf` to the last bit.
        let pair = Pair::new(wi, wo);
        let drawn = above.and(pair.above);
        let unshadowed = self.shadowing.unshadowed(self.distribution, &pair);
        Draw {
            wi,
            pdf: T::select(drawn, self.density(&pair), zero),
            weight: Mirrored { cos: cos_d(&pair), scale: T::select(drawn, unshadowed, zero) },
        }
    }

    /// The density of the samples, whether or not the light is above the surface.
    #[inline(always)]
    fn density<T: Real>(&self, pair: &Pair<T>) -> T
    where
        D: Distribution<T>,
        S: Shadowing<T, D>,
    {
        let masking = self.shadowing.masking(self.distribution, pair);
        (self.distribution.density_along(pair.sum) * masking).min(T::max_finite())
    }

    #[inline(never)]
    pub(super) fn mirrored_block<T: Real>(
        &self,
        set: InstructionSet,
        wi: Components<'_, T>,
        wo: Components<'_, T>,
        mirrored: &mut MirroredBlock<T>,
    ) where
        D: Distribution<T>,
        S: Shadowing<T, D>,
    {
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                mirrored.fill(
                    #[inline(always)]
                    |index| self.mirrored(wi.at(index), wo.at(index)),
                );
            },
        );
    }

    #[inline(never)]
    pub(super) fn pdf_batch<T: Real>(
        &self,
        wi: Directions<'_, T>,
        wo: Directions<'_, T>,
        pdf: &mut [T],
    ) -> Result<(), BatchError>
    where
        D: Distribution<T>,
        S: Shadowing<T, D>,
    {
        run::pdf(wi, wo, pdf, &|set, _, wi, wo, pdf| {
            within::<T, _>(
                set,
                #[inline(always)]
                || {
                    pdf.fill(
                        #[inline(always)]
                        |index| self.pdf(wi.at(index), wo.at(index)),
                    );
                },
            );
            Ok(())
        })
    }

    #[inline(never)]
    pub(super) fn draw_block<T: Real>(
        &self,
        set: InstructionSet,
        wo: Components<'_, T>,
        u: [&Plane<T>; 2],
        (wi, pdf): (&mut Planes<T, 3>, &mut Plane<T>),
        weight: &mut MirroredBlock<T>,
    ) where
        D: Distribution<T>,
        S: Shadowing<T, D>,
    {
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                // In two loops: a processor works ahead by a number of instructions, and the
                // shorter the way through a loop, the more of its turns overlap.
                let mut normals = Planes::<T, 3>::new();
                normals.fill(
                    #[inline(always)]
                    |index| self.visible(wo.at(index), [u[0][index], u[1][index]]),
                );
                let normals = normals.components();
                (wi, pdf, weight).fill(
                    #[inline(always)]
                    |index| {
                        let draw = self.mirror(wo.at(index), normals.at(index));
                        (draw.wi, draw.pdf, draw.weight)
                    },
                );
            },
        );
    }
}

/// The cosine that the Fresnel term is asked for. That of a pair exceeds 1 by the rounding of the
/// directions' lengths.
#[inline(always)]
fn cos_d<T: Real>(pair: &Pair<T>) -> T {
    pair.cos_d.min(T::lit(1.0))
}
