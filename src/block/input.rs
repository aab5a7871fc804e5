//! What a batch reads.

use super::error::{BatchError, Length};
use super::planes::{BLOCK, Plane};
use super::run::Input;
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

    fn check(&self, length: &Length, names: [&'static str; 4]) -> Result<(), BatchError> {
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
    fn split(self, middle: usize) -> (Self, Self) {
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

    /// See [`Input::planes`].
    #[inline(always)]
    fn planes<'b>(&self, start: usize, memory: [&'b mut Plane<T>; 3]) -> [&'b Plane<T>; 3]
    where
        'a: 'b,
    {
        let [x, y, z] = memory;
        match *self {
            Self::Vectors(vectors) => {
                let rest = vectors.get(start..).unwrap_or_default();
                take_apart(rest, x, y, z);
            }
            Self::Planes([all_x, all_y, all_z]) => {
                return [plane(all_x, start, x), plane(all_y, start, y), plane(all_z, start, z)];
            }
            Self::Same(w) => {
                [*x, *y, *z] = [[w.x(); BLOCK], [w.y(); BLOCK], [w.z(); BLOCK]];
            }
        }
        [x, y, z]
    }
}

/// Takes vectors apart into components.
#[inline(always)]
fn take_apart<T: Real>(vectors: &[T::Vec3], x: &mut Plane<T>, y: &mut Plane<T>, z: &mut Plane<T>) {
    if let Some(vectors) = vectors.first_chunk::<BLOCK>() {
        for (index, vector) in vectors.iter().enumerate() {
            (x[index], y[index], z[index]) = (vector.x(), vector.y(), vector.z());
        }
    } else if let Some(first) = vectors.first() {
        for index in 0..BLOCK {
            let vector = vectors.get(index).unwrap_or(first);
            (x[index], y[index], z[index]) = (vector.x(), vector.y(), vector.z());
        }
    }
}

/// The block of a slice that begins at `start`: in place if it is whole, else in memory, filled up
/// with its first element.
#[inline(always)]
fn plane<'b, T: Real>(slice: &'b [T], start: usize, memory: &'b mut Plane<T>) -> &'b Plane<T> {
    let rest = slice.get(start..).unwrap_or_default();
    if let Some(whole) = rest.first_chunk() {
        return whole;
    }
    *memory = [rest.first().copied().unwrap_or(T::zero()); BLOCK];
    for (memory, number) in memory.iter_mut().zip(rest) {
        *memory = *number;
    }
    memory
}

/// Uniform numbers in [0, 1) that a batch reads, `N` for each of its elements: two for a
/// [`Brdf`](crate::Brdf), three for a [`Bsdf`](crate::Bsdf).
#[derive(Clone, Copy, Debug)]
pub enum Uniforms<'a, T = f32, const N: usize = 2> {
    /// The numbers of one element after those of the other.
    Points(&'a [[T; N]]),
    /// All first numbers, all second numbers, and so on.
    Planes([&'a [T]; N]),
}

/// What the uniform numbers are called in errors.
const U: [&str; 3] = ["u[0]", "u[1]", "u[2]"];

impl<'a, T: Real, const N: usize> Uniforms<'a, T, N> {
    fn check(&self, length: &Length) -> Result<(), BatchError> {
        match self {
            Self::Points(points) => length.check("u", points.len()),
            Self::Planes(planes) => {
                U.iter().zip(planes).try_for_each(|(name, plane)| length.check(name, plane.len()))
            }
        }
    }

    /// What comes before an element, and the rest.
    #[cfg(feature = "rayon")]
    fn split(self, middle: usize) -> (Self, Self) {
        match self {
            Self::Points(points) => {
                let (first, second) = points.split_at(middle);
                (Self::Points(first), Self::Points(second))
            }
            Self::Planes(planes) => {
                let halves = planes.map(|plane| plane.split_at(middle));
                (
                    Self::Planes(halves.map(|(first, _)| first)),
                    Self::Planes(halves.map(|(_, second)| second)),
                )
            }
        }
    }

    /// See [`Input::planes`].
    #[inline(always)]
    fn planes<'b>(&self, start: usize, mut memory: [&'b mut Plane<T>; N]) -> [&'b Plane<T>; N]
    where
        'a: 'b,
    {
        match *self {
            Self::Points(points) => {
                let rest = points.get(start..).unwrap_or_default();
                let first = rest.first().copied().unwrap_or([T::zero(); N]);
                for (plane, number) in memory.iter_mut().zip(first) {
                    **plane = [number; BLOCK];
                }
                for (index, point) in rest.iter().take(BLOCK).enumerate() {
                    for (plane, number) in memory.iter_mut().zip(point) {
                        plane[index] = *number;
                    }
                }
                memory.map(|plane| &*plane)
            }
            Self::Planes(planes) => {
                let mut planes = planes.into_iter();
                memory.map(|memory| plane(planes.next().unwrap_or_default(), start, memory))
            }
        }
    }
}

/// Names of an argument and its components, for errors.
const WI: [&str; 4] = ["wi", "wi.x", "wi.y", "wi.z"];
const WO: [&str; 4] = ["wo", "wo.x", "wo.y", "wo.z"];
const H: [&str; 4] = ["h", "h.x", "h.y", "h.z"];

/// Pairs of directions: what values and densities are asked for.
#[derive(Clone, Copy)]
pub(crate) struct Pairs<'a, T: Real> {
    pub(crate) wi: Directions<'a, T>,
    pub(crate) wo: Directions<'a, T>,
}

impl<T: Real> Input<T, 6> for Pairs<'_, T> {
    fn check(&self, length: &Length) -> Result<(), BatchError> {
        self.wi.check(length, WI)?;
        self.wo.check(length, WO)
    }

    #[inline(always)]
    fn planes<'b>(&'b self, start: usize, memory: &'b mut [Plane<T>; 6]) -> [&'b Plane<T>; 6] {
        let [a, b, c, d, e, f] = memory;
        let [a, b, c] = self.wi.planes(start, [a, b, c]);
        let [d, e, f] = self.wo.planes(start, [d, e, f]);
        [a, b, c, d, e, f]
    }

    #[cfg(feature = "rayon")]
    fn split(self, middle: usize) -> (Self, Self) {
        let (wi, wo) = (self.wi.split(middle), self.wo.split(middle));
        (Self { wi: wi.0, wo: wo.0 }, Self { wi: wi.1, wo: wo.1 })
    }
}

