//! Batches of models over the whole sphere on all cores: those of [`Bsdf`], bit for bit.

use super::in_parts;
use crate::block::{
    BatchError, BsdfSampleBuffer, ColorBuffer, Directions, Draws, Numbers, Pairs, Uniforms,
};
use crate::bsdf::{Bsdf, TransportMode};
use crate::real::Real;

/// [`Bsdf::eval_batch`] on all cores.
///
/// # Errors
/// If slices differ in length. Nothing is written then.
pub fn eval<T: Real, M: Bsdf<T> + ?Sized>(
    model: &M,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    mode: TransportMode,
    values: ColorBuffer<'_, T, M::Color>,
) -> Result<(), BatchError> {
    in_parts(Pairs { wi, wo }, values, &|Pairs { wi, wo }, values| {
        model.eval_batch(wi, wo, mode, values)
    })
}

/// [`Bsdf::pdf_batch`] on all cores.
///
/// # Errors
/// If slices differ in length. Nothing is written then.
pub fn pdf<T: Real, M: Bsdf<T> + ?Sized>(
    model: &M,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    mode: TransportMode,
    pdf: &mut [T],
) -> Result<(), BatchError> {
    in_parts(Pairs { wi, wo }, Numbers(pdf, "pdf"), &|Pairs { wi, wo }, Numbers(pdf, _)| {
        model.pdf_batch(wi, wo, mode, pdf)
    })
}

/// [`Bsdf::eval_pdf_batch`] on all cores.
///
/// # Errors
/// If slices differ in length. Nothing is written then.
pub fn eval_pdf<T: Real, M: Bsdf<T> + ?Sized>(
    model: &M,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    mode: TransportMode,
    values: ColorBuffer<'_, T, M::Color>,
    pdf: &mut [T],
) -> Result<(), BatchError> {
    let answers = (values, Numbers(pdf, "pdf"));
    in_parts(Pairs { wi, wo }, answers, &|Pairs { wi, wo }, (values, Numbers(pdf, _))| {
        model.eval_pdf_batch(wi, wo, mode, values, pdf)
    })
}

/// [`Bsdf::sample_batch`] on all cores.
///
/// # Errors
/// If slices differ in length. Nothing is written then.
pub fn sample<T, M>(
    model: &M,
    wo: Directions<'_, T>,
    u: Uniforms<'_, T, 3>,
    mode: TransportMode,
    samples: BsdfSampleBuffer<'_, T, M::Color>,
) -> Result<(), BatchError>
where
    T: Real,
    T::Mask: Send,
    M: Bsdf<T> + ?Sized,
{
    in_parts(Draws { wo, u }, samples.apart(), &|Draws { wo, u }, parts| {
        model.sample_batch(wo, u, mode, BsdfSampleBuffer::of(parts))
    })
}
