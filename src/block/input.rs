//! What a batch reads.

use super::error::{BatchError, Length};
use super::planes::{BLOCK, Components, Plane, Planes};
use crate::real::{Real, Vector};

/// Directions that a batch reads, one for each of its elements.
///
/// ```
/// use brdf::batch::Directions;
/// use glam::Vec3;
///
/// let (x, y, z) = ([0.0, 0.6], [0.0, 0.0], [1.0, 0.8]);
/// let separate: Directions<'_, f32> = [&x, &y, &z].into();
/// let vectors = vec![Vec3::Z, Vec3::new(0.6, 0.0, 0.8)];
/// let together: Directions<'_, f32> = (&vectors).into();
/// assert_eq!(separate.len(), together.len());
/// ```
#[derive(Clone, Copy, Debug)]
pub enum Directions<'a, T: Real = f32> {
    /// One vector after the other.
    Vectors(&'a [T::Vec3]),
    /// All x, all y, all z: the layout that needs no rearrangement.
    Planes([&'a [T]; 3]),
    /// The same direction for every element.
    Same(T::Vec3),
}

impl<'a, T: Real> Directions<'a, T> {
    /// The number of directions, without end for [`Same`](Self::Same). Of components that differ
    /// in length the first counts.
    #[must_use]
    pub const fn len(&self) -> Option<usize> {
        match self {
            Self::Vectors(vectors) => Some(vectors.len()),
            Self::Planes(planes) => Some(planes[0].len()),
            Self::Same(_) => None,
        }
    }

    /// True if there is no direction.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        matches!(self.len(), Some(0))
    }

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
            Self::Same(_) => Ok(()),
        }
    }

    /// What comes before an element, and the rest.
    #[cfg(feature = "rayon")]
    pub(crate) fn split(self, middle: usize) -> (Self, Self) {
        match self {
            Self::Vectors(vectors) => {
                let (first, second) = vectors.split_at(middle);
                (Self::Vectors(first), Self::Vectors(second))
            }
            Self::Planes(planes) => {
                let [x, y, z] = planes.map(|plane| plane.split_at(middle));
                (Self::Planes([x.0, y.0, z.0]), Self::Planes([x.1, y.1, z.1]))
            }
            Self::Same(w) => (Self::Same(w), Self::Same(w)),
        }
    }

    /// The block that begins at `start`: in place if it is whole, else in `memory` and filled up
    /// with null vectors, for which every answer is zero.
    #[inline(always)]
    pub(crate) fn block<'b>(&self, start: usize, memory: &'b mut Planes<T, 3>) -> Components<'b, T>
    where
        'a: 'b,
    {
        match *self {
            Self::Vectors(vectors) => {
                let rest = vectors.get(start..).unwrap_or_default();
                rearrange::<T>(rest, memory);
                memory.components()
            }
            Self::Planes(planes) => {
                let [x, y, z] = planes.map(|plane| whole(plane, start));
                if let (Some(x), Some(y), Some(z)) = (x, y, z) {
                    return Components([x, y, z]);
                }
                for (memory, plane) in memory.0.iter_mut().zip(planes) {
                    fill(memory, plane.get(start..).unwrap_or_default());
                }
                memory.components()
            }
            Self::Same(w) => {
                memory.0 = [[w.x(); BLOCK], [w.y(); BLOCK], [w.z(); BLOCK]];
                memory.components()
            }
        }
    }
}

/// The block of a slice that begins at `start`, if it is whole.
#[inline(always)]
pub(super) fn whole<T>(slice: &[T], start: usize) -> Option<&[T; BLOCK]> {
    slice.get(start..).and_then(<[T]>::first_chunk)
}

/// Copies what there is of a block, and its first element behind it: a formula may rely on what it
/// is asked.
pub(super) fn fill<T: Real>(memory: &mut Plane<T>, from: &[T]) {
    *memory = [from.first().copied().unwrap_or(T::zero()); BLOCK];
    for (memory, from) in memory.iter_mut().zip(from) {
        *memory = *from;
    }
}

/// Takes vectors apart into components.
#[inline(always)]
fn rearrange<T: Real>(vectors: &[T::Vec3], memory: &mut Planes<T, 3>) {
    if let Some(vectors) = vectors.first_chunk::<BLOCK>() {
        for (index, vector) in vectors.iter().enumerate() {
            memory.set(index, *vector);
        }
    } else if let Some(first) = vectors.first() {
        for index in 0..BLOCK {
            memory.set(index, *vectors.get(index).unwrap_or(first));
        }
    }
}

