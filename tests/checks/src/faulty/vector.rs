//! Three such numbers: an operation of vectors is the same operation in each component.

use std::fmt::Debug;
use std::ops::{Add, Mul, Neg, Sub};

use brdf::{Color, Real, Vector};

use super::number::{Faulty, FaultyMask};
use super::place::{Operation, at};

/// A vector or colour of numbers that err.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaultyVector([Faulty; 3]);

impl FaultyVector {
    #[inline(always)]
    fn numbers(self) -> [f64; 3] {
        self.0.map(|component| component.0)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident)*) => {$(
        impl $operator for FaultyVector {
            type Output = Self;
            #[inline(never)]
            #[track_caller]
            fn $method(self, other: Self) -> Self {
                let ([a, b, c], [x, y, z]) = (self.0, other.0);
                Self([a.$method(x), b.$method(y), c.$method(z)])
            }
        }
    )*};
}
operators!(Add add Sub sub Mul mul);

impl Mul<Faulty> for FaultyVector {
    type Output = Self;
    #[inline(never)]
    #[track_caller]
    fn mul(self, scale: Faulty) -> Self {
        let [a, b, c] = self.0;
        Self([a * scale, b * scale, c * scale])
    }
}

impl Neg for FaultyVector {
    type Output = Self;
    #[inline(never)]
    #[track_caller]
    fn neg(self) -> Self {
        let [a, b, c] = self.0;
        Self([-a, -b, -c])
    }
}

impl Vector<Faulty> for FaultyVector {
    #[inline(always)]
    fn new(x: Faulty, y: Faulty, z: Faulty) -> Self {
        Self([x, y, z])
    }
    #[inline(never)]
    #[track_caller]
    fn x(self) -> Faulty {
        let [x, y, z] = self.numbers();
        Faulty(at(Operation::X, y, z, x))
    }
    #[inline(never)]
    #[track_caller]
    fn y(self) -> Faulty {
        let [x, y, z] = self.numbers();
        Faulty(at(Operation::Y, x, z, y))
    }
    #[inline(never)]
    #[track_caller]
    fn z(self) -> Faulty {
        let [x, y, z] = self.numbers();
        Faulty(at(Operation::Z, x, y, z))
    }
    #[inline(never)]
    #[track_caller]
    fn dot(self, other: Self) -> Faulty {
        let ([a, b, c], [x, y, z]) = (self.numbers(), other.numbers());
        Faulty(at(Operation::Dot, c, z, a * x + b * y + c * z))
    }
    #[inline(never)]
    #[track_caller]
    fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.numbers(), other.numbers());
        Self([
            Faulty(at(Operation::Cross, b * z, c * y, b * z - c * y)),
            Faulty(at(Operation::Cross, c * x, a * z, c * x - a * z)),
            Faulty(at(Operation::Cross, a * y, b * x, a * y - b * x)),
        ])
    }
    #[inline(never)]
    #[track_caller]
    fn length_squared(self) -> Faulty {
        let [x, y, z] = self.numbers();
        Faulty(at(Operation::LengthSquared, x, z, x * x + y * y + z * z))
    }
    /// The components that are not normalised are the operands.
    #[inline(never)]
    #[track_caller]
    fn normalize_or_normal(self) -> Self {
        let raw = self.numbers();
        let unit = Vector::normalize_or_normal(glam::DVec3::from_array(raw)).to_array();
        Self([
            Faulty(at(Operation::Normalize, raw[0], 0.0, unit[0])),
            Faulty(at(Operation::Normalize, raw[1], 0.0, unit[1])),
            Faulty(at(Operation::Normalize, raw[2], 0.0, unit[2])),
        ])
    }
    #[inline(never)]
    #[track_caller]
    fn select(mask: FaultyMask, yes: Self, no: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (yes.0, no.0);
        Self([Real::select(mask, a, x), Real::select(mask, b, y), Real::select(mask, c, z)])
    }
}

impl Color<Faulty> for FaultyVector {
    type Over<U: Real> = U::Vec3;
    type Channels<E: Debug + Send> = [E; 3];

    #[inline(always)]
    fn by_channel<E: Debug + Send>(make: impl FnMut(usize) -> E) -> [E; 3] {
        std::array::from_fn(make)
    }
    #[inline(always)]
    fn channels(self) -> [Faulty; 3] {
        self.0
    }
    #[inline(always)]
    fn from_channels(channels: [Faulty; 3]) -> Self {
        Self(channels)
    }

    #[inline(always)]
    fn splat(value: Faulty) -> Self {
        Self([value; 3])
    }
    #[inline(always)]
    fn map(self, formula: impl Fn(Faulty) -> Faulty) -> Self {
        Self(self.0.map(formula))
    }
    #[inline(always)]
    fn zip(self, other: Self, formula: impl Fn(Faulty, Faulty) -> Faulty) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([formula(a, x), formula(b, y), formula(c, z)])
    }
    #[inline(always)]
    fn lift<U: Real>(self, lift: impl Fn(Faulty) -> U) -> U::Vec3 {
        let [x, y, z] = self.0;
        <U::Vec3 as Vector<U>>::new(lift(x), lift(y), lift(z))
    }
    #[inline(always)]
    fn fold<A>(self, start: A, step: impl Fn(A, Faulty) -> A) -> A {
        self.0.into_iter().fold(start, step)
    }
    #[inline(never)]
    #[track_caller]
    fn choose(mask: FaultyMask, yes: Self, no: Self) -> Self {
        Vector::select(mask, yes, no)
    }
}
