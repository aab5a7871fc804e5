//! Reflectance of a smooth surface.

use crate::quadrature::integrate;
use crate::real::{Color, Real};

/// The reflectance of a smooth surface for unpolarised light.
///
/// On a microfacet surface the angle is that between the light and the facet (V·H), not the one
/// to the macroscopic normal.
pub trait Fresnel<T: Real = f32>: Send + Sync {
    /// What a reflectance has channels for.
    type Color: Color<T>;

    /// Reflectance in 0 … 1 at the cosine of the angle of incidence.
    fn reflectance(&self, cos_theta: T) -> Self::Color;

    /// Cosine-averaged reflectance 2 ∫₀¹ F(μ) μ dμ: the fraction reflected of light that arrives
    /// with the same radiance from everywhere.
    fn average(&self) -> Self::Color {
        integrate(T::lit(0.0), T::lit(1.0), |cos| self.reflectance(cos) * (cos * T::lit(2.0)))
    }
}
