//! Batches of the parts of a model: Fresnel terms and distributions.

use super::error::{BatchError, Length};
use super::input::{Directions, fill, whole};
use super::instruction_set::InstructionSet;
use super::output::{ColorBuffer, whole_mut, write_plane};
use super::planes::{Answers, BLOCK, Components, Plane, Planes, within};
use super::values::{Slots, Values};
use crate::real::{Color, Real};

pub(crate) fn reflectance<T: Real, C: Color<T>>(
    cos_theta: &[T],
    values: ColorBuffer<'_, T, C>,
    formula: impl Fn(T) -> C,
) -> Result<(), BatchError> {
    over_numbers(cos_theta, values, &|set, cos_theta, mut values| {
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                values.fill(
                    #[inline(always)]
                    |index| formula(cos_theta[index]),
                );
            },
        );
    })
}

pub(crate) fn density<T: Real>(
    h: Directions<'_, T>,
    densities: &mut [T],
    formula: impl Fn(T::Vec3) -> T,
) -> Result<(), BatchError> {
    over_directions(h, densities, &|set, h, densities| {
        within::<T, _>(
            set,
            #[inline(always)]
            || {
                densities.fill(
                    #[inline(always)]
                    |index| formula(h.at(index)),
                );
            },
        );
    })
}

/// Reflectances of a block of cosines.
type ReflectanceBlock<'a, T, C> = &'a dyn Fn(InstructionSet, &Plane<T>, Slots<'_, T, C>);

#[inline(never)]
fn over_numbers<T: Real, C: Color<T>>(
    cos_theta: &[T],
    mut values: ColorBuffer<'_, T, C>,
    block: ReflectanceBlock<'_, T, C>,
) -> Result<(), BatchError> {
    let length = values.length(["values", "values[0]", "values[1]", "values[2]"])?;
    length.check("cos_theta", cos_theta.len())?;
    let set = InstructionSet::selected();
    within::<T, _>(
        set,
        #[inline(always)]
        || {
            let mut memory = [T::zero(); BLOCK];
            let mut result = Values::new();
            for start in (0..length.get()).step_by(BLOCK) {
                let numbers = match whole(cos_theta, start) {
                    Some(numbers) => numbers,
                    None => {
                        fill(&mut memory, cos_theta.get(start..).unwrap_or_default());
                        &memory
                    }
                };
                if let Some(slots) = values.slots(start, &mut result) {
                    block(set, numbers, slots);
                } else {
                    block(set, numbers, result.slots());
                    values.write(start, &result);
                }
            }
        },
    );
    Ok(())
}

/// Densities of a block of normals.
type DensityBlock<'a, T> = &'a dyn Fn(InstructionSet, Components<'_, T>, &mut Plane<T>);

#[inline(never)]
fn over_directions<T: Real>(
    h: Directions<'_, T>,
    densities: &mut [T],
    block: DensityBlock<'_, T>,
) -> Result<(), BatchError> {
    let length = Length::of("densities", densities.len());
    h.check(&length, ["h", "h.x", "h.y", "h.z"])?;
    let set = InstructionSet::selected();
    within::<T, _>(
        set,
        #[inline(always)]
        || {
            let mut memory = Planes::new();
            let mut result = [T::zero(); BLOCK];
            for start in (0..length.get()).step_by(BLOCK) {
                let h = h.block(start, &mut memory);
                if let Some(densities) = whole_mut(densities, start) {
                    block(set, h, densities);
                } else {
                    block(set, h, &mut result);
                    write_plane(densities, start, &result);
                }
            }
        },
    );
    Ok(())
}
