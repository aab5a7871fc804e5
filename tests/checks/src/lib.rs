//! What the tests, benches and examples of the crate share: the registry of models, what can be
//! measured of them, and what must hold of it.
//!
//! Models are compiled here, once for each kind of number; the programs that ask them get objects.

pub mod directions;
pub mod distributions;
pub mod faulty;
pub mod fits;
pub mod interfaces;
pub mod measure;
pub mod models;
pub mod mutation;
pub mod slopes;
pub mod sound;
pub mod tables;
pub mod traced;
pub mod values;

use std::path::{Path, PathBuf};

/// A file of the repository.
pub fn path(relative: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(relative)
}

/// The text of a file of the repository.
///
/// # Panics
/// If there is no such file.
pub fn text(relative: &str) -> String {
    let read = std::fs::read_to_string(path(relative));
    read.unwrap_or_else(|error| panic!("{relative}: {error}"))
}
