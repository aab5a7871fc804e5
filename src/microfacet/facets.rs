//! What distribution and shadowing make together, without the Fresnel term.
//!
//! For batches this is a stage of its own. It is compiled once for each pair of distribution and
//! shadowing and not once more for each Fresnel term, and its loops keep to fewer registers.

use super::shadowing::Shadowing;
use crate::block::planes::{Answers, BLOCK, Components, Plane, Planes, within};
use crate::block::{BatchError, Directions, InstructionSet, run};
use crate::direction::{Pair, above_or_normal, above_surface, reflect};
use crate::distribution::Distribution;
use crate::real::{Mask, Real, Vector, in_place};

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
        Self { cos: [T::zero(); BLOCK], scale: [T::zero(); BLOCK] }
    }

    #[inline(always)]
    pub(super) fn at(&self, index: usize) -> Mirrored<T> {
        Mirrored { cos: self.cos[index], scale: self.scale[index] }
    }
}

impl<T: Real> Answers for MirroredBlock<T> {
    type Answer = Mirrored<T>;

    #[inline(always)]
    fn fill(&mut self, formula: impl Fn(usize) -> Mirrored<T>) {
        for index in 0..BLOCK {
            let mirrored = formula(index);
            self.cos[index] = mirrored.cos;
            self.scale[index] = mirrored.scale;
        }
    }
}

/// Fills in draws: see [`Answers::fill`].
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "an iterator would be another function")]
fn fill_draws<T: Real>(
    wi: &mut Planes<T, 3>,
    pdf: &mut Plane<T>,
    weight: &mut MirroredBlock<T>,
    formula: impl Fn(usize) -> Draw<T>,
) {
    for index in 0..BLOCK {
        let draw = formula(index);
        wi.0[0][index] = draw.wi.x();
        wi.0[1][index] = draw.wi.y();
        wi.0[2][index] = draw.wi.z();
        pdf[index] = draw.pdf;
        weight.cos[index] = draw.weight.cos;
        weight.scale[index] = draw.weight.scale;
    }
}

/// What a block of draws remembers from stage to stage.
pub(super) struct DrawBlock<T> {
    normals: Planes<T, 3>,
    pub(super) weight: MirroredBlock<T>,
}

impl<T: Real> DrawBlock<T> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self { normals: Planes::new(), weight: MirroredBlock::new() }
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
                Mirrored { cos: cos_d(&pair), scale: value.only_where(pair.above) }
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
                self.density(&pair).only_where(pair.above)
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
        self.shadowing.sample_visible(self.distribution, wo, u)
    }

    /// What a facet of the drawn normal `h` mirrors to the viewer.
    #[inline(always)]
    fn mirror<T: Real>(&self, wo: T::Vec3, h: T::Vec3) -> Draw<T>
    where
        D: Distribution<T>,
        S: Shadowing<T, D>,
    {
        let above = above_surface::<T, _>(wo);
        let wo = above_or_normal::<T, _>(wo);
        let wi = reflect(wo, h);
        // Everything else from the pair, so that it agrees with `eval` and `pdf` to the last bit.
        let pair = Pair::where_above(wi, wo, above_surface::<T, _>(wi).and(above));
        let unshadowed = self.shadowing.unshadowed(self.distribution, &pair);
        Draw {
            wi,
            pdf: self.density(&pair).only_where(pair.above),
            weight: Mirrored { cos: cos_d(&pair), scale: unshadowed.only_where(pair.above) },
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
        DrawBlock { normals, weight }: &mut DrawBlock<T>,
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
                normals.fill(
                    #[inline(always)]
                    |index| self.visible(wo.at(index), [u[0][index], u[1][index]]),
                );
                let normals = normals.components();
                fill_draws(
                    wi,
                    pdf,
                    weight,
                    #[inline(always)]
                    |index| self.mirror(wo.at(index), normals.at(index)),
                );
            },
        );
    }
}

/// The cosine that the Fresnel term is asked for. That of a pair exceeds 1 by the rounding of the
/// directions' lengths.
#[inline(always)]
fn cos_d<T: Real>(pair: &Pair<T>) -> T {
    pair.cos_d.min(T::one())
}
