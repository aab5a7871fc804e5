//! What a fit finds, and how well it is known.

use nalgebra::DMatrix;

use super::error::FitError;
use super::measured::Fittable;
use super::solve::Problem;

/// The singular values of the derivatives, each column of length 1, below which they have no
/// digits left: numbers that act together as one.
const ALIKE: f64 = 1e-7;

/// A description that fits, and how well its numbers are known.
#[derive(Clone, Debug, PartialEq)]
pub struct Fitted<D> {
    description: D,
    parameters: Vec<FittedParameter>,
    residual: f64,
    correlation: DMatrix<f64>,
}

/// A number that was free.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FittedParameter {
    /// Where it stands in the description.
    pub path: String,
    /// What fits best.
    pub value: f64,
    /// The standard deviation of the value, if the residuals are independent and of equal spread:
    /// √(s² (JᵀJ)⁻¹) with the derivatives J of the residuals and s² = Σ residual²/(m − n) of m residuals
    /// and n numbers. `None` where the measured values do not tell the number.
    pub standard_error: Option<f64>,
    /// Whether it ended at one of its bounds. The standard errors of the others are for a number that
    /// stays there.
    pub at_bound: bool,
}

impl<D> Fitted<D> {
    /// The description with the best numbers.
    #[must_use]
    pub const fn description(&self) -> &D {
        &self.description
    }

    /// The free numbers, in the order in which they were freed.
    #[must_use]
    pub fn parameters(&self) -> &[FittedParameter] {
        &self.parameters
    }

    /// The root of the mean square of the weighted residuals that count.
    #[must_use]
    pub const fn residual(&self) -> f64 {
        self.residual
    }

    /// How much the errors of two free numbers go together, −1 … 1; 0 where one of them has none.
    #[must_use]
    pub fn correlation(&self, one: usize, other: usize) -> f64 {
        self.correlation.get((one, other)).copied().unwrap_or(0.0)
    }
}

impl<D: Fittable> Fitted<D> {
    /// The end of a fit of `count` residuals.
    pub(super) fn of(problem: &Problem<'_, D>, sum: f64, count: usize) -> Result<Self, FitError> {
        let (mut values, _) = problem.values_and_slopes();
        let derivatives = problem.derivatives(&values)?;
        // A number that has no influence did not move from where the fit began, which is inside if the
        // start is at a bound: it stays what it was. One that moved may have lost its influence.
        let ends = problem.unbounded.iter().zip(problem.free);
        for (value, (end, free)) in values.iter_mut().zip(ends) {
            if *end == free.unbounded_start() {
                *value = free.start;
            }
        }
        let description = problem.description.changed(&|path, value| {
            let path = path.to_string();
            let place = problem.free.iter().position(|free| free.path == path);
            place.and_then(|place| values.get(place).copied()).unwrap_or(value)
        })?;
        let at_bound: Vec<bool> = problem
            .free
            .iter()
            .zip(&values)
            .map(|(free, value)| free.is_at_bound(*value))
            .collect();
        let spread = (sum / count.saturating_sub(values.len()).max(1) as f64).sqrt();
        let (errors, correlation) = errors(derivatives, &at_bound);
        let parameters = problem.free.iter().zip(values).zip(errors).zip(at_bound).map(
            |(((free, value), error), at_bound)| FittedParameter {
                path: free.path.clone(),
                value,
                standard_error: error.map(|error| error * spread),
                at_bound,
            },
        );
        Ok(Self {
            description,
            parameters: parameters.collect(),
            residual: (sum / count as f64).sqrt(),
            correlation,
        })
    }
}

/// √ of the diagonal of (JᵀJ)⁻¹, where it is known, and the correlations.
fn errors(derivatives: DMatrix<f64>, held: &[bool]) -> (Vec<Option<f64>>, DMatrix<f64>) {
    let count = derivatives.ncols();
    let lengths: Vec<f64> = derivatives.column_iter().map(|column| column.norm()).collect();
    let moves = |place: usize| !held[place] && lengths[place] > 0.0;
    let places: Vec<usize> = (0..count).filter(|place| moves(*place)).collect();
    let (mut errors, mut correlation) = (vec![None; count], DMatrix::zeros(count, count));
    if places.is_empty() {
        return (errors, correlation);
    }
    let columns: Vec<_> =
        places.iter().map(|place| derivatives.column(*place) / lengths[*place]).collect();
    // The roots of the eigenvalues of JᵀJ would have half the digits.
    let decomposition = DMatrix::from_columns(&columns).svd(false, true);
    let Some(directions) = decomposition.v_t else {
        return (errors, correlation);
    };
    let largest = decomposition.singular_values.max();
    let (mut covariance, mut alike) =
        (DMatrix::zeros(places.len(), places.len()), vec![0.0; count]);
    for (value, direction) in decomposition.singular_values.iter().zip(directions.row_iter()) {
        if *value > ALIKE * largest {
            covariance += direction.transpose() * direction / (value * value);
        } else {
            for (part, place) in direction.iter().zip(&places) {
                alike[*place] += part * part;
            }
        }
    }
    for (row, place) in places.iter().enumerate() {
        if alike[*place] < ALIKE {
            errors[*place] = Some(covariance[(row, row)].sqrt() / lengths[*place]);
        }
    }
    for (row, one) in places.iter().enumerate() {
        for (column, other) in places.iter().enumerate() {
            if errors[*one].is_some() && errors[*other].is_some() {
                let scale = (covariance[(row, row)] * covariance[(column, column)]).sqrt();
                correlation[(*one, *other)] = covariance[(row, column)] / scale;
            }
        }
    }
    (errors, correlation)
}
