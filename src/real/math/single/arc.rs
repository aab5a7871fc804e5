//! Arc sine, arc cosine and the angle of a point.

use core::f32::consts::{FRAC_PI_2, PI};

use super::sqrt;
use crate::real::math::double;

/// What `FRAC_PI_2` and `PI` lack.
const FRAC_PI_2_LOW: f32 = -4.371139e-8;
const PI_LOW: f32 = -8.742278e-8;

#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the one rounding of the result")]
pub(in crate::real) fn asin(x: f32) -> f32 {
    let a = f64::from(x.abs());
    let a = if a > 1.0 { 1.0 } else { a };
    // Near 1: asin a = π/2 − 2 asin √((1 − a)/2).
    let near_one = a > 0.5;
    let z = if near_one { 0.5 * (1.0 - a) } else { a * a };
    let s = if near_one { double::sqrt(z) } else { a };
    let angle = s + s
        * z
        * polynomial!(
            z;
            0.16666659991358493, 0.07500504179771242, 0.0445169561937122, 0.03180770930984996,
            0.014438640250987957, 0.03751640091349836
        );
    let angle = if near_one { core::f64::consts::FRAC_PI_2 - 2.0 * angle } else { angle };
    (angle as f32).copysign(x)
}

#[inline(always)]
pub(in crate::real) fn acos(x: f32) -> f32 {
    let a = x.abs();
    let a = if a > 1.0 { 1.0 } else { a };
    // Near 1: acos a = 2 asin √((1 − a)/2).
    let near_one = a > 0.5;
    let z = if near_one { 0.5 * (1.0 - a) } else { a * a };
    let s = if near_one { sqrt(z) } else { a };
    let tail =
        s * z * polynomial!(z; 0.16666752, 0.074953094, 0.045469165, 0.024184681, 0.04215849);
    let (signed, signed_tail) = (s.copysign(x), tail.copysign(x));
    let central = FRAC_PI_2 - (signed - (FRAC_PI_2_LOW - signed_tail));
    let twice = 2.0 * (s + tail);
    let outer = if x > 0.0 { twice } else { PI - (twice - PI_LOW) };
    if near_one { outer } else { central }
}

/// acos²(1 − x) for 0 ≤ x ≤ 1.
#[inline(always)]
pub(in crate::real) fn angle_squared(x: f32) -> f32 {
    let rest = polynomial!(
        x;
        0.33333355, 0.088880375, 0.028684435, 0.0094314935, 0.0064563453, -0.0040024463,
        0.0075634443, -0.00462125, 0.001675149
    );
    (x + x) + x * x * rest
}

#[inline(always)]
pub(in crate::real) fn atan2(y: f32, x: f32) -> f32 {
    let (ax, ay) = (x.abs(), y.abs());
    let ax = if ax > f32::MAX { f32::MAX } else { ax };
    let ay = if ay > f32::MAX { f32::MAX } else { ay };
    let steep = ay > ax;
    let (smaller, larger) = (if steep { ax } else { ay }, if steep { ay } else { ax });
    let t = smaller / if larger == 0.0 { 1.0 } else { larger };
    let z = t * t;
    // The angle to the nearer axis is t + tail.
    let tail = t
        * z
        * polynomial!(
            z;
            -0.333333, 0.1999853, -0.14264013, 0.10950848, -0.08399164, 0.05787806, -0.03109268,
            0.010865793, -0.0017820332
        );
    let left = x < 0.0;
    let axis = if left { PI } else { 0.0 };
    let axis_low = if left { PI_LOW } else { 0.0 };
    let axis = if steep { FRAC_PI_2 } else { axis };
    let axis_low = if steep { FRAC_PI_2_LOW } else { axis_low };
    let away = steep == left;
    let t = if away { t } else { -t };
    let tail = if away { tail } else { -tail };
    let sum = axis + t;
    let error = t - (sum - axis);
    (sum + (error + (tail + axis_low))).copysign(y)
}
