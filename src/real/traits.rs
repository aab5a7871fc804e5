//! The contracts: what a number, a mask, a vector and a colour can do.
//!
//! They stand in one file because they refer to each other: a number names the vector made of it.

use core::f64::consts::{LN_2, TAU};
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::math;

/// The answer of a comparison: one truth value, or one per lane, or a symbol.
///
/// A mask is never turned into a `bool` by a formula; it chooses, through [`Real::select`].
pub trait Mask: Copy + Debug {
    /// True where both are true.
    #[must_use]
    fn and(self, other: Self) -> Self;
    /// True where at least one is true.
    #[must_use]
    fn or(self, other: Self) -> Self;
    /// True where this is false.
    #[must_use]
    fn not(self) -> Self;
    /// Whether this is known to be false everywhere, so that what it would choose need not be
    /// computed. For speed alone: an answer must not depend on it.
    #[must_use]
    fn is_never(self) -> bool {
        false
    }
}

/// The number that every formula of this crate is written over.
///
/// Implemented by `f32`, `f64`, [`Lanes`](crate::Lanes) and [`Dual`](crate::Dual), numbers with
/// derivatives; open to traced expressions. Formulas choose with [`select`](Self::select) and never
/// branch on a value, so the side that is not taken must be harmless too.
///
/// The elementary functions of `f32`, `f64` and their lanes are this crate's own: built of
/// additions, multiplications, divisions and square roots without fused multiply-add, they give
/// the same bits for a scalar and in lanes, on every instruction set and in every build.
/// Their largest error, in units in the last place of the exact result:
///
/// | function | `f32` | `f64` | remarks |
/// |---|---|---|---|
/// | `exp` | 1.0 | 1.0 | |
/// | `exp_m1` | 1.3 | 1.25 | |
/// | `decay` | | | to 1.7·10⁻⁷ in `f32`, 3.4·10⁻¹⁶ in `f64` |
/// | `ln` | 0.85 | 0.8 | −∞ at 0, NaN below |
/// | `ln_1p` | 1.4 | 1.4 | −∞ at −1, NaN below |
/// | `powf` | 0.55 | 1.4 | NaN for a negative base |
/// | `sin`, `cos` | 1.1 | 1.0 | for \|x\| ≤ 10⁴; beyond, in [−1, 1] but less and less precise |
/// | `sin_cos_turns` | 2.2 | 1.7 | for \|x\| ≤ 10⁶; beyond, in [−1, 1] |
/// | `tan` | 0.55 | 1.3 | for \|x\| ≤ 10⁴ |
/// | `asin` | 0.55 | 1.0 | |
/// | `acos` | 1.2 | 1.25 | |
/// | `angle_squared` | 1.0 | 1.0 | for 0 ≤ x ≤ 1 |
/// | `atan2` | 1.6 | 1.4 | |
/// | `erf` | 0.55 | 1.25 | |
/// | `erfc` | 0.6 | 1.5 | in the tail too, down to underflow |
/// | `erfcx` | | | to 3.5·10⁻⁷ in `f32`, 10⁻¹⁵ in `f64` |
/// | `ierfc` | | | x + ierfc x to 3.2·10⁻⁷ in `f32`, 10⁻¹⁵ in `f64`, where ierfc x itself is good to 10⁻¹⁵ + 1.2·10⁻¹⁶ x² |
/// | `mean_magnitude` | | | to 3.8·10⁻⁷ in `f32`, 10⁻¹⁵ in `f64` |
/// | `erf_inv` | 3.5 | 2.0 | beyond ±1 the value at the largest number below 1 |
/// | `sqrt`, `floor` | exact | exact | correctly rounded |
/// | `rsqrt` | 1.5 | 1.5 | for normal x > 0 |
///
/// On a plain `f32` or `f64`, `x.exp()` means the method of the standard library, whose bits
/// depend on the platform; `Real::exp(x)` means this one. Inside a function over `T: Real` there is
/// only this one.
///
/// ```
/// use brdf::Real;
///
/// assert_eq!(Real::erfc(5.0_f64), 1.537459794428035e-12);
/// assert_eq!(Real::powf(0.9_f32, 50.0), 0.005153768);
/// ```
pub trait Real:
    Copy
    + Debug
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// What comparisons answer.
    type Mask: Mask;
    /// Three of these numbers, as a direction or as an RGB colour: `glam::Vec3` for `f32`,
    /// `glam::DVec3` for `f64`, [`Vector3`](crate::Vector3) otherwise.
    type Vec3: Vector<Self> + Color<Self>;

    /// Whether loops over these numbers become SIMD code, so that [batches](crate::batch) of them are
    /// worth compiling for several instruction sets.
    const VECTORIZES: bool = false;

    /// The distance from 1 to the next larger number, which says how many steps of an iteration are
    /// worth taking.
    const SPACING: f64 = f64::EPSILON;

    /// Whether these numbers carry [derivatives](crate::Dual).
    const HAS_DERIVATIVES: bool = false;

    /// The nearest number to a literal.
    #[must_use]
    fn lit(value: f64) -> Self;
    /// 0.
    #[must_use]
    #[inline(always)]
    #[track_caller]
    fn zero() -> Self {
        Self::lit(0.0)
    }
    /// 1.
    #[must_use]
    #[inline(always)]
    #[track_caller]
    fn one() -> Self {
        Self::lit(1.0)
    }
    /// The largest finite number. Values too large to represent saturate here.
    #[must_use]
    fn max_finite() -> Self;
    /// `yes` where the mask is true, `no` elsewhere.
    #[must_use]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// This number where the mask is true, zero elsewhere.
    #[must_use]
    #[inline(always)]
    #[track_caller]
    fn only_where(self, mask: Self::Mask) -> Self {
        Self::select(mask, self, Self::zero())
    }
    /// A value of this number that does not lie in `lower..=upper` (NaN never does), if there is
    /// one. Constructors validate with it; a symbol has no value and answers `None`.
    #[must_use]
    fn outside(self, lower: f64, upper: f64) -> Option<f64>;

    /// Where `self < other`; false for NaN.
    #[must_use]
    fn lt(self, other: Self) -> Self::Mask;
    /// Where `self <= other`; false for NaN.
    #[must_use]
    fn le(self, other: Self) -> Self::Mask;
    /// Where `self > other`; false for NaN.
    #[must_use]
    fn gt(self, other: Self) -> Self::Mask {
        other.lt(self)
    }
    /// Where `self >= other`; false for NaN.
    #[must_use]
    fn ge(self, other: Self) -> Self::Mask {
        other.le(self)
    }
    /// The smaller of two; `other` if either is NaN.
    #[must_use]
    fn min(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }
    /// The larger of two; `other` if either is NaN.
    #[must_use]
    fn max(self, other: Self) -> Self {
        Self::select(self.gt(other), self, other)
    }
    /// `self`, which exceeds `bound` by rounding at most, without the excess. The value is that of
    /// [`min`](Self::min), and the derivatives are those of `self`: a bound that the exact formula
    /// never reaches does not stop it from changing.
    #[must_use]
    #[inline(always)]
    #[track_caller]
    fn at_most(self, bound: Self) -> Self {
        self.min(bound)
    }
    /// This number as one that nothing changes, without its derivatives.
    #[must_use]
    #[inline(always)]
    fn held(self) -> Self {
        self
    }
    /// The value of this number with the derivatives of another.
    #[must_use]
    #[inline(always)]
    fn with_derivatives_of(self, other: Self) -> Self {
        let _ = other;
        self
    }
    /// This number x, which an iteration found, as the solution of F(x) = 0: with the derivatives
    /// that the equation gives it, −∂F/F′, and not those of the steps. They are 0 where F′ is.
    ///
    /// The equation answers F(x) and F′(x). Numbers without derivatives do not ask it.
    #[must_use]
    #[inline(always)]
    fn as_solution_of(self, equation: impl FnOnce(Self) -> (Self, Self)) -> Self {
        if !Self::HAS_DERIVATIVES {
            return self;
        }
        let x = self.held();
        let (value, slope) = equation(x);
        let steep = slope.abs().gt(Self::zero());
        let step = value / Self::select(steep, slope.held(), Self::one());
        x.with_derivatives_of(x - step.only_where(steep))
    }
    /// Absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// The magnitude of `self` with the sign of `sign`, also for zeros.
    #[must_use]
    fn copysign(self, sign: Self) -> Self;
    /// The largest integer not above.
    #[must_use]
    fn floor(self) -> Self;
    /// Square root, correctly rounded.
    #[must_use]
    fn sqrt(self) -> Self;
    /// 1/√x of a normal number x > 0, the largest included; of +0 a large finite number. Elsewhere
    /// the answer has no meaning.
    ///
    /// Made of multiplications and additions alone for `f32`, `f64` and their lanes, with which a
    /// processor is done sooner than with one root and one division.
    #[must_use]
    fn rsqrt(self) -> Self {
        Self::one() / self.sqrt()
    }

    /// eˣ.
    #[must_use]
    fn exp(self) -> Self;
    /// 2⁻ˣ times a positive `factor`, for `self` = x ≥ 0 and a product of at most 10²⁴: what densities
    /// fall with. Where x is no number it is 0. In `f32` it is 0 below the least normal number, and above
    /// it has all its digits even where 2⁻ˣ alone would have lost some.
    #[must_use]
    #[inline(always)]
    #[track_caller]
    fn decay(self, factor: Self) -> Self {
        // From 10⁴ on it is zero in every number.
        (self.min(Self::lit(1e4)) * Self::lit(-LN_2)).exp() * factor
    }
    /// eˣ − 1, accurate near 0.
    #[must_use]
    fn exp_m1(self) -> Self;
    /// Natural logarithm.
    #[must_use]
    fn ln(self) -> Self;
    /// ln(1 + x), accurate near 0.
    #[must_use]
    fn ln_1p(self) -> Self;
    /// `self` to a real power, for `self >= 0`; 0⁰ = 1.
    #[must_use]
    fn powf(self, exponent: Self) -> Self;
    /// (x/(x + `rest`))ⁿ for `self` = x > 0, `rest` ≥ 0 and an `exponent` n ≥ 0, where x and
    /// x/(x + `rest`) are normal numbers and x + `rest` is at most 10³⁸. Elsewhere the answer has no
    /// meaning.
    ///
    /// The power of a number close to 1 of which it is known what is missing there: cosⁿθ of
    /// cos²θ and sin²θ. It keeps the digits of both, and needs no root and no quotient of them. Its
    /// relative error is at most ε(4½ |ln y| + 1) for a result y < 1/e, 5½ ε above, with ε = 2⁻²³ in
    /// `f32`, 2⁻⁵² in `f64`.
    ///
    /// ```
    /// use brdf::Real;
    ///
    /// let power = Real::power_of_part(1.0_f32, 1e-9, 1e8); // 1 + 1e-9 is 1 in f32
    /// assert!((power - 0.9048374).abs() < 1e-7); // exp(−0.1)
    /// ```
    #[must_use]
    fn power_of_part(self, rest: Self, exponent: Self) -> Self {
        let (zero, one, whole) = (Self::zero(), Self::one(), self + rest);
        let near = rest.lt(self);
        let logarithm = Self::select(
            near,
            Self::select(near, -(rest / whole), zero).ln_1p(),
            Self::select(near, one, self / whole).ln(),
        );
        (exponent * logarithm).exp()
    }
    /// Sine and cosine of an angle in radians.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);
    /// Sine and cosine of a number of turns, 2π times `self` radians: azimuths of uniform numbers.
    #[must_use]
    fn sin_cos_turns(self) -> (Self, Self) {
        (self * Self::lit(TAU)).sin_cos()
    }
    /// Sine of an angle in radians.
    #[must_use]
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    /// Cosine of an angle in radians.
    #[must_use]
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    /// Tangent of an angle in radians.
    #[must_use]
    fn tan(self) -> Self;
    /// Arc sine in [−π/2, π/2]; arguments outside [−1, 1] count as the nearest end.
    #[must_use]
    fn asin(self) -> Self;
    /// Arc cosine in [0, π]; arguments outside [−1, 1] count as the nearest end.
    #[must_use]
    fn acos(self) -> Self;
    /// The square of the angle in radians whose versine 1 − cos is `self`, acos²(1 − x), for
    /// 0 ≤ x ≤ 1: no root, and all digits near 0, where it is 2x.
    #[must_use]
    fn angle_squared(self) -> Self {
        (self * Self::lit(0.5)).sqrt().asin().squared() * Self::lit(4.0)
    }
    /// The angle of the point (x = `other`, y = `self`) in [−π, π]; 0 at the origin.
    #[must_use]
    fn atan2(self, other: Self) -> Self;
    /// Error function.
    #[must_use]
    fn erf(self) -> Self;
    /// 1 − erf(x), accurate relative to its own size in the tail.
    #[must_use]
    fn erfc(self) -> Self;
    /// exp(x²) erfc(x) for `self` ≥ 0: what is left of the tail without its exponential.
    #[must_use]
    fn erfcx(self) -> Self {
        math::erfcx(self)
    }
    /// The integral of erfc from `self` ≥ 0 to infinity, exp(−x²)/√π − x erfc(x): how much the mean
    /// distance of x from a normally distributed number exceeds x. Accurate relative to that
    /// distance, x + ierfc(x), to which it is added; in `f64` and by default also relative to its
    /// own size, in the tail too.
    #[must_use]
    fn ierfc(self) -> Self {
        math::ierfc(self)
    }
    /// The mean of |x| of a normally distributed x, whose mean is `self` = z ≥ 0: z erf ν +
    /// √Q exp(−ν²), ν² = z²/(π Q), where √Q is what it is for z = 0. For Q from 10⁻³⁶ to a quarter of
    /// the largest number.
    #[must_use]
    fn mean_magnitude(self, square_at_zero: Self) -> Self {
        math::mean_magnitude(self, square_at_zero)
    }
    /// The x with erf(x) = `self`, for −1 < `self` < 1; finite at the ends.
    #[must_use]
    fn erf_inv(self) -> Self;

    /// `self²`.
    #[must_use]
    fn squared(self) -> Self {
        self * self
    }
    /// `self` to a whole power, by repeated squaring.
    #[must_use]
    fn powi(self, exponent: u32) -> Self {
        let (mut result, mut square, mut rest) = (Self::one(), self, exponent);
        while rest > 0 {
            if rest & 1 == 1 {
                result = result * square;
            }
            square = square * square;
            rest >>= 1;
        }
        result
    }
    /// `self` moved into `lower..=upper`; `lower` for NaN.
    #[must_use]
    fn clamp(self, lower: Self, upper: Self) -> Self {
        self.max(lower).min(upper)
    }
}

