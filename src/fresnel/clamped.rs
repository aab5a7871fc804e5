//! What the corrections of Schlick's polynomial share: answers are held in 0 … 1.

use super::term::average_over_cosine;
use crate::real::{Color, Mask, Real};

/// A reflectance in 0 … 1. At both ends, to rounding, it has the derivatives of what is held, which are those
/// towards the inside.
#[inline(always)]
pub(super) fn unit<T: Real, C: Color<T>>(color: C) -> C {
    let one = T::one();
    color.map(|value| {
        let kept = value.clamp(T::zero(), one);
        if !T::HAS_DERIVATIVES {
            return kept;
        }
        let rounding = T::lit(8.0 * T::SPACING);
        let inside = value.ge(-rounding).and(value.le(one + rounding));
        T::select(inside, kept.with_derivatives_of(value), kept.held())
    })
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

#[cfg(test)]
mod tests {
    use crate::{Dual, F82, F82Tint, Fresnel, Lazanyi, Schlick};

    type Number = Dual<f64, 1>;

    fn by(value: f64) -> Number {
        Dual::variable(value, 0)
    }
    fn number(value: f64) -> Number {
        Dual::constant(value)
    }

    #[test]
    fn derivatives_at_the_ends_of_parameters_are_those_towards_the_inside() {
        let normal = number(1.0);
        for f0 in [0.0, 1.0] {
            let slopes = [
                Schlick::new(by(f0)).unwrap().reflectance(normal),
                F82::new(by(f0), number(0.5)).unwrap().reflectance(normal),
                F82Tint::new(by(f0), number(0.5)).unwrap().reflectance(normal),
                Lazanyi::new(by(f0), number(1.0), number(6.0)).unwrap().reflectance(normal),
            ];
            for slope in slopes {
                assert_eq!((slope.value, slope.derivatives), (f0, [1.0]));
            }
        }
        let peak = number(1.0 / 7.0);
        for f0 in [0.0, 0.1, 0.5, 0.9, 1.0] {
            for f82 in [0.0, 1.0] {
                let slope = F82::new(number(f0), by(f82)).unwrap().reflectance(peak);
                assert!((slope.derivatives[0] - 1.0).abs() < 1e-14, "{f0} {f82}: {slope:?}");
            }
            let slope = F82Tint::new(number(f0), by(0.0)).unwrap().reflectance(peak);
            let want = Schlick::new(f0).unwrap().reflectance(1.0 / 7.0);
            assert!((slope.derivatives[0] - want).abs() < 1e-14, "{f0}: {slope:?}");
        }
    }

    #[test]
    fn what_is_held_does_not_change() {
        let dark = F82::new(number(0.1), by(0.0)).unwrap().reflectance(number(0.2));
        assert_eq!((dark.value, dark.derivatives), (0.0, [0.0]));
    }
}
