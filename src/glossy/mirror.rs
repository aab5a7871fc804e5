//! Lobes around the mirror direction.

use core::f64::consts::FRAC_1_PI;

use crate::direction::above_or_normal;
use crate::frame::Frame;
use crate::real::{Real, Vector};
use crate::sampling::ln_of_rest;

/// 1 − R·V, as |R − V|²/2 with R the mirror direction of `wi`.
///
/// The difference of two near vectors is exact, so that the narrowest lobe keeps its digits; and
/// the same bits arise when `wi` and `wo` change places.
#[inline(always)]
pub(super) fn mirror_versine<T: Real>(wi: T::Vec3, wo: T::Vec3) -> T {
    let (x, y, z) = (wi.x() + wo.x(), wi.y() + wo.y(), wi.z() - wo.z());
    (x * x + y * y + z * z) * T::lit(0.5)
}

/// `wo` as a unit vector; the normal where it is no direction above the surface.
#[inline(always)]
pub(super) fn unit_viewer<T: Real>(wo: T::Vec3) -> T::Vec3 {
    Vector::normalize_or_normal(above_or_normal::<T, _>(wo))
}

/// The unit direction at an angle of given 1 − cos from the mirror direction of `wo`, at azimuth
/// 2π `turn` around it.
#[inline(always)]
pub(super) fn around_mirror<T: Real>(wo: T::Vec3, versine: T, turn: T) -> T::Vec3 {
    let viewer = unit_viewer::<T>(wo);
    let mirror = <T::Vec3 as Vector<T>>::new(-viewer.x(), -viewer.y(), viewer.z());
    let sin = (versine * (T::lit(2.0) - versine)).max(T::zero()).sqrt();
    let (sin_phi, cos_phi) = turn.sin_cos_turns();
    Frame::from_normal(mirror).to_world(Vector::new(
        sin * cos_phi,
        sin * sin_phi,
        T::one() - versine,
    ))
}

/// The mean of max(0, cosθᵢ) over the directions at an angle of given 1 − cos from the mirror
/// direction of a viewer at (`sin_o`, `cos_o`); the angle no larger than a right one.
#[inline(always)]
pub(super) fn mean_cosine<T: Real>(sin_o: T, cos_o: T, versine: T) -> T {
    let (zero, one) = (T::zero(), T::one());
    let center = cos_o * (one - versine);
    let swing = sin_o * (versine * (T::lit(2.0) - versine)).max(zero).sqrt();
    // A circle around the mirror direction lies above the surface as a whole, or is cut.
    let cut = swing.gt(center);
    let turn = T::select(cut, -center / T::select(cut, swing, one), one).acos();
    let arc = (swing * swing - center * center).max(zero).sqrt();
    T::select(cut, (turn * center + arc) * T::lit(FRAC_1_PI), center)
}

/// 1 − cos of an angle drawn with density (n + 1)/(2π) cosⁿ per steradian.
#[inline(always)]
pub(super) fn sample_power<T: Real>(exponent: T, u: T) -> T {
    -(ln_of_rest(u) / (exponent + T::one())).exp_m1()
}
