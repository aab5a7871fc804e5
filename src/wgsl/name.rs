//! Names of functions and parameters.

use super::error::ShaderError;

/// Keywords of WGSL, words it reserves, and the names of its types and functions: one of those would take
/// the place of what the text, or the shader that it stands in, calls.
const WORDS: &str = include_str!("words.txt");

/// A name that may stand in a text.
pub(super) fn checked(name: &str) -> Result<&str, ShaderError> {
    let mut letters = name.chars();
    let first = letters.next().is_some_and(|letter| letter.is_ascii_alphabetic());
    let rest = letters.all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
    let own = name.to_ascii_lowercase().starts_with("brdf");
    let word = WORDS.split_whitespace().any(|word| word == name);
    if first && rest && !name.contains("__") && !name.ends_with('_') && !own && !word {
        Ok(name)
    } else {
        Err(ShaderError::Name(name.into()))
    }
}
