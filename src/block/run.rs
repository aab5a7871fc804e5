//! The loops over blocks. They know numbers and colours, but no model, and are compiled once for
//! all of them.

use super::error::{BatchError, Length};
use super::input::{Directions, Uniforms};
use super::instruction_set::InstructionSet;
use super::output::{ColorBuffer, SampleBuffer, whole_mut, write_plane};
use super::planes::{BLOCK, Components, Plane, Planes, within};
use super::values::{Samples, Slots, Values};
use crate::real::{Color, Real};

const WI: [&str; 4] = ["wi", "wi.x", "wi.y", "wi.z"];
const WO: [&str; 4] = ["wo", "wo.x", "wo.y", "wo.z"];
const VALUES: [&str; 4] = ["values", "values[0]", "values[1]", "values[2]"];

/// The length of a batch of values, if all slices have it.
pub(crate) fn check_eval<T: Real, C: Color<T>>(
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    values: &ColorBuffer<'_, T, C>,
) -> Result<usize, BatchError> {
    let length = values.length(VALUES)?;
    wi.check(&length, WI)?;
    wo.check(&length, WO)?;
    Ok(length.get())
}

/// The length of a batch of densities, if all slices have it.
pub(crate) fn check_pdf<T: Real>(
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    pdf: &[T],
) -> Result<usize, BatchError> {
    let length = Length::of("pdf", pdf.len());
    wi.check(&length, WI)?;
    wo.check(&length, WO)?;
    Ok(length.get())
}

/// The length of a batch of samples, if all slices have it.
pub(crate) fn check_sample<T: Real, C: Color<T>>(
    wo: Directions<'_, T>,
    u: Uniforms<'_, T>,
    samples: &SampleBuffer<'_, T, C>,
) -> Result<usize, BatchError> {
    let length = samples.length()?;
    wo.check(&length, WO)?;
    u.check(&length)?;
    Ok(length.get())
}

/// Values of a block of pairs that begins at a place of the batch.
pub(crate) type EvalBlock<'a, T, C> = &'a mut dyn FnMut(
    InstructionSet,
    usize,
    Components<'_, T>,
    Components<'_, T>,
    Slots<'_, T, C>,
) -> Result<(), BatchError>;

/// Runs `block` for every block of pairs and writes the values.
#[inline(never)]
pub(crate) fn eval<T: Real, C: Color<T>>(
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    mut values: ColorBuffer<'_, T, C>,
    block: EvalBlock<'_, T, C>,
) -> Result<(), BatchError> {
    let length = check_eval(wi, wo, &values)?;
    let set = InstructionSet::selected();
    within::<T, _>(
        set,
        #[inline(always)]
        || {
            let (mut wi_memory, mut wo_memory) = (Planes::new(), Planes::new());
            let mut result = Values::new();
            for start in (0..length).step_by(BLOCK) {
                let wi = wi.block(start, &mut wi_memory);
                let wo = wo.block(start, &mut wo_memory);
                if let Some(slots) = values.slots(start, &mut result) {
                    block(set, start, wi, wo, slots)?;
                } else {
                    block(set, start, wi, wo, result.slots())?;
                    values.write(start, &result);
                }
            }
            Ok(())
        },
    )
}

/// Densities of a block of pairs that begins at a place of the batch.
pub(crate) type PdfBlock<'a, T> = &'a dyn Fn(
    InstructionSet,
    usize,
    Components<'_, T>,
    Components<'_, T>,
    &mut Plane<T>,
) -> Result<(), BatchError>;

/// Runs `block` for every block of pairs and writes the densities.
#[inline(never)]
pub(crate) fn pdf<T: Real>(
    wi: Directions<'_, T>,
    wo: Directions<'_, T>,
    pdf: &mut [T],
    block: PdfBlock<'_, T>,
) -> Result<(), BatchError> {
    let length = check_pdf(wi, wo, pdf)?;
    let set = InstructionSet::selected();
    within::<T, _>(
        set,
        #[inline(always)]
        || {
            let (mut wi_memory, mut wo_memory) = (Planes::new(), Planes::new());
            let mut result = [T::zero(); BLOCK];
            for start in (0..length).step_by(BLOCK) {
                let wi = wi.block(start, &mut wi_memory);
                let wo = wo.block(start, &mut wo_memory);
                if let Some(pdf) = whole_mut(pdf, start) {
                    block(set, start, wi, wo, pdf)?;
                } else {
                    block(set, start, wi, wo, &mut result)?;
                    write_plane(pdf, start, &result);
                }
            }
            Ok(())
        },
    )
}

/// Samples of a block of viewers that begins at a place of the batch.
pub(crate) type SampleBlock<'a, T, C> = &'a mut dyn FnMut(
    InstructionSet,
    usize,
    Components<'_, T>,
    [&Plane<T>; 2],
    &mut Samples<T, C>,
) -> Result<(), BatchError>;

/// Runs `block` for every block of viewers and writes the samples.
#[inline(never)]
pub(crate) fn sample<T: Real, C: Color<T>>(
    wo: Directions<'_, T>,
    u: Uniforms<'_, T>,
    mut samples: SampleBuffer<'_, T, C>,
    block: SampleBlock<'_, T, C>,
) -> Result<(), BatchError> {
    let length = check_sample(wo, u, &samples)?;
    let set = InstructionSet::selected();
    within::<T, _>(
        set,
        #[inline(always)]
        || {
            let (mut wo_memory, mut u_memory) = (Planes::new(), Planes::new());
            let mut result = Samples::new();
            for start in (0..length).step_by(BLOCK) {
                let wo = wo.block(start, &mut wo_memory);
                let u = u.block(start, &mut u_memory);
                block(set, start, wo, u, &mut result)?;
                samples.wi.write(start, &result.wi);
                samples.weight.write(start, &result.weight);
                write_plane(samples.pdf, start, &result.pdf);
            }
            Ok(())
        },
    )
}
