//! The trait of models over the whole sphere of directions.

mod answers;
mod pointers;

use core::array;

use crate::block::{
    BatchError, BsdfSampleBuffer, ColorBlock, ColorBuffer, Directions, Draws, EventBlock, Numbers,
    PairBlock, Pairs, Plane, SampleBlock, Uniforms, run,
};
use crate::direction::off_surface_or_normal;
use crate::quadrature::mean_over_square;
use crate::real::{Color, Mask, Real, Vector};

pub(crate) use answers::never;
pub use answers::{BsdfSample, Lobe, Lobes, Power, TransportMode};

/// A model of scattering: reflection on both sides of a surface, and transmission through it.
///
/// Directions live in the shading frame (normal +z), are unit vectors and point away from the
/// surface: `wi` towards the light, `wo` towards the viewer. Those with z < 0 are below the surface.
/// Where either is no direction or lies in the surface, every answer is zero. Answers are finite and
/// never negative: a value too large for its number saturates at the largest finite one.
///
/// What scatters into single directions (a mirror, a smooth interface) has no value per steradian. Such
/// specular lobes are in neither [`eval`](Self::eval) nor [`pdf`](Self::pdf): they are listed by
/// [`specular`](Self::specular), and [`sample`](Self::sample) says when it drew one.
///
/// A [`Brdf`](crate::Brdf) is made one by [`Opaque`](crate::Opaque). The trait is object safe:
///
/// ```
/// use brdf::{Bsdf, Lambert, Opaque, SmoothDielectric, TransportMode};
/// use glam::Vec3;
///
/// let scene: Vec<Box<dyn Bsdf<Color = Vec3>>> = vec![
///     Box::new(Opaque::new(Lambert::new(Vec3::splat(0.5))?)),
///     Box::new(SmoothDielectric::new(1.5_f32)?),
/// ];
/// let glass = scene[1].sample(Vec3::Z, [0.5, 0.5, 0.9], TransportMode::Radiance);
/// assert!(glass.specular && glass.wi == -Vec3::Z);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("BTDF", "BxDF", "transmission", "scattering"))]
pub trait Bsdf<T: Real = f32>: Send + Sync {
    /// What a value has channels for.
    type Color: Color<T>;