/// Pairs of uniform numbers in [0, 1) that a batch reads, one for each of its elements.
#[derive(Clone, Copy, Debug)]
pub enum Uniforms<'a, T = f32> {
    /// One pair after the other.
    Pairs(&'a [[T; 2]]),
    /// All first numbers, all second numbers.
    Planes([&'a [T]; 2]),
}

impl<'a, T: Real> Uniforms<'a, T> {
    pub(super) fn check(&self, length: &Length) -> Result<(), BatchError> {
        match self {
            Self::Pairs(pairs) => length.check("u", pairs.len()),
            Self::Planes([first, second]) => {
                length.check("u[0]", first.len())?;
                length.check("u[1]", second.len())
            }
        }
    }

    /// What comes before an element, and the rest.
    #[cfg(feature = "rayon")]
    pub(crate) fn split(self, middle: usize) -> (Self, Self) {
        match self {
            Self::Pairs(pairs) => {
                let (first, second) = pairs.split_at(middle);
                (Self::Pairs(first), Self::Pairs(second))
            }
            Self::Planes(planes) => {
                let [u0, u1] = planes.map(|plane| plane.split_at(middle));
                (Self::Planes([u0.0, u1.0]), Self::Planes([u0.1, u1.1]))
            }
        }
    }

    /// The block that begins at `start`, as [`Directions::block`].
    #[inline(always)]
    pub(crate) fn block<'b>(&self, start: usize, memory: &'b mut Planes<T, 2>) -> [&'b Plane<T>; 2]
    where
        'a: 'b,
    {
        match *self {
            Self::Pairs(pairs) => {
                let rest = pairs.get(start..).unwrap_or_default();
                let first = rest.first().copied().unwrap_or([T::zero(); 2]);
                *memory = Planes(first.map(|number| [number; BLOCK]));
                for (index, pair) in rest.iter().take(BLOCK).enumerate() {
                    memory.0[0][index] = pair[0];
                    memory.0[1][index] = pair[1];
                }
            }
            Self::Planes(planes) => {
                let [first, second] = planes.map(|plane| whole(plane, start));
                if let (Some(first), Some(second)) = (first, second) {
                    return [first, second];
                }
                for (memory, plane) in memory.0.iter_mut().zip(planes) {
                    fill(memory, plane.get(start..).unwrap_or_default());
                }
            }
        }
        [&memory.0[0], &memory.0[1]]
    }
}

impl<'a, T: Real> From<Components<'a, T>> for Directions<'a, T> {
    fn from(components: Components<'a, T>) -> Self {
        Self::Planes(components.0.map(<[T; BLOCK]>::as_slice))
    }
}

macro_rules! from_vectors {
    ($float:ty, $vector:ty) => {
        impl<'a> From<&'a [$vector]> for Directions<'a, $float> {
            fn from(vectors: &'a [$vector]) -> Self {
                Self::Vectors(vectors)
            }
        }
        impl<'a, const N: usize> From<&'a [$vector; N]> for Directions<'a, $float> {
            fn from(vectors: &'a [$vector; N]) -> Self {
                Self::Vectors(vectors)
            }
        }
        impl<'a> From<&'a alloc::vec::Vec<$vector>> for Directions<'a, $float> {
            fn from(vectors: &'a alloc::vec::Vec<$vector>) -> Self {
                Self::Vectors(vectors)
            }
        }
        impl From<$vector> for Directions<'_, $float> {
            fn from(same: $vector) -> Self {
                Self::Same(same)
            }
        }
    };
}
from_vectors!(f32, glam::Vec3);
from_vectors!(f64, glam::DVec3);

impl<'a, T: Real, P: AsRef<[T]> + ?Sized> From<[&'a P; 3]> for Directions<'a, T> {
    fn from(planes: [&'a P; 3]) -> Self {
        Self::Planes(planes.map(AsRef::as_ref))
    }
}

impl<'a, T: Real, P: AsRef<[T]> + ?Sized> From<[&'a P; 2]> for Uniforms<'a, T> {
    fn from(planes: [&'a P; 2]) -> Self {
        Self::Planes(planes.map(AsRef::as_ref))
    }
}

impl<'a, T, P: AsRef<[[T; 2]]> + ?Sized> From<&'a P> for Uniforms<'a, T> {
    fn from(pairs: &'a P) -> Self {
        Self::Pairs(pairs.as_ref())
    }
}
