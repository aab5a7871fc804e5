//! Ways to turn two uniform numbers into a direction, shared by the models.

use crate::real::{Real, Vector};

/// Two uniform numbers as every sampler takes them: what lies outside 0 … 1 is moved to the nearer
/// end, NaN to 0. Both ends are allowed.
#[inline(always)]
pub(crate) fn uniform<T: Real>(u: [T; 2]) -> [T; 2] {
    u.map(|u| u.clamp(T::zero(), T::one()))
}

/// A direction with density cosθ/π: a uniform point of the unit disk, lifted to the hemisphere.
#[inline(always)]
pub(crate) fn cosine_hemisphere<T: Real>(u: [T; 2]) -> T::Vec3 {
    let [radius_squared, turn] = uniform(u);
    let radius = radius_squared.sqrt();
    let (sin, cos) = turn.sin_cos_turns();
    Vector::new(radius * cos, radius * sin, (T::one() - radius_squared).sqrt())
}
