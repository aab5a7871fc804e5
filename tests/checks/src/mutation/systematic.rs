//! The obvious bugs at every place of the source that the checks reach.

use rayon::prelude::*;

use super::mutant::{LEFT, MINUS, NEGATIVE, NOT, PLUS, RIGHT, TURNED};
use super::suite::Suite;
use crate::faulty::{Fault, Operation, Place, Wrong};

const LARGER: Wrong = |_, _, result| if result == 0.0 { 0.01 } else { 1.01 * result };
const SMALLER_OF_TWO: Wrong = |left, right, _| left.min(right);
const LARGER_OF_TWO: Wrong = |left, right, _| left.max(right);
const ALL: Wrong = |left, right, _| left * right;
const ANY: Wrong = |left, right, _| left.max(right);
/// The other of two that are chosen from.
const OTHER: Wrong = |yes, no, result| if result.to_bits() == yes.to_bits() { no } else { yes };

/// What may be computed in the place of an operation.
fn faults(operation: Operation) -> &'static [(&'static str, Wrong)] {
    match operation {
        Operation::Literal => &[("1 % larger", LARGER)],
        Operation::Add => &[("− for +", MINUS), ("left side only", LEFT)],
        Operation::Sub => &[("+ for −", PLUS), ("left side only", LEFT)],
        Operation::Mul => &[("left side only", LEFT), ("right side only", RIGHT)],
        Operation::Div => &[("not divided", LEFT), ("turned round", TURNED)],
        Operation::Min => &[("max for min", LARGER_OF_TWO), ("not bounded", LEFT)],
        Operation::Max => &[("min for max", SMALLER_OF_TWO), ("not bounded", LEFT)],
        Operation::Clamp => &[("not bounded", LEFT)],
        Operation::Select => &[("the other", OTHER), ("always yes", LEFT), ("always no", RIGHT)],
        Operation::Less
        | Operation::LessOrEqual
        | Operation::Greater
        | Operation::GreaterOrEqual
        | Operation::Not => &[("the opposite", NOT)],
        Operation::And => {
            &[("or for and", ANY), ("left side only", LEFT), ("right side only", RIGHT)]
        }
        Operation::Or => {
            &[("and for or", ALL), ("left side only", LEFT), ("right side only", RIGHT)]
        }
        Operation::X | Operation::Y | Operation::Z => &[("another component", LEFT)],
        Operation::Dot | Operation::LengthSquared => &[("1 % larger", LARGER)],
        Operation::Cross => &[("the opposite", NEGATIVE)],
        Operation::Neg
        | Operation::Squared
        | Operation::Powi
        | Operation::Powf
        | Operation::Sqrt
        | Operation::Rsqrt
        | Operation::Abs
        | Operation::Copysign
        | Operation::Floor
        | Operation::Exp
        | Operation::ExpM1
        | Operation::Ln
        | Operation::Ln1p
        | Operation::Sin
        | Operation::Cos
        | Operation::Tan
        | Operation::Asin
        | Operation::Acos
        | Operation::PowerOfPart
        | Operation::AngleSquared
        | Operation::Atan2
        | Operation::Erf
        | Operation::Erfc
        | Operation::ErfInv
        | Operation::Normalize => &[("left out", LEFT)],
        // The angle is what is shown of it.
        Operation::SinCos | Operation::SinCosTurns => &[("1 % larger", LARGER)],
    }
}

/// A bug that nobody thought of, and what became of it.
#[derive(Clone, Copy, Debug)]
pub struct Outcome {
    pub place: Place,
    pub fault: &'static str,
    pub killer: Option<&'static str>,
}

/// A place and what may go wrong there, in words and as a formula.
pub type Bug = (Place, &'static str, Wrong);

/// The bugs in the files whose names begin so.
pub fn bugs(suite: &Suite, files: &str) -> Vec<Bug> {
    let places = suite.places().into_iter().filter(|place| place.file.starts_with(files));
    places
        .flat_map(|place| {
            faults(place.operation).iter().map(move |&(name, wrong)| (place, name, wrong))
        })
        .collect()
}

/// Runs them all, telling `done` after each.
pub fn run(suite: &Suite, bugs: &[Bug], done: impl Fn() + Sync) -> Vec<Outcome> {
    bugs.par_iter()
        .filter_map(|&(place, name, wrong)| {
            let fault = Fault::leak(place, wrong);
            let killer = suite.killers(fault, false).first().map(|killer| killer.check);
            done();
            // Links of a chain may be numbered in another way once an earlier one errs.
            fault.has_fired().then_some(Outcome { place, fault: name, killer })
        })
        .collect()
}
