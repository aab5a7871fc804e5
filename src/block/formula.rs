//! What is done with a batch unless a model knows better: its formula, element by element, in a
//! loop that the compiler turns into SIMD code.

use super::error::BatchError;
use super::input::{Directions, Uniforms};
use super::output::{ColorBuffer, SampleBuffer};
use super::planes::{Answers, BLOCK, within};
use super::run;
use crate::real::{Color, Real};

/// One call after the other, for numbers that gain nothing from SIMD code.
pub(crate) mod calls {
    use super::*;

    pub(crate) fn eval<T: Real, C: Color<T>>(
        wi: Directions<'_, T>,
        wo: Directions<'_, T>,
        values: ColorBuffer<'_, T, C>,
        formula: impl Fn(T::Vec3, T::Vec3) -> C,
    ) -> Result<(), BatchError> {
        run::eval(wi, wo, values, &mut |_, _, wi, wo, mut values| {
            for index in 0..BLOCK {
                values.set(index, formula(wi.at(index), wo.at(index)));
            }
            Ok(())
        })
    }

    pub(crate) fn pdf<T: Real>(
        wi: Directions<'_, T>,
        wo: Directions<'_, T>,
        pdf: &mut [T],
        formula: impl Fn(T::Vec3, T::Vec3) -> T,
    ) -> Result<(), BatchError> {
        run::pdf(wi, wo, pdf, &|_, _, wi, wo, pdf| {
            for (index, pdf) in pdf.iter_mut().enumerate() {
                *pdf = formula(wi.at(index), wo.at(index));
            }
            Ok(())
        })
    }

    pub(crate) fn sample<T: Real, C: Color<T>>(
        wo: Directions<'_, T>,
        u: Uniforms<'_, T>,
        samples: SampleBuffer<'_, T, C>,
        formula: impl Fn(T::Vec3, [T; 2]) -> (T::Vec3, C, T),
    ) -> Result<(), BatchError> {
        run::sample(wo, u, samples, &mut |_, _, wo, u, samples| {
            for (index, (&u0, &u1)) in u[0].iter().zip(u[1]).enumerate() {
                let (wi, weight, pdf) = formula(wo.at(index), [u0, u1]);
                samples.wi.set(index, wi);
                samples.weight.slots().set(index, weight);
                samples.pdf[index] = pdf;
            }
            Ok(())
        })
    }
}

pub(crate) fn eval<T: Real, C: Color<T>>(
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    values: ColorBuffer<'_, T, C>,
    formula: impl Fn(T::Vec3, T::Vec3) -> C,
) -> Result<(), BatchError> {
    if !T::VECTORIZES {
        return calls::eval(wi, wo, values, formula);
    }
    run::eval(wi, wo, values, &mut |set, _, wi, wo, mut values| {
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                values.fill(
                    #[inline(always)]
                    |index| formula(wi.at(index), wo.at(index)),
                );
            },
        );
        Ok(())
    })
}

pub(crate) fn pdf<T: Real>(
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    pdf: &mut [T],
    formula: impl Fn(T::Vec3, T::Vec3) -> T,
) -> Result<(), BatchError> {
    if !T::VECTORIZES {
        return calls::pdf(wi, wo, pdf, formula);
    }
    run::pdf(wi, wo, pdf, &|set, _, wi, wo, pdf| {
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                pdf.fill(
                    #[inline(always)]
                    |index| formula(wi.at(index), wo.at(index)),
                );
            },
        );
        Ok(())
    })
}

pub(crate) fn sample<T: Real, C: Color<T>>(
    wo: Directions<'_, T>,
    u: Uniforms<'_, T>,
    samples: SampleBuffer<'_, T, C>,
    formula: impl Fn(T::Vec3, [T; 2]) -> (T::Vec3, C, T),
) -> Result<(), BatchError> {
    if !T::VECTORIZES {
        return calls::sample(wo, u, samples, formula);
    }
    run::sample(wo, u, samples, &mut |set, _, wo, u, samples| {
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                samples.fill(
                    #[inline(always)]
                    |index| formula(wo.at(index), [u[0][index], u[1][index]]),
                );
            },
        );
        Ok(())
    })
}
