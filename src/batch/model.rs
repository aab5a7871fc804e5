//! What every model does with a batch unless it knows better: its formula, element by element, in
//! a loop that the compiler turns into SIMD code.

use super::block::{BLOCK, Values, within};
use super::error::BatchError;
use super::input::{Directions, Uniforms};
use super::output::{ColorBuffer, SampleBuffer};
use super::run::{self, Samples};
use crate::brdf::Brdf;
use crate::real::Real;

/// One call after the other, for numbers that gain nothing from SIMD code.
pub(crate) mod calls {
    use super::*;

    pub(crate) fn eval<T: Real, M: Brdf<T> + ?Sized>(
        model: &M,
        wi: Directions<'_, T>,
        wo: Directions<'_, T>,
        values: ColorBuffer<'_, T, M::Color>,
    ) -> Result<(), BatchError> {
        run::eval(wi, wo, values, &|_, _, wi, wo, values| {
            for index in 0..BLOCK {
                values.set(index, model.eval(wi.at(index), wo.at(index)));
            }
            Ok(())
        })
    }

    pub(crate) fn pdf<T: Real, M: Brdf<T> + ?Sized>(
        model: &M,
        wi: Directions<'_, T>,
        wo: Directions<'_, T>,
        pdf: &mut [T],
    ) -> Result<(), BatchError> {
        run::pdf(wi, wo, pdf, &|_, _, wi, wo, pdf| {
            for (index, pdf) in pdf.iter_mut().enumerate() {
                *pdf = model.pdf(wi.at(index), wo.at(index));
            }
            Ok(())
        })
    }

    pub(crate) fn sample<T: Real, M: Brdf<T> + ?Sized>(
        model: &M,
        wo: Directions<'_, T>,
        u: Uniforms<'_, T>,
        samples: SampleBuffer<'_, T, M::Color>,
    ) -> Result<(), BatchError> {
        run::sample(wo, u, samples, &|_, _, wo, u, samples| {
            for (index, (&u0, &u1)) in u[0].iter().zip(u[1]).enumerate() {
                let sample = model.sample(wo.at(index), [u0, u1]);
                samples.wi.set(index, sample.wi);
                samples.weight.set(index, sample.weight);
                samples.pdf[index] = sample.pdf;
            }
            Ok(())
        })
    }
}

pub(crate) fn eval<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    values: ColorBuffer<'_, T, M::Color>,
) -> Result<(), BatchError> {
    if !T::VECTORIZES {
        return calls::eval(model, wi, wo, values);
    }
    run::eval(wi, wo, values, &|set, _, wi, wo, values| {
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                let mut block = Values::new();
                for index in 0..BLOCK {
                    block.set(index, model.eval(wi.at(index), wo.at(index)));
                }
                values.copy_from(&block);
            },
        );
        Ok(())
    })
}

pub(crate) fn pdf<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    pdf: &mut [T],
) -> Result<(), BatchError> {
    if !T::VECTORIZES {
        return calls::pdf(model, wi, wo, pdf);
    }
    run::pdf(wi, wo, pdf, &|set, _, wi, wo, pdf| {
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                let mut block = [T::lit(0.0); BLOCK];
                for (index, pdf) in block.iter_mut().enumerate() {
                    *pdf = model.pdf(wi.at(index), wo.at(index));
                }
                *pdf = block;
            },
        );
        Ok(())
    })
}

pub(crate) fn sample<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wo: Directions<'_, T>,
    u: Uniforms<'_, T>,
    samples: SampleBuffer<'_, T, M::Color>,
) -> Result<(), BatchError> {
    if !T::VECTORIZES {
        return calls::sample(model, wo, u, samples);
    }
    run::sample(wo, u, samples, &|set, _, wo, u, samples| {
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                let mut block = Samples::new();
                for (index, (&u0, &u1)) in u[0].iter().zip(u[1]).enumerate() {
                    let sample = model.sample(wo.at(index), [u0, u1]);
                    block.wi.set(index, sample.wi);
                    block.weight.set(index, sample.weight);
                    block.pdf[index] = sample.pdf;
                }
                samples.copy_from(&block);
            },
        );
        Ok(())
    })
}
