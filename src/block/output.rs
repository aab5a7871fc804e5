//! What a batch writes.

use super::error::{BatchError, Length};
use super::planes::{BLOCK, Plane, Planes, copy_front};
use super::values::{Slots, Values, channels};
use crate::real::{Color, Real};

/// Directions that a batch writes.
#[derive(Debug)]
pub enum DirectionBuffer<'a, T: Real = f32> {
    /// One vector after the other.
    Vectors(&'a mut [T::Vec3]),
    /// All x, all y, all z.
    Planes([&'a mut [T]; 3]),
}

/// Colours that a batch writes.
///
/// ```
/// use brdf::batch::ColorBuffer;
/// use brdf::{Brdf, Lambert};
/// use glam::Vec3;
///
/// let clay = Lambert::new(Vec3::new(0.8, 0.5, 0.2))?;
/// let mut red = [0.0; 2];
/// let (mut green, mut blue) = (red, red);
/// clay.eval_batch(
///     Vec3::Z.into(),
///     Vec3::Z.into(),
///     ColorBuffer::Planes([&mut red, &mut green, &mut blue]),
/// )?;
/// assert!((green[1] - 0.5 / std::f32::consts::PI).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub enum ColorBuffer<'a, T = f32, C = glam::Vec3> {
    /// One colour after the other.
    Colors(&'a mut [C]),
    /// All red, all green, all blue. A colour with one channel is a number, and its slice one of
    /// [`Colors`](Self::Colors).
    Planes([&'a mut [T]; 3]),
}

/// Where the samples of a batch go. All three have the length of the batch.
#[derive(Debug)]
pub struct SampleBuffer<'a, T: Real = f32, C = glam::Vec3> {
    /// [`Sample::wi`](crate::Sample::wi).
    pub wi: DirectionBuffer<'a, T>,
    /// [`Sample::weight`](crate::Sample::weight).
    pub weight: ColorBuffer<'a, T, C>,
    /// [`Sample::pdf`](crate::Sample::pdf).
    pub pdf: &'a mut [T],
}

impl<T: Real> DirectionBuffer<'_, T> {
    pub(super) fn check(
        &self,
        length: &Length,
        names: [&'static str; 4],
    ) -> Result<(), BatchError> {
        match self {
            Self::Vectors(vectors) => length.check(names[0], vectors.len()),
            Self::Planes(planes) => names[1..]
                .iter()
                .zip(planes)
                .try_for_each(|(name, plane)| length.check(name, plane.len())),
        }
    }

    /// Writes what there is room for of a block that begins at `start`.
    #[inline(always)]
    pub(crate) fn write(&mut self, start: usize, block: &Planes<T, 3>) {
        match self {
            Self::Vectors(vectors) => {
                let vectors = part(vectors, start);
                put_together(vectors, |index| block.components().at(index));
            }
            Self::Planes(planes) => {
                for (plane, block) in planes.iter_mut().zip(&block.0) {
                    copy_front(block, part(plane, start));
                }
            }
        }
    }
}

impl<T: Real, C: Color<T>> ColorBuffer<'_, T, C> {
    /// The length that all other slices must have, under the names of this argument.
    pub(super) fn length(&self, names: [&'static str; 4]) -> Result<Length, BatchError> {
        let length = match self {
            Self::Colors(colors) => Length::of(names[0], colors.len()),
            Self::Planes(planes) => Length::of(names[1], planes[0].len()),
        };
        self.check(&length, names)?;
        Ok(length)
    }

    pub(super) fn check(
        &self,
        length: &Length,
        names: [&'static str; 4],
    ) -> Result<(), BatchError> {
        match self {
            Self::Colors(colors) => length.check(names[0], colors.len()),
            Self::Planes(planes) => {
                let channels = channels::<T, C>();
                if channels != planes.len() {
                    let (argument, slices) = (names[0], planes.len());
                    return Err(BatchError::Channels { argument, slices, channels });
                }
                names[1..]
                    .iter()
                    .zip(planes)
                    .try_for_each(|(name, plane)| length.check(name, plane.len()))
            }
        }
    }

    /// Slots in this memory for a block that begins at `start`, if it is whole and they fit.
    #[inline(always)]
    pub(crate) fn slots<'b>(
        &'b mut self,
        start: usize,
        memory: &'b mut Values<T, C>,
    ) -> Option<Slots<'b, T, C>> {
        match self {
            Self::Colors(colors) => {
                whole_mut(colors, start).and_then(|colors| memory.slots_in(colors))
            }
            Self::Planes(_) => None,
        }
    }

    /// Writes what there is room for of a block that begins at `start`.
    #[inline(always)]
    pub(crate) fn write(&mut self, start: usize, block: &Values<T, C>) {
        match self {
            Self::Colors(colors) => {
                put_together(part(colors, start), |index| block.at(index));
            }
            Self::Planes(planes) => {
                for (channel, plane) in planes.iter_mut().enumerate() {
                    block.copy_channel(channel, part(plane, start));
                }
            }
        }
    }

    /// Applies a formula to every channel of every colour.
    pub(crate) fn map(&mut self, formula: impl Fn(T) -> T) {
        match self {
            Self::Colors(colors) => {
                for color in colors.iter_mut() {
                    *color = color.map(&formula);
                }
            }
            Self::Planes(planes) => {
                for value in planes.iter_mut().flat_map(|plane| plane.iter_mut()) {
                    *value = formula(*value);
                }
            }
        }
    }

    /// The same memory for a call that ends before this borrow.
    pub(crate) fn reborrow(&mut self) -> ColorBuffer<'_, T, C> {
        match self {
            Self::Colors(colors) => ColorBuffer::Colors(colors),
            Self::Planes([r, g, b]) => ColorBuffer::Planes([r, g, b]),
        }
    }
}

/// What comes before an element, and the rest.
#[cfg(feature = "rayon")]
mod split {
    use super::{ColorBuffer, DirectionBuffer, SampleBuffer};
    use crate::real::Real;

    type Planes<'a, T> = [&'a mut [T]; 3];

    fn planes<T>(planes: Planes<'_, T>, middle: usize) -> (Planes<'_, T>, Planes<'_, T>) {
        let [x, y, z] = planes.map(|plane| plane.split_at_mut(middle));
        ([x.0, y.0, z.0], [x.1, y.1, z.1])
    }

    impl<T: Real> DirectionBuffer<'_, T> {
        fn split(self, middle: usize) -> (Self, Self) {
            match self {
                Self::Vectors(vectors) => {
                    let (first, second) = vectors.split_at_mut(middle);
                    (Self::Vectors(first), Self::Vectors(second))
                }
                Self::Planes(all) => {
                    let (first, second) = planes(all, middle);
                    (Self::Planes(first), Self::Planes(second))
                }
            }
        }
    }

    impl<T, C> ColorBuffer<'_, T, C> {
        pub(crate) fn split(self, middle: usize) -> (Self, Self) {
            match self {
                Self::Colors(colors) => {
                    let (first, second) = colors.split_at_mut(middle);
                    (Self::Colors(first), Self::Colors(second))
                }
                Self::Planes(all) => {
                    let (first, second) = planes(all, middle);
                    (Self::Planes(first), Self::Planes(second))
                }
            }
        }
    }

    impl<T: Real, C> SampleBuffer<'_, T, C> {
        pub(crate) fn split(self, middle: usize) -> (Self, Self) {
            let (wi, weight) = (self.wi.split(middle), self.weight.split(middle));
            let pdf = self.pdf.split_at_mut(middle);
            (
                Self { wi: wi.0, weight: weight.0, pdf: pdf.0 },
                Self { wi: wi.1, weight: weight.1, pdf: pdf.1 },
            )
        }
    }
}

