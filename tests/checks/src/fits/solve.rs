//! Least squares.

use glam::DVec3;
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};

use super::family::{Family, Model};
use super::measured::{Material, Point};

/// The best member of a family for a material, and how far it is off.
pub struct Fit {
    pub family: Family,
    pub values: Vec<f64>,
    pub model: Model,
    /// Root mean square of what is minimised: ∛(f cosθᵢ) − ∛(measured), sr^(−1/3).
    pub cube_root: f64,
    /// The same, divided by the root mean square of the measured cube roots.
    pub relative: f64,
    /// Root mean square of f cosθᵢ − measured, sr⁻¹.
    pub plain: f64,
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

/// The step of the central differences, in the numbers without bounds.
const STEP: f64 = 1e-5;

struct Problem<'a> {
    family: Family,
    material: &'a Material,
    measured: Vec<DVec3>,
    free: DVector<f64>,
}

impl<'a> Problem<'a> {
    fn new(family: Family, material: &'a Material, start: &[f64]) -> Self {
        let measured =
            material.points.iter().map(|point| cube_roots(reflected(point.value, point))).collect();
        let parameters = family.parameters();
        let free = parameters.iter().zip(start).map(|(parameter, value)| parameter.free(*value));
        let free = DVector::from_iterator(parameters.len(), free);
        Self { family, material, measured, free }
    }

    fn values(&self, free: &DVector<f64>) -> Vec<f64> {
        let parameters = self.family.parameters();
        parameters.iter().zip(free.iter()).map(|(parameter, x)| parameter.bounded(*x)).collect()
    }

    fn residuals_at(&self, free: &DVector<f64>) -> Option<DVector<f64>> {
        let model = self.family.model(&self.values(free)).ok()?;
        let pairs = self.material.points.iter().zip(&self.measured);
        let residuals = pairs.flat_map(|(point, measured)| {
            let value = reflected(model.eval(point.wi, point.wo), point);
            (cube_roots(value) - measured).to_array()
        });
        Some(DVector::from_iterator(3 * self.measured.len(), residuals))
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Problem<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, free: &DVector<f64>) {
        self.free.copy_from(free);
    }

    fn params(&self) -> DVector<f64> {
        self.free.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        self.residuals_at(&self.free)
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let columns = (0..self.free.len()).map(|index| {
            let (mut above, mut below) = (self.free.clone(), self.free.clone());
            above[index] += STEP;
            below[index] -= STEP;
            Some((self.residuals_at(&above)? - self.residuals_at(&below)?) / (2.0 * STEP))
        });
        Some(DMatrix::from_columns(&columns.collect::<Option<Vec<_>>>()?))
    }
}

/// The best fit from all starts of the family.
pub fn fit(family: Family, material: &Material) -> Fit {
    let ends = family.starts().into_iter().map(|start| {
        let problem = Problem::new(family, material, &start);
        let (problem, report) = LevenbergMarquardt::new().with_patience(200).minimize(problem);
        assert!(
            report.termination.was_successful(),
            "{} on {} from {start:?}: {:?}",
            family.name(),
            material.key,
            report.termination
        );
        (report.objective_function, problem.values(&problem.free))
    });
    let best = ends.min_by(|a, b| a.0.total_cmp(&b.0));
    let (_, values) = best.expect("every family has a start");
    measure(family, values, material)
}

/// How far the member of a family with these parameters is off.
pub fn measure(family: Family, values: Vec<f64>, material: &Material) -> Fit {
    let model = family.model(&values).expect("the solver stays within the bounds");
    let channels = |color: &dyn Fn(&Point, DVec3, DVec3) -> DVec3| {
        root_mean_square(material.points.iter().flat_map(|point| {
            let value = reflected(model.eval(point.wi, point.wo), point);
            color(point, value, reflected(point.value, point)).to_array()
        }))
    };
    let cube_root = channels(&|_, value, measured| cube_roots(value) - cube_roots(measured));
    let scale = channels(&|_, _, measured| cube_roots(measured));
    let plain = channels(&|_, value, measured| value - measured);
    Fit { family, cube_root, relative: cube_root / scale, plain, values, model }
}
