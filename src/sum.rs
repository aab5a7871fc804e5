use alloc::vec::Vec;
use core::fmt;

use crate::block::{BLOCK, ColorBlock, DrawBlock, PairBlock, Plane, SampleBlock};
use crate::brdf::{Brdf, Sample};
use crate::error::{ParameterError, range};
use crate::real::{Color, Lift, Mask, Real, Vector, lift};
use crate::sampling::uniform;

/// A weighted sum of models: diffuse plus specular, mixtures of materials, layers.
///
/// # Formula
/// ```text
/// f = Σ wₖ fₖ        pdf = Σ pₖ pdfₖ        pₖ = mean(wₖ)/Σ mean(wⱼ)
/// ```
///
/// # Parameters
///
/// | symbol | meaning | range |
/// |---|---|---|
/// | wₖ | weight of a term, per channel | 0 … 10¹⁰ |
/// | fₖ | any model, also `Box<dyn Brdf<Color = …>>` or another sum | |
///
/// # Energy
/// Reciprocal if all terms are. Conserving if all terms are and the weights of each channel add up
/// to at most 1; the directional albedo is Σ wₖ Eₖ.
///
/// # Sampling
/// From one term, chosen with probability pₖ by the first uniform number, which is then stretched
/// to serve again.
///
/// ```
/// use brdf::{Brdf, Lambert, Phong, WeightedSum};
/// use glam::Vec3;
///
/// type Layer = Box<dyn Brdf<Color = Vec3>>;
/// let diffuse: Layer = Box::new(Lambert::new(Vec3::new(0.8, 0.2, 0.1))?);
/// let gloss: Layer = Box::new(Phong::new(Vec3::ONE, 40.0)?);
/// let plastic = WeightedSum::new([(Vec3::splat(0.9), diffuse), (Vec3::splat(0.1), gloss)])?;
/// assert!((plastic.albedo(Vec3::Z).x - 0.82).abs() < 1e-6);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct WeightedSum<M, C = glam::Vec3, T = f32> {
    terms: Vec<Term<M, C, T>>,
}

#[derive(Clone, PartialEq)]
struct Term<M, C, T> {
    weight: C,
    /// The probability to draw from this term.
    probability: T,
    model: M,
}

/// Shows the weights; models behind `dyn` have nothing to show.
impl<M, C: fmt::Debug, T> fmt::Debug for WeightedSum<M, C, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("WeightedSum ")?;
        f.debug_list().entries(self.terms.iter().map(|term| &term.weight)).finish()
    }
}

impl<M, C, T> WeightedSum<M, C, T> {
    /// The sum of the given (weight, model) pairs.
    ///
    /// # Errors
    /// If there is no term, if a channel of a `weight` is not in 0 … 10¹⁰, or if the
    /// `total weight`, averaged over the channels, is 0 or (below 10⁻³⁰) as good as that.
    pub fn new(terms: impl IntoIterator<Item = (C, M)>) -> Result<Self, ParameterError>
    where
        T: Real,
        C: Color<T>,
    {
        let mut total = T::zero();
        let mut checked = Vec::new();
        for (weight, model) in terms {
            range::WEIGHT.check("weight", weight)?;
            let mean = weight.mean();
            total = total + mean;
            checked.push(Term { weight, probability: mean, model });
        }
        range::TOTAL_WEIGHT.check("total weight", total)?;
        for term in &mut checked {
            term.probability = term.probability / total;
        }
        Ok(Self { terms: checked })
    }

    /// The same sum of other models, each made of the one in its place.
    pub(crate) fn map<N>(self, mut change: impl FnMut(M) -> N) -> WeightedSum<N, C, T> {
        let terms = self.terms.into_iter().map(|Term { weight, probability, model }| Term {
            weight,
            probability,
            model: change(model),
        });
        WeightedSum { terms: terms.collect() }
    }
}

lift! {
    [T: Real, C: Color<T>, M: Lift<T>] Term<M, C, T> => Term<M::Over<U>, C::Over<U>, U>:
    Term { weight: color, probability: number, model: part }
}

impl<T: Real, C: Color<T>, M: Lift<T>> Lift<T> for WeightedSum<M, C, T> {
    type Over<U: Real> = WeightedSum<M::Over<U>, C::Over<U>, U>;

    fn lift<U: Real>(&self, lift: impl Fn(T) -> U + Copy) -> Self::Over<U> {
        WeightedSum { terms: self.terms.iter().map(|term| term.lift(lift)).collect() }
    }
}

