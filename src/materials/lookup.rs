//! Materials by name.

use alloc::string::String;
use alloc::vec::Vec;
use core::error::Error;
use core::fmt;

use super::material::Material;
use super::sets::ALL;

/// No material, or more than one, has the name that was asked for.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum LookupError {
    /// There is no such material.
    Unknown {
        /// What was asked for.
        name: String,
    },
    /// Several materials may be meant.
    Ambiguous {
        /// What was asked for.
        name: String,
        /// The materials that it may mean.
        candidates: Vec<&'static Material>,
    },
}

impl fmt::Display for LookupError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { name } => write!(f, "no material is called {name:?}"),
            Self::Ambiguous { name, candidates } => {
                write!(f, "{name:?} may be any of")?;
                for (index, material) in candidates.iter().enumerate() {
                    let separator = if index == 0 { " " } else { ", " };
                    write!(f, "{separator}{}", material.key())?;
                }
                Ok(())
            }
        }
    }
}

impl Error for LookupError {}

/// The material of a key, a chemical symbol or a name.
///
/// ```
/// use brdf::materials::{LookupError, find};
///
/// assert_eq!(find("Au")?.name(), "Gold");
/// assert_eq!(find("GOLD")?.key(), "Au");
/// assert_eq!(find("au_mcpeak")?.name(), "Gold (McPeak 2015)");
/// assert_eq!(find("stainless steel")?.key(), "stainless_steel");
/// assert_eq!(find("quartz").unwrap_err().to_string(), "\"quartz\" may be any of quartz_o, quartz_e");
/// # Ok::<(), LookupError>(())
/// ```
///
/// Upper and lower case are the same. The part of a name in parentheses or after a comma may be
/// left out if only one material has the rest. `aluminum` is `aluminium`.
///
/// # Errors
/// If no material or more than one has that name.
pub fn find(name: &str) -> Result<&'static Material, LookupError> {
    let name = name.trim();
    let spelled = if name.eq_ignore_ascii_case("aluminum") { "Al" } else { name };
    let whole = ALL.into_iter().find(|material| {
        material.key().eq_ignore_ascii_case(spelled)
            || material.name().eq_ignore_ascii_case(spelled)
    });
    if let Some(material) = whole {
        return Ok(material);
    }
    let candidates: Vec<&'static Material> =
        ALL.into_iter().filter(|one| plain(one.name()).eq_ignore_ascii_case(spelled)).collect();
    match candidates.as_slice() {
        [] => Err(LookupError::Unknown { name: name.into() }),
        [material] => Ok(material),
        _ => Err(LookupError::Ambiguous { name: name.into(), candidates }),
    }
}

/// A name up to its first parenthesis or comma.
fn plain(name: &str) -> &str {
    name.split(['(', ',']).next().unwrap_or(name).trim_end()
}

impl Material {
    /// Other sets of the same element.
    pub fn alternatives(&self) -> impl Iterator<Item = &'static Self> {
        let (key, symbol) = (self.key(), self.symbol());
        ALL.into_iter()
            .filter(move |other| symbol.is_some() && other.symbol() == symbol && other.key() != key)
    }
}
