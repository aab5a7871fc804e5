//! What models are compared with.

use glam::DVec3;

use super::counting::{Counting, above, cosine, counting, size, value};
use super::error::FitError;
use crate::brdf::Brdf;
use crate::description::{BrdfDescription, DescriptionError, FresnelDescription, Number, Path};
use crate::fresnel::Fresnel;
use crate::real::{Real, Vector};

/// A measured value of f_r, between two directions above the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Towards the light.
    pub wi: DVec3,
    /// Towards the viewer.
    pub wo: DVec3,
    /// f_r in sr⁻¹, −10¹⁰⁰ … 10¹⁰⁰; where a colour is out of gamut, channels may be negative.
    pub value: DVec3,
    /// How much each channel counts, 0 … 10¹⁰⁰: what its residual is multiplied with, one over its
    /// standard deviation if that is known; 0 leaves it out.
    pub weight: DVec3,
}

impl Measured {
    /// A value whose channels count alike.
    #[must_use]
    pub const fn new(wi: DVec3, wo: DVec3, value: DVec3) -> Self {
        Self { wi, wo, value, weight: DVec3::ONE }
    }
}

/// A measured reflectance of a Fresnel term.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredReflectance {
    /// The cosine of the angle of incidence, 0 … 1.
    pub cos: f64,
    /// The reflected part of unpolarised light.
    pub reflectance: DVec3,
    /// How much each channel counts, as in [`Measured`].
    pub weight: DVec3,
}

impl MeasuredReflectance {
    /// A reflectance at one wavelength, to be compared with the first channel of the term.
    #[must_use]
    pub const fn new(cos: f64, reflectance: f64) -> Self {
        Self { cos, reflectance: DVec3::splat(reflectance), weight: DVec3::X }
    }
}

/// What is compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Metric {
    /// The values themselves: the peak of a lobe counts, and next to nothing else.
    #[default]
    Value,
    /// f_r cosθᵢ, the reflected radiance for light of irradiance 1 across its own direction.
    Cosine,
    /// ∛(f_r cosθᵢ), which weighs peak and tails about as the eye does.
    ///
    /// A. Fores, J. Ferwerda, J. Gu, "Toward a perceptually based metric for BRDF modeling", Color and
    /// Imaging Conference 2012.
    CubeRoot,
}

impl Metric {
    fn of<T: Real>(self, value: T, cos: f64) -> T {
        match self {
            Self::Value => value,
            Self::Cosine => value * T::lit(cos),
            Self::CubeRoot => (value * T::lit(cos)).powf(T::lit(1.0 / 3.0)),
        }
    }

    /// The same of what was measured, which may be negative.
    fn of_measured(self, value: f64, cos: f64) -> f64 {
        match self {
            Self::Value => value,
            Self::Cosine => value * cos,
            Self::CubeRoot => (value * cos).cbrt(),
        }
    }
}

/// A description that can be fitted, and what it is fitted to.
pub trait Fittable: Clone {
    /// One measurement.
    type Point: Copy;

