//! Least squares, and how far the best models are off.

use brdf::description::BrdfDescription;
use brdf::fit::{FittedParameter, Measured};
use brdf::{AnyBrdf, Brdf};
use glam::DVec3;

use super::family::Family;
use super::measured::{Material, Point};

/// The best member of a family for a material, and how far it is off.
pub struct Fit {
    pub family: Family,
    pub description: BrdfDescription,
    /// The diffuse colour, the specular colour, the shape of the lobe: what there is of them.
    pub parameters: Vec<FittedParameter>,
    pub model: AnyBrdf<f64>,
    pub residuals: Residuals,
}

/// How far a model is off.
#[derive(Clone, Copy)]
pub struct Residuals {
    /// Root mean square of what is minimised: ∛(f cosθᵢ) − ∛(measured), sr^(−1/3).
    pub cube_root: f64,
    /// The same, divided by the root mean square of the measured cube roots.
    pub relative: f64,
    /// Root mean square of f cosθᵢ − measured, sr⁻¹.
    pub plain: f64,
}

impl Fit {
    /// The values of the parameters.
    pub fn values(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.value).collect()
    }
}

/// Reflected radiance for light of irradiance 1 across its own direction: f cosθᵢ.
fn reflected(value: DVec3, point: &Point) -> DVec3 {
    value * point.wi.z
}

/// Negative for negative values: colours out of gamut keep their sign.
fn cube_roots(color: DVec3) -> DVec3 {
    DVec3::from(color.to_array().map(f64::cbrt))
}

fn root_mean_square(values: impl Iterator<Item = f64>) -> f64 {
    let (count, sum) = values.fold((0.0, 0.0), |(count, sum), v| (count + 1.0, sum + v * v));
    f64::sqrt(sum / count)
}

/// The best fit from all starts of the family.
pub fn fit(family: Family, material: &Material) -> Fit {
    let measured: Vec<Measured> = material
        .points
        .iter()
        .map(|point| Measured::new(point.wi, point.wo, point.value))
        .collect();
    let ends = family.starts().into_iter().map(|start| {
        let fitted = family.fit(&start).to(&measured);
        fitted.unwrap_or_else(|error| {
            panic!("{} on {} from {start:?}: {error}", family.name(), material.key)
        })
    });
    let best = ends.min_by(|a, b| a.residual().total_cmp(&b.residual()));
    let best = best.expect("every family has a start");
    let description = best.description().clone();
    let model = description.build().expect("the solver stays within the bounds");
    let residuals = measure(&model, material);
    Fit { family, description, parameters: best.parameters().to_vec(), model, residuals }
}

/// How far a model is off.
pub fn measure(model: &AnyBrdf<f64>, material: &Material) -> Residuals {
    let channels = |color: &dyn Fn(DVec3, DVec3) -> DVec3| {
        root_mean_square(material.points.iter().flat_map(|point| {
            let value = reflected(model.eval(point.wi, point.wo), point);
            color(value, reflected(point.value, point)).to_array()
        }))
    };
    let cube_root = channels(&|value, measured| cube_roots(value) - cube_roots(measured));
    let scale = channels(&|_, measured| cube_roots(measured));
    let plain = channels(&|value, measured| value - measured);
    Residuals { cube_root, relative: cube_root / scale, plain }
}
