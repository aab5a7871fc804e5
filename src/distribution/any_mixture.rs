//! What a mixture of any distributions answers: the sum of its terms, or one of them.

use core::array;

use super::any::{AnyDistribution, AnyMixture, each_smith};
use super::mixture::{Choice, Visible, reach};
use super::spread::{Spreads, mixed};
use super::traits::{Distribution, Smith};
use crate::block::{BLOCK, Block, DirectionBlock, DrawBlock, Plane, UniformBlock};
use crate::real::{Mask, Real};
use crate::sampling::uniform;

impl<T: Real> AnyMixture<T> {
    /// The mixture as one with Smith's shadowing, if that is known for all terms.
    pub(crate) fn as_smith(&self) -> Option<SmithMixture<'_, T>> {
        self.has_smith.then_some(SmithMixture(self))
    }

    /// A draw of one of the terms, chosen with the probabilities that `probability` tells.
    ///
    /// A term draws once it is known that the number does not reach the next: where the answer is
    /// known, as with plain floats, only one term draws.
    #[inline(always)]
    fn choose(
        &self,
        u: [T; 2],
        probability: impl Fn(T, &AnyDistribution<T>) -> T,
        draw: impl Fn(&AnyDistribution<T>, [T; 2]) -> T::Vec3,
    ) -> T::Vec3 {
        let mut choice = Choice::new(u);
        let mut before: Option<(&AnyDistribution<T>, [T; 2], T::Mask)> = None;
        for (weight, each) in &self.terms {
            let (u, reached) = choice.reach(probability(*weight, each));
            if let Some((each, u, mask)) = before {
                let mask = mask.and(reached.not());
                if !mask.is_never() {
                    choice.take(mask, draw(each, u));
                }
            }
            before = Some((each, u, reached));
        }
        if let Some((each, u, mask)) = before
            && !mask.is_never()
        {
            choice.take(mask, draw(each, u));
        }
        choice.chosen()
    }

    /// Σ wᵢ `term`(Dᵢ).
    #[inline(always)]
    fn sum(&self, term: impl Fn(&AnyDistribution<T>) -> T) -> T {
        self.terms.iter().fold(T::zero(), |sum, (weight, each)| sum + *weight * term(each))
    }
}

// Calls and no code in place: the terms of a mixture are of the type that contains it.
impl<T: Real> Distribution<T> for AnyMixture<T> {
    #[inline(never)]
    fn density(&self, h: T::Vec3) -> T {
        self.sum(|each| each.density(h)).min(T::max_finite())
    }

    #[inline(never)]
    fn density_along(&self, m: T::Vec3) -> T {
        self.sum(|each| each.density_along(m)).min(T::max_finite())
    }

    #[inline(never)]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        self.choose(u, |weight, _| weight, |each, u| each.sample(u))
    }

    #[inline(always)]
    fn sample_along(&self, u: [T; 2]) -> T::Vec3 {
        self.choose(u, |weight, _| weight, |each, u| each.sample_along(u))
    }

    fn spreads(&self) -> Option<Spreads<T>> {
        mixed(self.terms.iter().map(|(weight, each)| (*weight, each.spreads())))
    }

    fn density_block(&self, h: DirectionBlock<'_, T>, densities: &mut Plane<T>) {
        self.sum_block(h, densities, |each, density| each.density_block(h, density));
    }

    fn density_along_block(&self, m: DirectionBlock<'_, T>, densities: &mut Plane<T>) {
        self.sum_block(m, densities, |each, density| each.density_along_block(m, density));
    }

    fn sample_block(&self, uniforms: UniformBlock<'_, T>, h: &mut [Plane<T>; 4]) {
        self.choose_block(
            uniforms,
            h,
            |weight, _, probability| *probability = [weight; BLOCK],
            |each, uniforms, drawn| each.sample_block(uniforms, drawn),
        );
    }

    fn sample_along_block(&self, uniforms: UniformBlock<'_, T>, h: &mut [Plane<T>; 4]) {
        self.choose_block(
            uniforms,
            h,
            |weight, _, probability| *probability = [weight; BLOCK],
            |each, uniforms, drawn| each.sample_along_block(uniforms, drawn),
        );
    }
}

/// A mixture of distributions for which Smith's shadowing is known.
#[derive(Clone, Copy)]
pub(crate) struct SmithMixture<'a, T: Real>(&'a AnyMixture<T>);

impl<T: Real> Distribution<T> for SmithMixture<'_, T> {
    #[inline(always)]
    fn density(&self, h: T::Vec3) -> T {
        self.0.density(h)
    }

    #[inline(always)]
    fn density_along(&self, m: T::Vec3) -> T {
        self.0.density_along(m)
    }

    #[inline(always)]
    fn sample(&self, u: [T; 2]) -> T::Vec3 {
        self.0.sample(u)
    }
}

