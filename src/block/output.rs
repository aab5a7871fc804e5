//! What a batch writes.

use super::error::{BatchError, Length};
use super::planes::{BLOCK, ColorBlock, Plane, SampleBlock, copy_front};
use super::run::Output;
use crate::real::{Color, Real, Vector};

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
///     ColorBuffer::from([&mut red, &mut green, &mut blue]),
/// )?;
/// assert!((green[1] - 0.5 / std::f32::consts::PI).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub enum ColorBuffer<'a, T: Real = f32, C: Color<T> = glam::Vec3> {
    /// One colour after the other.
    Colors(&'a mut [C]),
    /// A slice for each channel: all red, all green, all blue.
    Planes(C::Channels<&'a mut [T]>),
}

/// Where the samples of a batch go. All three have the length of the batch.
#[derive(Debug)]
pub struct SampleBuffer<'a, T: Real = f32, C: Color<T> = glam::Vec3> {
    /// [`Sample::wi`](crate::Sample::wi).
    pub wi: DirectionBuffer<'a, T>,
    /// [`Sample::weight`](crate::Sample::weight).
    pub weight: ColorBuffer<'a, T, C>,
    /// [`Sample::pdf`](crate::Sample::pdf).
    pub pdf: &'a mut [T],
}

/// Where the samples of a batch over the whole sphere go. All four have the length of the batch.
#[derive(Debug)]
pub struct BsdfSampleBuffer<'a, T: Real = f32, C: Color<T> = glam::Vec3> {
    /// [`BsdfSample::wi`](crate::BsdfSample::wi).
    pub wi: DirectionBuffer<'a, T>,
    /// [`BsdfSample::weight`](crate::BsdfSample::weight).
    pub weight: ColorBuffer<'a, T, C>,
    /// [`BsdfSample::pdf`](crate::BsdfSample::pdf).
    pub pdf: &'a mut [T],
    /// [`BsdfSample::specular`](crate::BsdfSample::specular).
    pub specular: &'a mut [T::Mask],
}

impl<'a, T: Real, C: Color<T>> BsdfSampleBuffer<'a, T, C> {
    /// Where what all samples have goes, and where it goes whether they are specular.
    #[inline(always)]
    pub(crate) fn apart(self) -> (SampleBuffer<'a, T, C>, Masks<'a, T>) {
        let Self { wi, weight, pdf, specular } = self;
        (SampleBuffer { wi, weight, pdf }, Masks(specular))
    }

    #[cfg(feature = "rayon")]
    pub(crate) fn of((samples, specular): (SampleBuffer<'a, T, C>, Masks<'a, T>)) -> Self {
        let SampleBuffer { wi, weight, pdf } = samples;
        Self { wi, weight, pdf, specular: specular.0 }
    }
}

/// Whether samples are specular: what a batch writes where a block has numbers above 0.
#[derive(Debug)]
pub(crate) struct Masks<'a, T: Real>(&'a mut [T::Mask]);

/// Numbers that a batch writes, and what the argument is called in errors.
#[derive(Debug)]
pub(crate) struct Numbers<'a, T>(pub(crate) &'a mut [T], pub(crate) &'static str);

impl<T: Real> DirectionBuffer<'_, T> {
    fn check(&self, length: &Length, names: [&'static str; 4]) -> Result<(), BatchError> {
        match self {
            Self::Vectors(vectors) => length.check(names[0], vectors.len()),
            Self::Planes(planes) => names[1..]
                .iter()
                .zip(planes)
                .try_for_each(|(name, plane)| length.check(name, plane.len())),
        }
    }

    #[inline(always)]
    fn write(&mut self, start: usize, block: &[Plane<T>; 4]) {
        match self {
            Self::Vectors(vectors) => {
                put_together(part(vectors, start), |index| {
                    Vector::new(block[0][index], block[1][index], block[2][index])
                });
            }
            Self::Planes(planes) => {
                for (plane, block) in planes.iter_mut().zip(block) {
                    copy_front(block, part(plane, start));
                }
            }
        }
    }
}

