//! What models do to polarised light.

use crate::brdf::{Brdf, Sample};
use crate::polarization::Mueller;
use crate::real::{Color, Real};

/// A reflectance model that knows how it polarises light.
///
/// The incoming frame is that of k = −wi, the outgoing one that of k = wo: ŝ = k × N/|k × N| with the
/// normal N = +z, and ŝ = +y where k is parallel to N; see [`polarization`](crate::polarization).
///
/// ```
/// use brdf::polarization::Stokes;
/// use brdf::{Beckmann, Brdf, CookTorrance, Dielectric, PolarizedBrdf};
/// use glam::DVec3;
///
/// let glass = CookTorrance::new(Beckmann::new(0.3)?, Dielectric::new(1.5)?);
/// let (wi, wo) = (DVec3::new(0.8, 0.0, 0.6), DVec3::new(-0.8, 0.0, 0.6));
/// let matrix = glass.mueller(wi, wo);
/// assert_eq!(matrix.rows[0][0], glass.eval(wi, wo));
/// let light = matrix * Stokes::unpolarized(1.0);
/// assert!(light.q > 0.9 * light.i && light.u == 0.0);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
pub trait PolarizedBrdf<T: Real = f32>: Brdf<T> {
    /// [`mueller`](Self::mueller) over its first element, which is 1; finite for all directions.
    fn polarization(&self, wi: T::Vec3, wo: T::Vec3) -> Mueller<Self::Color>;

    /// The Mueller matrix of the pair in sr⁻¹, without the cosine. Its first element is
    /// [`eval`](Brdf::eval), bit for bit: what unpolarised light gives.
    fn mueller(&self, wi: T::Vec3, wo: T::Vec3) -> Mueller<Self::Color> {
        times(self.polarization(wi, wo), self.eval(wi, wo))
    }

    /// [`sample`](Brdf::sample) with the Mueller matrix f cosθᵢ/pdf in the place of the weight, which is
    /// its first element: light from `wi` is drawn as if it were unpolarised.
    fn sample_mueller(
        &self,
        wo: T::Vec3,
        u: [T; 2],
    ) -> (Sample<T, Self::Color>, Mueller<Self::Color>) {
        let sample = self.sample(wo, u);
        (sample, times(self.polarization(sample.wi, wo), sample.weight))
    }
}

/// A matrix whose first element is 1, times a colour.
pub(crate) fn times<T: Real, C: Color<T>>(matrix: Mueller<C>, color: C) -> Mueller<C> {
    let mut rows = matrix.rows.map(|row| row.map(|element| element * color));
    rows[0][0] = color;
    Mueller { rows }
}
