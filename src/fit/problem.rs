//! What is minimised: the residuals and their derivatives by the parts of the way between the bounds.

use nalgebra::{DMatrix, DVector};

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
}

impl<D: Fittable> Problem<'_, D> {
    /// The values of the free numbers at parts of the way between their bounds, and their derivatives.
    pub(super) fn values_and_slopes(&self, parts: &DVector<f64>) -> (Vec<f64>, Vec<f64>) {
        let both = self.free.iter().zip(parts);
        both.map(|(free, part)| free.value_and_slope(*part)).unzip()
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

    pub(super) fn residuals(&self, parts: &DVector<f64>) -> Result<DVector<f64>, DescriptionError> {
        let residuals = self.residuals_of(&self.values_and_slopes(parts).0, |_, value| value)?;
        Ok(DVector::from_vec(residuals))
    }

    /// The derivatives of all residuals by the parts of the way of some numbers, a column for each.
    pub(super) fn derivatives(
        &self,
        parts: &DVector<f64>,
        places: &[usize],
    ) -> Result<DMatrix<f64>, DescriptionError> {
        let (values, slopes) = self.values_and_slopes(parts);
        let mut columns = Vec::with_capacity(places.len());
        for some in places.chunks(AT_ONCE) {
            let residuals = self.residuals_of(&values, |place, value| {
                // A place that is not among them is beyond the last.
                let variable = some.iter().position(|other| *other == place).unwrap_or(AT_ONCE);
                Dual::<f64, AT_ONCE>::variable(value, variable)
            })?;
            for (variable, place) in some.iter().enumerate() {
                let slope = slopes[*place];
                let column = residuals.iter().map(|one| one.derivatives[variable] * slope);
                columns.push(DVector::from_iterator(residuals.len(), column));
            }
        }
        Ok(DMatrix::from_columns(&columns))
    }
}
