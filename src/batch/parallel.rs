//! Batches on all cores, with the `rayon` feature.
//!
//! The results are those of [`Brdf::eval_batch`] and its like, bit for bit, whatever the number of threads.
//! The threads are rayon's: those of the pool that the call is made from. Models over the whole sphere have
//! theirs in [`bsdf`].
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

pub mod bsdf;

use crate::block::{
    BatchError, ColorBuffer, Directions, Draws, Input, Numbers, Output, Pairs, SampleBuffer,
    Uniforms, check,
};
use crate::brdf::Brdf;
use crate::real::Real;

/// Elements that one thread does at a time: enough to be worth the way to it, few enough for the
/// cache. A multiple of the block.
const CHUNK: usize = 4096;

/// Where to divide a batch in two, if it is large enough.
const fn middle(length: usize) -> Option<usize> {
    if length <= CHUNK { None } else { Some((length / 2).next_multiple_of(CHUNK)) }
}

/// Does a batch in parts, on as many cores as there are.
fn in_parts<T, I, O, const N: usize>(
    input: I,
    output: O,
    part: &(impl Fn(I, O) -> Result<(), BatchError> + Sync),
) -> Result<(), BatchError>
where
    T: Real,
    I: Input<T, N> + Send + Sync,
    O: Output + Send,
{
    let length = check(&input, &output)?;
    let Some(middle) = middle(length) else {
        return part(input, output);
    };
    let (input, output) = (input.split(middle), output.split(middle));
    let (first, second) =
        rayon::join(|| in_parts(input.0, output.0, part), || in_parts(input.1, output.1, part));
    first.and(second)
}

/// [`Brdf::eval_batch`] on all cores.
///
/// # Errors
/// If slices differ in length. Nothing is written then.
pub fn eval<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    values: ColorBuffer<'_, T, M::Color>,
) -> Result<(), BatchError> {
    in_parts(Pairs { wi, wo }, values, &|Pairs { wi, wo }, values| model.eval_batch(wi, wo, values))
}

/// [`Brdf::pdf_batch`] on all cores.
///
/// # Errors
/// If slices differ in length. Nothing is written then.
pub fn pdf<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    pdf: &mut [T],
) -> Result<(), BatchError> {
    in_parts(Pairs { wi, wo }, Numbers(pdf, "pdf"), &|Pairs { wi, wo }, Numbers(pdf, _)| {
        model.pdf_batch(wi, wo, pdf)
    })
}

/// [`Brdf::eval_pdf_batch`] on all cores.
///
/// # Errors
/// If slices differ in length. Nothing is written then.
pub fn eval_pdf<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    values: ColorBuffer<'_, T, M::Color>,
    pdf: &mut [T],
) -> Result<(), BatchError> {
    let answers = (values, Numbers(pdf, "pdf"));
    in_parts(Pairs { wi, wo }, answers, &|Pairs { wi, wo }, (values, Numbers(pdf, _))| {
        model.eval_pdf_batch(wi, wo, values, pdf)
    })
}

/// [`Brdf::sample_batch`] on all cores.
///
/// # Errors
/// If slices differ in length. Nothing is written then.
pub fn sample<T: Real, M: Brdf<T> + ?Sized>(
    model: &M,
    wo: Directions<'_, T>,
    u: Uniforms<'_, T>,
    samples: SampleBuffer<'_, T, M::Color>,
) -> Result<(), BatchError> {
    in_parts(Draws { wo, u }, samples, &|Draws { wo, u }, samples| {
        model.sample_batch(wo, u, samples)
    })
}
