//! Blocks of a surface whose facets are of several kinds: each kind answers for the whole block, in
//! loops of its own, and the answers are put together.

use core::array;

use super::areas::Areas;
use super::shadowing::{Draw, Mirrored, mirror_pair, pdf_of};
use crate::block::{BLOCK, DrawBlock, PairBlock, Plane};
use crate::direction::Pair;
use crate::distribution::{AnyMixture, Distribution, Smith};
use crate::real::{Real, Vector};

/// What the kinds of facets answer together.
struct Together<T> {
    /// D.
    density: Plane<T>,
    /// A(wi) and A(wo), if the shadowing depends on them.
    areas: [Plane<T>; 2],
}

impl<T: Real> Together<T> {
    #[inline(never)]
    fn new<S: Areas<T>>(mixture: &AnyMixture<T>, pairs: PairBlock<'_, T>) -> Self {
        let zero = [T::zero(); BLOCK];
        let (mut sum, mut density, mut areas) = ([zero; 3], zero, [zero; 2]);
        pairs.numbers(
            &mut sum,
            #[inline(always)]
            |index| {
                let sum = Pair::<T>::sum(pairs.wi(index), pairs.wo(index));
                [sum.x(), sum.y(), sum.z()]
            },
        );
        mixture.density_along_block(pairs.of(sum.each_ref()), &mut density);
        if let (true, Some(smith)) = (S::NEEDED, mixture.as_smith()) {
            for (area, w) in areas.iter_mut().zip(pairs.apart()) {
                smith.projected_area_block(w, area);
            }
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
    pairs: PairBlock<'_, T>,
    mirrored: &mut [Plane<T>; 2],
) {
    let answers = Together::new::<S>(mixture, pairs);
    pairs.numbers(
        mirrored,
        #[inline(always)]
        |index| {
            let pair = Pair::new(pairs.wi(index), pairs.wo(index));
            let visibility = S::visibility_of(answers.areas(index), &pair);
            Mirrored::of(&pair, answers.density[index], visibility).planes()
        },
    );
}

#[inline(never)]
pub(super) fn pdf<T: Real, S: Areas<T>>(
    mixture: &AnyMixture<T>,
    pairs: PairBlock<'_, T>,
    densities: &mut Plane<T>,
) {
    let answers = Together::new::<S>(mixture, pairs);
    pairs.numbers(
        array::from_mut(densities),
        #[inline(always)]
        |index| {
            let pair = Pair::new(pairs.wi(index), pairs.wo(index));
            let masking = S::masking_of(answers.areas(index), &pair);
            [pdf_of(&pair, answers.density[index], masking)]
        },
    );
}

#[inline(never)]
pub(super) fn mirrored_pdf<T: Real, S: Areas<T>>(
    mixture: &AnyMixture<T>,
    pairs: PairBlock<'_, T>,
    mirrored_planes: &mut [Plane<T>; 2],
    densities: &mut Plane<T>,
) {
    mirrored::<T, S>(mixture, pairs, mirrored_planes);
    pdf::<T, S>(mixture, pairs, densities);
}

#[inline(never)]
pub(super) fn mirror<T: Real, S: Areas<T>>(
    mixture: &AnyMixture<T>,
    draws: DrawBlock<'_, T>,
    wi_pdf: &mut [Plane<T>; 4],
    weight: &mut [Plane<T>; 2],
) {
    // The viewer too: where it is no direction above the surface, the normal stands for it.
    let mut pairs = [[T::zero(); BLOCK]; 6];
    let [h_x, h_y, h_z, _] = &*wi_pdf;
    draws.numbers(
        &mut pairs,
        #[inline(always)]
        |index| {
            let h = Vector::new(h_x[index], h_y[index], h_z[index]);
            let Pair { wi, wo, .. } = mirror_pair::<T>(draws.wo(index), h);
            [wi.x(), wi.y(), wi.z(), wo.x(), wo.y(), wo.z()]
        },
    );
    let answers = Together::new::<S>(mixture, draws.of(pairs.each_ref()));
    draws.changed(
        wi_pdf,
        weight,
        #[inline(always)]
        |index, [x, y, z, _]| {
            let pair = mirror_pair::<T>(draws.wo(index), Vector::new(x, y, z));
            let areas = answers.areas(index);
            let (masking, unshadowed) =
                (S::masking_of(areas, &pair), S::unshadowed_of(areas, &pair));
            Draw::of(&pair, answers.density[index], masking, unshadowed).planes()
        },
    );
}
