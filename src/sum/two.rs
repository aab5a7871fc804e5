use alloc::vec;

use super::terms::{Kept, Term, Terms, limited};
use super::weighted::WeightedSum;
use crate::block::{ColorBlock, DrawBlock, PairBlock, Plane, SampleBlock};
use crate::brdf::{Brdf, Sample};
use crate::error::{ParameterError, range};
use crate::real::{Color, Lift, Mask, Real, lift};
use crate::sampling::uniform;

/// The weighted sum of two models whose types are known: textured plastic, a base under a coat.
///
/// # Formula
/// ```text
/// f = w₁ f₁ + w₂ f₂        pdf = p₁ pdf₁ + p₂ pdf₂        pₖ = mean(wₖ)/(mean(w₁) + mean(w₂))
/// ```
///
/// # Parameters
///
/// | symbol | meaning | range |
/// |---|---|---|
/// | wₖ | weight of a term, per channel | 0 … 10¹⁰ |
/// | fₖ | any model with the same colours; a sum of two for three terms | |
///
/// Its answers are those of [`WeightedSum`](crate::WeightedSum) of the same terms. It is `Copy` where
/// its terms are and needs no memory of its own, so that a sum may be made for each place of a texture:
///
/// ```
/// use brdf::{Brdf, CookTorrance, Ggx, Lambert, ParameterError, Schlick, SumOfTwo, batch};
/// use glam::Vec3;
///
/// let texture = [Vec3::new(0.8, 0.2, 0.1), Vec3::new(0.1, 0.3, 0.7)];
/// let coat = CookTorrance::new(Ggx::new(0.1)?, Schlick::new(Vec3::splat(0.04))?);
/// let plastic = |place: usize| {
///     SumOfTwo::new((Vec3::splat(0.9), Lambert::new(texture[place])?), (Vec3::splat(0.1), coat))
/// };
/// let mut values = [Vec3::ZERO; 2];
/// batch::eval_each(plastic, (&[Vec3::Z; 2]).into(), Vec3::Z.into(), (&mut values).into())?;
/// assert_eq!(values[1], plastic(1)?.eval(Vec3::Z, Vec3::Z));
///
/// // A third term: a sum is a term too.
/// let dust = Lambert::new(Vec3::splat(0.5))?;
/// let dusty = SumOfTwo::new((Vec3::splat(0.8), plastic(0)?), (Vec3::splat(0.2), dust))?;
/// assert!(dusty.albedo(Vec3::Z).z > plastic(0)?.albedo(Vec3::Z).z);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Energy
/// Reciprocal if both terms are. Conserving if both terms are and the weights of each channel add up
/// to at most 1; the directional albedo is w₁ E₁ + w₂ E₂.
///
/// # Sampling
/// From one term, chosen with probability pₖ by the first uniform number, which is then stretched
/// to serve again.
#[doc(alias("mix", "blend", "layer"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SumOfTwo<A, B, C = glam::Vec3, T = f32> {
    first: Term<A, C, T>,
    second: Term<B, C, T>,
}

impl<A, B, C, T> SumOfTwo<A, B, C, T> {
    /// The sum of two (weight, model) pairs.
    ///
    /// # Errors
    /// If a channel of a `weight` is not in 0 … 10¹⁰, or if the `total weight`, averaged over the
    /// channels, is 0 or (below 10⁻³⁰) as good as that.
    pub fn new(first: (C, A), second: (C, B)) -> Result<Self, ParameterError>
    where
        T: Real,
        C: Color<T>,
    {
        let (first, second) = (Term::new(first.0, first.1)?, Term::new(second.0, second.1)?);
        let total = first.probability + second.probability;
        range::TOTAL_WEIGHT.check("total weight", total)?;
        let share = |mean: T| mean / total;
        Ok(Self {
            first: Term { probability: share(first.probability), ..first },
            second: Term { probability: share(second.probability), ..second },
        })
    }