impl<T: Real, C: Color<T>> ColorBuffer<'_, T, C> {
    /// The length of the first slice, with which the others must agree.
    fn length_of(&self, names: &Names) -> Result<Length, BatchError> {
        let length = match self {
            Self::Colors(colors) => Length::of(names.whole, colors.len()),
            Self::Planes(planes) => {
                let first = planes.as_ref().first().map_or(0, |plane| plane.len());
                Length::of(names.channel(0), first)
            }
        };
        self.check(&length, names)?;
        Ok(length)
    }

    fn check(&self, length: &Length, names: &Names) -> Result<(), BatchError> {
        match self {
            Self::Colors(colors) => length.check(names.whole, colors.len()),
            Self::Planes(planes) => {
                planes.as_ref().iter().enumerate().try_for_each(|(channel, plane)| {
                    length.check(names.channel(channel), plane.len())
                })
            }
        }
    }
}

impl<T: Real, C: Color<T>> Output for ColorBuffer<'_, T, C> {
    type Block = ColorBlock<T, C>;

    #[inline(always)]
    fn memory() -> Self::Block {
        C::by_channel(|_| [T::zero(); BLOCK])
    }

    fn length(&self) -> Result<Length, BatchError> {
        self.length_of(&VALUES)
    }

    #[inline(always)]
    fn in_place(&mut self, start: usize) -> Option<&mut Self::Block> {
        match self {
            Self::Colors(colors) => whole(colors, start).and_then(C::in_place),
            Self::Planes(_) => None,
        }
    }

    #[inline(always)]
    fn write(&mut self, start: usize, block: &Self::Block) {
        match self {
            Self::Colors(colors) => {
                put_together(part(colors, start), |index| C::at(block, index));
            }
            Self::Planes(planes) => {
                for (plane, block) in planes.as_mut().iter_mut().zip(block.as_ref()) {
                    copy_front(block, part(plane, start));
                }
            }
        }
    }

    #[cfg(feature = "rayon")]
    fn split(self, middle: usize) -> (Self, Self) {
        match self {
            Self::Colors(colors) => {
                let (first, second) = colors.split_at_mut(middle);
                (Self::Colors(first), Self::Colors(second))
            }
            Self::Planes(mut planes) => {
                let second = C::by_channel(|channel| match planes.as_mut().get_mut(channel) {
                    Some(plane) => split_off(plane, middle),
                    None => &mut [],
                });
                (Self::Planes(planes), Self::Planes(second))
            }
        }
    }
}

impl<T: Real> Output for Numbers<'_, T> {
    type Block = Plane<T>;

    #[inline(always)]
    fn memory() -> Plane<T> {
        [T::zero(); BLOCK]
    }

    fn length(&self) -> Result<Length, BatchError> {
        Ok(Length::of(self.1, self.0.len()))
    }

    #[inline(always)]
    fn in_place(&mut self, start: usize) -> Option<&mut Plane<T>> {
        whole(self.0, start)
    }

    #[inline(always)]
    fn write(&mut self, start: usize, block: &Plane<T>) {
        copy_front(block, part(self.0, start));
    }

    #[cfg(feature = "rayon")]
    fn split(self, middle: usize) -> (Self, Self) {
        let (first, second) = self.0.split_at_mut(middle);
        (Self(first, self.1), Self(second, self.1))
    }
}

impl<T: Real> Output for Masks<'_, T> {
    type Block = Plane<T>;

    #[inline(always)]
    fn memory() -> Plane<T> {
        [T::zero(); BLOCK]
    }

    fn length(&self) -> Result<Length, BatchError> {
        Ok(Length::of("samples.specular", self.0.len()))
    }

    #[inline(always)]
    fn in_place(&mut self, _: usize) -> Option<&mut Plane<T>> {
        None
    }

    #[inline(always)]
    fn write(&mut self, start: usize, block: &Plane<T>) {
        for (to, from) in part(self.0, start).iter_mut().zip(block) {
            *to = from.gt(T::zero());
        }
    }

    #[cfg(feature = "rayon")]
    fn split(self, middle: usize) -> (Self, Self) {
        let (first, second) = self.0.split_at_mut(middle);
        (Self(first), Self(second))
    }
}

/// Two kinds of answers at once.
impl<A: Output, B: Output> Output for (A, B) {
    type Block = (A::Block, B::Block);

    #[inline(always)]
    fn memory() -> Self::Block {
        (A::memory(), B::memory())
    }

