//! The search for a minimum within bounds: from face to face of the box that they are.

use nalgebra::{DMatrix, DVector};

use super::face::Face;
use super::free::END;
use super::measured::Fittable;
use super::problem::Problem;
use crate::description::DescriptionError;

/// How often the numbers that stay at their bounds are chosen anew.
const ROUNDS: usize = 100;

/// The way, in parts of that between the bounds, below which a number counts as not moved.
const STILL: f64 = 1e-9;

/// The cosine of the angle between the residuals and their derivative by a number, below which the
/// number stands at a minimum.
const LEVEL: f64 = 1e-6;

/// The sum of the squared residuals, in parts of that of the measured values, which is but rounding.
const ROUNDING: f64 = 1e-28;

/// How far inside of a bound a number is tried that stays there.
const TRIALS: [f64; 9] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// The part of the sum of squares that a trial must save.
const SAVING: f64 = 1e-9;

/// Where a search ended.
pub(super) struct End {
    pub(super) parts: DVector<f64>,
    /// The sum of the squared residuals.
    pub(super) sum: f64,
    /// Whether no number within its bounds makes it smaller, as far as derivatives and trials tell.
    pub(super) minimum: bool,
    /// The derivatives of the residuals by the parts of the way.
    pub(super) derivatives: DMatrix<f64>,
    /// The sum of the squares of what was measured.
    pub(super) size: f64,
}

impl<D: Fittable> Problem<'_, D> {
    /// Goes to a minimum near the start; `size` is the sum of the squares of what was measured.
    pub(super) fn minimize(&self, size: f64) -> Result<End, DescriptionError> {
        let all: Vec<usize> = (0..self.free.len()).collect();
        let starts = self.free.iter().map(|free| free.start_part());
        let mut parts = DVector::from_iterator(all.len(), starts);
        let mut settled = false;
        for _ in 0..ROUNDS {
                eprintln!("{round} {:?}", parts.as_slice());
            }
            let residuals = self.residuals(&parts)?;
            let derivatives = self.derivatives(&parts, &all)?;
            let moving: Vec<usize> = all
                .iter()
                .copied()
                .filter(|place| !stays(parts[*place], lean(&derivatives, &residuals, *place)))
                .collect();
            let sum = residuals.norm_squared();
            if sum <= ROUNDING * size {
                settled = true;
                break;
            }
            if !moving.is_empty() {
                let face = Face::new(self, parts.clone(), &moving, &derivatives);
                let next = face.minimum();
                let moved = (&next - &parts).amax();
                if self.residuals(&next)?.norm_squared() <= sum {
                    parts = next;
                    if moved > STILL {
                        continue;
                    }
                }
            }
            match self.better(&parts) {
                Some(better) => parts = better,
                None => {
                    settled = true;
                    break;
                }
            }
        }
        let residuals = self.residuals(&parts)?;
        let derivatives = self.derivatives(&parts, &all)?;
        let sum = residuals.norm_squared();
        let level = |place: &usize| {
            let (part, lean) = (parts[*place], lean(&derivatives, &residuals, *place));
            lean.abs() <= LEVEL
                || stays(
                    if part < END {
                        0.0
                    } else if part > 1.0 - END {
                        1.0
                    } else {
                        part
                    },
                    lean,
                )
        };
        let minimum = settled && (sum <= ROUNDING * size || all.iter().all(level));
        Ok(End { parts, sum, minimum, derivatives, size })
    }

    /// The best of what is reached by moving one number away from its bound, if that makes the residuals
    /// smaller: there its derivative may be zero in spite of that, as that of σ of Oren and Nayar is, or
    /// infinite, as that of a cube root.
    fn better(&self, parts: &DVector<f64>) -> Option<DVector<f64>> {
        let sum = |parts: &DVector<f64>| Some(self.residuals(parts).ok()?.norm_squared());
        let now = sum(parts)?;
        let (mut best, mut least) = (None, now * (1.0 - SAVING));
        for (place, part) in parts.iter().enumerate() {
            if *part > 0.0 && *part < 1.0 {
                continue;
            }
            for way in TRIALS {
                let mut trial = parts.clone();
                trial[place] = if *part > 0.0 { 1.0 - way } else { way };
                if let Some(sum) = sum(&trial).filter(|sum| *sum < least) {
                    (best, least) = (Some(trial), sum);
                }
            }
        }
        best
    }
}

/// The cosine of the angle between the residuals and their derivative by a number; 0 if it has none.
fn lean(derivatives: &DMatrix<f64>, residuals: &DVector<f64>, place: usize) -> f64 {
    let column = derivatives.column(place);
    let lengths = column.norm() * residuals.norm();
    if lengths > 0.0 { column.dot(residuals) / lengths } else { 0.0 }
}

/// Whether a number is at a bound, and the residuals would not become smaller inside.
fn stays(part: f64, lean: f64) -> bool {
    (part <= 0.0 && lean >= -LEVEL) || (part >= 1.0 && lean <= LEVEL)
}
