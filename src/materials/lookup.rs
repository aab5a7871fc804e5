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
        /// Up to three materials that are called almost so, the nearest first.
        nearest: Vec<&'static Material>,
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
            Self::Unknown { name, nearest } => {
                write!(f, "no material is called {name:?}")?;
                let words = if nearest.is_empty() { "" } else { "; near it are" };
                list(f, words, nearest)
            }
            Self::Ambiguous { name, candidates } => {
                write!(f, "{name:?} may be any of")?;
                list(f, "", candidates)
            }
        }
    }
}

/// Keys with commas between them.
fn list(f: &mut fmt::Formatter<'_>, words: &str, materials: &[&Material]) -> fmt::Result {
    f.write_str(words)?;
    for (index, material) in materials.iter().enumerate() {
        let separator = if index == 0 { " " } else { ", " };
        write!(f, "{separator}{}", material.key())?;
    }
    Ok(())
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
/// left out if only one material has the rest; of a set and its
/// [second opinions](Material::alternatives) that is the set. Some materials have other names too:
///
/// | name | key |
/// |---|---|
/// | aluminum | `Al` |
/// | electrum | `electrum_Au50Ag50` |
/// | halite, rock salt | `NaCl` |
/// | N-BK7 | `BK7` |
/// | plexiglass | `PMMA` |
/// | silica, quartz glass | `fused_silica` |
/// | soda-lime, soda-lime glass, window glass | `soda_lime` |
/// | steel | `stainless_steel` |
///
/// # Errors
/// If no material or more than one has that name.
pub fn find(name: &str) -> Result<&'static Material, LookupError> {
    let name = name.trim();
    let other = OTHER_NAMES.iter().find(|(other, _)| other.eq_ignore_ascii_case(name));
    let spelled = other.map_or(name, |(_, key)| key);
    let whole = ALL.into_iter().find(|material| {
        material.key().eq_ignore_ascii_case(spelled)
            || material.name().eq_ignore_ascii_case(spelled)
    });
    if let Some(material) = whole {
        return Ok(material);
    }
    let mut candidates: Vec<&'static Material> =
        ALL.into_iter().filter(|one| plain(one.name()).eq_ignore_ascii_case(spelled)).collect();
    if candidates.len() > 1 {
        candidates.retain(|one| one.first_key() == one.key());
    }
    match candidates.as_slice() {
        [] => Err(LookupError::Unknown { name: name.into(), nearest: nearest(name) }),
        [material] => Ok(material),
        _ => Err(LookupError::Ambiguous { name: name.into(), candidates }),
    }
}

/// Names that materials are found by beside their own.
const OTHER_NAMES: [(&str, &str); 12] = [
    ("aluminum", "Al"),
    ("electrum", "electrum_Au50Ag50"),
    ("halite", "NaCl"),
    ("rock salt", "NaCl"),
    ("N-BK7", "BK7"),
    ("plexiglass", "PMMA"),
    ("silica", "fused_silica"),
    ("quartz glass", "fused_silica"),
    ("soda-lime glass", "soda_lime"),
    ("soda-lime", "soda_lime"),
    ("window glass", "soda_lime"),
    ("steel", "stainless_steel"),
];

/// A name up to its first parenthesis or comma.
fn plain(name: &str) -> &str {
    name.split(['(', ',']).next().unwrap_or(name).trim_end()
}

/// The longest name that is compared with those of the materials; theirs are shorter.
const MAX_NAME: usize = 64;

/// The materials whose names contain the text or are contained in it, or differ from it by at most
/// a third of its letters: the three that differ least.
fn nearest(name: &str) -> Vec<&'static Material> {
    let text: Vec<char> = name.chars().map(|letter| letter.to_ascii_lowercase()).collect();
    if !(2..=MAX_NAME).contains(&text.len()) {
        return Vec::new();
    }
    let mut found: Vec<(usize, &'static Material)> = ALL
        .into_iter()
        .filter_map(|material| {
            let other = OTHER_NAMES.iter().filter(|(_, key)| *key == material.key());
            let names = [material.key(), material.name(), plain(material.name())];
            let names = names.into_iter().chain(other.map(|(name, _)| *name));
            let difference = names.filter_map(|name| difference(&text, name)).min()?;
            Some((difference, material))
        })
        .collect();
    found.sort_by_key(|(difference, _)| *difference);
    found.into_iter().take(3).map(|(_, material)| material).collect()
}

/// How many letters differ, if they are few; one if the shorter text is a part of the other.
fn difference(text: &[char], name: &str) -> Option<usize> {
    let name: Vec<char> = name.chars().map(|letter| letter.to_ascii_lowercase()).collect();
    let (short, long) = if text.len() < name.len() { (text, &*name) } else { (&*name, text) };
    let edits = edits(text, &name);
    if edits <= text.len() / 3 {
        Some(edits)
    } else {
        // Symbols of one or two letters are a part of most words.
        let part = short.len() > 2 && long.windows(short.len()).any(|window| window == short);
        part.then_some(1)
    }
}

/// Levenshtein's distance: the fewest letters to insert, remove or replace.
fn edits(from: &[char], to: &[char]) -> usize {
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (index, letter) in from.iter().enumerate() {
        let mut diagonal = index;
        let mut left = index + 1;
        for (above, other) in row.iter_mut().skip(1).zip(to) {
            let replaced = diagonal + usize::from(letter != other);
            diagonal = *above;
            left = replaced.min(left + 1).min(diagonal + 1);
            *above = left;
        }
        if let Some(first) = row.first_mut() {
            *first = index + 1;
        }
    }
    row.last().copied().unwrap_or_default()
}

impl Material {
    /// The key of the set that this one is a second opinion on; its own if it is on none.
    fn first_key(&self) -> &'static str {
        match self.key().split_once('_') {
            Some((first, _)) if ALL.into_iter().any(|other| other.key() == first) => first,
            _ => self.key(),
        }
    }

    /// Other sets of the same material, of metals and of transparent media.
    ///
    /// ```
    /// use brdf::materials::find;
    ///
    /// let water = find("water")?;
    /// assert_eq!(water.name(), "Water (Hale & Querry 1973)");
    /// assert!(water.alternatives().map(|other| other.key()).eq(["water_daimon"]));
    /// # Ok::<(), brdf::materials::LookupError>(())
    /// ```
    pub fn alternatives(&self) -> impl Iterator<Item = &'static Self> {
        let (key, first) = (self.key(), self.first_key());
        ALL.into_iter().filter(move |other| other.first_key() == first && other.key() != key)
    }
}
