//! The one loop behind all batches. It knows numbers and colours, but no model.

use super::error::{BatchError, Length};
use super::instruction_set::InstructionSet;
use super::planes::{BLOCK, Block, Plane};
use crate::real::Real;

/// What a batch reads: `N` numbers for each element.
pub(crate) trait Input<T: Real, const N: usize>: Copy {
    /// Whether all slices have the length.
    fn check(&self, length: &Length) -> Result<(), BatchError>;

    /// The block that begins at `start`: in place if it is whole, else in `memory` and filled up
    /// with its first element, since a formula may rely on what it is asked.
    fn planes<'b>(&'b self, start: usize, memory: &'b mut [Plane<T>; N]) -> [&'b Plane<T>; N];

    /// What comes before an element, and the rest.
    #[cfg(feature = "rayon")]
    fn split(self, middle: usize) -> (Self, Self);
}

/// What a batch writes.
pub(crate) trait Output: Sized {
    /// The answers of a block.
    type Block;

    /// Memory for a block.
    fn memory() -> Self::Block;

    /// The length that all slices must have, if they agree.
    fn length(&self) -> Result<Length, BatchError>;

    /// The block that begins at `start` in the caller's memory, if it is whole and lies there as
    /// loops want it.
    fn in_place(&mut self, start: usize) -> Option<&mut Self::Block>;

    /// Writes what there is room for of a block that begins at `start`.
    fn write(&mut self, start: usize, block: &Self::Block);

    /// What comes before an element, and the rest.
    #[cfg(feature = "rayon")]
    fn split(self, middle: usize) -> (Self, Self);
}

/// The length of a batch, if all slices have it.
pub(crate) fn check<T: Real, const N: usize>(
    input: &impl Input<T, N>,
    output: &impl Output,
) -> Result<usize, BatchError> {
    let length = output.length()?;
    input.check(&length)?;
    Ok(length.get())
}

/// Answers about a block that begins at a place of the batch.
pub(crate) type Answer<'a, T, B, const N: usize> =
    &'a mut dyn FnMut(Block<'_, T, N>, usize, &mut B) -> Result<(), BatchError>;

/// Runs `block` for every block of a batch and writes the answers.
#[inline(never)]
pub(crate) fn run<T: Real, O: Output, const N: usize>(
    input: impl Input<T, N>,
    mut output: O,
    block: Answer<'_, T, O::Block, N>,
) -> Result<(), BatchError> {
    let length = check(&input, &output)?;
    let set = InstructionSet::selected();
    let all: Block<'_, T, 0> = Block { set, planes: [] };
    all.within(
        #[inline(always)]
        || {
            let (mut memory, mut result) = ([[T::zero(); BLOCK]; N], O::memory());
            for start in (0..length).step_by(BLOCK) {
                let asked = Block { set, planes: input.planes(start, &mut memory) };
                if let Some(place) = output.in_place(start) {
                    block(asked, start, place)?;
                } else {
                    block(asked, start, &mut result)?;
                    output.write(start, &result);
                }
            }
            Ok(())
        },
    )
}