impl<T: Real, C: Color<T>> SampleBuffer<'_, T, C> {
    /// The same memory for a call that ends before this borrow.
    pub(crate) fn reborrow(&mut self) -> SampleBuffer<'_, T, C> {
        let wi = match &mut self.wi {
            DirectionBuffer::Vectors(vectors) => DirectionBuffer::Vectors(vectors),
            DirectionBuffer::Planes([x, y, z]) => DirectionBuffer::Planes([x, y, z]),
        };
        SampleBuffer { wi, weight: self.weight.reborrow(), pdf: self.pdf }
    }

    pub(super) fn length(&self) -> Result<Length, BatchError> {
        let length = Length::of("samples.pdf", self.pdf.len());
        self.wi.check(&length, ["samples.wi", "samples.wi.x", "samples.wi.y", "samples.wi.z"])?;
        let names =
            ["samples.weight", "samples.weight[0]", "samples.weight[1]", "samples.weight[2]"];
        self.weight.check(&length, names)?;
        Ok(length)
    }
}

macro_rules! from_vectors {
    ($float:ty, $vector:ty) => {
        impl<'a> From<&'a mut [$vector]> for DirectionBuffer<'a, $float> {
            fn from(vectors: &'a mut [$vector]) -> Self {
                Self::Vectors(vectors)
            }
        }
        impl<'a, const N: usize> From<&'a mut [$vector; N]> for DirectionBuffer<'a, $float> {
            fn from(vectors: &'a mut [$vector; N]) -> Self {
                Self::Vectors(vectors)
            }
        }
        impl<'a> From<&'a mut alloc::vec::Vec<$vector>> for DirectionBuffer<'a, $float> {
            fn from(vectors: &'a mut alloc::vec::Vec<$vector>) -> Self {
                Self::Vectors(vectors)
            }
        }
    };
}
from_vectors!(f32, glam::Vec3);
from_vectors!(f64, glam::DVec3);

