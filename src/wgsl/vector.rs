//! The symbol of a vector.

use core::fmt::Debug;
use core::ops::{Add, Mul, Neg, Sub};

use super::expr::{Expr, ExprMask};
use super::simplify as to;
use super::value::Value;
use crate::real::{Color, Real, Vector};

/// A direction or a colour of a shader, a `vec3<f32>`.
///
/// A colour with equal channels may be a number, which counts for all three of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExprVec3(pub(super) Value);

impl From<glam::Vec3> for ExprVec3 {
    fn from(vector: glam::Vec3) -> Self {
        vector.as_dvec3().into()
    }
}

impl From<glam::DVec3> for ExprVec3 {
    fn from(vector: glam::DVec3) -> Self {
        Self(Value::numbers(vector.to_array()))
    }
}

macro_rules! operators {
    ($($operator:ident<$other:ty> $method:ident)*) => {$(
        impl $operator<$other> for ExprVec3 {
            type Output = Self;
            fn $method(self, other: $other) -> Self {
                Self(to::$method(self.0, other.0))
            }
        }
    )*};
}
operators!(Add<Self> add Sub<Self> sub Mul<Self> mul Mul<Expr> mul);

impl Neg for ExprVec3 {
    type Output = Self;
    fn neg(self) -> Self {
        Self(to::neg(self.0))
    }
}

impl Vector<Expr> for ExprVec3 {
    fn new(x: Expr, y: Expr, z: Expr) -> Self {
        Self(to::compose([x.0, y.0, z.0]))
    }
    fn x(self) -> Expr {
        Expr(to::component(self.0, 0))
    }
    fn y(self) -> Expr {
        Expr(to::component(self.0, 1))
    }
    fn z(self) -> Expr {
        Expr(to::component(self.0, 2))
    }
    fn dot(self, other: Self) -> Expr {
        Expr(to::dot(self.0, other.0))
    }
    fn cross(self, other: Self) -> Self {
        Self(to::cross(self.0, other.0))
    }
    fn select(mask: ExprMask, yes: Self, no: Self) -> Self {
        Self(to::select(mask.0, yes.0, no.0))
    }
}

impl Color<Expr> for ExprVec3 {
    type Over<U: Real> = U::Vec3;
    type Channels<E: Debug + Send> = [E; 3];

    fn by_channel<E: Debug + Send>(make: impl FnMut(usize) -> E) -> [E; 3] {
        core::array::from_fn(make)
    }
    fn channels(self) -> [Expr; 3] {
        [self.x(), self.y(), self.z()]
    }
    fn from_channels([x, y, z]: [Expr; 3]) -> Self {
        Vector::new(x, y, z)
    }
    fn splat(value: Expr) -> Self {
        Self(value.0)
    }
    fn map(self, formula: impl Fn(Expr) -> Expr) -> Self {
        Self(formula(Expr(self.0)).0)
    }
    fn zip(self, other: Self, formula: impl Fn(Expr, Expr) -> Expr) -> Self {
        Self(formula(Expr(self.0), Expr(other.0)).0)
    }
    fn lift<U: Real>(self, lift: impl Fn(Expr) -> U) -> U::Vec3 {
        <U::Vec3 as Vector<U>>::new(lift(self.x()), lift(self.y()), lift(self.z()))
    }
    fn fold<A>(self, start: A, step: impl Fn(A, Expr) -> A) -> A {
        step(step(step(start, self.x()), self.y()), self.z())
    }
}