impl<M, C, T> Brdf<T> for WeightedSum<M, C, T>
where
    T: Real,
    C: Color<T>,
    M: Brdf<T, Color = C>,
{
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        self.total(|model| model.eval(wi, wo))
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let sum = self
            .terms
            .iter()
            .fold(T::zero(), |sum, term| sum + term.probability * term.model.pdf(wi, wo));
        sum.min(T::max_finite())
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3) -> (C, T) {
        let (value, pdf) = self.terms.iter().fold(
            (C::splat(T::zero()), T::zero()),
            |(values, densities), term| {
                let (value, pdf) = term.model.eval_pdf(wi, wo);
                (values + term.weight * value, densities + term.probability * pdf)
            },
        );
        (limited(value), pdf.min(T::max_finite()))
    }

    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let (u, mut start, mut kept) = (uniform(u), T::zero(), Kept::new());
        for (index, term) in self.terms.iter().enumerate() {
            let end = start + term.probability;
            // What the next term replaces need not be drawn.
            let next = self.terms.get(index + 1).map(|next| next.reached(end, u[0]));
            let reached = term.reached(start, u[0]);
            let needed = next.map_or(reached, |next| reached.and(next.not()));
            if !needed.is_never() {
                let sample = term.model.sample(wo, [term.stretched(start, u[0]), u[1]]);
                kept = kept.or(needed, sample.wi, sample.pdf);
            }
            start = end;
        }
        let (value, pdf) = self.eval_pdf(kept.wi, wo);
        kept.sample(pdf, value)
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        self.total(|model| model.albedo(wo))
    }

    // Block by block, term by term: each term in loops of its own.

    fn eval_block(&self, pairs: PairBlock<'_, T>, values: &mut ColorBlock<T, C>) {
        let (mut sum, mut each) = (black::<T, C>(), black::<T, C>());
        for term in &self.terms {
            term.model.eval_block(pairs, &mut each);
            add::<T, C>(pairs, &mut sum, term.weight, &each);
        }
        for (values, sum) in values.as_mut().iter_mut().zip(sum.as_ref()) {
            *values = sum.map(|sum| sum.min(T::max_finite()));
        }
    }

    fn pdf_block(&self, pairs: PairBlock<'_, T>, pdf: &mut Plane<T>) {
        let mut each = [T::zero(); BLOCK];
        let mut sum = each;
        for term in &self.terms {
            term.model.pdf_block(pairs, &mut each);
            for (sum, pdf) in sum.iter_mut().zip(each) {
                *sum = *sum + term.probability * pdf;
            }
        }
        *pdf = sum.map(|sum| sum.min(T::max_finite()));
    }

    fn eval_pdf_block(
        &self,
        pairs: PairBlock<'_, T>,
        values: &mut ColorBlock<T, C>,
        pdf: &mut Plane<T>,
    ) {
        let (mut value, mut density) = (black::<T, C>(), [T::zero(); BLOCK]);
        let (mut values_sum, mut sum) = (black::<T, C>(), density);
        for term in &self.terms {
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

    fn sample_block(&self, draws: DrawBlock<'_, T>, samples: &mut SampleBlock<T, C>) {
        let (mut start, mut kept) = (T::zero(), [Kept::new(); BLOCK]);
        let [_, _, _, u0, u1] = draws.planes;
        let u0 = u0.map(|u| uniform([u; 2])[0]);
        for term in &self.terms {
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
    fn stretched(&self, start: T, u: T) -> T {
        let (zero, one) = (T::zero(), T::one());
        let possible = self.probability.gt(zero);
        let stretched = (u - start) / T::select(possible, self.probability, one);
        let usable = stretched.ge(zero).and(stretched.lt(one));
        T::select(usable, stretched, T::lit(0.5))
    }

    /// Where the term begins at or before u₀: of such terms the last one draws the sample.
    #[inline(always)]
    fn reached(&self, start: T, u: T) -> T::Mask {
        self.probability.gt(T::zero()).and(u.ge(start))
    }
}

/// The draw that a sum keeps, with its density within the term that drew it.
#[derive(Clone, Copy)]
struct Kept<T: Real> {
    wi: T::Vec3,
    drawn: T,
}

impl<T: Real> Kept<T> {
    #[inline(always)]
    fn new() -> Self {
        let zero = T::zero();
        Self { wi: Vector::new(zero, zero, T::one()), drawn: zero }
    }

    /// Another draw where the mask is true.
    #[inline(always)]
    fn or(self, mask: T::Mask, wi: T::Vec3, drawn: T) -> Self {
        Self { wi: Vector::select(mask, wi, self.wi), drawn: T::select(mask, drawn, self.drawn) }
    }

    /// The sample, with density and value of the whole sum. The probability of a direction is that
    /// of all terms; what one of them could draw, the sum can.
    #[inline(always)]
    fn sample<C: Color<T>>(self, pdf: T, value: C) -> Sample<T, C> {
        let valid = self.drawn.gt(T::zero()).and(pdf.gt(T::zero()));
        let scale = (self.wi.z() / T::select(valid, pdf, T::one())).min(T::max_finite());
        let weight = value.map(|value| (value * scale).min(T::max_finite()));
        Sample { wi: self.wi, weight, pdf }.only_where(valid)
    }
}

#[inline(always)]
fn limited<T: Real, C: Color<T>>(color: C) -> C {
    color.map(|value| value.min(T::max_finite()))
}

impl<M, C, T> WeightedSum<M, C, T> {
    /// Σ wₖ · a colour of each model, no larger than the largest number.
    #[inline(always)]
    fn total(&self, color: impl Fn(&M) -> C) -> C
    where
        T: Real,
        C: Color<T>,
    {
        let sum = self
            .terms
            .iter()
            .fold(C::splat(T::zero()), |sum, term| sum + term.weight * color(&term.model));
        limited(sum)
    }
}
