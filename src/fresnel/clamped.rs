//! What the corrections of Schlick's polynomial share: answers are held in 0 … 1.

use super::term::average_over_cosine;
use crate::real::{Color, Real};

/// A reflectance in 0 … 1.
#[inline(always)]
pub(super) fn unit<T: Real, C: Color<T>>(color: C) -> C {
    color.map(|value| value.clamp(T::zero(), T::one()))
}

/// The average of what is clamped, from that of what is not: where nothing is clamped the difference is
/// exactly 0.
pub(super) fn average<T: Real, C: Color<T>>(whole: C, formula: impl Fn(T) -> C) -> C {
    let cut = average_over_cosine(|cos| {
        let value = formula(cos);
        unit::<T, C>(value).zip(value, |kept, value| kept - value)
    });
    unit(whole + cut)
}

/// F₀ + (1 − F₀)(1 − u)⁵ at u = 1/7, of which 1 − F₀ keeps (6/7)⁵.
pub(super) fn schlick_at_peak<T: Real>(f0: T) -> T {
    f0 + (T::one() - f0) * T::lit(EDGE)
}

/// b of a reflectance at u = 1/7.
pub(super) fn dip<T: Real>(f0: T, at_peak: T) -> T {
    (schlick_at_peak(f0) - at_peak) * T::lit(49.0 / (6.0 * EDGE))
}

/// (6/7)⁵.
const EDGE: f64 = 7776.0 / 16807.0;

/// Schlick's polynomial less b u (1 − u)⁶.
#[inline(always)]
pub(super) fn dipped<T: Real, C: Color<T>>(f0: C, b: C, cos: T) -> C {
    let one = T::one();
    let versine = one - cos;
    let fifth = versine.squared().squared() * versine;
    let sixth = cos * (fifth * versine);
    f0.map(|f0| f0 + (one - f0) * fifth).zip(b, |schlick, b| schlick - b * sixth)
}

/// Its average, (20 F₀ + 1)/21 − b/126 where nothing is clamped.
pub(super) fn dipped_average<T: Real, C: Color<T>>(f0: C, b: C) -> C {
    let schlick = f0.map(|f0| f0 + (T::one() - f0) * T::lit(1.0 / 21.0));
    let whole = schlick.zip(b, |schlick, b| schlick - b * T::lit(1.0 / 126.0));
    average(whole, |cos| dipped(f0, b, cos))
}
