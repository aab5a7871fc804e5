//! Where in a description a value stands.

use alloc::string::ToString;
use core::fmt;

use super::error::{DescriptionError, Problem};

/// The keys and indices that lead to a value of a description, as errors write them:
/// `sum[1].brdf.cook_torrance`.
#[derive(Clone, Copy, Debug)]
pub struct Path<'a> {
    parent: Option<&'a Self>,
    step: Step,
}

#[derive(Clone, Copy, Debug)]
enum Step {
    Root,
    Key(&'static str),
    Index(usize),
}

impl<'a> Path<'a> {
    pub(super) const ROOT: Self = Self { parent: None, step: Step::Root };

    /// The value of a key of this one.
    pub(super) const fn key(&'a self, key: &'static str) -> Self {
        Self { parent: Some(self), step: Step::Key(key) }
    }

    /// A component of this value.
    pub(super) const fn index(&'a self, index: usize) -> Self {
        Self { parent: Some(self), step: Step::Index(index) }
    }

    pub(super) fn error(&self, problem: Problem) -> DescriptionError {
        DescriptionError::new(self.to_string(), problem)
    }
}

impl fmt::Display for Path<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(parent) = self.parent {
            parent.fmt(f)?;
        }
        match (self.step, self.parent) {
            (Step::Root, _) => Ok(()),
            (Step::Key(key), Some(Path { step: Step::Root, .. })) => f.write_str(key),
            (Step::Key(key), _) => write!(f, ".{key}"),
            (Step::Index(index), _) => write!(f, "[{index}]"),
        }
    }
}
