//! A block of directions in the layout that SIMD code wants: one array per component.
//!
//! Batches run block by block. The loops over a block have a fixed length and write to arrays of the
//! function they stand in. So the compiler knows that nothing overlaps, and turns them into SIMD
//! code without asking at run time.

use core::cell::Cell;

use super::instruction_set::InstructionSet;
use crate::real::{Color, Real, Vector};

/// Directions in a block.
pub(crate) const BLOCK: usize = 128;

/// One number of each direction of a block.
pub(crate) type Plane<T> = [T; BLOCK];

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
pub(crate) struct Planes<T, const N: usize>(pub(crate) [Plane<T>; N]);

impl<T: Real, const N: usize> Planes<T, N> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self([[T::lit(0.0); BLOCK]; N])
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

/// The colours of a block: planes for up to four channels, colours side by side for more.
#[derive(Debug)]
pub(crate) struct Values<T, C> {
    planes: Planes<T, 4>,
    colors: [C; BLOCK],
}

impl<T: Real, C: Color<T>> Values<T, C> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { planes: Planes::new(), colors: [C::splat(T::lit(0.0)); BLOCK] }
    }

    /// Copies what is in use.
    #[inline(always)]
    pub(crate) fn copy_from(&mut self, other: &Self) {
        if channels::<T, C>() <= 4 {
            for channel in 0..channels::<T, C>() {
                self.planes.0[channel & 3] = other.planes.0[channel & 3];
            }
        } else {
            self.colors = other.colors;
        }
    }

    #[inline(always)]
    pub(crate) fn set(&mut self, index: usize, color: C) {
        if channels::<T, C>() <= 4 {
            let _ = color.fold((0, &mut self.planes.0), |(channel, planes), value| {
                // The mask tells the compiler what the condition above says.
                planes[channel & 3][index] = value;
                (channel + 1, planes)
            });
        } else {
            self.colors[index] = color;
        }
    }

    #[inline(always)]
    pub(crate) fn at(&self, index: usize) -> C {
        if channels::<T, C>() <= 4 {
            let channel = Cell::new(0);
            C::splat(T::lit(0.0))
                .map(|_| self.planes.0[channel.replace(channel.get() + 1) & 3][index])
        } else {
            self.colors[index]
        }
    }

    /// One channel of the first values.
    #[inline(always)]
    pub(crate) fn copy_channel(&self, channel: usize, to: &mut [T]) {
        if channels::<T, C>() <= 4 {
            copy_front(&self.planes.0[channel & 3], to);
        } else {
            for (to, color) in to.iter_mut().zip(&self.colors) {
                let (_, value) = color.fold((0, T::lit(0.0)), |(at, found), value| {
                    (at + 1, if at == channel { value } else { found })
                });
                *to = value;
            }
        }
    }
}

/// Runs `work` compiled for the instruction set, if these numbers gain by it.
#[inline(always)]
pub(crate) fn within<T: Real, R>(set: InstructionSet, work: impl FnOnce() -> R) -> R {
    if T::VECTORIZES { set.run(work) } else { work() }
}

/// Number of channels of a colour.
#[inline(always)]
pub(crate) fn channels<T: Real, C: Color<T>>() -> usize {
    C::splat(T::lit(0.0)).fold(0, |count, _| count + 1)
}

/// Fills `to`, which is no longer than a block, from the front of the plane.
#[inline(always)]
pub(crate) fn copy_front<T: Copy>(from: &Plane<T>, to: &mut [T]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = *from;
    }
}
