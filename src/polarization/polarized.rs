use crate::real::Real;

/// Something for each of the two linear polarisations: reflectances, amplitudes.
///
/// ```
/// use brdf::fresnel::dielectric_polarized;
///
/// // At Brewster's angle glass reflects s-polarised light only.
/// let cos = brdf::brewster_angle(1.0_f64, 1.5).cos();
/// let reflectance = dielectric_polarized(1.5, cos);
/// assert!((reflectance.s - 0.147928994).abs() < 1e-9 && reflectance.p < 1e-30);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polarized<T> {
    /// Electric field perpendicular (senkrecht) to the plane of incidence.
    pub s: T,
    /// Electric field parallel to the plane of incidence.
    pub p: T,
}

impl<T> Polarized<T> {
    /// What a formula makes of each.
    #[inline(always)]
    #[must_use]
    pub fn map<U>(self, formula: impl Fn(T) -> U) -> Polarized<U> {
        Polarized { s: formula(self.s), p: formula(self.p) }
    }
}

impl<T: Real> Polarized<T> {
    /// Reflectance of unpolarised light, R = (R_s + R_p)/2.
    #[inline(always)]
    #[must_use]
    pub fn unpolarized(self) -> T {
        (self.s + self.p) * T::lit(0.5)
    }
}
