use crate::block::{ColorBlock, DrawBlock, PairBlock, Plane, SampleBlock};
use crate::brdf::{Brdf, Sample};
use crate::real::{Color, Lift, Real, lift};

/// A model times a constant: what the printed forms of 1977 and 1982 are.
///
/// # Formula
/// ```text
/// f = c · f₀        pdf = pdf₀
/// ```
///
/// Made by [`CookTorrance1982Printed`](crate::CookTorrance1982Printed) and
/// [`Blinn1977Printed`](crate::Blinn1977Printed), which state what it means. Reciprocal if the model
/// is. A sample is one of the model, with c times the weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaled<M, T = f32> {
    model: M,
    /// c.
    scale: T,
}

impl<M, T> Scaled<M, T> {
    pub(crate) const fn of(model: M, scale: T) -> Self {
        Self { model, scale }
    }

    pub(crate) fn into_model(self) -> M {
        self.model
    }

    /// The model that is multiplied.
    #[must_use]
    pub const fn model(&self) -> &M {
        &self.model
    }

    /// The constant that it is multiplied with.
    #[must_use]
    pub const fn scale(&self) -> T
    where
        T: Copy,
    {
        self.scale
    }
}

lift! {
    [T: Real, M: Lift<T>] Scaled<M, T> => Scaled<M::Over<U>, U>:
    Scaled { model: part, scale: number }
}

impl<T: Real> Scaled<(), T> {
    /// A colour times a number, no larger than the largest number.
    #[inline(always)]
    fn limited<C: Color<T>>(color: C, scale: T) -> C {
        (color * scale).map(|value| value.min(T::max_finite()))
    }

    /// The same for the colours of a block.
    #[inline(always)]
    fn limit<C: Color<T>>(colors: &mut ColorBlock<T, C>, scale: T) {
        for value in colors.as_mut().iter_mut().flatten() {
            *value = (*value * scale).min(T::max_finite());
        }
    }
}

impl<T: Real, M: Brdf<T>> Brdf<T> for Scaled<M, T> {
    type Color = M::Color;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> M::Color {
        Scaled::limited(self.model.eval(wi, wo), self.scale)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        self.model.pdf(wi, wo)
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3) -> (M::Color, T) {
        let (value, pdf) = self.model.eval_pdf(wi, wo);
        (Scaled::limited(value, self.scale), pdf)
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, M::Color> {
        let sample = self.model.sample(wo, u);
        Sample { weight: Scaled::limited(sample.weight, self.scale), ..sample }
    }

    fn is_reciprocal(&self) -> bool {
        self.model.is_reciprocal()
    }

    fn albedo(&self, wo: T::Vec3) -> M::Color {
        Scaled::limited(self.model.albedo(wo), self.scale)
    }

    fn eval_block(&self, pairs: PairBlock<'_, T>, values: &mut ColorBlock<T, M::Color>) {
        self.model.eval_block(pairs, values);
        Scaled::limit::<M::Color>(values, self.scale);
    }

    fn pdf_block(&self, pairs: PairBlock<'_, T>, pdf: &mut Plane<T>) {
        self.model.pdf_block(pairs, pdf);
    }

    fn eval_pdf_block(
        &self,
        pairs: PairBlock<'_, T>,
        values: &mut ColorBlock<T, M::Color>,
        pdf: &mut Plane<T>,
    ) {
        self.model.eval_pdf_block(pairs, values, pdf);
        Scaled::limit::<M::Color>(values, self.scale);
    }

    fn sample_block(&self, draws: DrawBlock<'_, T>, samples: &mut SampleBlock<T, M::Color>) {
        self.model.sample_block(draws, samples);
        Scaled::limit::<M::Color>(&mut samples.weight, self.scale);
    }
}
