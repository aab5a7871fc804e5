//! Least squares by Levenberg and Marquardt, with exact derivatives.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};

use super::error::FitError;
use super::free::Free;
use super::measured::{Fittable, Metric};
use crate::description::{DescriptionError, Path};
use crate::real::{Dual, Real};

/// How many derivatives are carried through the formulas at a time.
const AT_ONCE: usize = 4;

pub(super) struct Problem<'a, D: Fittable> {
    pub(super) description: &'a D,
    pub(super) points: &'a [D::Point],
    pub(super) metric: Metric,
    pub(super) free: &'a [Free],
    pub(super) unbounded: DVector<f64>,
}

impl<D: Fittable> Problem<'_, D> {
    /// The values of the free numbers, and their derivatives by the numbers without bounds.
    pub(super) fn values_and_slopes(&self) -> (Vec<f64>, Vec<f64>) {
        let both = self.free.iter().zip(self.unbounded.iter());
        both.map(|(free, unbounded)| free.value_and_slope(*unbounded)).unzip()
    }

    /// The residuals of the numbers that `number` makes of the places and values of the free ones.
    fn residuals_of<T: Real>(
        &self,
        values: &[f64],
        number: impl Fn(usize, f64) -> T,
    ) -> Result<Vec<T>, DescriptionError> {
        let number = |path: &Path<'_>, value: f64| {
            let path = path.to_string();
            match self.free.iter().position(|free| free.path == path) {
                Some(place) => number(place, values.get(place).copied().unwrap_or(value)),
                None => T::lit(value),
            }
        };
        self.description.residuals(&number, self.points, self.metric)
    }

    /// The derivatives of all residuals by the free numbers, one column for each.
    pub(super) fn derivatives(&self, values: &[f64]) -> Result<DMatrix<f64>, DescriptionError> {
        let mut columns = Vec::with_capacity(self.free.len());
        for first in (0..self.free.len()).step_by(AT_ONCE) {
            let residuals = self.residuals_of(values, |place, value| {
                // A place before the first is beyond the last.
                Dual::<f64, AT_ONCE>::variable(value, place.wrapping_sub(first))
            })?;
            for place in 0..AT_ONCE.min(self.free.len() - first) {
                let column = residuals.iter().map(|residual| residual.derivatives[place]);
                columns.push(DVector::from_iterator(residuals.len(), column));
            }
        }
        Ok(DMatrix::from_columns(&columns))
    }

    /// Moves to the nearest minimum; the sum of the squared residuals there, halved.
    pub(super) fn minimize(self) -> Result<(Self, f64), FitError> {
        let (problem, report) = LevenbergMarquardt::new().with_patience(200).minimize(self);
        if report.termination.was_successful() {
            Ok((problem, report.objective_function))
        } else {
            Err(FitError::Solver(format!("{:?}", report.termination)))
        }
    }
}

impl<D: Fittable> LeastSquaresProblem<f64, Dyn, Dyn> for Problem<'_, D> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, unbounded: &DVector<f64>) {
        self.unbounded.copy_from(unbounded);
    }

    fn params(&self) -> DVector<f64> {
        self.unbounded.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let (values, _) = self.values_and_slopes();
        self.residuals_of::<f64>(&values, |_, value| value).ok().map(DVector::from_vec)
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let (values, slopes) = self.values_and_slopes();
        let mut jacobian = self.derivatives(&values).ok()?;
        for (mut column, slope) in jacobian.column_iter_mut().zip(slopes) {
            column *= slope;
        }
        Some(jacobian)
    }
}
