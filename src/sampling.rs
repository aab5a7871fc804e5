//! Ways to turn two uniform numbers into a direction, shared by the models.

use crate::real::{Real, Vector};

/// A direction with density cosθ/π: a uniform point of the unit disk, lifted to the hemisphere.
#[inline(always)]
pub(crate) fn cosine_hemisphere<T: Real>(u: [T; 2]) -> T::Vec3 {
    let (zero, one) = (T::lit(0.0), T::lit(1.0));
    let radius_squared = u[0].clamp(zero, one);
    let radius = radius_squared.sqrt();
    let (sin, cos) = (u[1] * T::lit(core::f64::consts::TAU)).sin_cos();
    Vector::new(radius * cos, radius * sin, (one - radius_squared).sqrt())
}