impl<T: Real> SmithMixture<'_, T> {
    /// What one of the distributions draws, chosen as the viewer sees them.
    #[inline(always)]
    fn choose_visible(
        &self,
        wo: T::Vec3,
        u: [T; 2],
        draw: impl Fn(&AnyDistribution<T>, [T; 2]) -> T::Vec3,
    ) -> T::Vec3 {
        let visible = Visible::new(wo, self.lambda_cos(wo));
        let probability = |weight, each: &AnyDistribution<T>| each_smith!(each, one => visible.probability(weight, one.lambda_cos(wo)), T::zero());
        self.0.choose(u, probability, draw)
    }
}

impl<T: Real> Smith<T> for SmithMixture<'_, T> {
    #[inline(never)]
    fn lambda_cos(&self, w: T::Vec3) -> T {
        let term =
            |each: &AnyDistribution<T>| each_smith!(each, one => one.lambda_cos(w), T::zero());
        self.0.sum(term).min(T::max_finite())
    }

    #[inline(never)]
    fn projected_area(&self, w: T::Vec3) -> T {
        let term =
            |each: &AnyDistribution<T>| each_smith!(each, one => one.projected_area(w), T::zero());
        self.0.sum(term).min(T::max_finite())
    }

    #[inline(never)]
    fn sample_visible(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        let draw =
            |each: &AnyDistribution<T>, u| each_smith!(each, one => one.sample_visible(wo, u), wo);
        self.choose_visible(wo, u, draw)
    }

    #[inline(never)]
    fn sample_visible_along(&self, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        let draw = |each: &AnyDistribution<T>, u| each_smith!(each, one => one.sample_visible_along(wo, u), wo);
        self.choose_visible(wo, u, draw)
    }

    fn projected_area_block(&self, w: DirectionBlock<'_, T>, areas: &mut Plane<T>) {
        self.0.sum_block(w, areas, |each, area| {
            each_smith!(each, one => one.projected_area_block(w, area), ());
        });
    }

    fn sample_visible_block(&self, draws: DrawBlock<'_, T>, h: &mut [Plane<T>; 4]) {
        let visible = |index| Visible::new(draws.wo(index), self.lambda_cos(draws.wo(index)));
        let visible: [Visible<T>; BLOCK] = array::from_fn(visible);
        let [_, _, _, u0, u1] = draws.planes;
        self.0.choose_block(
            draws.of([u0, u1]),
            h,
            |weight, each, probability| {
                each_smith!(each, one => draws.numbers(array::from_mut(probability), |index| {
                    [visible[index].probability(weight, one.lambda_cos(draws.wo(index)))]
                }), ());
            },
            |each, uniforms, drawn| {
                let draws = draws.with(uniforms.planes);
                each_smith!(each, one => one.sample_visible_block(draws, drawn), ());
            },
        );
    }
}

impl<T: Real> AnyMixture<T> {
    /// Σ wᵢ `term`(Dᵢ) for a block.
    fn sum_block<const N: usize>(
        &self,
        block: Block<'_, T, N>,
        sum: &mut Plane<T>,
        term: impl Fn(&AnyDistribution<T>, &mut Plane<T>),
    ) {
        let mut part = [T::zero(); BLOCK];
        *sum = part;
        for (weight, each) in &self.terms {
            term(each, &mut part);
            block.changed(
                array::from_mut(sum),
                &mut [],
                #[inline(always)]
                |index, [sum]| ([sum + *weight * part[index]], []),
            );
        }
        *sum = sum.map(|sum| sum.min(T::max_finite()));
    }

    /// [`choose`](Self::choose) for a block: every term draws.
    fn choose_block(
        &self,
        uniforms: UniformBlock<'_, T>,
        h: &mut [Plane<T>; 4],
        probability: impl Fn(T, &AnyDistribution<T>, &mut Plane<T>),
        draw: impl Fn(&AnyDistribution<T>, UniformBlock<'_, T>, &mut [Plane<T>; 4]),
    ) {
        let zero = [T::zero(); BLOCK];
        let (mut part, mut start, mut place, mut drawn) = (zero, zero, zero, [zero; 4]);
        *h = [zero, zero, [T::one(); BLOCK], zero];
        let [u0, u1] = uniforms.planes;
        for (weight, each) in &self.terms {
            probability(*weight, each, &mut part);
            let at = |index: usize| {
                let [u, _] = uniform([u0[index]; 2]);
                reach(u, start[index], part[index])
            };
            uniforms.numbers(array::from_mut(&mut place), |index| [at(index).0]);
            draw(each, uniforms.of([&place, u1]), &mut drawn);
            uniforms.changed(
                h,
                &mut [],
                #[inline(always)]
                |index, before| {
                    let (_, reached) = at(index);
                    let mut after = before;
                    for (after, drawn) in after.iter_mut().zip(&drawn) {
                        *after = T::select(reached, drawn[index], *after);
                    }
                    (after, [])
                },
            );
            for (start, part) in start.iter_mut().zip(&part) {
                *start = *start + *part;
            }
        }
    }
}