/// Viewers and `N` uniform numbers for each: what samples are drawn for.
#[derive(Clone, Copy)]
pub(crate) struct Draws<'a, T: Real, const N: usize> {
    pub(crate) wo: Directions<'a, T>,
    pub(crate) u: Uniforms<'a, T, N>,
}

macro_rules! draws {
    ($uniforms:literal, $numbers:literal: $($u:ident)*) => {
        impl<T: Real> Input<T, $numbers> for Draws<'_, T, $uniforms> {
            fn check(&self, length: &Length) -> Result<(), BatchError> {
                self.wo.check(length, WO)?;
                self.u.check(length)
            }

            #[inline(always)]
            fn planes<'b>(
                &'b self,
                start: usize,
                memory: &'b mut [Plane<T>; $numbers],
            ) -> [&'b Plane<T>; $numbers] {
                let [x, y, z, $($u),*] = memory;
                let [x, y, z] = self.wo.planes(start, [x, y, z]);
                let [$($u),*] = self.u.planes(start, [$($u),*]);
                [x, y, z, $($u),*]
            }

            #[cfg(feature = "rayon")]
            fn split(self, middle: usize) -> (Self, Self) {
                let (wo, u) = (self.wo.split(middle), self.u.split(middle));
                (Self { wo: wo.0, u: u.0 }, Self { wo: wo.1, u: u.1 })
            }
        }
    };
}
draws!(2, 5: u0 u1);
draws!(3, 6: u0 u1 u2);

/// Normals of facets.
#[derive(Clone, Copy)]
pub(crate) struct Normals<'a, T: Real>(pub(crate) Directions<'a, T>);

impl<T: Real> Input<T, 3> for Normals<'_, T> {
    fn check(&self, length: &Length) -> Result<(), BatchError> {
        self.0.check(length, H)
    }

    #[inline(always)]
    fn planes<'b>(&'b self, start: usize, memory: &'b mut [Plane<T>; 3]) -> [&'b Plane<T>; 3] {
        let [x, y, z] = memory;
        self.0.planes(start, [x, y, z])
    }

    #[cfg(feature = "rayon")]
    fn split(self, middle: usize) -> (Self, Self) {
        let (first, second) = self.0.split(middle);
        (Self(first), Self(second))
    }
}

/// Cosines of angles of incidence.
#[derive(Clone, Copy)]
pub(crate) struct Cosines<'a, T>(pub(crate) &'a [T]);

impl<T: Real> Input<T, 1> for Cosines<'_, T> {
    fn check(&self, length: &Length) -> Result<(), BatchError> {
        length.check("cos_theta", self.0.len())
    }

    #[inline(always)]
    fn planes<'b>(&'b self, start: usize, memory: &'b mut [Plane<T>; 1]) -> [&'b Plane<T>; 1] {
        let [memory] = memory;
        [plane(self.0, start, memory)]
    }

    #[cfg(feature = "rayon")]
    fn split(self, middle: usize) -> (Self, Self) {
        let (first, second) = self.0.split_at(middle);
        (Self(first), Self(second))
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

impl<'a, T, P, const N: usize> From<[&'a P; N]> for Uniforms<'a, T, N>
where
    T: Real,
    P: AsRef<[T]> + ?Sized,
{
    fn from(planes: [&'a P; N]) -> Self {
        Self::Planes(planes.map(AsRef::as_ref))
    }
}

impl<'a, T, P: AsRef<[[T; N]]> + ?Sized, const N: usize> From<&'a P> for Uniforms<'a, T, N> {
    fn from(points: &'a P) -> Self {
        Self::Points(points.as_ref())
    }
}
