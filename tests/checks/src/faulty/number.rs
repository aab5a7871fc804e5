//! The number itself.

use std::ops::{Add, Div, Mul, Neg, Sub};

use brdf::{Mask, Real};

use super::place::{Operation, at};
use super::vector::FaultyVector;

/// An `f64` whose operations look whether they are to err: each through a call, or the code of all
/// models over such numbers would be half of what is compiled here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Faulty(pub f64);

impl From<Faulty> for f64 {
    fn from(number: Faulty) -> Self {
        number.0
    }
}

/// The answer of a comparison of such numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FaultyMask(bool);

#[inline(always)]
#[track_caller]
fn mask(operation: Operation, left: f64, right: f64, truth: bool) -> FaultyMask {
    FaultyMask(at(operation, left, right, f64::from(u8::from(truth))) != 0.0)
}

impl FaultyMask {
    #[inline(always)]
    fn number(self) -> f64 {
        f64::from(u8::from(self.0))
    }
}

impl Mask for FaultyMask {
    #[inline(never)]
    #[track_caller]
    fn and(self, other: Self) -> Self {
        mask(Operation::And, self.number(), other.number(), self.0 && other.0)
    }
    #[inline(never)]
    #[track_caller]
    fn or(self, other: Self) -> Self {
        mask(Operation::Or, self.number(), other.number(), self.0 || other.0)
    }
    #[inline(never)]
    #[track_caller]
    fn not(self) -> Self {
        mask(Operation::Not, self.number(), 0.0, !self.0)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident)*) => {$(
        impl $operator for Faulty {
            type Output = Self;
            #[inline(never)]
            #[track_caller]
            fn $method(self, other: Self) -> Self {
                Self(at(Operation::$operator, self.0, other.0, self.0.$method(other.0)))
            }
        }
    )*};
}
operators!(Add add Sub sub Mul mul Div div);

impl Neg for Faulty {
    type Output = Self;
    #[inline(never)]
    #[track_caller]
    fn neg(self) -> Self {
        Self(at(Operation::Neg, self.0, 0.0, -self.0))
    }
}

macro_rules! functions {
    ($($function:ident $operation:ident)*) => {$(
        #[inline(never)]
        #[track_caller]
        fn $function(self) -> Self {
            Self(at(Operation::$operation, self.0, 0.0, Real::$function(self.0)))
        }
    )*};
}
macro_rules! functions_of_two {
    ($($function:ident $operation:ident)*) => {$(
        #[inline(never)]
        #[track_caller]
        fn $function(self, other: Self) -> Self {
            let result = Real::$function(self.0, other.0);
            Self(at(Operation::$operation, self.0, other.0, result))
        }
    )*};
}
macro_rules! comparisons {
    ($($function:ident $operation:ident)*) => {$(
        #[inline(never)]
        #[track_caller]
        fn $function(self, other: Self) -> FaultyMask {
            mask(Operation::$operation, self.0, other.0, Real::$function(self.0, other.0))
        }
    )*};
}

impl Real for Faulty {
    type Mask = FaultyMask;
    type Vec3 = FaultyVector;

    #[inline(never)]
    #[track_caller]
    fn lit(value: f64) -> Self {
        Self(at(Operation::Literal, value, 0.0, value))
    }
    #[inline(never)]
    #[track_caller]
    fn max_finite() -> Self {
        Self(at(Operation::Literal, f64::MAX, 0.0, f64::MAX))
    }
    #[inline(never)]
    #[track_caller]
    fn select(mask: FaultyMask, yes: Self, no: Self) -> Self {
        Self(at(Operation::Select, yes.0, no.0, if mask.0 { yes.0 } else { no.0 }))
    }
    fn outside(self, lower: f64, upper: f64) -> Option<f64> {
        Real::outside(self.0, lower, upper)
    }
    #[inline(never)]
    #[track_caller]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = Real::sin_cos(at(Operation::SinCos, self.0, 0.0, self.0));
        (Self(sin), Self(cos))
    }
    #[inline(never)]
    #[track_caller]
    fn sin_cos_turns(self) -> (Self, Self) {
        let turns = at(Operation::SinCosTurns, self.0, 0.0, self.0);
        let (sin, cos) = Real::sin_cos_turns(turns);
        (Self(sin), Self(cos))
    }
    #[inline(never)]
    #[track_caller]
    fn powi(self, exponent: u32) -> Self {
        let result = Real::powi(self.0, exponent);
        Self(at(Operation::Powi, self.0, f64::from(exponent), result))
    }
    /// Of the arguments the part and the exponent are shown to a fault.
    #[inline(never)]
    #[track_caller]
    fn power_of_part(self, rest: Self, exponent: Self) -> Self {
        let result = Real::power_of_part(self.0, rest.0, exponent.0);
        Self(at(Operation::PowerOfPart, self.0, exponent.0, result))
    }
    /// Of the bounds only the upper one is shown to a fault.
    #[inline(never)]
    #[track_caller]
    fn clamp(self, lower: Self, upper: Self) -> Self {
        let result = Real::clamp(self.0, lower.0, upper.0);
        Self(at(Operation::Clamp, self.0, upper.0, result))
    }
    comparisons!(lt Less le LessOrEqual gt Greater ge GreaterOrEqual);
    functions!(abs Abs floor Floor sqrt Sqrt rsqrt Rsqrt squared Squared);
    functions!(exp Exp exp_m1 ExpM1 ln Ln ln_1p Ln1p);
    functions!(sin Sin cos Cos tan Tan asin Asin acos Acos angle_squared AngleSquared);
    functions!(erf Erf erfc Erfc erf_inv ErfInv);
    functions_of_two!(min Min max Max copysign Copysign powf Powf atan2 Atan2);
}
