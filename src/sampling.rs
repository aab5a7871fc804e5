//! Ways to turn two uniform numbers into a direction, shared by the models.

use crate::real::{Real, Vector};

/// Two uniform numbers as every sampler takes them: what lies outside 0 … 1 is moved to the nearer
/// end, NaN to 0. Both ends are allowed.
#[inline(always)]
pub(crate) fn uniform<T: Real>(u: [T; 2]) -> [T; 2] {
    u.map(|u| u.clamp(T::zero(), T::one()))
}

/// ln(1 − u) of a uniform number, which is the logarithm of one too: that of 1 counts as the least
/// power of e that every number can represent.
#[inline(always)]
pub(crate) fn ln_of_rest<T: Real>(u: T) -> T {
    (-u).ln_1p().max(T::lit(-85.0))
}

/// A direction with density (n + 1)/2π cosⁿθ.
#[inline(always)]
pub(crate) fn cosine_power<T: Real>(exponent: T, u: [T; 2]) -> T::Vec3 {
    let [u, turn] = uniform(u);
    // cosθ = (1 − u₀)^(1/(n + 1)) through its logarithm, which gives sinθ all its digits.
    let ln_cos = ln_of_rest(u) / (exponent + T::one());
    let sin = (-(ln_cos + ln_cos).exp_m1()).max(T::zero()).sqrt();
    let (sin_phi, cos_phi) = turn.sin_cos_turns();
    Vector::new(sin * cos_phi, sin * sin_phi, ln_cos.exp())
}

/// A direction with density cosθ/π: a uniform point of the unit disk, lifted to the hemisphere.
#[inline(always)]
pub(crate) fn cosine_hemisphere<T: Real>(u: [T; 2]) -> T::Vec3 {
    let [radius_squared, turn] = uniform(u);
    let radius = radius_squared.sqrt();
    let (sin, cos) = turn.sin_cos_turns();
    Vector::new(radius * cos, radius * sin, (T::one() - radius_squared).sqrt())
}
