//! A model behind a pointer is a model.

use alloc::boxed::Box;
use alloc::sync::Arc;

use super::{Bsdf, BsdfSample, Lobes, Power, TransportMode};
use crate::block::{ColorBlock, EventBlock, PairBlock, Plane, SampleBlock};
use crate::real::Real;

macro_rules! forward {
    ($pointer:ty) => {
        impl<T: Real, M: Bsdf<T> + ?Sized> Bsdf<T> for $pointer {
            type Color = M::Color;
            #[inline(always)]
            fn eval(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> M::Color {
                (**self).eval(wi, wo, mode)
            }
            #[inline(always)]
            fn pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> T {
                (**self).pdf(wi, wo, mode)
            }
            #[inline(always)]
            fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> (M::Color, T) {
                (**self).eval_pdf(wi, wo, mode)
            }
            #[inline(always)]
            fn sample(
                &self,
                wo: T::Vec3,
                u: [T; 3],
                mode: TransportMode,
            ) -> BsdfSample<T, M::Color> {
                (**self).sample(wo, u, mode)
            }
            #[inline(always)]
            fn specular(&self, wo: T::Vec3, mode: TransportMode) -> Lobes<T, M::Color> {
                (**self).specular(wo, mode)
            }
            fn power(&self, wo: T::Vec3) -> Power<M::Color> {
                (**self).power(wo)
            }
            fn eval_block(
                &self,
                pairs: PairBlock<'_, T>,
                mode: TransportMode,
                values: &mut ColorBlock<T, M::Color>,
            ) {
                (**self).eval_block(pairs, mode, values);
            }
            fn pdf_block(&self, pairs: PairBlock<'_, T>, mode: TransportMode, pdf: &mut Plane<T>) {
                (**self).pdf_block(pairs, mode, pdf);
            }
            fn eval_pdf_block(
                &self,
                pairs: PairBlock<'_, T>,
                mode: TransportMode,
                values: &mut ColorBlock<T, M::Color>,
                pdf: &mut Plane<T>,
            ) {
                (**self).eval_pdf_block(pairs, mode, values, pdf);
            }
            fn sample_block(
                &self,
                draws: EventBlock<'_, T>,
                mode: TransportMode,
                samples: &mut SampleBlock<T, M::Color>,
                specular: &mut Plane<T>,
            ) {
                (**self).sample_block(draws, mode, samples, specular);
            }
        }
    };
}
forward!(Arc<M>);
forward!(Box<M>);
forward!(&M);
