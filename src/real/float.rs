//! `f32` and `f64` as numbers.

use super::math;
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
    #[inline(always)]
    fn is_never(self) -> bool {
        !self
    }
}

macro_rules! functions {
    ($precision:ident: $($function:ident)*) => {$(
        #[inline(always)]
        fn $function(self) -> Self {
            math::$precision::$function(self)
        }
    )*};
}

macro_rules! functions_of_two {
    ($precision:ident: $($function:ident)*) => {$(
        #[inline(always)]
        fn $function(self, other: Self) -> Self {
            math::$precision::$function(self, other)
        }
    )*};
}

macro_rules! float {
    ($float:ident, $vector:ty, $precision:ident, [$($own:ident)*], [$($own_of_two:ident)*]) => {
        impl Real for $float {
            type Mask = bool;
            type Vec3 = $vector;

            const VECTORIZES: bool = true;
            const SPACING: f64 = Self::EPSILON as f64;

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
            #[inline(always)]
            fn outside(self, lower: f64, upper: f64) -> Option<f64> {
                // In this precision, so that the number nearest to an end is inside.
                let range = Self::lit(lower)..=Self::lit(upper);
                (!range.contains(&self)).then_some(f64::from(self))
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
            fn sin_cos(self) -> (Self, Self) {
                math::$precision::sin_cos(self)
            }
            #[inline(always)]
            fn sin_cos_turns(self) -> (Self, Self) {
                math::$precision::sin_cos_turns(self)
            }

            #[inline(always)]
            fn power_of_part(self, rest: Self, exponent: Self) -> Self {
                math::$precision::power_of_part(self, rest, exponent)
            }

            functions!($precision: floor sqrt rsqrt exp exp_m1 ln ln_1p tan asin acos);
            functions!($precision: angle_squared erf erfc erf_inv);
            // What only this precision has a formula of its own for.
            functions!($precision: $($own)*);
            functions_of_two!($precision: $($own_of_two)*);
            functions_of_two!($precision: powf atan2);
        }
    };
}

float!(f32, glam::Vec3, single, [erfcx ierfc], [decay mean_magnitude]);
float!(f64, glam::DVec3, double, [], [decay]);
