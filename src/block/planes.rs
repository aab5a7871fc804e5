//! A block of a batch in the layout that SIMD code wants: one array for each component.
//!
//! Batches run block by block, by loops of a fixed length that the compiler turns into SIMD code.

use core::cell::Cell;

use super::instruction_set::InstructionSet;
use crate::real::{Color, Mask, Real, Vector};

/// The number of elements in a block.
pub const BLOCK: usize = 128;

/// One number of each element of a block.
pub type Plane<T> = [T; BLOCK];

/// The colours of a block: one plane for each channel.
pub type ColorBlock<T, C> = <C as Color<T>>::Channels<Plane<T>>;

/// What is asked about the elements of a block, `N` numbers for each, and the instruction set that
/// the answers are computed with.
#[derive(Clone, Copy, Debug)]
pub struct Block<'a, T, const N: usize> {
    /// What the loops over the block are compiled for.
    pub set: InstructionSet,
    /// The numbers, wherever they lie.
    pub planes: [&'a Plane<T>; N],
}

/// Pairs of directions: x, y, z of `wi`, then of `wo`.
pub type PairBlock<'a, T> = Block<'a, T, 6>;
/// Viewers and uniform numbers: x, y, z of `wo`, then the numbers.
pub type DrawBlock<'a, T> = Block<'a, T, 5>;
/// Directions: x, y, z.
pub type DirectionBlock<'a, T> = Block<'a, T, 3>;
/// Pairs of uniform numbers.
pub type UniformBlock<'a, T> = Block<'a, T, 2>;
/// Cosines of angles of incidence.
pub type CosineBlock<'a, T> = Block<'a, T, 1>;

impl<'a, T: Real, const N: usize> Block<'a, T, N> {
    /// Runs a loop over the block, compiled for the instruction set if these numbers gain by it.
    ///
    /// What the loop calls takes part only if it is always inlined: functions with
    /// `#[inline(always)]`, closures with the same attribute.
    #[inline(always)]
    pub fn within<R>(&self, work: impl FnOnce() -> R) -> R {
        if T::VECTORIZES { self.set.run(work) } else { work() }
    }

    /// Fills colours with what a formula answers for the places of the block.
    #[inline(always)]
    pub fn colors<C: Color<T>>(&self, colors: &mut ColorBlock<T, C>, formula: impl Fn(usize) -> C) {
        self.colors_and_numbers(
            colors,
            &mut [],
            #[inline(always)]
            |index| (formula(index), []),
        );
    }

    /// [`colors`](Self::colors) of a formula that also tells where it does not hold. The answer is
    /// whether it is known to hold at all places.
    #[inline(always)]
    pub(crate) fn colors_unless<C: Color<T>>(
        &self,
        colors: &mut ColorBlock<T, C>,
        formula: impl Fn(usize) -> (C, T::Mask),
    ) -> bool {
        self.within(
            #[inline(always)]
            || {
                let fails = Cell::new(T::zero().lt(T::zero()));
                C::fill(
                    colors,
                    &mut [],
                    #[inline(always)]
                    |index| {
                        let (color, fails_here) = formula(index);
                        fails.set(fails.get().or(fails_here));
                        (color, [])
                    },
                );
                fails.get().is_never()
            },
        )
    }

    /// Fills colours, and planes beside them, with what a formula answers for the places of the block.
    #[inline(always)]
    pub fn colors_and_numbers<C: Color<T>, const M: usize>(
        &self,
        colors: &mut ColorBlock<T, C>,
        planes: &mut [Plane<T>; M],
        formula: impl Fn(usize) -> (C, [T; M]),
    ) {
        self.within(
            #[inline(always)]
            || C::fill(colors, planes, formula),
        );
    }

    /// Fills planes with the numbers that a formula answers for the places of the block.
    #[inline(always)]
    pub fn numbers<const M: usize>(
        &self,
        planes: &mut [Plane<T>; M],
        formula: impl Fn(usize) -> [T; M],
    ) {
        self.within(
            #[inline(always)]
            || fill(planes, formula),
        );
    }

    /// Changes planes and fills others: the formula is told what stands at its place.
    #[inline(always)]
    pub(crate) fn changed<const M: usize, const K: usize>(
        &self,
        planes: &mut [Plane<T>; M],
        others: &mut [Plane<T>; K],
        formula: impl Fn(usize, [T; M]) -> ([T; M], [T; K]),
    ) {
        self.within(
            #[inline(always)]
            || refill(planes, others, formula),
        );
    }

    /// Other numbers for the same loops.
    #[inline(always)]
    #[must_use]
    pub const fn of<'b, const M: usize>(&self, planes: [&'b Plane<T>; M]) -> Block<'b, T, M> {
        Block { set: self.set, planes }
    }

    #[inline(always)]
    fn vector<const START: usize>(&self, index: usize) -> T::Vec3 {
        let at = |component: usize| self.planes[START + component][index];
        Vector::new(at(0), at(1), at(2))
    }
}

