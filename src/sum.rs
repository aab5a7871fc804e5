use alloc::vec::Vec;
use core::fmt;

use crate::brdf::{Brdf, Sample};
use crate::error::{ParameterError, range};
use crate::real::{Color, Mask, Real, Vector};
use crate::sampling::uniform;

/// A weighted sum of models: diffuse plus specular, mixtures of materials, layers.
///
/// ```text
/// f = Σ wₖ fₖ        pdf = Σ pₖ pdfₖ        pₖ = mean(wₖ)/Σ mean(wⱼ)
/// ```
///
/// | symbol | meaning | range |
/// |---|---|---|
/// | wₖ | weight of a term, per channel | 0 … 10¹⁰ |
/// | fₖ | any model, also `Box<dyn Brdf<Color = …>>` or another sum | |
///
/// Reciprocal if all terms are. Conserving if all terms are and the weights of each channel add up
/// to at most 1; the directional albedo is Σ wₖ Eₖ. A sample is drawn from one term, chosen with
/// probability pₖ by the first uniform number, which is then stretched to serve again.
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
        let mut total = T::lit(0.0);
        let mut checked = Vec::new();
        for (weight, model) in terms {
            ParameterError::check("weight", range::WEIGHT, |lower, upper| {
                weight.outside(lower, upper)
            })?;
            let mean = weight.mean();
            total = total + mean;
            checked.push(Term { weight, probability: mean, model });
        }
        ParameterError::check("total weight", range::TOTAL_WEIGHT, |lower, upper| {
            total.outside(lower, upper)
        })?;
        for term in &mut checked {
            term.probability = term.probability / total;
        }
        Ok(Self { terms: checked })
    }

    /// The same sum of other models, each made of the one in its place.
    #[cfg(feature = "serde")]
    pub(crate) fn map<N>(self, mut change: impl FnMut(M) -> N) -> WeightedSum<N, C, T> {
        let terms = self.terms.into_iter().map(|Term { weight, probability, model }| Term {
            weight,
            probability,
            model: change(model),
        });
        WeightedSum { terms: terms.collect() }
    }
}

impl<M, C, T> Brdf<T> for WeightedSum<M, C, T>
where
    T: Real,
    C: Color<T>,
    M: Brdf<T, Color = C>,
{
    type Color = C;

    #[inline]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        self.total(|model| model.eval(wi, wo))
    }

    #[inline]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let sum = self
            .terms
            .iter()
            .fold(T::lit(0.0), |sum, term| sum + term.probability * term.model.pdf(wi, wo));
        sum.min(T::max_finite())
    }

    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let (u, zero, one) = (uniform(u), T::lit(0.0), T::lit(1.0));
        let mut start = zero;
        let mut wi = <T::Vec3 as Vector<T>>::new(zero, zero, one);
        let mut drawn = zero;
        for term in &self.terms {
            // Every term draws, and the last one that begins at or before u₀ is kept. Rounding may
            // stretch u₀ to 1, and for the terms not kept it lies anywhere: ½ serves as well.
            let possible = term.probability.gt(zero);
            let stretched = (u[0] - start) / T::select(possible, term.probability, one);
            let usable = stretched.ge(zero).and(stretched.lt(one));
            let u0 = T::select(usable, stretched, T::lit(0.5));
            let sample = term.model.sample(wo, [u0, u[1]]);
            let kept = possible.and(u[0].ge(start));
            wi = <T::Vec3 as Vector<T>>::select(kept, sample.wi, wi);
            drawn = T::select(kept, sample.pdf, drawn);
            start = start + term.probability;
        }
        // The probability of a direction is that of all terms; what one of them could draw, the
        // sum can.
        let pdf = self.pdf(wi, wo);
        let valid = drawn.gt(zero).and(pdf.gt(zero));
        let limit = T::max_finite();
        let scale = (wi.z() / T::select(valid, pdf, one)).min(limit);
        let weight = self.eval(wi, wo).map(|value| (value * scale).min(limit));
        Sample { wi, weight, pdf }.only_where(valid)
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        self.total(|model| model.albedo(wo))
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
            .fold(C::splat(T::lit(0.0)), |sum, term| sum + term.weight * color(&term.model));
        sum.map(|value| value.min(T::max_finite()))
    }
}
