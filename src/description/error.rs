//! What can be wrong with a description.

use alloc::string::String;
use core::error::Error;
use core::fmt;

use super::bounds::{MAX_DEPTH, MAX_SAMPLES, MAX_TERMS};
use crate::error::ParameterError;

/// A description of something that cannot be built: where, what, and what is allowed.
///
/// ```
/// use brdf::description::BrdfDescription;
///
/// let text = r#"{"sum": [{"weight": 1, "brdf": {"lambert": {"albedo": [0.5, 0.5, 1.5]}}}]}"#;
/// let error = serde_json::from_str::<BrdfDescription>(text).unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "sum[0].brdf.lambert.albedo[2] must be between 0 and 1, not 1.5"
/// );
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DescriptionError {
    path: String,
    problem: Problem,
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Problem {
    /// A number outside its range.
    Parameter(ParameterError),
    /// A metal or another material that is not known, and why not.
    Metal(String),
    /// Smith's shadowing with this distribution, for which it is not known.
    NoSmith(&'static str),
    /// A rough dielectric of this distribution, which is neither Beckmann's nor GGX.
    NotRefracting(&'static str),
    /// An index that differs between the channels, as said here, where it must not.
    Dispersion(String),
    /// Sums or mixtures inside each other, too deep.
    TooDeep,
    /// More terms of sums and mixtures than are allowed altogether.
    TooManyTerms,
    /// More samples than are allowed altogether.
    TooManySamples,
    /// A Fresnel term that has three channels only, built for other wavelengths.
    NoSpectrum,
    /// A form that is in the table of forms and that nothing builds.
    Unknown,
}

impl DescriptionError {
    pub(super) const fn new(path: String, problem: Problem) -> Self {
        Self { path, problem }
    }

    /// The keys and indices that lead to the value, as in `sum[0].brdf.lambert.albedo`.
    #[must_use]
    pub fn path(&self) -> &str {
        &self.path
    }

    /// What is wrong with the value.
    #[must_use]
    pub const fn problem(&self) -> &Problem {
        &self.problem
    }
}

impl fmt::Display for DescriptionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let separator = match &self.problem {
            // The path ends with the name of the parameter, unless it is one of the whole list.
            Problem::Parameter(error) if !is_of_list(error) => " ",
            _ => ": ",
        };
        write!(f, "{}{separator}{}", self.path, self.problem)
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter(error) => {
                if is_of_list(error) {
                    write!(f, "{} ", error.parameter())?;
                }
                write!(f, "{}", error.rule())
            }
            Self::Metal(why) => f.write_str(why),
            Self::NoSmith(distribution) => write!(
                f,
                "Smith's shadowing is known for `beckmann`, `ggx` and mixtures of them, not for \
                 `{distribution}`; `v_cavity` fits every distribution",
            ),
            Self::NotRefracting(distribution) => {
                write!(f, "must be `beckmann` or `ggx`, not `{distribution}`")
            }
            Self::Dispersion(found) => write!(
                f,
                "must be one index for all wavelengths, that is a number, [n, k], or the same eta \
                 and k in all channels, not {found}",
            ),
            // Reading ends with the first one that is too much.
            Self::TooManySamples => write!(
                f,
                "samples may be at most {MAX_SAMPLES} altogether, and here is one of number {}",
                MAX_SAMPLES + 1
            ),
            Self::NoSpectrum => f.write_str(
                "must be built in red, green and blue, not at wavelengths: this term is a colour, of \
                 the whole spectrum; `stack` is the film at each wavelength",
            ),
            Self::Unknown => f.write_str("this form cannot be built"),
            Self::TooDeep => write!(
                f,
                "at most {MAX_DEPTH} sums and mixtures may stand inside each other, and here is one \
                 of depth {}",
                MAX_DEPTH + 1
            ),
            Self::TooManyTerms => write!(
                f,
                "sums and mixtures may have at most {MAX_TERMS} terms altogether, and here is one \
                 of number {}",
                MAX_TERMS + 1
            ),
        }
    }
}

/// Whether the parameter is no key but the sum of weights of a list.
fn is_of_list(error: &ParameterError) -> bool {
    (error.parameter().contains("weight") && error.parameter() != "weight")
        || error.parameter().starts_with("number of ")
}

impl Error for DescriptionError {}
