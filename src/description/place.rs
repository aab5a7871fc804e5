//! Where the reader is, how much it has read, and where it failed.

use alloc::string::{String, ToString};
use core::cell::{Cell, RefCell};
use core::fmt;

use serde::de::Error;

use super::bounds::{MAX_DEPTH, MAX_SAMPLES, MAX_TERMS};
use super::error::{DescriptionError, Problem};
use super::path::Path;
use crate::parameter::Parameter;

/// The place of the value that is read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<'a> {
    path: Path<'a>,
    /// How many lists the value stands in.
    depth: usize,
    record: &'a Record,
}

/// What one walk through a description writes down.
#[derive(Debug, Default)]
pub(super) struct Record {
    /// The terms of all lists so far.
    terms: Cell<usize>,
    /// The samples so far.
    samples: Cell<usize>,
    /// The place where reading failed first.
    failure: RefCell<String>,
    failed: Cell<bool>,
    /// Why the description was refused, which says the place itself.
    refusal: RefCell<Option<DescriptionError>>,
}

impl Record {
    /// Why the description was refused, or the place where reading failed.
    pub(super) fn into_failure(self) -> (Option<DescriptionError>, String) {
        (self.refusal.into_inner(), self.failure.into_inner())
    }
}

impl<'a> Place<'a> {
    pub(super) const fn root(record: &'a Record) -> Self {
        Self { path: Path::ROOT, depth: 0, record }
    }

    pub(super) const fn path(&self) -> &Path<'a> {
        &self.path
    }

    /// The value of a key of this one.
    pub(super) const fn key(&'a self, key: &'static str) -> Self {
        Self { path: self.path.key(key), ..*self }
    }

    /// A component of this value.
    pub(super) const fn index(&'a self, index: usize) -> Self {
        Self { path: self.path.index(index), ..*self }
    }

    /// A term of this list, if there may be one more.
    pub(super) fn term(&'a self, index: usize) -> Result<Self, Problem> {
        let terms = self.record.terms.get() + 1;
        self.record.terms.set(terms);
        if terms > MAX_TERMS {
            return Err(Problem::TooManyTerms);
        }
        if self.depth == MAX_DEPTH {
            return Err(Problem::TooDeep);
        }
        Ok(Self { depth: self.depth + 1, ..self.index(index) })
    }

    /// A sample of this list, if there may be one more.
    pub(super) fn sample(&'a self, index: usize) -> Result<Self, Problem> {
        let samples = self.record.samples.get() + 1;
        self.record.samples.set(samples);
        if samples > MAX_SAMPLES {
            return Err(Problem::TooManySamples);
        }
        Ok(self.index(index))
    }

    /// Checks a number of this place, the one at an index of the parameter.
    pub(super) fn check<E: Error>(
        &self,
        parameter: &'static Parameter,
        index: usize,
        value: f64,
    ) -> Result<(), E> {
        let range = parameter.kind.range(index);
        let checked = range.map_or(Ok(()), |range| range.check::<f64, _>(parameter.name, value));
        checked.map_err(|error| self.refuse(self.path.error(Problem::Parameter(error))))
    }

    /// The error with which reading ends where the description is refused.
    pub(super) fn refuse<E: Error>(&self, refusal: DescriptionError) -> E {
        self.note_failure();
        let error = E::custom(&refusal);
        self.record.refusal.borrow_mut().get_or_insert(refusal);
        error
    }

    /// Notes that reading failed here, or below a place where it is already known to have failed.
    pub(super) fn note_failure(&self) {
        self.note_failure_at(|| self.path.to_string());
    }

    /// Notes that reading failed at a key that this value should not have.
    pub(super) fn note_failure_at_word(&self, word: &str) {
        self.note_failure_at(|| match self.path.to_string() {
            place if place.is_empty() => word.into(),
            place => place + "." + word,
        });
    }

    fn note_failure_at(&self, place: impl FnOnce() -> String) {
        if !self.record.failed.replace(true) {
            self.record.failure.replace(place());
        }
    }
}

/// How far a reader of a value got, to explain errors that formats raise by themselves.
#[derive(Debug, Default)]
pub(super) struct Progress {
    /// The name that was read.
    name: Cell<Option<&'static str>>,
    /// Whether what is expected was asked for: then an error says it.
    told: Cell<bool>,
}

impl Progress {
    pub(super) fn named(&self, name: &'static str) {
        self.name.set(Some(name));
    }

    pub(super) fn tell(&self) {
        self.told.set(true);
    }

    /// The result, whose error says what is expected here unless it says that already or comes
    /// from further inside.
    pub(super) fn explain<V, E: Error>(
        &self,
        place: &Place<'_>,
        expected: &dyn fmt::Display,
        result: Result<V, E>,
    ) -> Result<V, E> {
        result.map_err(|error| match self.name.get() {
            _ if self.told.get() || place.record.failed.get() => error,
            None => E::custom(format_args!("expected {expected}: {error}")),
            Some(name) => {
                E::custom(format_args!("`{name}` must be the only key of its object: {error}"))
            }
        })
    }
}

/// As much of a text as an error message should repeat, longer than every name.
pub(super) fn beginning(text: &str) -> String {
    match text.char_indices().nth(40) {
        None => text.into(),
        Some((end, _)) => String::from(&text[..end]) + "…",
    }
}
