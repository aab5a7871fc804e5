//! The terms of a sum, what one of them draws, and blocks of all of them.

use crate::block::{BLOCK, ColorBlock, DrawBlock, PairBlock, Plane, SampleBlock};
use crate::brdf::{Brdf, Sample};
use crate::error::{ParameterError, range};
use crate::real::{Color, Lift, Mask, Real, Vector, lift};
use crate::sampling::uniform;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Term<M, C, T> {
    pub(super) weight: C,
    /// The probability to draw from this term.
    pub(super) probability: T,
    pub(super) model: M,
}

lift! {
    [T: Real, C: Color<T>, M: Lift<T>] Term<M, C, T> => Term<M::Over<U>, C::Over<U>, U>:
    Term { weight: color, probability: number, model: part }
}

impl<M, C, T> Term<M, C, T> {
    /// A term with the mean of its weight in the place of the probability.
    pub(super) fn new(weight: C, model: M) -> Result<Self, ParameterError>
    where
        T: Real,
        C: Color<T>,
    {
        range::WEIGHT.check("weight", weight)?;
        Ok(Self { weight, probability: weight.mean(), model })
    }

    /// The same term with a model made of this one.
    pub(super) fn map<N>(self, change: impl FnOnce(M) -> N) -> Term<N, C, T> {
        let Self { weight, probability, model } = self;
        Term { weight, probability, model: change(model) }
    }

    /// The same model behind a reference without its type.
    pub(super) fn as_dyn(&self) -> Term<&dyn Brdf<T, Color = C>, C, T>
    where
        T: Real,
        C: Color<T>,
        M: Brdf<T, Color = C>,
    {
        Term { weight: self.weight, probability: self.probability, model: &self.model }
    }
}

/// The terms of a sum for the blocks of its batches: block by block, term by term, each term in loops
/// of its own.
pub(super) struct Terms<'a, M, C, T>(pub(super) &'a [Term<M, C, T>]);

impl<T, C, M> Terms<'_, M, C, T>
where
    T: Real,
    C: Color<T>,
    M: Brdf<T, Color = C>,
{
    pub(super) fn eval_block(self, pairs: PairBlock<'_, T>, values: &mut ColorBlock<T, C>) {
        let (mut sum, mut each) = (black::<T, C>(), black::<T, C>());
        for term in self.0 {
            term.model.eval_block(pairs, &mut each);
            add::<T, C>(pairs, &mut sum, term.weight, &each);
        }
        for (values, sum) in values.as_mut().iter_mut().zip(sum.as_ref()) {
            *values = sum.map(|sum| sum.min(T::max_finite()));
        }
    }

    pub(super) fn pdf_block(self, pairs: PairBlock<'_, T>, pdf: &mut Plane<T>) {
        let mut each = [T::zero(); BLOCK];
        let mut sum = each;
        for term in self.0 {
            term.model.pdf_block(pairs, &mut each);
            for (sum, pdf) in sum.iter_mut().zip(each) {
                *sum = *sum + term.probability * pdf;
            }
        }
        *pdf = sum.map(|sum| sum.min(T::max_finite()));
    }

    pub(super) fn eval_pdf_block(
        self,
        pairs: PairBlock<'_, T>,
        values: &mut ColorBlock<T, C>,
        pdf: &mut Plane<T>,
    ) {
        let (mut value, mut density) = (black::<T, C>(), [T::zero(); BLOCK]);
        let (mut values_sum, mut sum) = (black::<T, C>(), density);
        for term in self.0 {
            term.model.eval_pdf_block(pairs, &mut value, &mut density);
            add::<T, C>(pairs, &mut values_sum, term.weight, &value);
            for (sum, pdf) in sum.iter_mut().zip(density) {
                *sum = *sum + term.probability * pdf;
            }
        }
        for (values, sum) in values.as_mut().iter_mut().zip(values_sum.as_ref()) {
            *values = sum.map(|sum| sum.min(T::max_finite()));
        }
        *pdf = sum.map(|sum| sum.min(T::max_finite()));
    }

    pub(super) fn sample_block(self, draws: DrawBlock<'_, T>, samples: &mut SampleBlock<T, C>) {
        let (mut start, mut kept) = (T::zero(), [Kept::new(); BLOCK]);
        let [_, _, _, u0, u1] = draws.planes;
        let u0 = u0.map(|u| uniform([u; 2])[0]);
        for term in self.0 {
            let stretched = u0.map(|u| term.stretched(start, u));
            term.model.sample_block(draws.with([&stretched, u1]), samples);
            let [x, y, z, pdf] = &samples.wi_pdf;
            for (index, kept) in kept.iter_mut().enumerate() {
                let wi = Vector::new(x[index], y[index], z[index]);
                *kept = kept.or(term.reached(start, u0[index]), wi, pdf[index]);
            }
            start = start + term.probability;
        }
        let (mut pdf, mut values) = ([T::zero(); BLOCK], black::<T, C>());
        let wi = kept.each_ref().map(|kept| kept.wi);
        let wi = [wi.map(Vector::x), wi.map(Vector::y), wi.map(Vector::z)];
        let pairs = draws.lit_from(wi.each_ref());
        self.eval_pdf_block(pairs, &mut values, &mut pdf);
        draws.samples(
            samples,
            #[inline(always)]
            |index| kept[index].sample(pdf[index], C::at(&values, index)),
        );
    }
}

