//! Why there is no text.

use alloc::string::String;
use core::error::Error;
use core::fmt;

use super::parameters::Binding;
#[cfg(feature = "serde")]
use crate::description::DescriptionError;
use crate::error::ParameterError;

/// What keeps a function from being written.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ShaderError {
    /// A name that is none in the language of shaders, that of one of its functions or types, or one
    /// that begins with `brdf`.
    Name(String),
    /// A name that the module has already.
    Taken(String),
    /// A place of a uniform buffer that the module uses already.
    Bound(Binding),
    /// A name of which the module has no model.
    Unknown(String),
    /// A function or model of this name with a symbol of another function, or of another thread.
    Foreign(String),
    /// More operations than text should have: a long loop was written out.
    TooLong {
        /// The name of the function or model.
        name: String,
        /// How many operations there may be.
        most: usize,
    },
    /// A model of this name over the whole sphere where one of reflection must be.
    WholeSphere(String),
    /// A constant that is not finite, as a quotient by 0 is, or a parameter whose value is not finite in
    /// single precision.
    NotFinite {
        /// The name of the function or model, or of the parameter.
        name: String,
        /// The value.
        value: f64,
    },
    /// A constant that a constructor does not accept.
    Parameter(ParameterError),
    /// A description whose values are not in range in single precision.
    #[cfg(feature = "serde")]
    Description(DescriptionError),
}

impl From<ParameterError> for ShaderError {
    fn from(error: ParameterError) -> Self {
        Self::Parameter(error)
    }
}

#[cfg(feature = "serde")]
impl From<DescriptionError> for ShaderError {
    fn from(error: DescriptionError) -> Self {
        Self::Description(error)
    }
}

impl fmt::Display for ShaderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name(name) => write!(
                f,
                "name must be a letter, then letters, digits and single underscores, no word of \
                 WGSL and not begin with `brdf`; it is {name:?}"
            ),
            Self::Taken(name) => write!(f, "name {name:?} is in the module already"),
            Self::Bound(Binding { group, binding }) => {
                write!(f, "@group({group}) @binding({binding}) has a buffer of the module already")
            }
            Self::Unknown(name) => write!(f, "the module has no model of the name {name:?}"),
            Self::Foreign(name) => {
                write!(f, "{name:?} has a symbol that belongs to another function or thread")
            }
            Self::TooLong { name, most } => {
                write!(f, "{name:?} must have at most {most} operations, and has more")
            }
            Self::WholeSphere(name) => write!(
                f,
                "the albedo is that of a model of reflection, and {name:?} is one over the whole sphere"
            ),
            Self::NotFinite { name, value } => {
                write!(
                    f,
                    "the constants of {name:?} must be finite in single precision, not {value}"
                )
            }
            Self::Parameter(error) => error.fmt(f),
            #[cfg(feature = "serde")]
            Self::Description(error) => error.fmt(f),
        }
    }
}

impl Error for ShaderError {}
