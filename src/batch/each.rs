//! One model for each element: textures of roughness, albedo, index.

use core::array;

use crate::block::{
    BLOCK, BatchError, ColorBuffer, Directions, Draws, Numbers, Pairs, SampleBuffer, Uniforms,
    check, run,
};
use crate::brdf::Brdf;
use crate::error::ParameterError;
use crate::real::Real;

/// [`Brdf::eval_batch`] where every element has a model of its own, which `model` makes for the
/// index of the element. It is asked once for each index, in order. Models that are not [`Copy`],
/// boxed ones for instance, are given by reference: `|index| Ok(&models[index])`.
///
/// ```
/// use brdf::batch::eval_each;
/// use brdf::{Beckmann, Brdf, CookTorrance, Schlick};
/// use glam::Vec3;
///
/// let roughness = [0.1, 0.2, 0.4];
/// let f0 = [Vec3::splat(0.04), Vec3::splat(0.5), Vec3::splat(0.9)];
/// let model = |index: usize| {
///     Ok(CookTorrance::new(Beckmann::new(roughness[index])?, Schlick::new(f0[index])?))
/// };
/// let wi = [Vec3::new(0.6, 0.0, 0.8); 3];
/// let mut values = [Vec3::ZERO; 3];
/// eval_each(model, (&wi).into(), Vec3::Z.into(), (&mut values).into())?;
/// assert_eq!(values[2], model(2)?.eval(wi[2], Vec3::Z));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If slices differ in length: then nothing is written. If a model cannot be made: then the blocks of
/// 128 elements before its own are done.
pub fn eval_each<T: Real, M: Brdf<T> + Copy>(
    model: impl Fn(usize) -> Result<M, ParameterError>,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    values: ColorBuffer<'_, T, M::Color>,
) -> Result<(), BatchError> {
    let pairs = Pairs { wi, wo };
    let length = check(&pairs, &values)?;
    run(pairs, values, &mut |pairs, start, values| {
        let mut models = [model_at(&model, start)?; BLOCK];
        fill(&mut models, &model, start, length)?;
        pairs.colors(
            values,
            #[inline(always)]
            |index| models[index].eval(pairs.wi(index), pairs.wo(index)),
        );
        Ok(())
    })
}

/// [`Brdf::pdf_batch`] where every element has a model of its own: see [`eval_each`].
///
/// # Errors
/// If slices differ in length, or a model cannot be made.
pub fn pdf_each<T: Real, M: Brdf<T> + Copy>(
    model: impl Fn(usize) -> Result<M, ParameterError>,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    pdf: &mut [T],
) -> Result<(), BatchError> {
    let (pairs, pdf) = (Pairs { wi, wo }, Numbers(pdf, "pdf"));
    let length = check(&pairs, &pdf)?;
    run(pairs, pdf, &mut |pairs, start, pdf| {
        let mut models = [model_at(&model, start)?; BLOCK];
        fill(&mut models, &model, start, length)?;
        pairs.numbers(
            array::from_mut(pdf),
            #[inline(always)]
            |index| [models[index].pdf(pairs.wi(index), pairs.wo(index))],
        );
        Ok(())
    })
}

/// [`Brdf::eval_pdf_batch`] where every element has a model of its own: see [`eval_each`].
///
/// # Errors
/// If slices differ in length, or a model cannot be made.
pub fn eval_pdf_each<T: Real, M: Brdf<T> + Copy>(
    model: impl Fn(usize) -> Result<M, ParameterError>,
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    values: ColorBuffer<'_, T, M::Color>,
    pdf: &mut [T],
) -> Result<(), BatchError> {
    let (pairs, answers) = (Pairs { wi, wo }, (values, Numbers(pdf, "pdf")));
    let length = check(&pairs, &answers)?;
    run(pairs, answers, &mut |pairs, start, (values, pdf)| {
        let mut models = [model_at(&model, start)?; BLOCK];
        fill(&mut models, &model, start, length)?;
        pairs.colors_and_numbers(
            values,
            array::from_mut(pdf),
            #[inline(always)]
            |index| {
                let (value, pdf) = models[index].eval_pdf(pairs.wi(index), pairs.wo(index));
                (value, [pdf])
            },
        );
        Ok(())
    })
}

/// [`Brdf::sample_batch`] where every element has a model of its own: see [`eval_each`].
///
/// # Errors
/// If slices differ in length, or a model cannot be made.
pub fn sample_each<T: Real, M: Brdf<T> + Copy>(
    model: impl Fn(usize) -> Result<M, ParameterError>,
    wo: Directions<'_, T>,
    u: Uniforms<'_, T>,
    samples: SampleBuffer<'_, T, M::Color>,
) -> Result<(), BatchError> {
    let draws = Draws { wo, u };
    let length = check(&draws, &samples)?;
    run(draws, samples, &mut |draws, start, samples| {
        let mut models = [model_at(&model, start)?; BLOCK];
        fill(&mut models, &model, start, length)?;
        draws.samples(
            samples,
            #[inline(always)]
            |index| models[index].sample(draws.wo(index), draws.u(index)),
        );
        Ok(())
    })
}

/// The model of one element.
#[inline(always)]
fn model_at<M>(
    model: &impl Fn(usize) -> Result<M, ParameterError>,
    index: usize,
) -> Result<M, BatchError> {
    model(index).map_err(|error| BatchError::Parameter { index, error })
}

/// Makes the models of a block that begins at `start`, all but the first, up to the end.
#[inline(always)]
fn fill<M>(
    models: &mut [M; BLOCK],
    model: &impl Fn(usize) -> Result<M, ParameterError>,
    start: usize,
    end: usize,
) -> Result<(), BatchError> {
    for (index, place) in (start..end).zip(models).skip(1) {
        *place = model_at(model, index)?;
    }
    Ok(())
}
