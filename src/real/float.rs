//! `f32` and `f64` as numbers.

use super::traits::{Mask, Real};

impl Mask for bool {
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self & other
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self | other
    }
    #[inline(always)]
    fn not(self) -> Self {
        !self
    }
}

macro_rules! float {
    ($float:ident, $vector:ty, $sqrt:path) => {
        impl Real for $float {
            type Mask = bool;
            type Vec3 = $vector;

            #[inline(always)]
            #[allow(clippy::cast_possible_truncation, reason = "rounding a literal is the purpose")]
            fn lit(value: f64) -> Self {
                value as Self
            }
            #[inline(always)]
            fn max_finite() -> Self {
                Self::MAX
            }
            #[inline(always)]
            fn select(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
            #[inline]
            fn outside(self, lower: f64, upper: f64) -> Option<f64> {
                let value = f64::from(self);
                (!(lower..=upper).contains(&value)).then_some(value)
            }
            #[inline(always)]
            fn lt(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn le(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn abs(self) -> Self {
                Self::abs(self)
            }
            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                Self::copysign(self, sign)
            }
            #[inline(always)]
            fn floor(self) -> Self {
                Self::floor(self)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }
            #[inline(always)]
            fn exp(self) -> Self {
                Self::exp(self)
            }
            #[inline(always)]
            fn exp_m1(self) -> Self {
                Self::exp_m1(self)
            }
            #[inline(always)]
            fn ln(self) -> Self {
                Self::ln(self)
            }
            #[inline(always)]
            fn ln_1p(self) -> Self {
                Self::ln_1p(self)
            }
            #[inline(always)]
            fn powf(self, exponent: Self) -> Self {
                Self::powf(self, exponent)
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                Self::sin_cos(self)
            }
            #[inline(always)]
            fn tan(self) -> Self {
                Self::tan(self)
            }
            #[inline(always)]
            fn asin(self) -> Self {
                Self::asin(self.clamp(-1.0, 1.0))
            }
            #[inline(always)]
            fn acos(self) -> Self {
                Self::acos(self.clamp(-1.0, 1.0))
            }
            #[inline(always)]
            fn atan2(self, other: Self) -> Self {
                Self::atan2(self, other)
            }
            #[inline(always)]
            fn erf(self) -> Self {
                self
            }
            #[inline(always)]
            fn erfc(self) -> Self {
                self
            }
            #[inline(always)]
            fn erf_inv(self) -> Self {
                self
            }
        }
    };
}

float!(f32, glam::Vec3, f32::sqrt);
float!(f64, glam::DVec3, f64::sqrt);