impl<'a, T: Real> PairBlock<'a, T> {
    /// The direction towards the light of one of the elements.
    #[inline(always)]
    #[must_use]
    pub fn wi(&self, index: usize) -> T::Vec3 {
        self.vector::<0>(index)
    }

    /// The direction towards the viewer of one of the elements.
    #[inline(always)]
    #[must_use]
    pub fn wo(&self, index: usize) -> T::Vec3 {
        self.vector::<3>(index)
    }

    /// Light and viewer exchanged.
    #[inline(always)]
    #[must_use]
    pub const fn exchanged(&self) -> Self {
        let [a, b, c, d, e, f] = self.planes;
        Block { set: self.set, planes: [d, e, f, a, b, c] }
    }

    /// All directions towards the light, and all towards the viewer.
    #[inline(always)]
    #[must_use]
    pub const fn apart(&self) -> [DirectionBlock<'a, T>; 2] {
        let [a, b, c, d, e, f] = self.planes;
        [Block { set: self.set, planes: [a, b, c] }, Block { set: self.set, planes: [d, e, f] }]
    }
}

impl<'a, T: Real> DrawBlock<'a, T> {
    /// The direction towards the viewer of one of the elements.
    #[inline(always)]
    #[must_use]
    pub fn wo(&self, index: usize) -> T::Vec3 {
        self.vector::<0>(index)
    }

    /// The uniform numbers of one of the elements.
    #[inline(always)]
    #[must_use]
    pub const fn u(&self, index: usize) -> [T; 2] {
        [self.planes[3][index], self.planes[4][index]]
    }

    /// The same viewers with other uniform numbers.
    #[inline(always)]
    #[must_use]
    pub const fn with<'b>(&self, [u0, u1]: [&'b Plane<T>; 2]) -> DrawBlock<'b, T>
    where
        'a: 'b,
    {
        let [x, y, z, _, _] = self.planes;
        Block { set: self.set, planes: [x, y, z, u0, u1] }
    }

    /// Other directions towards the light for the same viewers.
    #[inline(always)]
    #[must_use]
    pub(crate) const fn lit_from<'b>(&self, wi: [&'b Plane<T>; 3]) -> PairBlock<'b, T>
    where
        'a: 'b,
    {
        let ([a, b, c], [x, y, z, _, _]) = (wi, self.planes);
        Block { set: self.set, planes: [a, b, c, x, y, z] }
    }
}

impl<T: Real> DirectionBlock<'_, T> {
    /// One of the directions.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, index: usize) -> T::Vec3 {
        self.vector::<0>(index)
    }
}

impl<T: Real> UniformBlock<'_, T> {
    /// The numbers of one of the elements.
    #[inline(always)]
    #[must_use]
    pub const fn u(&self, index: usize) -> [T; 2] {
        [self.planes[0][index], self.planes[1][index]]
    }
}

impl<T: Real> CosineBlock<'_, T> {
    /// One of the cosines.
    #[inline(always)]
    #[must_use]
    pub const fn cos(&self, index: usize) -> T {
        self.planes[0][index]
    }
}

/// Viewers over the whole sphere and uniform numbers: [`Bsdf::sample`](crate::Bsdf::sample) for a block.
#[derive(Clone, Copy, Debug)]
pub struct EventBlock<'a, T> {
    /// The viewers, and the two numbers that choose a direction.
    pub draws: DrawBlock<'a, T>,
    /// The third number, which chooses the event.
    pub event: &'a Plane<T>,
}

impl<'a, T: Real> EventBlock<'a, T> {
    #[inline(always)]
    pub(crate) const fn new(Block { set, planes }: Block<'a, T, 6>) -> Self {
        let [x, y, z, u0, u1, event] = planes;
        Self { draws: Block { set, planes: [x, y, z, u0, u1] }, event }
    }

    /// The direction towards the viewer of one of the elements.
    #[inline(always)]
    #[must_use]
    pub fn wo(&self, index: usize) -> T::Vec3 {
        self.draws.wo(index)
    }

    /// The uniform numbers of one of the elements.
    #[inline(always)]
    #[must_use]
    pub const fn u(&self, index: usize) -> [T; 3] {
        let [u0, u1] = self.draws.u(index);
        [u0, u1, self.event[index]]
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
}

impl<T: Real, C: Color<T>> Default for SampleBlock<T, C> {
    fn default() -> Self {
        Self::new()
    }
}

/// Fills planes with what a formula answers for their places: for numbers what [`Color::fill`] is
/// for colours, and as fast.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "an iterator would be another function")]
fn fill<T: Real, const M: usize>(planes: &mut [Plane<T>; M], formula: impl Fn(usize) -> [T; M]) {
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
fn refill<T: Real, const M: usize, const K: usize>(
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

/// Fills `to`, which is no longer than a block, from the front of the plane.
#[inline(always)]
pub(super) fn copy_front<T: Copy>(from: &Plane<T>, to: &mut [T]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = *from;
    }
}
