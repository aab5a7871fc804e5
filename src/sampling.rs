//! Ways to turn two uniform numbers into a direction, shared by the models.

use crate::real::{Real, Vector};

/// The point of the unit disk at radius √u₀ and azimuth 2πu₁: uniform over the disk.
#[inline(always)]
pub(crate) fn uniform_disk<T: Real>(u: [T; 2]) -> (T, T) {
    let radius = u[0].max(T::lit(0.0)).sqrt();
    let (sin, cos) = (u[1] * T::lit(core::f64::consts::TAU)).sin_cos();
    (radius * cos, radius * sin)
}

/// A direction with density cosθ/π.
#[inline(always)]
pub(crate) fn cosine_hemisphere<T: Real>(u: [T; 2]) -> T::Vec3 {
    let (x, y) = uniform_disk(u);
    let z = (T::lit(1.0) - u[0]).max(T::lit(0.0)).sqrt();
    Vector::new(x, y, z)
}
