use crate::block::{BLOCK, ColorBlock, EventBlock, PairBlock, Plane, SampleBlock};
use crate::brdf::{Brdf, mean_weight_of_beam, weight_of_beam};
use crate::bsdf::{Bsdf, BsdfSample, Power, TransportMode, never};
use crate::direction::above_surface;
use crate::real::{Color, Lift, Real, lift};

/// A model of reflection as one over the whole sphere: zero where either direction lies below the
/// surface.
///
/// Reciprocal or not, conserving or not, as the model is. A model that is not
/// [reciprocal](Brdf::is_reciprocal) answers for importance with the directions exchanged: the samples
/// are those of [`Brdf::sample`], their weights are f(wo, wi) |cosθᵢ|/pdf, and the power of a beam is the
/// mean of these over the lattice of the default [albedo](Brdf::albedo).
///
/// ```
/// use brdf::{Bsdf, Lambert, Opaque, TransportMode};
/// use glam::Vec3;
///
/// let paper = Opaque::new(Lambert::new(Vec3::splat(0.5))?);
/// assert_eq!(paper.eval(Vec3::Z, -Vec3::Z, TransportMode::Radiance), Vec3::ZERO);
/// assert_eq!(paper.power(Vec3::Z).reflectance, Vec3::splat(0.5));
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opaque<M> {
    model: M,
}

impl<M> Opaque<M> {
    /// The model, and nothing below the surface.
    #[must_use]
    pub const fn new(model: M) -> Self {
        Self { model }
    }

    /// The model.
    #[must_use]
    pub const fn model(&self) -> &M {
        &self.model
    }
}

lift! {
    [T: Real, M: Lift<T>] Opaque<M> => Opaque<M::Over<U>>: Opaque { model: part }
}

impl<T: Real, M: Brdf<T>> Bsdf<T> for Opaque<M> {
    type Color = M::Color;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> M::Color {
        match mode {
            TransportMode::Radiance => self.model.eval(wi, wo),
            TransportMode::Importance => self.model.eval(wo, wi),
        }
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3, _: TransportMode) -> T {
        self.model.pdf(wi, wo)
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> (M::Color, T) {
        match mode {
            TransportMode::Radiance => self.model.eval_pdf(wi, wo),
            TransportMode::Importance => (self.eval(wi, wo, mode), self.model.pdf(wi, wo)),
        }
    }

    #[inline(always)]
    fn sample(
        &self,
        wo: T::Vec3,
        [x, y, _]: [T; 3],
        mode: TransportMode,
    ) -> BsdfSample<T, M::Color> {
        let sample = self.model.sample(wo, [x, y]);
        let weight = if mode == TransportMode::Radiance || self.model.is_reciprocal() {
            sample.weight
        } else {
            weight_of_beam(&self.model, wo, sample)
        };
        BsdfSample { wi: sample.wi, weight, pdf: sample.pdf, specular: never::<T>() }
    }

    /// The albedo, which is the power of a beam if the model is reciprocal.
    fn power(&self, wo: T::Vec3) -> Power<M::Color> {
        let none = M::Color::splat(T::zero());
        let reflectance = if self.model.is_reciprocal() {
            self.model.albedo(wo)
        } else {
            mean_weight_of_beam(&self.model, wo)
        };
        let reflectance = reflectance.only_where(above_surface::<T, _>(wo));
        Power { reflectance, transmittance: none }
    }

    fn eval_block(
        &self,
        pairs: PairBlock<'_, T>,
        mode: TransportMode,
        values: &mut ColorBlock<T, M::Color>,
    ) {
        let pairs = match mode {
            TransportMode::Radiance => pairs,
            TransportMode::Importance => pairs.exchanged(),
        };
        self.model.eval_block(pairs, values);
    }

    fn pdf_block(&self, pairs: PairBlock<'_, T>, _: TransportMode, pdf: &mut Plane<T>) {
        self.model.pdf_block(pairs, pdf);
    }

    fn eval_pdf_block(
        &self,
        pairs: PairBlock<'_, T>,
        mode: TransportMode,
        values: &mut ColorBlock<T, M::Color>,
        pdf: &mut Plane<T>,
    ) {
        match mode {
            TransportMode::Radiance => self.model.eval_pdf_block(pairs, values, pdf),
            TransportMode::Importance => {
                self.eval_block(pairs, mode, values);
                self.model.pdf_block(pairs, pdf);
            }
        }
    }

    fn sample_block(
        &self,
        draws: EventBlock<'_, T>,
        mode: TransportMode,
        samples: &mut SampleBlock<T, M::Color>,
        specular: &mut Plane<T>,
    ) {
        if mode == TransportMode::Radiance || self.model.is_reciprocal() {
            self.model.sample_block(draws.draws, samples);
            *specular = [T::zero(); BLOCK];
        } else {
            draws.samples(
                samples,
                specular,
                #[inline(always)]
                |index| self.sample(draws.wo(index), draws.u(index), mode),
            );
        }
    }
}
