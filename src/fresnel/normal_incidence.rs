use crate::error::{ParameterError, Range};
use crate::real::Real;

/// The largest reflectance that still has an index within the range of the models.
const INVERTIBLE: Range = Range::new(0.0, 0.9996);

/// Reflectance at normal incidence of a medium of complex relative index `eta` + i `k`,
///
/// ```text
/// R₀ = ((n − 1)² + k²)/((n + 1)² + k²)
/// ```
///
/// For metals the k² is essential: gold at 659.5 nm has 0.963, and 0.569 without it.
///
/// ```
/// let gold = brdf::fresnel::normal_incidence(0.14_f64, 3.697);
/// assert!((gold - 0.9625853747).abs() < 1e-10);
/// ```
#[inline(always)]
#[must_use]
pub fn normal_incidence<T: Real>(eta: T, k: T) -> T {
    let one = T::one();
    let k_squared = k * k;
    ((eta - one).squared() + k_squared) / ((eta + one).squared() + k_squared)
}

/// The index n ≥ 1 of the transparent medium that has the reflectance `r0` at normal incidence,
///
/// ```text
/// n = (1 + √R₀)/(1 − √R₀)
/// ```
///
/// The inverse of [`normal_incidence`] for k = 0 and n ≥ 1 only. The index that it gives for a
/// metal reproduces R₀ and nothing else: gold at 659.5 nm becomes a "dielectric" with n = 104.9,
/// whose curve is wrong by 0.5 near grazing.
///
/// # Errors
/// If `r0` is not in 0 … 0.9996: the index would exceed 10⁴, and be infinite at 1.
///
/// ```
/// let ior = brdf::fresnel::index_from_normal_incidence(0.04_f64)?;
/// assert!((ior - 1.5).abs() < 1e-15);
/// assert!(brdf::fresnel::index_from_normal_incidence(1.0_f64).is_err());
/// # Ok::<(), brdf::ParameterError>(())
/// ```
pub fn index_from_normal_incidence<T: Real>(r0: T) -> Result<T, ParameterError> {
    INVERTIBLE.check("r0", r0)?;
    let one = T::one();
    // 1 − √R₀ = (1 − R₀)/(1 + √R₀) keeps its digits for R₀ near 1.
    Ok((one + r0.sqrt()).squared() / (one - r0))
}
