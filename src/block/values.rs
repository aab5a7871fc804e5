//! The colours of a block.

use core::cell::Cell;

use super::planes::{Answers, BLOCK, Plane, Planes, copy_front};
use crate::real::{Color, Real};

/// Memory for the colours of a block: planes for two to four channels, else colours side by side.
#[derive(Debug)]
pub(crate) struct Values<T, C> {
    planes: Planes<T, 4>,
    colors: [C; BLOCK],
}

/// Where the colours of a block go: its memory, or the caller's.
#[derive(Debug)]
pub(crate) struct Slots<'a, T, C> {
    planes: &'a mut Planes<T, 4>,
    colors: &'a mut [C; BLOCK],
}

/// Number of channels of a colour.
#[inline(always)]
pub(crate) fn channels<T: Real, C: Color<T>>() -> usize {
    C::splat(T::zero()).fold(0, |count, _| count + 1)
}

/// Whether the channels of a colour have planes of their own.
#[inline(always)]
pub(crate) fn in_planes<T: Real, C: Color<T>>() -> bool {
    matches!(channels::<T, C>(), 2..=4)
}

/// One channel of a colour.
#[inline(always)]
fn channel<T: Real, C: Color<T>>(color: C, channel: usize) -> T {
    let (_, value) = color.fold((0, T::zero()), |(at, found), value| {
        (at + 1, if at == channel { value } else { found })
    });
    value
}

/// Sets a colour of a block, by statements and not by a function: see [`Answers::fill`].
macro_rules! set {
    ($planes:expr, $colors:expr, $index:expr, $color:expr) => {
        let color = $color;
        if in_planes::<T, C>() {
            $planes.0[0][$index] = channel(color, 0);
            $planes.0[1][$index] = channel(color, 1);
            if channels::<T, C>() > 2 {
                $planes.0[2][$index] = channel(color, 2);
            }
            if channels::<T, C>() > 3 {
                $planes.0[3][$index] = channel(color, 3);
            }
        } else {
            $colors[$index] = color;
        }
    };
}

impl<T: Real, C: Color<T>> Values<T, C> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { planes: Planes::new(), colors: [C::splat(T::zero()); BLOCK] }
    }

    #[inline(always)]
    pub(crate) fn slots(&mut self) -> Slots<'_, T, C> {
        Slots { planes: &mut self.planes, colors: &mut self.colors }
    }

    /// Slots in the caller's memory, for colours that need no rearrangement.
    #[inline(always)]
    pub(crate) fn slots_in<'a>(
        &'a mut self,
        colors: &'a mut [C; BLOCK],
    ) -> Option<Slots<'a, T, C>> {
        (!in_planes::<T, C>()).then_some(Slots { planes: &mut self.planes, colors })
    }

    #[inline(always)]
    pub(crate) fn at(&self, index: usize) -> C {
        if in_planes::<T, C>() {
            let channel = Cell::new(0);
            C::splat(T::zero())
                .map(|_| self.planes.0[channel.replace(channel.get() + 1) & 3][index])
        } else {
            self.colors[index]
        }
    }

    /// One channel of the first values.
    #[inline(always)]
    pub(crate) fn copy_channel(&self, number: usize, to: &mut [T]) {
        if in_planes::<T, C>() {
            copy_front(&self.planes.0[number & 3], to);
        } else {
            for (to, color) in to.iter_mut().zip(&self.colors) {
                *to = channel(*color, number);
            }
        }
    }
}

impl<T: Real, C: Color<T>> Slots<'_, T, C> {
    #[inline(always)]
    pub(crate) fn set(&mut self, index: usize, color: C) {
        set!(self.planes, self.colors, index, color);
    }
}

impl<T: Real, C: Color<T>> Answers for Slots<'_, T, C> {
    type Answer = C;

    #[inline(always)]
    fn fill(&mut self, formula: impl Fn(usize) -> C) {
        #[inline(always)]
        #[allow(clippy::needless_range_loop, reason = "an iterator would be another function")]
        fn fill<T: Real, C: Color<T>>(
            planes: &mut Planes<T, 4>,
            colors: &mut [C; BLOCK],
            formula: impl Fn(usize) -> C,
        ) {
            for index in 0..BLOCK {
                set!(planes, colors, index, formula(index));
            }
        }
        fill(self.planes, self.colors, formula);
    }
}

/// The samples of a block.
#[derive(Debug)]
pub(crate) struct Samples<T, C> {
    pub(crate) wi: Planes<T, 3>,
    pub(crate) weight: Values<T, C>,
    pub(crate) pdf: Plane<T>,
}

impl<T: Real, C: Color<T>> Samples<T, C> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { wi: Planes::new(), weight: Values::new(), pdf: [T::zero(); BLOCK] }
    }
}

impl<T: Real, C: Color<T>> Answers for Samples<T, C> {
    /// Direction, weight and density.
    type Answer = (T::Vec3, C, T);

    #[inline(always)]
    fn fill(&mut self, formula: impl Fn(usize) -> Self::Answer) {
        use crate::real::Vector;

        for index in 0..BLOCK {
            let (wi, weight, pdf) = formula(index);
            self.wi.0[0][index] = wi.x();
            self.wi.0[1][index] = wi.y();
            self.wi.0[2][index] = wi.z();
            set!(self.weight.planes, self.weight.colors, index, weight);
            self.pdf[index] = pdf;
        }
    }
}
