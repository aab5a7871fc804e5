use core::error::Error;
use core::fmt;

use crate::description::DescriptionError;

/// Why a description could not be fitted.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum FitError {
    /// No number of the description has this place.
    NoSuchNumber(String),
    /// Bounds that are no range, or that the parameter does not allow.
    Bounds(String),
    /// Nothing to change.
    NothingFree,
    /// Fewer measured values that count than numbers to find.
    TooFew {
        /// The values.
        measured: usize,
        /// The numbers.
        free: usize,
    },
    /// A measured value, a weight or a direction is not finite.
    NotFinite,
    /// The numbers do not build what is described.
    Description(DescriptionError),
    /// The solver gave up, and why.
    Solver(String),
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchNumber(path) => write!(f, "the description has no number {path}"),
            Self::Bounds(path) => {
                write!(f, "the bounds of {path} must be a range within that of the parameter")
            }
            Self::NothingFree => f.write_str("no number of the description is free"),
            Self::TooFew { measured, free } => {
                write!(f, "{measured} measured values are too few for {free} numbers")
            }
            Self::NotFinite => f.write_str("what was measured must be finite"),
            Self::Description(error) => error.fmt(f),
            Self::Solver(reason) => write!(f, "the fit did not converge: {reason}"),
        }
    }
}

impl Error for FitError {}

impl From<DescriptionError> for FitError {
    fn from(error: DescriptionError) -> Self {
        Self::Description(error)
    }
}