    fn length(&self) -> Result<Length, BatchError> {
        let (first, second) = (self.0.length()?, self.1.length()?);
        first.agree(&second)?;
        Ok(first)
    }

    #[inline(always)]
    fn in_place(&mut self, _: usize) -> Option<&mut Self::Block> {
        None
    }

    #[inline(always)]
    fn write(&mut self, start: usize, block: &Self::Block) {
        self.0.write(start, &block.0);
        self.1.write(start, &block.1);
    }

    #[cfg(feature = "rayon")]
    fn split(self, middle: usize) -> (Self, Self) {
        let (first, second) = (self.0.split(middle), self.1.split(middle));
        ((first.0, second.0), (first.1, second.1))
    }
}

impl<T: Real, C: Color<T>> Output for SampleBuffer<'_, T, C> {
    type Block = SampleBlock<T, C>;

    #[inline(always)]
    fn memory() -> Self::Block {
        SampleBlock::new()
    }

    fn length(&self) -> Result<Length, BatchError> {
        let length = Length::of("samples.pdf", self.pdf.len());
        self.wi.check(&length, ["samples.wi", "samples.wi.x", "samples.wi.y", "samples.wi.z"])?;
        self.weight.check(&length, &WEIGHTS)?;
        Ok(length)
    }

    #[inline(always)]
    fn in_place(&mut self, _: usize) -> Option<&mut Self::Block> {
        None
    }

    #[inline(always)]
    fn write(&mut self, start: usize, block: &Self::Block) {
        self.wi.write(start, &block.wi_pdf);
        self.weight.write(start, &block.weight);
        copy_front(&block.wi_pdf[3], part(self.pdf, start));
    }

    #[cfg(feature = "rayon")]
    fn split(self, middle: usize) -> (Self, Self) {
        let (wi, wi_rest) = match self.wi {
            DirectionBuffer::Vectors(vectors) => {
                let (first, second) = vectors.split_at_mut(middle);
                (DirectionBuffer::Vectors(first), DirectionBuffer::Vectors(second))
            }
            DirectionBuffer::Planes(mut planes) => {
                let second = planes.each_mut().map(|plane| split_off(plane, middle));
                (DirectionBuffer::Planes(planes), DirectionBuffer::Planes(second))
            }
        };
        let (weight, weight_rest) = self.weight.split(middle);
        let (pdf, pdf_rest) = self.pdf.split_at_mut(middle);
        (Self { wi, weight, pdf }, Self { wi: wi_rest, weight: weight_rest, pdf: pdf_rest })
    }
}

/// Leaves what comes before an element in the slice, and gives the rest.
#[cfg(feature = "rayon")]
fn split_off<'a, T>(slice: &mut &'a mut [T], middle: usize) -> &'a mut [T] {
    let (first, second) = core::mem::take(slice).split_at_mut(middle);
    *slice = first;
    second
}

/// What an argument with channels, and each of its first channels, is called in errors.
struct Names {
    whole: &'static str,
    channels: [&'static str; 16],
}

macro_rules! names {
    ($whole:literal: $($channel:literal)*) => {
        Names { whole: $whole, channels: [$( concat!($whole, "[", $channel, "]") ),*] }
    };
}
const VALUES: Names = names!("values": 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
const WEIGHTS: Names = names!("samples.weight": 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);

impl Names {
    fn channel(&self, channel: usize) -> &'static str {
        self.channels.get(channel).unwrap_or(&self.whole)
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

impl<'a, T: Real, C: Color<T>, P: AsMut<[C]> + ?Sized> From<&'a mut P> for ColorBuffer<'a, T, C> {
    fn from(colors: &'a mut P) -> Self {
        Self::Colors(colors.as_mut())
    }
}

impl<'a, T, C, P, const N: usize> From<[&'a mut P; N]> for ColorBuffer<'a, T, C>
where
    T: Real,
    C: Color<T>,
    C::Channels<&'a mut [T]>: From<[&'a mut [T]; N]>,
    P: AsMut<[T]> + ?Sized,
{
    fn from(planes: [&'a mut P; N]) -> Self {
        Self::Planes(planes.map(AsMut::as_mut).into())
    }
}

/// The block of a buffer that begins at `start`, if it is whole.
#[inline(always)]
fn whole<V>(buffer: &mut [V], start: usize) -> Option<&mut [V; BLOCK]> {
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
