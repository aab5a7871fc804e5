//! A seeded bug as data.

use rayon::prelude::*;

use super::suite::{Killer, Suite};
use crate::faulty::{Fault, Operation, Place, Wrong, source};

/// The operand before the sign, or the argument of a function that is left out.
pub(super) const LEFT: Wrong = |left, _, _| left;
/// The operand behind the sign.
pub(super) const RIGHT: Wrong = |_, right, _| right;
/// + for −.
pub(super) const PLUS: Wrong = |left, right, _| left + right;
/// − for +.
pub(super) const MINUS: Wrong = |left, right, _| left - right;
/// A quotient turned round.
pub(super) const TURNED: Wrong = |left, right, _| right / left;
/// A factor of 1 where there is another.
pub(super) const ONE: Wrong = |_, _, _| 1.0;
/// The opposite answer of a comparison.
pub(super) const NOT: Wrong = |_, _, result| 1.0 - result;
/// The opposite sign.
pub(super) const NEGATIVE: Wrong = |_, _, result| -result;

/// A seeded bug.
#[derive(Clone, Copy, Debug)]
pub struct Mutant {
    /// The models that it breaks, as a reader would group them.
    pub family: &'static str,
    /// The physics that it gets wrong.
    pub meaning: &'static str,
    file: &'static str,
    /// A piece of the file that stands there once, with ▸ where the expression, with its
    /// parentheses, or the name of the method begins.
    text: &'static str,
    operation: Operation,
    link: u8,
    wrong: Wrong,
}

/// What became of a mutant.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub mutant: &'static Mutant,
    /// Whether its place was reached at all. One that was not proves nothing.
    pub fired: bool,
    pub killers: Vec<Killer>,
}

impl Mutant {
    pub(super) const fn new(
        family: &'static str,
        meaning: &'static str,
        file: &'static str,
        text: &'static str,
        operation: Operation,
        wrong: Wrong,
    ) -> Self {
        Self { family, meaning, file, text, operation, link: 0, wrong }
    }

    /// The same in a later link of `a · b · c`.
    pub(super) const fn link(mut self, link: u8) -> Self {
        self.link = link;
        self
    }

    /// Its place, found by reading the source.
    ///
    /// # Panics
    /// If the source does not contain the text exactly once.
    pub fn place(&self) -> Place {
        let source = source(self.file);
        let (before, after) = self.text.split_once('▸').expect("the place is marked");
        let text = format!("{before}{after}");
        let mut found = source.match_indices(&text).map(|(at, _)| at);
        let (at, other) = (found.next(), found.next());
        let at = at.unwrap_or_else(|| panic!("{} has no {:?}", self.file, self.text));
        assert_eq!(other, None, "{} has {:?} more than once", self.file, self.text);
        let above = &source[..at + before.len()];
        let number = |count: usize| u32::try_from(count).expect("a source is short") + 1;
        let line = number(above.matches('\n').count());
        let column = number(above.rsplit('\n').next().expect("a part").chars().count());
        Place { file: self.file, line, column, operation: self.operation, link: self.link }
    }
}

impl Outcome {
    pub fn killed(&self) -> bool {
        self.fired && !self.killers.is_empty()
    }
}

/// Runs the checks on the crate with each of some bugs: up to the first that fails, or all.
pub fn run(
    suite: &Suite,
    mutants: impl Iterator<Item = &'static Mutant>,
    exhaustive: bool,
) -> Vec<Outcome> {
    let mutants: Vec<_> = mutants.collect();
    let outcome = |mutant: &&'static Mutant| {
        let fault = Fault::leak(mutant.place(), mutant.wrong);
        let killers = suite.killers(fault, exhaustive);
        Outcome { mutant, fired: fault.has_fired(), killers }
    };
    mutants.par_iter().map(outcome).collect()
}

/// The bugs and what found them, as a table in Markdown.
pub fn table(outcomes: &[Outcome]) -> String {
    let mut table = "| models | bug | found by |\n|---|---|---|\n".to_owned();
    for Outcome { mutant, fired, killers } in outcomes {
        let found = killers.iter().map(Killer::to_string).collect::<Vec<_>>().join("; ");
        let found = match found.as_str() {
            "" if *fired => "**nothing**",
            "" => "**nothing, it was never reached**",
            found => found,
        };
        table += &format!("| {} | {} | {found} |\n", mutant.family, mutant.meaning);
    }
    table
}
