//! The trait that all reflectance models share.

use alloc::boxed::Box;
use alloc::sync::Arc;
use core::array;

use crate::block::{
    BatchError, ColorBlock, ColorBuffer, Directions, DrawBlock, Draws, Numbers, PairBlock, Pairs,
    Plane, SampleBlock, SampleBuffer, Uniforms, run,
};
use crate::quadrature::mean_over_square;
use crate::real::{Color, Real, Vector};

/// A reflectance model: the ratio f_r of reflected radiance to irradiance, in sr⁻¹.
///
/// Directions live in the shading frame (normal +z), are unit vectors and point away from the
/// surface: `wi` towards the light, `wo` towards the viewer. Where either lies below the surface,
/// or is no direction at all, every answer is zero. Answers are finite and never negative: a value
/// too large for its number saturates at the largest finite one.
///
/// Models go from thread to thread: a model in a `Box` or an `Arc` is one too, one in an `Rc` cannot be and
/// answers by reference, `&*model`.
///
/// The trait is object safe:
///
/// ```
/// use brdf::{Brdf, Lambert};
/// use glam::Vec3;
///
/// let scene: Vec<Box<dyn Brdf<Color = Vec3>>> = vec![Box::new(Lambert::new(Vec3::splat(0.5))?)];
/// assert!((scene[0].eval(Vec3::Z, Vec3::Z).x - 0.5 / std::f32::consts::PI).abs() < 1e-7);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
///
/// A model that a directly following cast makes an object does not learn from it that a literal is an
/// `f32`; the literal, or a call before the cast, has to say it:
///
/// ```
/// use brdf::{Brdf, CookTorrance, Ggx, Schlick};
/// use glam::Vec3;
///
/// let gloss = CookTorrance::new(Ggx::new(0.1_f32)?, Schlick::new(Vec3::splat(0.04))?);
/// let gloss = Box::new(gloss) as Box<dyn Brdf<Color = Vec3>>;
/// # let _ = gloss.eval(Vec3::Z, Vec3::Z);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("BSDF", "BxDF", "reflectance", "scattering"))]
pub trait Brdf<T: Real = f32>: Send + Sync {
    /// What a value has channels for: one wavelength, or red, green and blue.
    type Color: Color<T>;

    /// f_r(wi, wo) in sr⁻¹, without the cosine.
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> Self::Color;

    /// The density per steradian with which [`sample`](Self::sample) returns `wi` for `wo`.
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T;