    /// The same sum of models of one type.
    pub(crate) fn into_sum<M>(self) -> WeightedSum<M, C, T>
    where
        A: Into<M>,
        B: Into<M>,
    {
        WeightedSum { terms: vec![self.first.map(Into::into), self.second.map(Into::into)] }
    }
}

lift! {
    [T: Real, C: Color<T>, A: Lift<T>, B: Lift<T>] SumOfTwo<A, B, C, T>
        => SumOfTwo<A::Over<U>, B::Over<U>, C::Over<U>, U>:
    SumOfTwo { first: part, second: part }
}

impl<A, B, C, T> Brdf<T> for SumOfTwo<A, B, C, T>
where
    T: Real,
    C: Color<T>,
    A: Brdf<T, Color = C>,
    B: Brdf<T, Color = C>,
{
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        self.total(self.first.model.eval(wi, wo), self.second.model.eval(wi, wo))
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        self.density(self.first.model.pdf(wi, wo), self.second.model.pdf(wi, wo))
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3) -> (C, T) {
        let (first, second) =
            (self.first.model.eval_pdf(wi, wo), self.second.model.eval_pdf(wi, wo));
        (self.total(first.0, second.0), self.density(first.1, second.1))
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let ([u0, u1], start, end) = (uniform(u), T::zero(), self.first.probability);
        let (mut kept, second) = (Kept::new(), self.second.reached(end, u0));
        let first = self.first.reached(start, u0).and(second.not());
        // What is not kept need not be drawn.
        if !first.is_never() {
            let draw = self.first.model.sample(wo, [self.first.stretched(start, u0), u1]);
            kept = kept.or(first, draw.wi, draw.pdf);
        }
        if !second.is_never() {
            let draw = self.second.model.sample(wo, [self.second.stretched(end, u0), u1]);
            kept = kept.or(second, draw.wi, draw.pdf);
        }
        let (value, pdf) = self.eval_pdf(kept.wi, wo);
        kept.sample(pdf, value)
    }

    fn is_reciprocal(&self) -> bool {
        self.first.model.is_reciprocal() && self.second.model.is_reciprocal()
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        self.total(self.first.model.albedo(wo), self.second.model.albedo(wo))
    }

    fn eval_block(&self, pairs: PairBlock<'_, T>, values: &mut ColorBlock<T, C>) {
        Terms(&self.terms()).eval_block(pairs, values);
    }

    fn pdf_block(&self, pairs: PairBlock<'_, T>, pdf: &mut Plane<T>) {
        Terms(&self.terms()).pdf_block(pairs, pdf);
    }

    fn eval_pdf_block(
        &self,
        pairs: PairBlock<'_, T>,
        values: &mut ColorBlock<T, C>,
        pdf: &mut Plane<T>,
    ) {
        Terms(&self.terms()).eval_pdf_block(pairs, values, pdf);
    }

    fn sample_block(&self, draws: DrawBlock<'_, T>, samples: &mut SampleBlock<T, C>) {
        Terms(&self.terms()).sample_block(draws, samples);
    }
}

impl<A, B, C, T> SumOfTwo<A, B, C, T> {
    /// Both terms, of one type.
    fn terms(&self) -> [Term<&dyn Brdf<T, Color = C>, C, T>; 2]
    where
        T: Real,
        C: Color<T>,
        A: Brdf<T, Color = C>,
        B: Brdf<T, Color = C>,
    {
        [self.first.as_dyn(), self.second.as_dyn()]
    }

    /// The weighted sum of a colour of each.
    #[inline(always)]
    fn total(&self, first: C, second: C) -> C
    where
        T: Real,
        C: Color<T>,
    {
        limited(self.first.weight * first + self.second.weight * second)
    }

    /// The density of both together.
    #[inline(always)]
    fn density(&self, first: T, second: T) -> T
    where
        T: Real,
    {
        (self.first.probability * first + self.second.probability * second).min(T::max_finite())
    }
}