    /// The value in sr⁻¹, without the cosine and without specular lobes.
    ///
    /// For [radiance](TransportMode::Radiance) it is f(wi, wo), of light from `wi` seen from `wo`; for
    /// [importance](TransportMode::Importance) f(wo, wi), of light from `wo` seen from `wi`.
    fn eval(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> Self::Color;

    /// The density per steradian with which [`sample`](Self::sample) returns `wi` for `wo`, of draws
    /// that are not specular.
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> T;

    /// [`eval`](Self::eval) and [`pdf`](Self::pdf) of the same pair, for multiple importance sampling.
    #[inline(always)]
    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> (Self::Color, T) {
        (self.eval(wi, wo, mode), self.pdf(wi, wo, mode))
    }

    /// Draws `wi` for `wo` from three independent uniform numbers in [0, 1): two for a direction, the
    /// third for the event, reflection below the probability of it.
    ///
    /// Numbers outside [0, 1) are taken as by [`Brdf::sample`](crate::Brdf::sample).
    fn sample(&self, wo: T::Vec3, u: [T; 3], mode: TransportMode) -> BsdfSample<T, Self::Color>;

    /// The specular lobes: radiance towards `wo` is the sum of their weights, each times the radiance
    /// from its `wi`. There is no probability in the weights.
    fn specular(&self, wo: T::Vec3, mode: TransportMode) -> Lobes<T, Self::Color> {
        let _ = mode;
        Lobes::none(off_surface_or_normal::<T, _>(wo))
    }

    /// Of a beam that arrives along `wo`, the power that returns and that passes, specular lobes
    /// included.
    ///
    /// By default the means of the weights of 33448 samples, for importance.
    fn power(&self, wo: T::Vec3) -> Power<Self::Color> {
        mean_power(self, wo)
    }

    /// [`eval`](Self::eval) for a block of pairs: what [`eval_batch`](Self::eval_batch) calls block
    /// by block.
    ///
    /// By default a loop over `eval`, as [`Brdf::eval_block`](crate::Brdf::eval_block).
    fn eval_block(
        &self,
        pairs: PairBlock<'_, T>,
        mode: TransportMode,
        values: &mut ColorBlock<T, Self::Color>,
    ) {
        pairs.colors(
            values,
            #[inline(always)]
            |index| self.eval(pairs.wi(index), pairs.wo(index), mode),
        );
    }

    /// [`pdf`](Self::pdf) for a block of pairs, as [`eval_block`](Self::eval_block).
    fn pdf_block(&self, pairs: PairBlock<'_, T>, mode: TransportMode, pdf: &mut Plane<T>) {
        pairs.numbers(
            array::from_mut(pdf),
            #[inline(always)]
            |index| [self.pdf(pairs.wi(index), pairs.wo(index), mode)],
        );
    }

    /// [`eval_pdf`](Self::eval_pdf) for a block of pairs, as [`eval_block`](Self::eval_block).
    fn eval_pdf_block(
        &self,
        pairs: PairBlock<'_, T>,
        mode: TransportMode,
        values: &mut ColorBlock<T, Self::Color>,
        pdf: &mut Plane<T>,
    ) {
        self.eval_block(pairs, mode, values);
        self.pdf_block(pairs, mode, pdf);
    }

    /// [`sample`](Self::sample) for a block of viewers, as [`eval_block`](Self::eval_block).
    /// `specular` is 1 where a specular lobe was drawn, 0 elsewhere.
    fn sample_block(
        &self,
        draws: EventBlock<'_, T>,
        mode: TransportMode,
        samples: &mut SampleBlock<T, Self::Color>,
        specular: &mut Plane<T>,
    ) {
        draws.samples(
            samples,
            specular,
            #[inline(always)]
            |index| self.sample(draws.wo(index), draws.u(index), mode),
        );
    }

    /// [`eval`](Self::eval) for many pairs of directions, bit for bit, at the speed of SIMD code: see
    /// [`batch`](crate::batch). Models override [`eval_block`](Self::eval_block) and not this.
    ///
    /// ```
    /// use brdf::{Bsdf, Ggx, RoughDielectric, TransportMode};
    /// use glam::Vec3;
    ///
    /// let frosted = RoughDielectric::new(Ggx::new(0.3)?, 1.5_f32)?;
    /// let wi: Vec<Vec3> = (0..200).map(|i| Vec3::new(i as f32, 0.0, -90.0).normalize()).collect();
    /// let mut values = vec![Vec3::ZERO; 200];
    /// let mode = TransportMode::Radiance;
    /// frosted.eval_batch((&wi).into(), Vec3::Z.into(), mode, (&mut values).into())?;
    /// assert_eq!(values[7], frosted.eval(wi[7], Vec3::Z, mode));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If slices differ in length.
    fn eval_batch(
        &self,
        wi: Directions<'_, T>,
        wo: Directions<'_, T>,
        mode: TransportMode,
        values: ColorBuffer<'_, T, Self::Color>,
    ) -> Result<(), BatchError> {
        run(Pairs { wi, wo }, values, &mut |pairs, _, values| {
            self.eval_block(pairs, mode, values);
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
        mode: TransportMode,
        pdf: &mut [T],
    ) -> Result<(), BatchError> {
        run(Pairs { wi, wo }, Numbers(pdf, "pdf"), &mut |pairs, _, pdf| {
            self.pdf_block(pairs, mode, pdf);
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
        mode: TransportMode,
        values: ColorBuffer<'_, T, Self::Color>,
        pdf: &mut [T],
    ) -> Result<(), BatchError> {
        let answers = (values, Numbers(pdf, "pdf"));
        run(Pairs { wi, wo }, answers, &mut |pairs, _, (values, pdf)| {
            self.eval_pdf_block(pairs, mode, values, pdf);
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
        u: Uniforms<'_, T, 3>,
        mode: TransportMode,
        samples: BsdfSampleBuffer<'_, T, Self::Color>,
    ) -> Result<(), BatchError> {
        run(Draws { wo, u }, samples.apart(), &mut |draws, _, (samples, specular)| {
            self.sample_block(EventBlock::new(draws), mode, samples, specular);
            Ok(())
        })
    }
}

impl<T: Real> EventBlock<'_, T> {
    /// Fills samples, and whether they are specular, with what a formula answers for the places of the
    /// block.
    #[inline(always)]
    pub fn samples<C: Color<T>>(
        &self,
        samples: &mut SampleBlock<T, C>,
        specular: &mut Plane<T>,
        formula: impl Fn(usize) -> BsdfSample<T, C>,
    ) {
        let zero = T::zero();
        let mut numbers = [*specular; 5];
        self.draws.colors_and_numbers(
            &mut samples.weight,
            &mut numbers,
            #[inline(always)]
            |index| {
                let sample = formula(index);
                let wi = sample.wi;
                let specular = T::select(sample.specular, T::one(), zero);
                (sample.weight, [wi.x(), wi.y(), wi.z(), sample.pdf, specular])
            },
        );
        let [x, y, z, pdf, one_or_zero] = numbers;
        (samples.wi_pdf, *specular) = ([x, y, z, pdf], one_or_zero);
    }
}

/// How many third numbers the default of [`Bsdf::power`] takes for each of its points.
const EVENTS: u32 = 8;

fn mean_power<T: Real, M: Bsdf<T> + ?Sized>(model: &M, wo: T::Vec3) -> Power<M::Color> {
    let mean = |returns: bool| {
        mean_over_square(|[x, y]| {
            let event = |index: u32| {
                let u = T::lit((f64::from(index) + 0.5) / f64::from(EVENTS));
                let sample = model.sample(wo, [x, y, u], TransportMode::Importance);
                let same_side = (sample.wi.z() * wo.z()).gt(T::zero());
                let counts = if returns { same_side } else { same_side.not() };
                sample.weight.only_where(counts)
            };
            let sum = (1..EVENTS).fold(event(0), |sum, index| sum + event(index));
            sum * T::lit(1.0 / f64::from(EVENTS))
        })
    };
    Power { reflectance: mean(true), transmittance: mean(false) }
}
