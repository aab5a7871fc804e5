//! The symbol as a number, as a vector, and the answers of its comparisons.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::prelude::Function;
use super::simplify as to;
use super::value::Value;
use crate::real::{Color, Mask, Real, Vector};

/// A number of a shader: a constant, or what a formula makes of the arguments of a function.
///
/// Running a formula on it records what the formula does. The same operation on the same operands is
/// recorded once. Of constants it is computed at once, in `f64`, so that a model of constants costs a
/// shader only what depends on directions. One that is not finite makes the function an
/// [error](super::ShaderError); one that is too large for `f32` counts as the largest number.
///
/// What is not a constant belongs to the function that is being written, on its thread. A symbol
/// that is used elsewhere makes that function an [error](super::ShaderError).
///
/// A colour's channels are one symbol: its formula is recorded once and written over `vec3<f32>`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expr(pub(super) Value);

/// A truth value of a shader: what comparisons of [`Expr`] answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExprMask(pub(super) Value);

impl From<f32> for Expr {
    fn from(value: f32) -> Self {
        Self(Value::Number(value.into()))
    }
}

impl From<f64> for Expr {
    fn from(value: f64) -> Self {
        Self(Value::Number(value))
    }
}

impl Mask for ExprMask {
    fn and(self, other: Self) -> Self {
        Self(to::and(self.0, other.0))
    }
    fn or(self, other: Self) -> Self {
        Self(to::or(self.0, other.0))
    }
    fn not(self) -> Self {
        Self(to::not(self.0))
    }
    fn is_never(self) -> bool {
        self.0 == Value::Truth(false)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident)*) => {$(
        impl $operator for Expr {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(to::$method(self.0, other.0))
            }
        }
    )*};
}
operators!(Add add Sub sub Mul mul Div div);

impl Neg for Expr {
    type Output = Self;
    fn neg(self) -> Self {
        Self(to::neg(self.0))
    }
}

macro_rules! functions {
    ($($method:ident $function:ident)*) => {$(
        fn $method(self) -> Self {
            Self(to::call(Function::$function, [self.0], |[x]| Real::$method(x)))
        }
    )*};
}
macro_rules! functions_of_two {
    ($($method:ident $function:ident)*) => {$(
        fn $method(self, other: Self) -> Self {
            let known = |[x, y]: [f64; 2]| Real::$method(x, y);
            Self(to::call(Function::$function, [self.0, other.0], known))
        }
    )*};
}

impl Real for Expr {
    type Mask = ExprMask;
    type Vec3 = ExprVec3;

    /// Shaders compute in `f32`.
    const SPACING: f64 = f32::EPSILON as f64;

    fn lit(value: f64) -> Self {
        value.into()
    }
    fn max_finite() -> Self {
        f32::MAX.into()
    }
    fn select(mask: ExprMask, yes: Self, no: Self) -> Self {
        Self(to::select(mask.0, yes.0, no.0))
    }
    /// Constants are checked in `f32`, as by `f32` itself.
    fn outside(self, lower: f64, upper: f64) -> Option<f64> {
        let numbers = self.0.known_numbers()?;
        #[allow(clippy::cast_possible_truncation, reason = "single precision is that of shaders")]
        let outside = |number: &&f64| Real::outside(**number as f32, lower, upper).is_some();
        numbers.iter().find(outside).copied()
    }
    fn lt(self, other: Self) -> ExprMask {
        ExprMask(to::less(self.0, other.0))
    }
    fn le(self, other: Self) -> ExprMask {
        ExprMask(to::less_equal(self.0, other.0))
    }
    fn min(self, other: Self) -> Self {
        Self(to::min(self.0, other.0))
    }
    fn max(self, other: Self) -> Self {
        Self(to::max(self.0, other.0))
    }
    fn clamp(self, lower: Self, upper: Self) -> Self {
        Self(to::clamp(self.0, lower.0, upper.0))
    }
    fn abs(self) -> Self {
        Self(to::abs(self.0))
    }
    fn floor(self) -> Self {
        Self(to::floor(self.0))
    }
    fn sqrt(self) -> Self {
        Self(to::sqrt(self.0))
    }
    fn sin_cos(self) -> (Self, Self) {
        let known = |x: f64| Real::sin_cos(x);
        let [sin, cos] = to::call_of_two(Function::SinCos, self.0, known);
        (Self(sin), Self(cos))
    }
    fn sin_cos_turns(self) -> (Self, Self) {
        let known = |x: f64| Real::sin_cos_turns(x);
        let [sin, cos] = to::call_of_two(Function::SinCosTurns, self.0, known);
        (Self(sin), Self(cos))
    }
    fn power_of_part(self, rest: Self, exponent: Self) -> Self {
        if exponent.0.is(0.0) {
            return Self::one();
        }
        let known = |[part, rest, exponent]: [f64; 3]| Real::power_of_part(part, rest, exponent);
        Self(to::call(Function::PowerOfPart, [self.0, rest.0, exponent.0], known))
    }
    fn powf(self, exponent: Self) -> Self {
        if exponent.0.is(0.0) {
            return Self::one();
        }
        let known = |[x, exponent]: [f64; 2]| Real::powf(x, exponent);
        Self(to::call(Function::Powf, [self.0, exponent.0], known))
    }
    functions!(rsqrt Rsqrt exp Exp exp_m1 ExpM1 ln Ln ln_1p Ln1p tan Tan asin Asin acos Acos);
    functions!(angle_squared AngleSquared erf Erf erfc Erfc erfcx Erfcx ierfc Ierfc erf_inv ErfInv);
    functions_of_two!(copysign Copysign atan2 Atan2 decay Decay);
}

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
