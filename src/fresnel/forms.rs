//! Fresnel's equations in the forms that textbooks print, for one wavelength and unpolarised
//! light.
//!
//! They are corrected where the print is wrong, and each says where. They equal
//! [`Dielectric`](super::Dielectric) and [`Conductor`](super::Conductor), which are to be preferred:
//! these forms subtract nearly equal numbers for indices near 1 and lose digits there.

use super::conductor::Refraction;
use super::term::incident_cosine;
use crate::real::Real;

/// The (g, c) form for a transparent medium,
///
/// ```text
/// F = ½ (g − c)²/(g + c)² {1 + [c(g + c) − 1]²/[c(g − c) + 1]²}    g² = n² + c² − 1
/// ```
///
/// with c = cosθ (V·H on microfacets; the sign is ignored) and n = `ior` the relative index,
/// transmitted over incident, 10⁻⁴ … 10⁴. Some prints have c(g − c) − 1 in the last denominator:
/// at normal incidence on glass that gives 0.20 instead of 0.04, and infinity where
/// c² = 1/(n² − 3). Prints also call n just "the index": from inside it is 1/n.
///
/// 1 where g² ≤ 0: in total reflection, at the critical angle, and at n = 1, c = 0 (where
/// [`Dielectric`](super::Dielectric) answers 0, the limit of the other order).
///
/// R. L. Cook, K. E. Torrance, *A Reflectance Model for Computer Graphics*, 1982.
///
/// ```
/// let glass = brdf::fresnel::forms::gc(1.5_f64, 0.5);
/// assert!((glass - 0.0891867128).abs() < 1e-10);
/// ```
#[inline(always)]
#[must_use]
pub fn gc<T: Real>(ior: T, cos_theta: T) -> T {
    let (zero, one) = (T::zero(), T::one());
    let c = incident_cosine(cos_theta);
    let g_squared = ior * ior + c * c - one;
    let total = g_squared.le(zero);
    let g = T::select(total, one, g_squared).sqrt();
    let s = (g - c) / (g + c);
    let ratio = (c * (g + c) - one) / (c * (g - c) + one);
    let reflectance = T::lit(0.5) * s * s * (one + ratio * ratio);
    T::select(total, one, reflectance.at_most(one))
}

/// The (a, b, u) form for any medium,
///
/// ```text
/// R = ½ ((a − u)² + b²)/((a + u)² + b²) {1 + ([u(a + u) − 1]² + b²u²)/([u(a − u) + 1]² + b²u²)}
/// ```
///
/// with u = cosθ (the sign is ignored) and a, b from [`ab`]. Prints have (a ± (u − 1/u))² + b² in
/// the inner fraction, which is 0·∞ at grazing; here it is multiplied by u². Prints give
/// a² = n² + u² − 1, b = 0 for dielectrics, which has no root in total reflection; the general a
/// and b give R = 1 there by themselves.
///
/// 0 for n = 1, k = 0, where there is no surface.
///
/// ```
/// // Gold at 659.5 nm.
/// let gold = brdf::fresnel::forms::abu(0.14_f64, 3.697, 0.3);
/// assert!((gold - 0.9559441142).abs() < 1e-10);
/// ```
#[inline(always)]
#[must_use]
pub fn abu<T: Real>(eta: T, k: T, cos_theta: T) -> T {
    let (zero, one) = (T::zero(), T::one());
    let u = incident_cosine(cos_theta);
    let (a, b) = ab(eta, k, u);
    let b_squared = b * b;
    let s = ((a - u).squared() + b_squared) / ((a + u).squared() + b_squared);
    let bu_squared = b_squared * u * u;
    let ratio =
        ((u * (a + u) - one).squared() + bu_squared) / ((u * (a - u) + one).squared() + bu_squared);
    let reflectance = T::lit(0.5) * s * (one + ratio);
    let no_surface = ((eta - one).squared() + k * k).le(zero);
    T::select(no_surface, zero, reflectance.at_most(one))
}

/// The numbers a and b of [`abu`]: a + ib = √((n + ik)² − sin²θ),
///
/// ```text
/// a² = ½(√(x² + 4n²k²) + x)    b² = ½(√(x² + 4n²k²) − x)    x = n² − k² + u² − 1
/// ```
///
/// with the smaller of the two from a b = n k instead of the difference.
///
/// ```
/// let (a, b) = brdf::fresnel::forms::ab(0.5_f64, 0.0, 0.5);
/// assert!(a < 1e-15 && (b * b - 0.5).abs() < 1e-15); // glass from inside, total reflection
/// ```
#[inline(always)]
#[must_use]
pub fn ab<T: Real>(eta: T, k: T, cos_theta: T) -> (T, T) {
    Refraction::new(eta, k, incident_cosine(cos_theta)).parts()
}
