//! What a batch does not accept.

use core::error::Error;
use core::fmt;

use crate::error::ParameterError;

/// Why a batch was not computed, or not to its end.
///
/// ```
/// use brdf::{Brdf, Lambert};
/// use glam::Vec3;
///
/// let white = Lambert::new(Vec3::ONE)?;
/// let mut values = [Vec3::ZERO; 3];
/// let (wi, wo) = ([Vec3::Z; 3], [Vec3::Z; 2]);
/// let error = white.eval_batch((&wi).into(), (&wo).into(), (&mut values).into()).unwrap_err();
/// assert_eq!(error.to_string(), "values has 3 elements, but wo has 2");
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BatchError {
    /// Two slices differ in length. Nothing was written.
    Length {
        /// The argument, and its component where it has some: `wi.x`, `values[0]`.
        argument: &'static str,
        /// Its number of elements.
        length: usize,
        /// The argument that differs from it.
        other: &'static str,
        /// The other's number of elements.
        other_length: usize,
    },
    /// A model of an element could not be built. What comes before the element's block of 128 has
    /// been computed.
    Parameter {
        /// The element.
        index: usize,
        /// What is wrong with it.
        error: ParameterError,
    },
}

impl fmt::Display for BatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { argument, length, other, other_length } => {
                write!(f, "{argument} has {length} elements, but {other} has {other_length}")
            }
            Self::Parameter { index, error } => {
                write!(f, "there is no model for element {index}: {error}")
            }
        }
    }
}

impl Error for BatchError {}

/// The length of the slices seen so far, which all others must have.
pub(crate) struct Length {
    argument: &'static str,
    length: usize,
}

impl Length {
    pub(super) const fn of(argument: &'static str, length: usize) -> Self {
        Self { argument, length }
    }

    pub(super) const fn get(&self) -> usize {
        self.length
    }

    /// Whether another argument has the same length.
    pub(super) fn agree(&self, other: &Self) -> Result<(), BatchError> {
        self.check(other.argument, other.length)
    }

    pub(super) fn check(&self, other: &'static str, other_length: usize) -> Result<(), BatchError> {
        let &Self { argument, length } = self;
        if length == other_length {
            return Ok(());
        }
        Err(BatchError::Length { argument, length, other, other_length })
    }
}
