//! Seeded bugs and the checks that have to find them.
//!
//! Nothing of it is in the crate. The formulas run over a number that errs at one place of the
//! source, [`Faulty`](super::faulty::Faulty), and the checks look at them as at any other.

pub mod files;
mod laws;
pub mod list;
pub mod mutant;
pub mod suite;
pub mod systematic;

use mutant::Outcome;

/// How many of the mutants of a family the checks killed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Killed {
    pub family: &'static str,
    pub killed: usize,
    pub of: usize,
}

/// Family by family, in the order of the list. A mutant that was never reached counts as alive.
pub fn killed(outcomes: &[Outcome]) -> Vec<Killed> {
    let mut rows: Vec<Killed> = Vec::new();
    for outcome in outcomes {
        let family = outcome.mutant.family;
        let index = rows.iter().position(|row| row.family == family).unwrap_or_else(|| {
            rows.push(Killed { family, killed: 0, of: 0 });
            rows.len() - 1
        });
        rows[index].of += 1;
        rows[index].killed += usize::from(outcome.killed());
    }
    rows
}
