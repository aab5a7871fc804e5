use alloc::vec::Vec;
use core::fmt;

use super::terms::{Kept, Term, Terms, limited};
use crate::block::{ColorBlock, DrawBlock, PairBlock, Plane, SampleBlock};
use crate::brdf::{Brdf, Sample};
use crate::error::{ParameterError, range};
use crate::real::{Color, Lift, Mask, Real};
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
#[doc(alias("mix", "blend", "layer"))]
#[derive(Clone, PartialEq)]
pub struct WeightedSum<M, C = glam::Vec3, T = f32> {
    pub(super) terms: Vec<Term<M, C, T>>,
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
            let term = Term::new(weight, model)?;
            total = total + term.probability;
            checked.push(term);
        }
        range::TOTAL_WEIGHT.check("total weight", total)?;
        for term in &mut checked {
            term.probability = term.probability / total;
        }
        Ok(Self { terms: checked })
    }

    /// The same sum of other models, each made of the one in its place.
    pub(crate) fn map<N>(self, mut change: impl FnMut(M) -> N) -> WeightedSum<N, C, T> {
        WeightedSum { terms: self.terms.into_iter().map(|term| term.map(&mut change)).collect() }
    }
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

    fn is_reciprocal(&self) -> bool {
        self.terms.iter().all(|term| term.model.is_reciprocal())
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        self.total(|model| model.albedo(wo))
    }

    fn eval_block(&self, pairs: PairBlock<'_, T>, values: &mut ColorBlock<T, C>) {
        Terms(&self.terms).eval_block(pairs, values);
    }

    fn pdf_block(&self, pairs: PairBlock<'_, T>, pdf: &mut Plane<T>) {
        Terms(&self.terms).pdf_block(pairs, pdf);
    }

    fn eval_pdf_block(
        &self,
        pairs: PairBlock<'_, T>,
        values: &mut ColorBlock<T, C>,
        pdf: &mut Plane<T>,
    ) {
        Terms(&self.terms).eval_pdf_block(pairs, values, pdf);
    }

    fn sample_block(&self, draws: DrawBlock<'_, T>, samples: &mut SampleBlock<T, C>) {
        Terms(&self.terms).sample_block(draws, samples);
    }
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
