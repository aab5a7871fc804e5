//! Where in a description a value stands, and how much of a description there may be.

use alloc::string::{String, ToString};
use core::cell::{Cell, RefCell};
use core::fmt;

use super::bounds::{MAX_DEPTH, MAX_TERMS};
use super::error::{DescriptionError, Problem};
use crate::error::ParameterError;

/// A value's place: the keys and indices that lead to it, linked on the stack.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<'a> {
    parent: Option<&'a Self>,
    step: Step,
    /// How many lists the value stands in.
    depth: usize,
    record: &'a Record,
}

#[derive(Clone, Copy, Debug)]
enum Step {
    Root,
    Key(&'static str),
    Index(usize),
}

/// What one walk through a description writes down.
#[derive(Debug, Default)]
pub(super) struct Record {
    /// The terms of all lists so far.
    terms: Cell<usize>,
    /// The place where reading failed first.
    failure: RefCell<String>,
    failed: Cell<bool>,
}

impl Record {
    /// The place where reading failed.
    pub(super) fn into_failure(self) -> String {
        self.failure.into_inner()
    }
}

impl<'a> Place<'a> {
    pub(super) const fn root(record: &'a Record) -> Self {
        Self { parent: None, step: Step::Root, depth: 0, record }
    }

    /// The value of a key of this one.
    pub(super) const fn key(&'a self, key: &'static str) -> Self {
        Self { parent: Some(self), step: Step::Key(key), ..*self }
    }

    /// A component of this value.
    pub(super) const fn index(&'a self, index: usize) -> Self {
        Self { parent: Some(self), step: Step::Index(index), ..*self }
    }

    /// A term of this list, if there may be one more.
    pub(super) fn term(&'a self, index: usize) -> Result<Self, DescriptionError> {
        let terms = self.record.terms.get() + 1;
        self.record.terms.set(terms);
        if terms > MAX_TERMS {
            return Err(self.error(Problem::TooManyTerms));
        }
        if self.depth == MAX_DEPTH {
            return Err(self.error(Problem::TooDeep));
        }
        Ok(Self { depth: self.depth + 1, ..self.index(index) })
    }

    pub(super) fn error(&self, problem: Problem) -> DescriptionError {
        DescriptionError::new(self.to_string(), problem)
    }

    /// What a constructor with this one parameter says.
    pub(super) fn parameter<V>(
        &self,
        result: Result<V, ParameterError>,
    ) -> Result<V, DescriptionError> {
        result.map_err(|error| self.error(Problem::Parameter(error)))
    }

    /// What a constructor says whose parameters are called like the keys of this value.
    pub(super) fn parameters<V>(
        &self,
        result: Result<V, ParameterError>,
    ) -> Result<V, DescriptionError> {
        result.map_err(|error| self.key(error.parameter()).error(Problem::Parameter(error)))
    }

    /// Notes that reading failed here, or below a place where it is already known to have failed.
    pub(super) fn note_failure(&self) {
        self.note_failure_at(|| self.to_string());
    }

    /// Notes that reading failed at a key that this value should not have.
    pub(super) fn note_failure_at_word(&self, word: &str) {
        self.note_failure_at(|| match self.to_string() {
            place if place.is_empty() => word.into(),
            place => place + "." + word,
        });
    }

    /// Whether it is known already where reading failed.
    pub(super) const fn has_failed(&self) -> bool {
        self.record.failed.get()
    }

    fn note_failure_at(&self, place: impl FnOnce() -> String) {
        if !self.record.failed.replace(true) {
            self.record.failure.replace(place());
        }
    }
}

/// As in `sum[1].brdf.cook_torrance`; nothing for a whole description.
impl fmt::Display for Place<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(parent) = self.parent {
            parent.fmt(f)?;
        }
        match (self.step, self.parent) {
            (Step::Root, _) => Ok(()),
            (Step::Key(key), Some(Place { step: Step::Root, .. })) => f.write_str(key),
            (Step::Key(key), _) => write!(f, ".{key}"),
            (Step::Index(index), _) => write!(f, "[{index}]"),
        }
    }
}