/// Adds weighted colours to a block.
#[inline(always)]
fn add<T: Real, C: Color<T>>(
    pairs: PairBlock<'_, T>,
    sum: &mut ColorBlock<T, C>,
    weight: C,
    each: &ColorBlock<T, C>,
) {
    let weights = weight.channels();
    pairs.within(
        #[inline(always)]
        || {
            let channels = sum.as_mut().iter_mut().zip(each.as_ref());
            for ((sum, each), weight) in channels.zip(weights.as_ref()) {
                for (sum, each) in sum.iter_mut().zip(each) {
                    *sum = *sum + *weight * *each;
                }
            }
        },
    );
}

/// A block of black.
#[inline(always)]
fn black<T: Real, C: Color<T>>() -> ColorBlock<T, C> {
    C::by_channel(|_| [T::zero(); BLOCK])
}

impl<M, C, T: Real> Term<M, C, T> {
    /// The first uniform number of this term's own sample, whose part begins at `start`. Rounding
    /// may stretch it to 1, and for the terms not kept it lies anywhere: ½ serves as well.
    #[inline(always)]
    pub(super) fn stretched(&self, start: T, u: T) -> T {
        let (zero, one) = (T::zero(), T::one());
        let possible = self.probability.gt(zero);
        let stretched = (u - start) / T::select(possible, self.probability, one);
        let usable = stretched.ge(zero).and(stretched.lt(one));
        T::select(usable, stretched, T::lit(0.5))
    }

    /// Where the term begins at or before u₀: of such terms the last one draws the sample.
    #[inline(always)]
    pub(super) fn reached(&self, start: T, u: T) -> T::Mask {
        self.probability.gt(T::zero()).and(u.ge(start))
    }
}

/// The draw that a sum keeps, with its density within the term that drew it.
#[derive(Clone, Copy)]
pub(super) struct Kept<T: Real> {
    pub(super) wi: T::Vec3,
    drawn: T,
}

impl<T: Real> Kept<T> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        let zero = T::zero();
        Self { wi: Vector::new(zero, zero, T::one()), drawn: zero }
    }

    /// Another draw where the mask is true.
    #[inline(always)]
    pub(super) fn or(self, mask: T::Mask, wi: T::Vec3, drawn: T) -> Self {
        Self { wi: Vector::select(mask, wi, self.wi), drawn: T::select(mask, drawn, self.drawn) }
    }

    /// The sample, with density and value of the whole sum. The probability of a direction is that
    /// of all terms; what one of them could draw, the sum can.
    #[inline(always)]
    pub(super) fn sample<C: Color<T>>(self, pdf: T, value: C) -> Sample<T, C> {
        let valid = self.drawn.gt(T::zero()).and(pdf.gt(T::zero()));
        let scale = (self.wi.z() / T::select(valid, pdf, T::one())).min(T::max_finite());
        let weight = value.map(|value| (value * scale).min(T::max_finite()));
        Sample { wi: self.wi, weight, pdf }.only_where(valid)
    }
}

#[inline(always)]
pub(super) fn limited<T: Real, C: Color<T>>(color: C) -> C {
    color.map(|value| value.min(T::max_finite()))
}
