//! Three numbers as a vector or a colour: glam's types, and a plain struct for all other numbers.

use core::fmt::Debug;
use core::ops::{Add, Mul, Neg, Sub};

use super::traits::{Color, Real, Vector};

/// A vector or RGB colour of any [`Real`] number: what `glam::Vec3` is for `f32`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector3<T> {
    /// First component, or red.
    pub x: T,
    /// Second component, or green.
    pub y: T,
    /// Third component, or blue.
    pub z: T,
}

impl<T: Real> Add for Vector3<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<T: Real> Sub for Vector3<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

impl<T: Real> Neg for Vector3<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z }
    }
}

impl<T: Real> Mul for Vector3<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self { x: self.x * other.x, y: self.y * other.y, z: self.z * other.z }
    }
}

impl<T: Real> Mul<T> for Vector3<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, scale: T) -> Self {
        Self { x: self.x * scale, y: self.y * scale, z: self.z * scale }
    }
}

/// Both contracts, for a type with fields `x`, `y`, `z`.
macro_rules! vector_and_color {
    ([$($generics:tt)*] $vector:ty, $number:ty) => {
        impl<$($generics)*> Vector<$number> for $vector {
            #[inline(always)]
            fn new(x: $number, y: $number, z: $number) -> Self {
                Self { x, y, z }
            }
            #[inline(always)]
            fn x(self) -> $number {
                self.x
            }
            #[inline(always)]
            fn y(self) -> $number {
                self.y
            }
            #[inline(always)]
            fn z(self) -> $number {
                self.z
            }
        }

        impl<$($generics)*> Color<$number> for $vector {
            type Over<U: Real> = U::Vec3;
            type Channels<E: Debug + Send> = [E; 3];

            #[inline(always)]
            fn by_channel<E: Debug + Send>(make: impl FnMut(usize) -> E) -> [E; 3] { core::array::from_fn(make) }
            #[inline(always)]
            fn channels(self) -> [$number; 3] {
                [self.x, self.y, self.z]
            }
            #[inline(always)]
            fn from_channels([x, y, z]: [$number; 3]) -> Self {
                Self { x, y, z }
            }
            #[inline(always)]
            #[allow(clippy::needless_range_loop, reason = "an iterator would be another function")]
            fn fill<const N: usize, const M: usize>(
                channels: &mut [[$number; N]; 3],
                numbers: &mut [[$number; N]; M],
                formula: impl Fn(usize) -> (Self, [$number; M]),
            ) {
                for index in 0..N {
                    let (color, beside) = formula(index);
                    channels[0][index] = color.x;
                    channels[1][index] = color.y;
                    channels[2][index] = color.z;
                    for number in 0..M {
                        numbers[number][index] = beside[number];
                    }
                }
            }
            #[inline(always)]
            fn at<const N: usize>(channels: &[[$number; N]; 3], index: usize) -> Self {
                Self { x: channels[0][index], y: channels[1][index], z: channels[2][index] }
            }
            #[inline(always)]
            fn splat(value: $number) -> Self {
                Self { x: value, y: value, z: value }
            }
            #[inline(always)]
            fn map(self, formula: impl Fn($number) -> $number) -> Self {
                Self { x: formula(self.x), y: formula(self.y), z: formula(self.z) }
            }
            #[inline(always)]
            fn zip(self, other: Self, formula: impl Fn($number, $number) -> $number) -> Self {
                Self {
                    x: formula(self.x, other.x),
                    y: formula(self.y, other.y),
                    z: formula(self.z, other.z),
                }
            }
            #[inline(always)]
            fn lift<U: Real>(self, lift: impl Fn($number) -> U) -> U::Vec3 {
                <U::Vec3 as Vector<U>>::new(lift(self.x), lift(self.y), lift(self.z))
            }
            #[inline(always)]
            fn fold<A>(self, start: A, step: impl Fn(A, $number) -> A) -> A {
                step(step(step(start, self.x), self.y), self.z)
            }
        }
    };
}

vector_and_color!([] glam::Vec3, f32);
vector_and_color!([] glam::DVec3, f64);
vector_and_color!([T: Real] Vector3<T>, T);
