//! Batches on all cores, with the `rayon` feature.
//!
//! The results are those of [`Brdf::eval_batch`] and its like, bit for bit, whatever the number of threads.
//! The threads are rayon's: those of the pool that the call is made from.
//!
//! ```
//! use brdf::batch::parallel;
//! use brdf::{Brdf, Lambert};
//! use glam::Vec3;
//!
//! let clay = Lambert::new(Vec3::new(0.8, 0.5, 0.2))?;
//! let wi = vec![Vec3::new(0.6, 0.0, 0.8); 100_000];
//! let mut values = vec![Vec3::ZERO; wi.len()];
//! parallel::eval(&clay, (&wi).into(), Vec3::Z.into(), (&mut values).into())?;
//! assert_eq!(values[99_999], clay.eval(wi[0], Vec3::Z));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::block::run;
use crate::block::{BatchError, ColorBuffer, Directions, SampleBuffer, Uniforms};
use crate::brdf::Brdf;
use crate::real::Real;

/// Elements that one thread does at a time: enough to be worth the way to it, few enough for the
/// cache. A multiple of the block.
const CHUNK: usize = 4096;

/// Where to divide a batch in two, if it is large enough.
const fn middle(length: usize) -> Option<usize> {
    if length <= CHUNK { None } else { Some((length / 2).next_multiple_of(CHUNK)) }
}

/// [`Brdf::eval_batch`] on all cores.
///
/// # Errors
/// If slices differ in length, or their number is not that of the channels. Nothing is written then.
pub fn eval<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    values: ColorBuffer<'_, T, M::Color>,
) -> Result<(), BatchError> {
    let length = run::check_eval(wi, wo, &values)?;
    eval_part(model, length, wi, wo, values)
}

fn eval_part<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    length: usize,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    values: ColorBuffer<'_, T, M::Color>,
) -> Result<(), BatchError> {
    let Some(middle) = middle(length) else {
        return model.eval_batch(wi, wo, values);
    };
    let (wi, wo, values) = (wi.split(middle), wo.split(middle), values.split(middle));
    let (first, second) = rayon::join(
        || eval_part(model, middle, wi.0, wo.0, values.0),
        || eval_part(model, length - middle, wi.1, wo.1, values.1),
    );
    first.and(second)
}

/// [`Brdf::pdf_batch`] on all cores.
///
/// # Errors
/// If slices differ in length, or their number is not that of the channels. Nothing is written then.
pub fn pdf<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    pdf: &mut [T],
) -> Result<(), BatchError> {
    run::check_pdf(wi, wo, pdf)?;
    pdf_part(model, wi, wo, pdf)
}

fn pdf_part<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    pdf: &mut [T],
) -> Result<(), BatchError> {
    let Some(middle) = middle(pdf.len()) else {
        return model.pdf_batch(wi, wo, pdf);
    };
    let (wi, wo, pdf) = (wi.split(middle), wo.split(middle), pdf.split_at_mut(middle));
    let (first, second) =
        rayon::join(|| pdf_part(model, wi.0, wo.0, pdf.0), || pdf_part(model, wi.1, wo.1, pdf.1));
    first.and(second)
}

/// [`Brdf::sample_batch`] on all cores.
///
/// # Errors
/// If slices differ in length, or their number is not that of the channels. Nothing is written then.
pub fn sample<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wo: Directions<'_, T>,
    u: Uniforms<'_, T>,
    samples: SampleBuffer<'_, T, M::Color>,
) -> Result<(), BatchError> {
    run::check_sample(wo, u, &samples)?;
    sample_part(model, wo, u, samples)
}

fn sample_part<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wo: Directions<'_, T>,
    u: Uniforms<'_, T>,
    samples: SampleBuffer<'_, T, M::Color>,
) -> Result<(), BatchError> {
    let Some(middle) = middle(samples.pdf.len()) else {
        return model.sample_batch(wo, u, samples);
    };
    let (wo, u, samples) = (wo.split(middle), u.split(middle), samples.split(middle));
    let (first, second) = rayon::join(
        || sample_part(model, wo.0, u.0, samples.0),
        || sample_part(model, wo.1, u.1, samples.1),
    );
    first.and(second)
}
