//! A block of directions in the layout that SIMD code wants: one array per component.
//!
//! Batches run block by block, and a block runs strip by strip: loops of a fixed length that write
//! to arrays of the function they stand in. So the compiler knows that nothing overlaps, and turns
//! them into SIMD code without asking at run time.

use core::cell::Cell;

use super::instruction_set::InstructionSet;
use crate::real::{Color, Real, Vector};

/// Directions in a block.
pub(crate) const BLOCK: usize = 128;

/// Directions whose answers wait in registers, or next to them, before they go to the block.
const STRIP: usize = 16;

/// One number of each direction of a block.
pub(crate) type Plane<T, const N: usize = BLOCK> = [T; N];

/// Answers of a block.
pub(crate) trait Answers {
    /// The answer for one direction.
    type Answer;
    /// The answers of a strip.
    type Strip;

    fn strip() -> Self::Strip;
    fn put(strip: &mut Self::Strip, lane: usize, answer: Self::Answer);
    fn store(&mut self, start: usize, strip: &Self::Strip);

    /// Answers for the directions of a block, by their places in it.
    #[inline(always)]
    fn fill(&mut self, formula: impl Fn(usize) -> Self::Answer) {
        for start in (0..BLOCK).step_by(STRIP) {
            let mut strip = Self::strip();
            for lane in 0..STRIP {
                Self::put(&mut strip, lane, formula(start + lane));
            }
            self.store(start, &strip);
        }
    }
}

impl<T: Real> Answers for Plane<T> {
    type Answer = T;
    type Strip = Plane<T, STRIP>;

    #[inline(always)]
    fn strip() -> Self::Strip {
        [T::lit(0.0); STRIP]
    }
    #[inline(always)]
    fn put(strip: &mut Self::Strip, lane: usize, answer: T) {
        strip[lane] = answer;
    }
    #[inline(always)]
    fn store(&mut self, start: usize, strip: &Self::Strip) {
        self[start..start + STRIP].copy_from_slice(strip);
    }
}

impl<A: Answers, B: Answers, C: Answers> Answers for (&mut A, &mut B, &mut C) {
    type Answer = (A::Answer, B::Answer, C::Answer);
    type Strip = (A::Strip, B::Strip, C::Strip);

    #[inline(always)]
    fn strip() -> Self::Strip {
        (A::strip(), B::strip(), C::strip())
    }
    #[inline(always)]
    fn put(strip: &mut Self::Strip, lane: usize, (a, b, c): Self::Answer) {
        A::put(&mut strip.0, lane, a);
        B::put(&mut strip.1, lane, b);
        C::put(&mut strip.2, lane, c);
    }
    #[inline(always)]
    fn store(&mut self, start: usize, (a, b, c): &Self::Strip) {
        self.0.store(start, a);
        self.1.store(start, b);
        self.2.store(start, c);
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
pub(crate) struct Planes<T, const COUNT: usize, const N: usize = BLOCK>(
    pub(crate) [Plane<T, N>; COUNT],
);

impl<T: Real, const COUNT: usize, const N: usize> Planes<T, COUNT, N> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self([[T::lit(0.0); N]; COUNT])
    }
}

impl<T: Real> Planes<T, 3> {
    #[inline(always)]
    pub(crate) fn components(&self) -> Components<'_, T> {
        Components([&self.0[0], &self.0[1], &self.0[2]])
    }
}

impl<T: Real, const N: usize> Planes<T, 3, N> {
    #[inline(always)]
    pub(crate) fn set(&mut self, index: usize, w: T::Vec3) {
        self.0[0][index] = w.x();
        self.0[1][index] = w.y();
        self.0[2][index] = w.z();
    }
}

impl<T: Real> Answers for Planes<T, 3> {
    type Answer = T::Vec3;
    type Strip = Planes<T, 3, STRIP>;

    #[inline(always)]
    fn strip() -> Self::Strip {
        Planes::new()
    }
    #[inline(always)]
    fn put(strip: &mut Self::Strip, lane: usize, answer: T::Vec3) {
        strip.set(lane, answer);
    }
    #[inline(always)]
    fn store(&mut self, start: usize, strip: &Self::Strip) {
        for (plane, strip) in self.0.iter_mut().zip(&strip.0) {
            plane.store(start, strip);
        }
    }
}

/// The colours of a block: planes for up to four channels, colours side by side for more.
#[derive(Debug)]
pub(crate) struct Values<T, C, const N: usize = BLOCK> {
    planes: Planes<T, 4, N>,
    colors: [C; N],
}

impl<T: Real, C: Color<T>, const N: usize> Values<T, C, N> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { planes: Planes::new(), colors: [C::splat(T::lit(0.0)); N] }
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
}

impl<T: Real, C: Color<T>> Answers for Values<T, C> {
    type Answer = C;
    type Strip = Values<T, C, STRIP>;

    #[inline(always)]
    fn strip() -> Self::Strip {
        Values::new()
    }
    #[inline(always)]
    fn put(strip: &mut Self::Strip, lane: usize, answer: C) {
        strip.set(lane, answer);
    }
    #[inline(always)]
    fn store(&mut self, start: usize, strip: &Self::Strip) {
        if channels::<T, C>() <= 4 {
            for channel in 0..channels::<T, C>() {
                self.planes.0[channel & 3].store(start, &strip.planes.0[channel & 3]);
            }
        } else {
            self.colors[start..start + STRIP].copy_from_slice(&strip.colors);
        }
    }
}

impl<T: Real, C: Color<T>> Values<T, C> {
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
