//! Arc sine, arc cosine and the angle of a point.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use super::{head, sqrt};

/// What `FRAC_PI_2` and `PI` lack.
const FRAC_PI_2_LOW: f64 = 6.123233995736766e-17;
const PI_LOW: f64 = 1.2246467991473532e-16;

/// For |x| ≤ ½: (s, z) = (|x|, x²), so that asin |x| = asin s. Nearer to 1:
/// z = (1 − |x|)/2 and s = √z, so that acos |x| = 2 asin s. The third is asin s − s.
#[inline(always)]
fn halved(x: f64) -> (f64, f64, f64, bool) {
    let a = x.abs();
    let a = if a > 1.0 { 1.0 } else { a };
    let near_one = a > 0.5;
    let z = if near_one { 0.5 * (1.0 - a) } else { a * a };
    let s = if near_one { sqrt(z) } else { a };
    let tail = s
        * z
        * polynomial!(
            z;
            0.16666666666665408, 0.07500000000337144, 0.04464285682821319, 0.030381959141976774,
            0.022371757925114713, 0.017359706721634, 0.013885215509220457, 0.012169346464375478,
            0.00652737623942706, 0.019529947661403667, -0.016226960190509714,
            0.03191417142568511
        );
    (s, z, tail, near_one)
}

#[inline(always)]
pub(in crate::real) fn asin(x: f64) -> f64 {
    let (s, z, tail, near_one) = halved(x);
    // π/2 − 2 asin s with the rounding of the square root put right.
    let s_head = head(s);
    let sum = s + s_head;
    let s_rest = (z - s_head * s_head) / if sum == 0.0 { 1.0 } else { sum };
    let outer = FRAC_PI_4 + ((FRAC_PI_4 - 2.0 * s_head) + (FRAC_PI_2_LOW - 2.0 * (s_rest + tail)));
    (if near_one { outer } else { s + tail }).copysign(x)
}

#[inline(always)]
pub(in crate::real) fn acos(x: f64) -> f64 {
    let (s, _, tail, near_one) = halved(x);
    let (signed, signed_tail) = (s.copysign(x), tail.copysign(x));
    let central = FRAC_PI_2 - (signed - (FRAC_PI_2_LOW - signed_tail));
    let twice = 2.0 * (s + tail);
    let outer = if x > 0.0 { twice } else { PI - (twice - PI_LOW) };
    if near_one { outer } else { central }
}

/// acos²(1 − x) for 0 ≤ x ≤ 1.
#[inline(always)]
pub(in crate::real) fn angle_squared(x: f64) -> f64 {
    let rest = polynomial!(
        x;
        0.33333333333334064, 0.08888888888773065, 0.028571428636055995, 0.01015872831973915,
        0.0038480352870261087, 0.0015219329700960171, 0.0006243905267478923,
        0.00024404868101498566, 0.00017905348076730968, -0.00017334695457481522,
        0.0005726315489391772, -0.0010513388430149915, 0.0015757838418390192,
        -0.00177801217502097, 0.0015154788192947891, -0.0009389675272729056,
        0.000402309748698109, -0.00010675372486900671, 1.3475415802477326e-5
    );
    (x + x) + x * x * rest
}

#[inline(always)]
pub(in crate::real) fn atan2(y: f64, x: f64) -> f64 {
    const THREE_QUARTERS: f64 = 2.356194490192345;
    const THREE_QUARTERS_LOW: f64 = 9.184850993605148e-17;
    let (ax, ay) = (x.abs(), y.abs());
    let ax = if ax > f64::MAX { f64::MAX } else { ax };
    let ay = if ay > f64::MAX { f64::MAX } else { ay };
    let steep = ay > ax;
    let (smaller, larger) = (if steep { ax } else { ay }, if steep { ay } else { ax });
    // So that the sum below cannot overflow.
    let scale = if larger > 1e300 { 0.25 } else { 1.0 };
    let (smaller, larger) = (smaller * scale, larger * scale);
    // Near the diagonal the angle counts from there: (a − b)/(a + b) = tan(θ − π/4).
    let diagonal = smaller > 0.5 * larger;
    let numerator = if diagonal { smaller - larger } else { smaller };
    let denominator = if diagonal { smaller + larger } else { larger };
    let t = numerator / if denominator == 0.0 { 1.0 } else { denominator };
    let z = t * t;
    let tail = t
        * z
        * polynomial!(
            z;
            -0.33333333333333315, 0.19999999999993764, -0.1428571428499809, 0.11111111070037386,
            -0.09090907705264845, 0.07692277638258496, -0.06666224958573465, 0.0587781525882104,
            -0.05230043679113263, 0.04589523464505511, -0.03711981986550064,
            0.023655733684004455, -0.008365731113804184
        );
    let left = x < 0.0;
    let axis = if left { PI } else { 0.0 };
    let axis_low = if left { PI_LOW } else { 0.0 };
    let axis = if steep { FRAC_PI_2 } else { axis };
    let axis_low = if steep { FRAC_PI_2_LOW } else { axis_low };
    let between = if left { THREE_QUARTERS } else { FRAC_PI_4 };
    let between_low = if left { THREE_QUARTERS_LOW } else { 0.5 * FRAC_PI_2_LOW };
    let base = if diagonal { between } else { axis };
    let base_low = if diagonal { between_low } else { axis_low };
    let away = steep == left;
    let t = if away { t } else { -t };
    let tail = if away { tail } else { -tail };
    let sum = base + t;
    let error = t - (sum - base);
    (sum + (error + (tail + base_low))).copysign(y)
}
