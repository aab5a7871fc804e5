//! What a fit finds, and how well it is known.

use nalgebra::DMatrix;

use super::error::FitError;
use super::measured::Fittable;
use super::problem::Problem;
use super::solve::End;

/// The singular values of the derivatives, each column of length 1, below which they have no
/// digits left: numbers that act together as one.
const ALIKE: f64 = 1e-7;

/// What a number changes when it goes from one bound to the other at this speed, in parts of what was
/// measured, is but rounding.
const NOTHING: f64 = 1e-13;

/// A description that fits, and how well its numbers are known.
#[derive(Clone, Debug, PartialEq)]
pub struct Fitted<D> {
    description: D,
    parameters: Vec<FittedParameter>,
    residual: f64,
    minimum: bool,
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

    /// Whether the fit ended at a minimum: every derivative of the residual is zero, or points out of the
    /// bounds at which its number stands, as far as rounding lets one tell. If not, the solver ran out
    /// of steps, or no step was left that the constructors of the models accept: the numbers are the best
    /// that were found, and a fit from there, or from another start, may find better ones.
    #[must_use]
    pub const fn is_minimum(&self) -> bool {
        self.minimum
    }

    /// How much the errors of two free numbers go together, −1 … 1; 0 where one of them has none.
    #[must_use]
    pub fn correlation(&self, one: usize, other: usize) -> f64 {
        self.correlation.get((one, other)).copied().unwrap_or(0.0)
    }
}

impl<D: Fittable> Fitted<D> {
    /// The end of a fit of `count` residuals, which are in parts of the unit; the size is the sum of the
    /// squares of what was measured.
    pub(super) fn of(
        problem: &Problem<'_, D>,
        end: End,
        count: usize,
        [unit, size]: [f64; 2],
    ) -> Result<Self, FitError> {
        let End { place, minimum } = end;
        let (values, slopes) = problem.values_and_slopes(&place.parts);
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
        let spread = (place.sum / count.saturating_sub(values.len()).max(1) as f64).sqrt();
        let least = NOTHING * size.sqrt();
        let (errors, correlation) = errors(&place.derivatives, &at_bound, least);
        let errors = errors.into_iter().zip(slopes).map(|(error, slope)| Some(error? * slope));
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
            residual: (place.sum / count as f64).sqrt() * unit,
            minimum,
            correlation,
        })
    }
}

/// √ of the diagonal of (JᵀJ)⁻¹, where it is known, and the correlations. `least` is the length of a
/// derivative that is none.
fn errors(
    derivatives: &DMatrix<f64>,
    held: &[bool],
    least: f64,
) -> (Vec<Option<f64>>, DMatrix<f64>) {
    let count = derivatives.ncols();
    let (mut errors, mut correlation) = (vec![None; count], DMatrix::zeros(count, count));
    let lengths: Vec<f64> = derivatives.column_iter().map(|column| column.norm()).collect();
    let decomposed = |places: &[usize]| {
        let columns: Vec<_> =
            places.iter().map(|place| derivatives.column(*place) / lengths[*place]).collect();
        if columns.is_empty() {
            return Vec::new();
        }
        // The roots of the eigenvalues of JᵀJ would have half the digits.
        let decomposition = DMatrix::from_columns(&columns).svd(false, true);
        let values = decomposition.singular_values;
        let least = ALIKE * values.max();
        let directions = decomposition.v_t.into_iter().flat_map(|directions| {
            directions.row_iter().map(|row| row.transpose()).collect::<Vec<_>>()
        });
        let told = values.iter().map(|value| (*value > least).then_some(*value));
        told.zip(directions).collect::<Vec<_>>()
    };
    let act: Vec<usize> = (0..count).filter(|place| lengths[*place] > least).collect();
    // Also a number at its bound may act as one with others, and go back for them to go on.
    let mut alike = vec![0.0; count];
    for (_, direction) in decomposed(&act).iter().filter(|(value, _)| value.is_none()) {
        for (part, place) in direction.iter().zip(&act) {
            alike[*place] += part * part;
        }
    }
    let places: Vec<usize> = act.into_iter().filter(|place| !held[*place]).collect();
    let mut covariance = DMatrix::zeros(places.len(), places.len());
    for (value, direction) in decomposed(&places) {
        if let Some(value) = value {
            covariance += &direction * direction.transpose() / (value * value);
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
