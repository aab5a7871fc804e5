//! Measured metals in their own colour.

use brdf::materials::{ALUMINIUM, COPPER, GOLD, SILVER};
use brdf::{
    Brdf, Conductor, CookTorrance, Distribution, Fresnel, Illuminant, Observer, ParameterError,
    Sample, Shadowing,
};
use glam::Vec3;

use crate::spectral::{CHANNELS, Spectral, WAVELENGTHS, wavelengths};
use crate::sphere::Material;

/// Gold.
pub fn gold() -> Result<Conductor<Spectral>, ParameterError> {
    GOLD.conductor(wavelengths())
}

/// Silver.
pub fn silver() -> Result<Conductor<Spectral>, ParameterError> {
    SILVER.conductor(wavelengths())
}

/// Copper.
pub fn copper() -> Result<Conductor<Spectral>, ParameterError> {
    COPPER.conductor(wavelengths())
}

/// Aluminium.
pub fn aluminium() -> Result<Conductor<Spectral>, ParameterError> {
    ALUMINIUM.conductor(wavelengths())
}

/// What a metal reflects along its normal, seen by the eye.
pub fn color(metal: &Conductor<Spectral>) -> Result<Vec3, ParameterError> {
    Ok(Observer::new(Illuminant::D65, WAVELENGTHS)?.linear_srgb(metal.reflectance(1.0)))
}

/// Microfacets of a spectral reflectance, seen by the eye.
pub fn facets<D, F, S>(
    distribution: D,
    fresnel: F,
    shadowing: S,
) -> Result<Material, ParameterError>
where
    D: Distribution + 'static,
    F: Fresnel<f32, Color = Spectral> + 'static,
    S: Shadowing<f32, D> + 'static,
{
    seen(CookTorrance::from_parts(distribution, fresnel, shadowing))
}

/// A spectral model, seen by the eye.
pub fn seen(model: impl Brdf<Color = Spectral> + 'static) -> Result<Material, ParameterError> {
    Ok(Box::new(Seen { model, observer: Observer::new(Illuminant::D65, WAVELENGTHS)? }))
}

/// A model for sixteen wavelengths as one for linear sRGB: exact per wavelength first, then the
/// standard observer's sums, which are linear.
struct Seen<M> {
    model: M,
    observer: Observer<f32, CHANNELS>,
}

impl<M: Brdf<Color = Spectral>> Brdf for Seen<M> {
    type Color = Vec3;

    fn eval(&self, wi: Vec3, wo: Vec3) -> Vec3 {
        self.observer.linear_srgb(self.model.eval(wi, wo))
    }

    fn pdf(&self, wi: Vec3, wo: Vec3) -> f32 {
        self.model.pdf(wi, wo)
    }

    fn sample(&self, wo: Vec3, u: [f32; 2]) -> Sample<f32, Vec3> {
        let Sample { wi, weight, pdf } = self.model.sample(wo, u);
        Sample { wi, weight: self.observer.linear_srgb(weight), pdf }
    }
}