impl<'a, T: Real, P: AsMut<[T]> + ?Sized> From<[&'a mut P; 3]> for DirectionBuffer<'a, T> {
    fn from(planes: [&'a mut P; 3]) -> Self {
        Self::Planes(planes.map(AsMut::as_mut))
    }
}

impl<'a, T, C, P: AsMut<[C]> + ?Sized> From<&'a mut P> for ColorBuffer<'a, T, C> {
    fn from(colors: &'a mut P) -> Self {
        Self::Colors(colors.as_mut())
    }
}

impl<'a, T, C, P: AsMut<[T]> + ?Sized> From<[&'a mut P; 3]> for ColorBuffer<'a, T, C> {
    fn from(planes: [&'a mut P; 3]) -> Self {
        Self::Planes(planes.map(AsMut::as_mut))
    }
}

/// Writes what there is room for of a block of numbers that begins at `start`.
#[inline(always)]
pub(crate) fn write_plane<T: Real>(to: &mut [T], start: usize, block: &Plane<T>) {
    copy_front(block, part(to, start));
}

/// The block of a buffer that begins at `start`, if it is whole.
#[inline(always)]
pub(super) fn whole_mut<V>(buffer: &mut [V], start: usize) -> Option<&mut [V; BLOCK]> {
    buffer.get_mut(start..).and_then(<[V]>::first_chunk_mut)
}

/// The part of a buffer that a block beginning at `start` covers.
#[inline(always)]
fn part<V>(buffer: &mut [V], start: usize) -> &mut [V] {
    let end = buffer.len().min(start.saturating_add(BLOCK));
    buffer.get_mut(start..end).unwrap_or_default()
}

/// Puts components together to vectors or colours.
#[inline(always)]
fn put_together<V>(to: &mut [V], at: impl Fn(usize) -> V) {
    if let Some(to) = to.first_chunk_mut::<BLOCK>() {
        for (index, to) in to.iter_mut().enumerate() {
            *to = at(index);
        }
    } else {
        for (index, to) in to.iter_mut().enumerate() {
            *to = at(index);
        }
    }
}
