//! The shape that Fujii gave to Oren and Nayar's grooves, and what it reflects.
//!
//! ```text
//! s/t′    s = L·V − (N·L)(N·V)    t′ = max(N·L, N·V) for s > 0, 1 otherwise
//! ```

use core::f64::consts::{FRAC_1_PI, FRAC_PI_2};

use crate::real::{Real, Vector};

/// s/t′, saturated where both directions graze to the last bit.
#[inline(always)]
pub(super) fn shape<T: Real>(wi: T::Vec3, wo: T::Vec3) -> T {
    let s = wi.x() * wo.x() + wi.y() * wo.y();
    let quotient = (s / wi.z().max(wo.z())).min(T::max_finite());
    T::select(s.gt(T::zero()), quotient, s)
}

/// sinθ, cosθ and the rest π/2 − θ of the angle to the horizon.
#[inline(always)]
fn angle<T: Real>(w: T::Vec3) -> [T; 3] {
    let w = Vector::normalize_or_normal(w);
    // A root has no derivative at 0.
    let sin = (w.x().squared() + w.y().squared()).max(T::lit(1e-36)).sqrt();
    [sin, w.z(), w.z().atan2(sin)]
}

/// (2/3) sinθ cosθ (1 + s + s²)/(1 + s): 2/3 of tanθ (1 − sin³θ), where the cosine of the tangent cancels.
#[inline(always)]
fn tangent<T: Real>(sin: T, cos: T) -> T {
    let one = T::one();
    T::lit(2.0 / 3.0) * (sin * cos) * (one + sin + sin * sin) / (one + sin)
}

/// G/π = (1/π) ∫ s/t′ cosθᵢ dωᵢ, from 0 at the normal to [`AT_GRAZING`].
#[inline(always)]
pub(super) fn reflected<T: Real>(wo: T::Vec3) -> T {
    let [sin, cos, rest] = angle::<T>(wo);
    let theta = T::lit(FRAC_PI_2) - rest;
    let g = sin * (theta - sin * cos) + tangent(sin, cos) - T::lit(2.0 / 3.0) * sin;
    g * T::lit(FRAC_1_PI)
}

/// [`AT_GRAZING`] − G/π, which keeps its digits at grazing, where it vanishes like cosθ/π.
#[inline(always)]
pub(super) fn missing<T: Real>(w: T::Vec3) -> T {
    let [sin, cos, rest] = angle::<T>(w);
    // 1 − sinθ without the difference.
    let versine = cos * cos / (T::one() + sin);
    let sum = T::lit(FRAC_PI_2 - 2.0 / 3.0) * versine + sin * (rest + sin * cos);
    (sum - tangent(sin, cos)).max(T::zero()) * T::lit(FRAC_1_PI)
}

/// ½ − 2/(3π).
pub(super) const AT_GRAZING: f64 = 0.5 - 2.0 / 3.0 * FRAC_1_PI;