/// A vector in space: the direction of light, of the viewer, of a facet.
///
/// The operations are spelled out in components so that a scalar and a lane round alike.
pub trait Vector<T: Real>:
    Copy + Debug + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> + Mul<T, Output = Self>
{
    /// The vector with these components.
    #[must_use]
    fn new(x: T, y: T, z: T) -> Self;
    /// First component: along the tangent.
    #[must_use]
    fn x(self) -> T;
    /// Second component: along the bitangent.
    #[must_use]
    fn y(self) -> T;
    /// Third component: along the normal; the cosine of the polar angle of a unit direction.
    #[must_use]
    fn z(self) -> T;

    /// Scalar product.
    #[must_use]
    fn dot(self, other: Self) -> T {
        self.x() * other.x() + self.y() * other.y() + self.z() * other.z()
    }
    /// Vector product.
    #[must_use]
    fn cross(self, other: Self) -> Self {
        Self::new(
            self.y() * other.z() - self.z() * other.y(),
            self.z() * other.x() - self.x() * other.z(),
            self.x() * other.y() - self.y() * other.x(),
        )
    }
    /// `self · self`.
    #[must_use]
    fn length_squared(self) -> T {
        Vector::dot(self, self)
    }
    /// The unit vector of the same direction; the normal `(0, 0, 1)` for a vector too short to
    /// have one.
    #[must_use]
    fn normalize_or_normal(self) -> Self {
        let length_squared = Vector::length_squared(self);
        let usable = length_squared.gt(T::lit(1e-37));
        let scale = T::one() / T::select(usable, length_squared, T::one()).sqrt();
        Self::select(usable, self * scale, Self::new(T::zero(), T::zero(), T::one()))
    }
    /// `yes` where the mask is true, `no` elsewhere.
    #[must_use]
    fn select(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self::new(
            T::select(mask, yes.x(), no.x()),
            T::select(mask, yes.y(), no.y()),
            T::select(mask, yes.z(), no.z()),
        )
    }
}

