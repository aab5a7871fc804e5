//! Least squares by Levenberg and Marquardt where some numbers stay at their bounds.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};

use super::measured::Fittable;
use super::problem::Problem;

/// The longest first step of a number, as part of the way between its bounds.
const FIRST_STEP: f64 = 0.1;

/// What the solver has a number begin at, whatever its value: it measures steps in parts of where it is.
const ORIGIN: f64 = 1e-3;

/// Evaluations for each number.
const PATIENCE: usize = 200;

/// How much a number is held back where it is, in parts of what the residuals do when it moves. The square of
/// this is what the steps are wrong by; its inverse is how much of their rounding a direction that
/// changes no residual takes up.
const HOLD: f64 = 1e-7;

/// What a residual is where the numbers build nothing: no improvement on any that is measured.
const REFUSED: f64 = 1e150;

/// Some numbers that move, from where they are, while the others stay.
pub(super) struct Face<'p, 'a, D: Fittable> {
    problem: &'p Problem<'a, D>,
    /// All numbers.
    parts: DVector<f64>,
    moving: &'p [usize],
    /// How far the moving ones went, and [`ORIGIN`]. The solver may carry them beyond the bounds, which
    /// they stop at.
    sought: DVector<f64>,
    start: DVector<f64>,
    hold: DVector<f64>,
    /// How many residuals there are, without those that hold the numbers back.
    count: usize,
}

impl<'p, 'a, D: Fittable> Face<'p, 'a, D> {
    /// `derivatives` are those by the moving numbers.
    pub(super) fn new(
        problem: &'p Problem<'a, D>,
        parts: DVector<f64>,
        moving: &'p [usize],
        derivatives: &DMatrix<f64>,
    ) -> Self {
        let lengths = moving.iter().map(|place| derivatives.column(*place).norm());
        let lengths = DVector::from_iterator(moving.len(), lengths);
        let (hold, largest) = (&lengths * HOLD, lengths.max() * HOLD);
        let start = DVector::from_iterator(moving.len(), moving.iter().map(|place| parts[*place]));
        let hold = hold.map(|hold| if hold > 0.0 { hold } else { largest });
        let count = derivatives.nrows();
        Self {
            problem,
            parts,
            moving,
            sought: DVector::repeat(moving.len(), ORIGIN),
            start,
            hold,
            count,
        }
    }

    /// Where the numbers are at the nearest minimum, or when the first of them meet a bound.
    pub(super) fn minimum(self) -> DVector<f64> {
        let solver =
            LevenbergMarquardt::new().with_patience(PATIENCE).with_stepbound(FIRST_STEP / ORIGIN);
        let (face, _) = solver.minimize(self);
        face.parts
    }

    /// Where the moving numbers would be without bounds.
    fn unbounded(&self) -> impl Iterator<Item = f64> {
        self.start.iter().zip(&self.sought).map(|(start, sought)| start + (sought - ORIGIN))
    }
}

impl<D: Fittable> LeastSquaresProblem<f64, Dyn, Dyn> for Face<'_, '_, D> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, sought: &DVector<f64>) {
        self.sought.copy_from(sought);
        let parts: Vec<f64> = self.unbounded().collect();
        for (place, part) in self.moving.iter().zip(parts) {
            self.parts[*place] = part.clamp(0.0, 1.0);
        }
    }

    fn params(&self) -> DVector<f64> {
        self.sought.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let count = self.moving.len();
        let moved =
            self.moving.iter().zip(&self.start).map(|(place, start)| self.parts[*place] - start);
        let held = DVector::from_iterator(count, moved).component_mul(&self.hold);
        let residuals = self.problem.residuals(&self.parts).ok();
        let residuals = residuals.filter(|all| all.iter().all(|one| one.is_finite()));
        let Some(residuals) = residuals else {
            return Some(DVector::repeat(self.count + count, REFUSED));
        };
        let both = residuals.iter().chain(&held).copied();
        Some(DVector::from_iterator(residuals.len() + count, both))
    }

    /// None once a number has left its bounds: it is then for another face to go on.
    fn jacobian(&self) -> Option<DMatrix<f64>> {
        if !self.unbounded().all(|part| (0.0..=1.0).contains(&part)) {
            return None;
        }
        let derivatives = self.problem.derivatives(&self.parts, self.moving).ok()?;
        let (rows, count) = derivatives.shape();
        let mut all = derivatives.resize_vertically(rows + count, 0.0);
        for (place, hold) in self.hold.iter().enumerate() {
            all[(rows + place, place)] = *hold;
        }
        Some(all)
    }
}
