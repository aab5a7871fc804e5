//! A block of directions in the layout that SIMD code wants: one array per component.
//!
//! Batches run block by block, by loops of a fixed length ([`Answers::fill`]) that the compiler turns
//! into SIMD code.

use super::instruction_set::InstructionSet;
use crate::real::{Real, Vector};

/// Directions in a block.
pub(crate) const BLOCK: usize = 128;

/// One number of each direction of a block.
pub(crate) type Plane<T> = [T; BLOCK];

/// Answers of a block.
pub(crate) trait Answers {
    /// The answer for one direction.
    type Answer;

    /// Answers for the directions of a block, by their places in it.
    ///
    /// That is one loop that writes by index through exclusive references among its own arguments
    /// and hands them to no other function. Only so does the compiler see that no answer changes what
    /// the formula reads next.
    fn fill(&mut self, formula: impl Fn(usize) -> Self::Answer);
}

impl<E: Copy> Answers for [E; BLOCK] {
    type Answer = E;

    #[inline(always)]
    #[allow(clippy::needless_range_loop, reason = "an iterator would be another function")]
    fn fill(&mut self, formula: impl Fn(usize) -> E) {
        for index in 0..BLOCK {
            self[index] = formula(index);
        }
    }
}

/// The components of the directions of a block, wherever they lie.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Components<'a, T>(pub(crate) [&'a Plane<T>; 3]);

impl<T: Real> Components<'_, T> {
    #[inline(always)]
    pub(crate) fn at(&self, index: usize) -> T::Vec3 {
        Vector::new(self.0[0][index], self.0[1][index], self.0[2][index])
    }
}

/// Memory for the components of the directions of a block.
#[derive(Debug)]
pub(crate) struct Planes<T, const COUNT: usize>(pub(crate) [Plane<T>; COUNT]);

impl<T: Real, const COUNT: usize> Planes<T, COUNT> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self([[T::zero(); BLOCK]; COUNT])
    }
}

impl<T: Real> Planes<T, 3> {
    #[inline(always)]
    pub(crate) fn components(&self) -> Components<'_, T> {
        Components([&self.0[0], &self.0[1], &self.0[2]])
    }

    #[inline(always)]
    pub(crate) fn set(&mut self, index: usize, w: T::Vec3) {
        self.0[0][index] = w.x();
        self.0[1][index] = w.y();
        self.0[2][index] = w.z();
    }
}

impl<T: Real> Answers for Planes<T, 3> {
    type Answer = T::Vec3;

    #[inline(always)]
    fn fill(&mut self, formula: impl Fn(usize) -> T::Vec3) {
        for index in 0..BLOCK {
            let w = formula(index);
            self.0[0][index] = w.x();
            self.0[1][index] = w.y();
            self.0[2][index] = w.z();
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