/// Whatever has channels: a number (one wavelength), a vector (red, green, blue), a spectrum.
///
/// A colour is as many numbers side by side as it has channels. [Batches](crate::batch) keep the
/// channels apart, in one array for each: see [`fill`](Self::fill).
pub trait Color<T: Real>:
    Copy
    + Debug
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Mul<T, Output = Self>
{
    /// The same kind of colour made of another number.
    type Over<U: Real>: Color<U>;
    /// An array with an element for each channel.
    type Channels<E: Debug + Send>: Debug + Send + AsRef<[E]> + AsMut<[E]>;

    /// The array of what is made for the places of the channels.
    #[must_use]
    fn by_channel<E: Debug + Send>(make: impl FnMut(usize) -> E) -> Self::Channels<E>;
    /// The channels of the colour.
    #[must_use]
    fn channels(self) -> Self::Channels<T>;
    /// The colour that has these channels.
    #[must_use]
    fn from_channels(channels: Self::Channels<T>) -> Self;
    /// Fills `N` colours, channel by channel, and `M` numbers beside each, with what a formula
    /// answers for their places.
    ///
    /// It is one loop that writes by index through the exclusive references among its own arguments
    /// and hands them to no other function. Only so does the compiler see that no answer changes
    /// what the formula reads next, and turns the loop into SIMD code. The default works for every
    /// colour, but not at that speed.
    #[inline(always)]
    fn fill<const N: usize, const M: usize>(
        channels: &mut Self::Channels<[T; N]>,
        numbers: &mut [[T; N]; M],
        formula: impl Fn(usize) -> (Self, [T; M]),
    ) {
        for index in 0..N {
            let (color, beside) = formula(index);
            for (channel, value) in channels.as_mut().iter_mut().zip(color.channels().as_ref()) {
                channel[index] = *value;
            }
            for (number, value) in numbers.iter_mut().zip(beside) {
                number[index] = value;
            }
        }
    }
    /// One of the colours that [`fill`](Self::fill) wrote.
    #[must_use]
    #[inline(always)]
    fn at<const N: usize>(channels: &Self::Channels<[T; N]>, index: usize) -> Self {
        let mut color = Self::by_channel(|_| T::zero());
        for (value, channel) in color.as_mut().iter_mut().zip(channels.as_ref()) {
            *value = channel[index];
        }
        Self::from_channels(color)
    }
    /// Colours side by side as their channels: only a colour with one channel is that already.
    #[must_use]
    #[inline(always)]
    fn in_place<const N: usize>(colors: &mut [Self; N]) -> Option<&mut Self::Channels<[T; N]>> {
        let _ = colors;
        None
    }

    /// The colour with the same value in every channel.
    #[must_use]
    fn splat(value: T) -> Self;
    /// Applies a formula to each channel.
    #[must_use]
    fn map(self, formula: impl Fn(T) -> T) -> Self;
    /// Applies a formula to each pair of channels.
    #[must_use]
    fn zip(self, other: Self, formula: impl Fn(T, T) -> T) -> Self;
    /// The same colour in another number.
    #[must_use]
    fn lift<U: Real>(self, lift: impl Fn(T) -> U) -> Self::Over<U>;
    /// Runs through the channels, first to last.
    #[must_use]
    fn fold<A>(self, start: A, step: impl Fn(A, T) -> A) -> A;

    /// Mean of the channels.
    #[must_use]
    fn mean(self) -> T {
        let (sum, count) =
            self.fold((T::zero(), 0.0), |(sum, count), value| (sum + value, count + 1.0));
        sum * T::lit(1.0 / count)
    }
    /// `yes` where the mask is true, `no` elsewhere, in every channel.
    #[must_use]
    fn choose(mask: T::Mask, yes: Self, no: Self) -> Self {
        yes.zip(no, |yes, no| T::select(mask, yes, no))
    }
    /// This colour where the mask is true, black elsewhere.
    #[must_use]
    #[inline(always)]
    #[track_caller]
    fn only_where(self, mask: T::Mask) -> Self {
        Self::choose(mask, self, Self::splat(T::zero()))
    }
    /// A channel value that does not lie in `lower..=upper`, if there is one.
    #[must_use]
    fn outside(self, lower: f64, upper: f64) -> Option<f64> {
        self.fold(None, |found, value| found.or(value.outside(lower, upper)))
    }
}