    /// [`eval`](Self::eval) and [`pdf`](Self::pdf) of the same pair, for multiple importance
    /// sampling. Models whose value and density have much in common compute it once.
    ///
    /// ```
    /// use brdf::{Brdf, Ggx, Schlick, CookTorrance};
    /// use glam::Vec3;
    ///
    /// let plastic = CookTorrance::new(Ggx::new(0.3)?, Schlick::new(Vec3::splat(0.04))?);
    /// let (wi, wo) = (Vec3::new(0.6, 0.0, 0.8), Vec3::Z);
    /// assert_eq!(plastic.eval_pdf(wi, wo), (plastic.eval(wi, wo), plastic.pdf(wi, wo)));
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[inline(always)]
    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3) -> (Self::Color, T) {
        (self.eval(wi, wo), self.pdf(wi, wo))
    }

    /// Draws `wi` for `wo` from two independent uniform numbers in [0, 1).
    ///
    /// The models of this crate take 1 too; what lies outside 0 … 1 counts as the nearer end, NaN
    /// as 0. An end may be that of a tail, a direction of next to no
    /// density: generators of `f32` in steps of 2⁻²⁴ draw 0 itself once in 1.7·10⁷ times, where it
    /// stands for all numbers up to the next.
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, Self::Color>;

    /// Directional albedo ∫ f_r cosθᵢ dωᵢ: what the viewer at `wo` sees of a surroundings of
    /// radiance 1. For a reciprocal model it is also the fraction reflected of the light that
    /// arrives along `wo`.
    ///
    /// By default the mean weight of the 4181 samples of a lattice: for samples whose weights are at
    /// most 1 it is within 6·10⁻⁴ of the integral where it was measured, on microfacet models of
    /// roughness 0.05 … 1. The models of this crate have closed forms or integrals on a line, good
    /// to 10⁻⁷, or, [`CookTorrance`](crate::CookTorrance), an integral over facets, good to 10⁻⁶. Its
    /// [derivatives](crate::Dual) are those of the integral, also by samples.
    fn albedo(&self, wo: T::Vec3) -> Self::Color {
        mean_weight(self, wo)
    }

    /// Whether f_r(wi, wo) = f_r(wo, wi), so that light and importance see the same model and the
    /// albedo is the fraction reflected of a beam. A model that is not reciprocal says so:
    /// [`Opaque`](crate::Opaque) goes by it.
    #[inline(always)]
    fn is_reciprocal(&self) -> bool {
        true
    }

    /// [`eval`](Self::eval) for a block of pairs: what [`eval_batch`](Self::eval_batch) calls block
    /// by block.
    ///
    /// By default a loop over `eval`, compiled for the instruction set, which is fast if all that
    /// `eval` calls is always inlined. A model that can do a whole block better, because it chooses
    /// between formulas or consists of other models, overrides it with the same answers.
    fn eval_block(&self, pairs: PairBlock<'_, T>, values: &mut ColorBlock<T, Self::Color>) {
        pairs.colors(
            values,
            #[inline(always)]
            |index| self.eval(pairs.wi(index), pairs.wo(index)),
        );
    }

    /// [`pdf`](Self::pdf) for a block of pairs, as [`eval_block`](Self::eval_block).
    fn pdf_block(&self, pairs: PairBlock<'_, T>, pdf: &mut Plane<T>) {
        pairs.numbers(
            array::from_mut(pdf),
            #[inline(always)]
            |index| [self.pdf(pairs.wi(index), pairs.wo(index))],
        );
    }

    /// [`eval_pdf`](Self::eval_pdf) for a block of pairs, as [`eval_block`](Self::eval_block).
    fn eval_pdf_block(
        &self,
        pairs: PairBlock<'_, T>,
        values: &mut ColorBlock<T, Self::Color>,
        pdf: &mut Plane<T>,
    ) {
        self.eval_block(pairs, values);
        self.pdf_block(pairs, pdf);
    }

    /// [`sample`](Self::sample) for a block of viewers, as [`eval_block`](Self::eval_block).
    fn sample_block(&self, draws: DrawBlock<'_, T>, samples: &mut SampleBlock<T, Self::Color>) {
        draws.samples(
            samples,
            #[inline(always)]
            |index| self.sample(draws.wo(index), draws.u(index)),
        );
    }

    /// [`eval`](Self::eval) for many pairs of directions, bit for bit, at the speed of SIMD code: see
    /// [`batch`](crate::batch). Models override [`eval_block`](Self::eval_block) and not this.
    ///
    /// # Errors
    /// If slices differ in length.
    fn eval_batch(
        &self,
        wi: Directions<'_, T>,
        wo: Directions<'_, T>,
        values: ColorBuffer<'_, T, Self::Color>,
    ) -> Result<(), BatchError> {
        run(Pairs { wi, wo }, values, &mut |pairs, _, values| {
            self.eval_block(pairs, values);
            Ok(())
        })
    }

    /// [`pdf`](Self::pdf) for many pairs of directions, bit for bit. Models override
    /// [`pdf_block`](Self::pdf_block) and not this.
    ///
    /// # Errors
    /// If slices differ in length.
    fn pdf_batch(
        &self,
        wi: Directions<'_, T>,
        wo: Directions<'_, T>,
        pdf: &mut [T],
    ) -> Result<(), BatchError> {
        run(Pairs { wi, wo }, Numbers(pdf, "pdf"), &mut |pairs, _, pdf| {
            self.pdf_block(pairs, pdf);
            Ok(())
        })
    }

    /// [`eval_pdf`](Self::eval_pdf) for many pairs of directions, bit for bit. Models override
    /// [`eval_pdf_block`](Self::eval_pdf_block) and not this.
    ///
    /// # Errors
    /// If slices differ in length.
    fn eval_pdf_batch(
        &self,
        wi: Directions<'_, T>,
        wo: Directions<'_, T>,
        values: ColorBuffer<'_, T, Self::Color>,
        pdf: &mut [T],
    ) -> Result<(), BatchError> {
        let answers = (values, Numbers(pdf, "pdf"));
        run(Pairs { wi, wo }, answers, &mut |pairs, _, (values, pdf)| {
            self.eval_pdf_block(pairs, values, pdf);
            Ok(())
        })
    }

    /// [`sample`](Self::sample) for many viewers, bit for bit. Models override
    /// [`sample_block`](Self::sample_block) and not this.
    ///
    /// # Errors
    /// If slices differ in length.
    fn sample_batch(
        &self,
        wo: Directions<'_, T>,
        u: Uniforms<'_, T>,
        samples: SampleBuffer<'_, T, Self::Color>,
    ) -> Result<(), BatchError> {
        run(Draws { wo, u }, samples, &mut |draws, _, samples| {
            self.sample_block(draws, samples);
            Ok(())
        })
    }
}

impl<T: Real> DrawBlock<'_, T> {
    /// Fills samples with what a formula answers for the places of the block.
    #[inline(always)]
    pub fn samples<C: Color<T>>(
        &self,
        samples: &mut SampleBlock<T, C>,
        formula: impl Fn(usize) -> Sample<T, C>,
    ) {
        self.colors_and_numbers(
            &mut samples.weight,
            &mut samples.wi_pdf,
            #[inline(always)]
            |index| {
                let Sample { wi, weight, pdf } = formula(index);
                (weight, [wi.x(), wi.y(), wi.z(), pdf])
            },
        );
    }
}

