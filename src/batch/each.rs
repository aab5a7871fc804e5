//! One model for each element: textures of roughness, albedo, index.

use crate::block::planes::{Answers, BLOCK, within};
use crate::block::run;
use crate::block::{BatchError, ColorBuffer, Directions, SampleBuffer, Uniforms};
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
    let length = run::check_eval(wi, wo, &values)?;
    run::eval(wi, wo, values, &mut |set, start, wi, wo, mut values| {
        let models = models(&model, start, length)?;
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                values.fill(
                    #[inline(always)]
                    |index| models[index].eval(wi.at(index), wo.at(index)),
                );
            },
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
    let length = run::check_pdf(wi, wo, pdf)?;
    run::pdf(wi, wo, pdf, &|set, start, wi, wo, pdf| {
        let models = models(&model, start, length)?;
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                pdf.fill(
                    #[inline(always)]
                    |index| models[index].pdf(wi.at(index), wo.at(index)),
                );
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
    let length = run::check_sample(wo, u, &samples)?;
    run::sample(wo, u, samples, &mut |set, start, wo, u, samples| {
        let models = models(&model, start, length)?;
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                samples.fill(
                    #[inline(always)]
                    |index| {
                        let u = [u[0][index], u[1][index]];
                        models[index].sample(wo.at(index), u).into_parts()
                    },
                );
            },
        );
        Ok(())
    })
}

/// The models of a block that begins at `start`, with the first one behind the end.
#[inline(always)]
fn models<M: Copy>(
    model: &impl Fn(usize) -> Result<M, ParameterError>,
    start: usize,
    end: usize,
) -> Result<[M; BLOCK], BatchError> {
    let at = |index| model(index).map_err(|error| BatchError::Parameter { index, error });
    let mut models = [at(start)?; BLOCK];
    for (index, model) in (start..end).zip(&mut models).skip(1) {
        *model = at(index)?;
    }
    Ok(models)
}