impl<T: Real> Color<T> for T {
    type Over<U: Real> = U;
    type Channels<E: Debug + Send> = [E; 1];

    #[inline(always)]
    fn by_channel<E: Debug + Send>(make: impl FnMut(usize) -> E) -> [E; 1] {
        core::array::from_fn(make)
    }
    #[inline(always)]
    fn channels(self) -> [T; 1] {
        [self]
    }
    #[inline(always)]
    fn from_channels([value]: [T; 1]) -> Self {
        value
    }
    #[inline(always)]
    #[allow(clippy::needless_range_loop, reason = "an iterator would be another function")]
    fn fill<const N: usize, const M: usize>(
        channels: &mut [[T; N]; 1],
        numbers: &mut [[T; N]; M],
        formula: impl Fn(usize) -> (T, [T; M]),
    ) {
        for index in 0..N {
            let (value, beside) = formula(index);
            channels[0][index] = value;
            for number in 0..M {
                numbers[number][index] = beside[number];
            }
        }
    }
    #[inline(always)]
    fn at<const N: usize>(channels: &[[T; N]; 1], index: usize) -> T {
        channels[0][index]
    }
    #[inline(always)]
    fn in_place<const N: usize>(colors: &mut [T; N]) -> Option<&mut [[T; N]; 1]> {
        Some(core::array::from_mut(colors))
    }
    #[inline(always)]
    fn splat(value: T) -> Self {
        value
    }
    #[inline(always)]
    fn map(self, formula: impl Fn(T) -> T) -> Self {
        formula(self)
    }
    #[inline(always)]
    fn zip(self, other: Self, formula: impl Fn(T, T) -> T) -> Self {
        formula(self, other)
    }
    #[inline(always)]
    fn lift<U: Real>(self, lift: impl Fn(T) -> U) -> U {
        lift(self)
    }
    #[inline(always)]
    fn fold<A>(self, start: A, step: impl Fn(A, T) -> A) -> A {
        step(start, self)
    }
}