/// The mean weight of the samples of a lattice.
pub(crate) fn mean_weight<T: Real, M: Brdf<T> + ?Sized>(model: &M, wo: T::Vec3) -> M::Color {
    mean_over_square(|u| weight(model, wo, u))
}

/// The mean weight of the samples of a lattice for a beam that arrives along `wo`, in place of a viewer
/// there.
pub(crate) fn mean_weight_of_beam<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wo: T::Vec3,
) -> M::Color {
    mean_over_square(|u| weight_of_beam(model, wo, model.sample(wo, u)))
}

/// f_r(wo, wi) cosθᵢ/pdf of a sample.
#[inline(always)]
pub(crate) fn weight_of_beam<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wo: T::Vec3,
    sample: Sample<T, M::Color>,
) -> M::Color {
    let Sample { wi, pdf, .. } = sample;
    let drawn = pdf.gt(T::zero());
    let scale = wi.z() / T::select(drawn, pdf, T::one());
    let weight = model.eval(wo, wi) * scale;
    weight.map(|weight| weight.min(T::max_finite())).only_where(drawn)
}

/// The weight of one sample. A call, so that the loops of the default albedo do not multiply the
/// code of the sampler.
///
/// The directions of the samples are nodes of a quadrature. They move with the parameters, and
/// some fall out of it, but the integral has the derivative of its integrand at nodes that stay.
#[inline(never)]
fn weight<T: Real, M: Brdf<T> + ?Sized>(model: &M, wo: T::Vec3, u: [T; 2]) -> M::Color {
    let Sample { wi, weight, pdf } = model.sample(wo, u);
    if !T::HAS_DERIVATIVES {
        return weight;
    }
    let wi: T::Vec3 = Vector::new(wi.x().held(), wi.y().held(), wi.z().held());
    let drawn = pdf.gt(T::zero());
    let scale = wi.z() / T::select(drawn, pdf, T::one()).held();
    let integrand = (model.eval(wi, wo) * scale).only_where(drawn);
    weight.zip(integrand, T::with_derivatives_of)
}

/// A direction drawn by [`Brdf::sample`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<T: Real, C> {
    /// Towards the light.
    pub wi: T::Vec3,
    /// f_r cosθᵢ / pdf; zero where the draw fell below the surface and gives no direction.
    pub weight: C,
    /// Density of `wi` per steradian. Zero where the draw gives no direction, and where a lobe is
    /// so narrow that rounding moved `wi` out of it; the weight then still counts.
    pub pdf: T,
}

impl<T: Real, C: Color<T>> Sample<T, C> {
    /// The sample where the mask is true, no direction (weight and pdf zero) elsewhere.
    #[inline(always)]
    #[must_use]
    pub fn only_where(self, mask: T::Mask) -> Self {
        Self { wi: self.wi, weight: self.weight.only_where(mask), pdf: self.pdf.only_where(mask) }
    }
}

macro_rules! forward {
    ($pointer:ty) => {
        impl<T: Real, M: Brdf<T> + ?Sized> Brdf<T> for $pointer {
            type Color = M::Color;
            #[inline(always)]
            fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> M::Color {
                (**self).eval(wi, wo)
            }
            #[inline(always)]
            fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
                (**self).pdf(wi, wo)
            }
            #[inline(always)]
            fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3) -> (M::Color, T) {
                (**self).eval_pdf(wi, wo)
            }
            #[inline(always)]
            fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, M::Color> {
                (**self).sample(wo, u)
            }
            #[inline(always)]
            fn albedo(&self, wo: T::Vec3) -> M::Color {
                (**self).albedo(wo)
            }
            #[inline(always)]
            fn is_reciprocal(&self) -> bool {
                (**self).is_reciprocal()
            }
            fn eval_block(&self, pairs: PairBlock<'_, T>, values: &mut ColorBlock<T, M::Color>) {
                (**self).eval_block(pairs, values);
            }
            fn pdf_block(&self, pairs: PairBlock<'_, T>, pdf: &mut Plane<T>) {
                (**self).pdf_block(pairs, pdf);
            }
            fn eval_pdf_block(
                &self,
                pairs: PairBlock<'_, T>,
                values: &mut ColorBlock<T, M::Color>,
                pdf: &mut Plane<T>,
            ) {
                (**self).eval_pdf_block(pairs, values, pdf);
            }
            fn sample_block(
                &self,
                draws: DrawBlock<'_, T>,
                samples: &mut SampleBlock<T, M::Color>,
            ) {
                (**self).sample_block(draws, samples);
            }
        }
    };
}
forward!(Arc<M>);
forward!(Box<M>);
forward!(&M);
