use core::error::Error;
use core::fmt;

use crate::description::DescriptionError;
use crate::error::{Number as Shown, ParameterError, Range};

/// Why a description could not be fitted.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum FitError {
    /// No number of the description has this place.
    NoSuchNumber(String),
    /// Bounds that are no range, or that the parameter does not allow.
    Bounds {
        /// The place of the number.
        path: String,
        /// The bounds.
        bounds: Range,
        /// The range of the parameter, in which they must lie.
        allowed: Range,
    },
    /// Nothing to change.
    NothingFree,
    /// Fewer measured values that count than numbers to find.
    TooFew {
        /// The values.
        measured: usize,
        /// The numbers.
        free: usize,
    },
    /// A measurement with which nothing can be compared.
    Measured {
        /// Where in the list it stands, counted from 0.
        index: usize,
        /// What is wrong with it.
        problem: Unfit,
    },
    /// The numbers do not build what is described.
    Description(DescriptionError),
}

/// What is wrong with a measurement.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Unfit {
    /// A value, a weight or a cosine out of its range.
    Number(ParameterError),
    /// No direction: its squared length is not 1, within 1 %.
    NoDirection {
        /// Which of both.
        direction: &'static str,
        /// Its squared length.
        error: ParameterError,
    },
    /// A direction that does not lie above the surface, where a BRDF has no value.
    Below {
        /// Which of both.
        direction: &'static str,
    },
}

impl fmt::Display for Unfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(error) => error.fmt(f),
            Self::NoDirection { direction, error } => write!(f, "{direction}: {error}"),
            Self::Below { direction } => write!(f, "{direction} must lie above the surface"),
        }
    }
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchNumber(path) => write!(f, "the description has no number {path}"),
            Self::Bounds { path, bounds, allowed } => {
                let [low, high, least, most] =
                    [bounds.lower, bounds.upper, allowed.lower, allowed.upper].map(Shown);
                write!(
                    f,
                    "the bounds of {path} must rise and lie between {least} and {most}, not be {low} and \
                     {high}"
                )
            }
            Self::NothingFree => f.write_str("no number of the description is free"),
            Self::TooFew { measured, free } => {
                write!(f, "{measured} measured values are too few for {free} numbers")
            }
            Self::Measured { index, problem } => write!(f, "measured[{index}]: {problem}"),
            Self::Description(error) => error.fmt(f),
        }
    }
}

impl Error for FitError {}

impl From<DescriptionError> for FitError {
    fn from(error: DescriptionError) -> Self {
        Self::Description(error)
    }
}