    #[doc(hidden)]
    fn all_numbers(&self) -> Vec<Number>;
    #[doc(hidden)]
    fn changed(&self, change: &dyn Fn(&Path<'_>, f64) -> f64) -> Result<Self, DescriptionError>;
    /// Weighted residuals, three for each point, of the numbers that `number` makes.
    #[doc(hidden)]
    fn residuals<T: Real>(
        &self,
        number: &dyn Fn(&Path<'_>, f64) -> T,
        points: &[Self::Point],
        metric: Metric,
    ) -> Result<Vec<T>, DescriptionError>;
    /// The measurements that count, once they are checked.
    #[doc(hidden)]
    fn counting(points: &[Self::Point]) -> Result<Counting<Self::Point>, FitError>;
    /// The sum of the squares of what was measured, weighted, in the metric.
    #[doc(hidden)]
    fn size(points: &[Self::Point], metric: Metric) -> f64;
}

/// The channels of a colour.
fn channels<T: Real>(color: T::Vec3) -> [T; 3] {
    [color.x(), color.y(), color.z()]
}

/// The weighted difference of each channel; zero where the weight is, whatever was measured there.
fn residual<T: Real>(
    model: T::Vec3,
    measured: DVec3,
    weight: DVec3,
    difference: impl Fn(T, f64) -> T,
) -> [T; 3] {
    let mut residuals = channels::<T>(model);
    let given = measured.to_array().into_iter().zip(weight.to_array());
    for (residual, (measured, weight)) in residuals.iter_mut().zip(given) {
        *residual = if weight == 0.0 {
            T::zero()
        } else {
            T::lit(weight) * difference(*residual, measured)
        };
    }
    residuals
}

fn vector<T: Real>(w: DVec3) -> T::Vec3 {
    Vector::new(T::lit(w.x), T::lit(w.y), T::lit(w.z))
}

impl Fittable for BrdfDescription {
    type Point = Measured;

    fn all_numbers(&self) -> Vec<Number> {
        self.numbers()
    }

    fn changed(&self, change: &dyn Fn(&Path<'_>, f64) -> f64) -> Result<Self, DescriptionError> {
        self.with_numbers(change)
    }

    fn residuals<T: Real>(
        &self,
        number: &dyn Fn(&Path<'_>, f64) -> T,
        points: &[Measured],
        metric: Metric,
    ) -> Result<Vec<T>, DescriptionError> {
        let model = self.build_with(number)?;
        let residuals = points.iter().flat_map(|point| {
            let value: T::Vec3 = model.eval(vector::<T>(point.wi), vector::<T>(point.wo));
            let cos = point.wi.z;
            residual::<T>(value, point.value, point.weight, |model, measured| {
                metric.of(model, cos) - T::lit(metric.of_measured(measured, cos))
            })
        });
        Ok(residuals.collect())
    }

    fn counting(points: &[Measured]) -> Result<Counting<Measured>, FitError> {
        counting(
            points,
            |point| &mut point.weight,
            |point| {
                above("wi", point.wi)?;
                above("wo", point.wo)?;
                value("value", point.value, point.weight)
            },
        )
    }

    fn size(points: &[Measured], metric: Metric) -> f64 {
        size(points.iter().map(|point| {
            let value = point.value.to_array().map(|value| metric.of_measured(value, point.wi.z));
            (DVec3::from(value), point.weight)
        }))
    }
}

impl Fittable for FresnelDescription {
    type Point = MeasuredReflectance;

    fn all_numbers(&self) -> Vec<Number> {
        self.numbers()
    }

    fn changed(&self, change: &dyn Fn(&Path<'_>, f64) -> f64) -> Result<Self, DescriptionError> {
        self.with_numbers(change)
    }

    fn residuals<T: Real>(
        &self,
        number: &dyn Fn(&Path<'_>, f64) -> T,
        points: &[MeasuredReflectance],
        _: Metric,
    ) -> Result<Vec<T>, DescriptionError> {
        let term = self.build_with(number)?;
        let residuals = points.iter().flat_map(|point| {
            let reflectance: T::Vec3 = term.reflectance(T::lit(point.cos));
            residual::<T>(reflectance, point.reflectance, point.weight, |model, measured| {
                model - T::lit(measured)
            })
        });
        Ok(residuals.collect())
    }

    fn counting(points: &[MeasuredReflectance]) -> Result<Counting<MeasuredReflectance>, FitError> {
        counting(
            points,
            |point| &mut point.weight,
            |point| {
                cosine(point.cos)?;
                value("reflectance", point.reflectance, point.weight)
            },
        )
    }

    fn size(points: &[MeasuredReflectance], _: Metric) -> f64 {
        size(points.iter().map(|point| (point.reflectance, point.weight)))
    }
}
