//! The functions of numbers, each with its slope.

use core::f64::consts::{FRAC_2_SQRT_PI, LN_2, TAU};

use super::super::math::ierfcx;
use super::super::traits::{Mask, Real};
use super::super::vector3::Vector3;
use super::{Dual, each, zip};

/// Functions of one number: what the value is called, and the slope there. A slope that is infinite
/// is 0, behind a `select` whose other side is finite.
macro_rules! functions {
    ($($function:ident: $x:ident, $y:ident => $slope:expr;)+) => {$(
        #[inline]
        fn $function(self) -> Self {
            let $x = self.value;
            let $y = $x.$function();
            self.chain($y, $slope)
        }
    )+};
}

impl<T: Real, const N: usize> Real for Dual<T, N> {
    type Mask = T::Mask;
    type Vec3 = Vector3<Self>;

    const SPACING: f64 = T::SPACING;
    const HAS_DERIVATIVES: bool = true;

    #[inline(always)]
    #[track_caller]
    fn lit(value: f64) -> Self {
        Self::constant(T::lit(value))
    }
    #[inline(always)]
    fn max_finite() -> Self {
        Self::constant(T::max_finite())
    }
    #[inline(always)]
    fn select(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self {
            value: T::select(mask, yes.value, no.value),
            derivatives: zip(yes.derivatives, no.derivatives, |yes, no| T::select(mask, yes, no)),
        }
    }
    fn outside(self, lower: f64, upper: f64) -> Option<f64> {
        self.value.outside(lower, upper)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> T::Mask {
        self.value.lt(other.value)
    }
    #[inline(always)]
    fn le(self, other: Self) -> T::Mask {
        self.value.le(other.value)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.nearer(other, self.value.min(other.value), self.lt(other))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.nearer(other, self.value.max(other.value), self.gt(other))
    }
    #[inline(always)]
    fn at_most(self, bound: Self) -> Self {
        // What is no number has no excess by rounding: there the bound takes its place.
        let finite = self.value.le(T::max_finite());
        let kept = each(self.derivatives, |derivative| derivative.only_where(finite));
        Self { value: self.value.at_most(bound.value), derivatives: kept }
    }
    #[inline(always)]
    fn held(self) -> Self {
        Self::constant(self.value)
    }
    #[inline(always)]
    fn with_derivatives_of(self, other: Self) -> Self {
        let value = self.value.with_derivatives_of(other.value);
        Self { value, derivatives: other.derivatives }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        let (value, one) = (self.value, T::one());
        let slope = T::select(value.lt(T::zero()), -one, one.only_where(value.gt(T::zero())));
        self.chain(value.abs(), slope)
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        let one = T::one();
        let slope = one.copysign(self.value) * one.copysign(sign.value);
        self.chain(self.value.copysign(sign.value), slope)
    }
    #[inline(always)]
    fn floor(self) -> Self {
        Self::constant(self.value.floor())
    }
    #[inline]
    fn powf(self, exponent: Self) -> Self {
        let (x, n, zero, one) = (self.value, exponent.value, T::zero(), T::one());
        let y = x.powf(n);
        let positive = x.gt(zero);
        let base = T::select(positive, x, one);
        // At 0 only the first power has a slope, and only a number that has derivatives itself knows
        // that the slopes of higher ones change there.
        let at_zero = if T::HAS_DERIVATIVES { n * x.powf(n - one) } else { one };
        let first = if T::HAS_DERIVATIVES { n.ge(one) } else { n.le(one).and(n.ge(one)) };
        let at_zero = at_zero.only_where(first);
        let slope = T::select(positive, n * (y / base), at_zero);
        self.chain_two(exponent, y, [slope, y * base.ln()])
    }
    #[inline]
    fn decay(self, factor: Self) -> Self {
        let (value, by) = (self.value.decay(factor.value), factor.value);
        let some = by.gt(T::zero());
        self.chain_two(
            factor,
            value,
            [value * T::lit(-LN_2), value / T::select(some, by, T::one())],
        )
    }
    #[inline]
    fn mean_magnitude(self, square_at_zero: Self) -> Self {
        let (z, q) = (self.value, square_at_zero.value);
        let inverse = q.rsqrt();
        let nu = z * inverse * T::lit(0.5 * FRAC_2_SQRT_PI);
        let by_square = T::lit(0.5) * (-nu.squared()).exp() * inverse;
        self.chain_two(square_at_zero, z.mean_magnitude(q), [nu.erf(), by_square])
    }
    #[inline]
    fn power_of_part(self, rest: Self, exponent: Self) -> Self {
        let (x, r, n) = (self.value, rest.value, exponent.value);
        let (zero, one, whole) = (T::zero(), T::one(), x + r);
        let y = x.power_of_part(r, n);
        let near = r.lt(x);
        let (missing, kept) = (r / whole, x / whole);
        // As in the function: of the two parts the one with the digits.
        let logarithm = T::select(
            near,
            T::select(near, -missing, zero).ln_1p(),
            T::select(near, one, kept).ln(),
        );
        let by_rest = n * y / whole;
        let part = self.chain_two(rest, y, [by_rest * (r / x), -by_rest]);
        part.chain_two(exponent, y, [one, y * logarithm])
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }
    #[inline]
    fn sin_cos_turns(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos_turns();
        let turn = T::lit(TAU);
        (self.chain(sin, cos * turn), self.chain(cos, -(sin * turn)))
    }
    #[inline]
    fn atan2(self, other: Self) -> Self {
        let (y, x, zero, one) = (self.value, other.value, T::zero(), T::one());
        let largest = y.abs().max(x.abs());
        let somewhere = largest.gt(zero);
        let scale = T::select(somewhere, largest, one);
        // Scaled so that the squares neither vanish nor overflow.
        let (sin, cos) = (y / scale, x / scale);
        let squared = T::select(somewhere, sin.squared() + cos.squared(), one);
        let inverse = (one / squared / scale).only_where(somewhere);
        self.chain_two(other, y.atan2(x), [cos * inverse, -(sin * inverse)])
    }

    functions! {
        sqrt: x, y => {
            let positive = x.gt(T::zero());
            (T::lit(0.5) / T::select(positive, y, T::one())).only_where(positive)
        };
        rsqrt: x, y => {
            let positive = x.gt(T::zero());
            (T::lit(-0.5) * y / T::select(positive, x, T::one())).only_where(positive)
        };
        exp: _x, y => y;
        exp_m1: x, _y => x.exp();
        ln: x, _y => inverse(x);
        ln_1p: x, _y => inverse(T::one() + x);
        sin: x, _y => x.cos();
        cos: x, _y => -x.sin();
        tan: _x, y => T::one() + y.squared();
        asin: x, _y => inverse_height(x);
        acos: x, _y => -inverse_height(x);
        angle_squared: x, y => {
            // 2θ/sinθ, which is 2 at 0.
            let sin_squared = x * (T::lit(2.0) - x);
            let tilted = sin_squared.gt(T::zero());
            let quotient = y / T::select(tilted, sin_squared, T::one());
            T::lit(2.0) * T::select(tilted, quotient, T::one()).sqrt()
        };
        erf: x, _y => T::lit(FRAC_2_SQRT_PI) * (-x.squared()).exp();
        erfc: x, _y => T::lit(-FRAC_2_SQRT_PI) * (-x.squared()).exp();
        erfcx: x, _y => T::lit(-2.0) * ierfcx(x);
        ierfc: x, _y => -x.erfc();
        erf_inv: _x, y => T::lit(1.0 / FRAC_2_SQRT_PI) * y.squared().exp();
    }
}

impl<T: Real, const N: usize> Dual<T, N> {
    /// The smaller or larger of two, which is `self` where the mask is true. The mean of their
    /// derivatives where both are.
    #[inline(always)]
    fn nearer(self, other: Self, value: T, own: T::Mask) -> Self {
        let tie = self.le(other).and(other.le(self));
        let half = T::lit(0.5);
        let derivatives = zip(self.derivatives, other.derivatives, |a, b| {
            T::select(own, a, T::select(tie, (a + b) * half, b))
        });
        Self { value, derivatives }
    }
}

/// 1/x; 0 for x ≤ 0.
#[inline(always)]
fn inverse<T: Real>(x: T) -> T {
    let positive = x.gt(T::zero());
    (T::one() / T::select(positive, x, T::one())).only_where(positive)
}

/// 1/√(1 − x²); 0 from ±1 on.
#[inline(always)]
fn inverse_height<T: Real>(x: T) -> T {
    let one = T::one();
    let squared = (one - x) * (one + x);
    let inside = squared.gt(T::zero());
    (one / T::select(inside, squared, one).sqrt()).only_where(inside)
}
