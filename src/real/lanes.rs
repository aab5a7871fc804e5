//! Several numbers at once, element by element: what the compiler turns into SIMD registers.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::traits::{Mask, Real};
use super::vector3::Vector3;

/// `N` numbers that go through a formula side by side.
///
/// Each lane has the bits that the scalar formula would give it. `N = 16` is a good choice for
/// `f32` on every instruction set that was measured.
///
/// ```
/// use brdf::{Lanes, Real};
///
/// let x = Lanes([0.0_f32, 1.0, 2.0, 3.0]);
/// assert_eq!((x * x + Lanes::lit(1.0)).0, [1.0, 2.0, 5.0, 10.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes<T, const N: usize>(pub [T; N]);

impl<T: Copy, const N: usize> Lanes<T, N> {
    // Plain loops: `core::array::from_fn` is a call that is not always inlined, and then runs lane
    // by lane.
    #[inline(always)]
    fn map(self, formula: impl Fn(T) -> T) -> Self {
        let mut out = self.0;
        for value in &mut out {
            *value = formula(*value);
        }
        Self(out)
    }
    #[inline(always)]
    fn zip(self, other: Self, formula: impl Fn(T, T) -> T) -> Self {
        let mut out = self.0;
        for (value, other) in out.iter_mut().zip(other.0) {
            *value = formula(*value, other);
        }
        Self(out)
    }
    #[inline(always)]
    fn compare(self, other: Self, formula: impl Fn(T, T) -> bool) -> Lanes<bool, N> {
        let mut out = [false; N];
        for ((truth, a), b) in out.iter_mut().zip(self.0).zip(other.0) {
            *truth = formula(a, b);
        }
        Lanes(out)
    }
}

impl<const N: usize> Mask for Lanes<bool, N> {
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self.zip(other, |a, b| a & b)
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self.zip(other, |a, b| a | b)
    }
    #[inline(always)]
    fn not(self) -> Self {
        self.map(|a| !a)
    }
}

macro_rules! elementwise {
    ($($operator:ident $method:ident)*) => {$(
        impl<T: Real<Mask = bool>, const N: usize> $operator for Lanes<T, N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, $operator::$method)
            }
        }
    )*};
}
elementwise!(Add add Sub sub Mul mul Div div);

impl<T: Real<Mask = bool>, const N: usize> Neg for Lanes<T, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(Neg::neg)
    }
}

macro_rules! lane_functions {
    ($($function:ident)*) => {$(
        #[inline(always)]
        fn $function(self) -> Self {
            self.map(T::$function)
        }
    )*};
}

macro_rules! lane_functions_of_two {
    ($($function:ident)*) => {$(
        #[inline(always)]
        fn $function(self, other: Self) -> Self {
            self.zip(other, T::$function)
        }
    )*};
}

impl<T: Real<Mask = bool>, const N: usize> Real for Lanes<T, N> {
    type Mask = Lanes<bool, N>;
    type Vec3 = Vector3<Self>;

    const SPACING: f64 = T::SPACING;
    const HAS_DERIVATIVES: bool = T::HAS_DERIVATIVES;

    #[inline(always)]
    fn lit(value: f64) -> Self {
        Self([T::lit(value); N])
    }
    #[inline(always)]
    fn max_finite() -> Self {
        Self([T::max_finite(); N])
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        let mut out = no.0;
        for (lane, value) in out.iter_mut().enumerate() {
            *value = T::select(mask.0[lane], yes.0[lane], *value);
        }
        Self(out)
    }
    fn outside(self, lower: f64, upper: f64) -> Option<f64> {
        self.0.into_iter().find_map(|value| value.outside(lower, upper))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        self.compare(other, T::lt)
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        self.compare(other, T::le)
    }
    #[inline(always)]
    fn power_of_part(self, rest: Self, exponent: Self) -> Self {
        let mut out = self.0;
        for (lane, value) in out.iter_mut().enumerate() {
            *value = value.power_of_part(rest.0[lane], exponent.0[lane]);
        }
        Self(out)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        (self.map(T::sin), self.map(T::cos))
    }
    #[inline(always)]
    fn sin_cos_turns(self) -> (Self, Self) {
        (self.map(|turns| turns.sin_cos_turns().0), self.map(|turns| turns.sin_cos_turns().1))
    }

    lane_functions!(abs held floor sqrt rsqrt exp exp_m1 ln ln_1p sin cos tan asin acos);
    lane_functions!(angle_squared erf erfc erfcx ierfc erf_inv);
    lane_functions_of_two!(min max at_most with_derivatives_of copysign powf atan2 decay mean_magnitude);
}
