//! Blocks of a surface whose facets are of several kinds: each kind answers for the whole block, in
//! loops of its own, and the answers are put together.

use core::array;

use super::areas::Areas;
use super::shadowing::{Draw, Mirrored, mirror_pair, pdf_of};
use crate::block::{BLOCK, DirectionBlock, InstructionSet, Plane, fill, refill, within};
use crate::direction::Pair;
use crate::distribution::{AnyMixture, Distribution, Smith};
use crate::real::{Real, Vector};

/// What the kinds of facets answer together.
struct Answers<T> {
    /// D.
    density: Plane<T>,
    /// A(wi) and A(wo), if the shadowing depends on them.
    areas: [Plane<T>; 2],
}

impl<T: Real> Answers<T> {
    #[inline(never)]
    fn new<S: Areas<T>>(
        mixture: &AnyMixture<T>,
        set: InstructionSet,
        wi: DirectionBlock<'_, T>,
        wo: DirectionBlock<'_, T>,
    ) -> Self {
        let zero = [T::zero(); BLOCK];
        let (mut sum, mut density, mut areas) = ([zero; 3], zero, [zero; 2]);
        fill(&mut sum, |index| {
            let sum = Pair::<T>::sum(wi.at(index), wo.at(index));
            [sum.x(), sum.y(), sum.z()]
        });
        mixture.density_along_block(set, DirectionBlock::new(&sum), &mut density);
        if let (true, Some(smith)) = (S::NEEDED, mixture.as_smith()) {
            let [area_i, area_o] = &mut areas;
            smith.projected_area_block(set, wi, area_i);
            smith.projected_area_block(set, wo, area_o);
        }
        Self { density, areas }
    }

    #[inline(always)]
    fn areas(&self, index: usize) -> [T; 2] {
        [self.areas[0][index], self.areas[1][index]]
    }
}

#[inline(never)]
pub(super) fn mirrored<T: Real, S: Areas<T>>(
    mixture: &AnyMixture<T>,
    set: InstructionSet,
    [wi, wo]: [DirectionBlock<'_, T>; 2],
    mirrored: &mut [Plane<T>; 2],
) {
    let answers = Answers::new::<S>(mixture, set, wi, wo);
    within::<T, _>(
        set,
        #[inline(always)]
        || {
            fill(
                mirrored,
                #[inline(always)]
                |index| {
                    let pair = Pair::new(wi.at(index), wo.at(index));
                    let visibility = S::visibility_of(answers.areas(index), &pair);
                    Mirrored::of(&pair, answers.density[index], visibility).planes()
                },
            );
        },
    );
}

#[inline(never)]
pub(super) fn pdf<T: Real, S: Areas<T>>(
    mixture: &AnyMixture<T>,
    set: InstructionSet,
    [wi, wo]: [DirectionBlock<'_, T>; 2],
    densities: &mut Plane<T>,
) {
    let answers = Answers::new::<S>(mixture, set, wi, wo);
    within::<T, _>(
        set,
        #[inline(always)]
        || {
            fill(
                array::from_mut(densities),
                #[inline(always)]
                |index| {
                    let pair = Pair::new(wi.at(index), wo.at(index));
                    let masking = S::masking_of(answers.areas(index), &pair);
                    [pdf_of(&pair, answers.density[index], masking)]
                },
            );
        },
    );
}

#[inline(never)]
pub(super) fn mirror<T: Real, S: Areas<T>>(
    mixture: &AnyMixture<T>,
    set: InstructionSet,
    wo: DirectionBlock<'_, T>,
    wi_pdf: &mut [Plane<T>; 4],
    weight: &mut [Plane<T>; 2],
) {
    // The viewer too: where it is no direction above the surface, the normal stands for it.
    let mut pairs = [[T::zero(); BLOCK]; 6];
    let [h_x, h_y, h_z, _] = &*wi_pdf;
    fill(&mut pairs, |index| {
        let h = Vector::new(h_x[index], h_y[index], h_z[index]);
        let Pair { wi, wo, .. } = mirror_pair::<T>(wo.at(index), h);
        [wi.x(), wi.y(), wi.z(), wo.x(), wo.y(), wo.z()]
    });
    let [a, b, c, d, e, f] = &pairs;
    let answers =
        Answers::new::<S>(mixture, set, DirectionBlock([a, b, c]), DirectionBlock([d, e, f]));
    within::<T, _>(
        set,
        #[inline(always)]
        || {
            refill(
                wi_pdf,
                weight,
                #[inline(always)]
                |index, [x, y, z, _]| {
                    let pair = mirror_pair::<T>(wo.at(index), Vector::new(x, y, z));
                    let areas = answers.areas(index);
                    let (masking, unshadowed) =
                        (S::masking_of(areas, &pair), S::unshadowed_of(areas, &pair));
                    Draw::of(&pair, answers.density[index], masking, unshadowed).planes()
                },
            );
        },
    );
}
