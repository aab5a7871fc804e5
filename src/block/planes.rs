//! A block of directions in the layout that SIMD code wants: one array per component.
//!
//! Batches run block by block, by loops of a fixed length ([`fill`], [`Color::fill`]) that the
//! compiler turns into SIMD code.

use super::instruction_set::InstructionSet;
use crate::real::{Color, Real, Vector};

/// The number of directions in a block.
pub const BLOCK: usize = 128;

/// One number of each direction of a block.
pub type Plane<T> = [T; BLOCK];

/// The colours of a block: one plane for each channel.
pub type ColorBlock<T, C> = <C as Color<T>>::Channels<Plane<T>>;

/// The directions of a block, wherever their components lie.
#[derive(Clone, Copy, Debug)]
pub struct DirectionBlock<'a, T>(pub [&'a Plane<T>; 3]);

impl<'a, T: Real> DirectionBlock<'a, T> {
    /// The directions whose components fill three planes.
    #[inline(always)]
    #[must_use]
    pub const fn new([x, y, z]: &'a [Plane<T>; 3]) -> Self {
        Self([x, y, z])
    }

    /// One of the directions.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, index: usize) -> T::Vec3 {
        Vector::new(self.0[0][index], self.0[1][index], self.0[2][index])
    }
}

/// The samples of a block.
#[derive(Debug)]
pub struct SampleBlock<T: Real, C: Color<T>> {
    /// [`Sample::weight`](crate::Sample::weight).
    pub weight: ColorBlock<T, C>,
    /// The components of [`Sample::wi`](crate::Sample::wi) and [`Sample::pdf`](crate::Sample::pdf).
    pub wi_pdf: [Plane<T>; 4],
}

impl<T: Real, C: Color<T>> SampleBlock<T, C> {
    /// Samples of no direction.
    #[inline(always)]
    #[must_use]
    pub fn new() -> Self {
        let zero = [T::zero(); BLOCK];
        Self { weight: C::by_channel(|_| zero), wi_pdf: [zero; 4] }
    }

    /// [`Sample::wi`](crate::Sample::wi).
    #[inline(always)]
    #[must_use]
    pub const fn wi(&self) -> DirectionBlock<'_, T> {
        let [x, y, z, _] = &self.wi_pdf;
        DirectionBlock([x, y, z])
    }
}

impl<T: Real, C: Color<T>> Default for SampleBlock<T, C> {
    fn default() -> Self {
        Self::new()
    }
}

/// Fills planes with what a formula answers for the places of a block: for numbers what
/// [`Color::fill`] is for colours, and as fast.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "an iterator would be another function")]
pub(crate) fn fill<T: Real, const M: usize>(
    planes: &mut [Plane<T>; M],
    formula: impl Fn(usize) -> [T; M],
) {
    for index in 0..BLOCK {
        let numbers = formula(index);
        for number in 0..M {
            planes[number][index] = numbers[number];
        }
    }
}

/// Changes some planes and fills others, as [`fill`]: the formula is told what stands at its place.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "an iterator would be another function")]
pub(crate) fn refill<T: Real, const M: usize, const K: usize>(
    planes: &mut [Plane<T>; M],
    others: &mut [Plane<T>; K],
    formula: impl Fn(usize, [T; M]) -> ([T; M], [T; K]),
) {
    for index in 0..BLOCK {
        let mut before = [T::zero(); M];
        for number in 0..M {
            before[number] = planes[number][index];
        }
        let (after, beside) = formula(index, before);
        for number in 0..M {
            planes[number][index] = after[number];
        }
        for number in 0..K {
            others[number][index] = beside[number];
        }
    }
}

/// Runs `work` compiled for the instruction set, if these numbers gain by it.
#[inline(always)]
pub(crate) fn within<T: Real, R>(set: InstructionSet, work: impl FnOnce() -> R) -> R {
    if T::VECTORIZES { set.run(work) } else { work() }
}

/// Fills `to`, which is no longer than a block, from the front of the plane.
#[inline(always)]
pub(crate) fn copy_front<T: Copy>(from: &Plane<T>, to: &mut [T]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = *from;
    }
}
