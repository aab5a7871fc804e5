//! The search for a minimum within bounds: from face to face of the box that they are.

use nalgebra::{DMatrix, DVector, DVectorView};

use super::face::Face;
use super::free::{END, Free};
use super::measured::Fittable;
use super::problem::Problem;
use crate::description::DescriptionError;

/// How often the numbers that stay at their bounds are chosen anew.
const ROUNDS: usize = 50;

/// The way, in parts of that between the bounds, below which a number counts as not moved.
const STILL: f64 = 1e-9;

/// The cosine of the angle between the residuals and their derivative by a number, below which the
/// number stands at a minimum.
const LEVEL: f64 = 1e-6;

/// The sum of the squared residuals, in parts of that of the measured values, which is but rounding.
const ROUNDING: f64 = 1e-24;

/// How far inside of a bound a number is tried that stays there.
const TRIALS: [f64; 9] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// The part of the sum of squares below which nothing was saved.
const SAVING: f64 = 1e-9;

/// Where a search ended.
pub(super) struct End {
    pub(super) place: Place,
    /// Whether no number within its bounds makes the residuals smaller, as far as derivatives and trials
    /// tell.
    pub(super) minimum: bool,
}

/// A place within the bounds.
pub(super) struct Place {
    pub(super) parts: DVector<f64>,
    /// The sum of the squared residuals.
    pub(super) sum: f64,
    /// The derivatives of the residuals by the parts of the way.
    pub(super) derivatives: DMatrix<f64>,
    /// The cosine of the angle between the residuals and their derivative by each number; 0 if it has
    /// none.
    leans: Vec<f64>,
}

impl Place {
    /// Whether a number so close to a bound is at it, and the residuals do not become smaller inside.
    fn stays(&self, number: usize, close: f64) -> bool {
        let (part, lean) = (self.parts[number], self.leans[number]);
        (part <= close && lean >= -LEVEL) || (part >= 1.0 - close && lean <= LEVEL)
    }

    /// Whether the residuals become smaller in no direction within the bounds.
    fn is_level(&self) -> bool {
        let mut leans = self.leans.iter().enumerate();
        leans.all(|(number, lean)| lean.abs() <= LEVEL || self.stays(number, END))
    }
}

impl<D: Fittable> Problem<'_, D> {
    /// Goes to a minimum near the start; `size` is the sum of the squares of what was measured.
    pub(super) fn minimize(&self, size: f64) -> Result<End, DescriptionError> {
        let starts = self.free.iter().map(Free::start_part);
        let mut place = self.place(DVector::from_iterator(self.free.len(), starts))?;
        let rounded = ROUNDING * size;
        for _ in 0..ROUNDS {
            if place.sum <= rounded {
                return Ok(End { place, minimum: true });
            }
            let Some(parts) = self.next(&place)? else {
                let minimum = place.is_level();
                return Ok(End { place, minimum });
            };
            place = self.place(parts)?;
        }
        let minimum = place.sum <= rounded;
        Ok(End { place, minimum })
    }

    fn place(&self, parts: DVector<f64>) -> Result<Place, DescriptionError> {
        let residuals = self.residuals(&parts)?;
        let all: Vec<usize> = (0..parts.len()).collect();
        let derivatives = self.derivatives(&parts, &all)?;
        let lean = |column: DVectorView<'_, f64>| {
            let lengths = column.norm() * residuals.norm();
            if lengths > 0.0 { column.dot(&residuals) / lengths } else { 0.0 }
        };
        let leans = derivatives.column_iter().map(lean).collect();
        Ok(Place { parts, sum: residuals.norm_squared(), derivatives, leans })
    }

    /// A better place: the minimum, or the next bound, of the numbers that need not stay at theirs; if
    /// that is here, what a trial finds.
    fn next(&self, place: &Place) -> Result<Option<DVector<f64>>, DescriptionError> {
        let numbers = 0..place.parts.len();
        let moving: Vec<usize> = numbers.filter(|number| !place.stays(*number, 0.0)).collect();
        if !moving.is_empty() {
            let face = Face::new(self, place.parts.clone(), &moving, &place.derivatives);
            let next = face.minimum();
            let sum = self.residuals(&next)?.norm_squared();
            let moved = (&next - &place.parts).amax();
            if sum < place.sum * (1.0 - SAVING) || (sum <= place.sum && moved > STILL) {
                return Ok(Some(next));
            }
        }
        Ok(self.trial(place))
    }

    /// The best of what is reached by moving one number away from its bound, if that makes the residuals
    /// smaller: its derivative there may be zero in spite of that, as that of σ of Oren and Nayar is, or
    /// have no value, as that of a cube root.
    fn trial(&self, place: &Place) -> Option<DVector<f64>> {
        let (mut best, mut least) = (None, place.sum * (1.0 - SAVING));
        for (number, part) in place.parts.iter().enumerate() {
            if *part > 0.0 && *part < 1.0 {
                continue;
            }
            for way in TRIALS {
                let mut trial = place.parts.clone();
                trial[number] = if *part > 0.0 { 1.0 - way } else { way };
                // Where nothing is built there is nothing better.
                let Ok(residuals) = self.residuals(&trial) else { continue };
                let sum = residuals.norm_squared();
                if sum < least {
                    (best, least) = (Some(trial), sum);
                }
            }
        }
        best
    }
}
