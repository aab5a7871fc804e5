//! The measured materials: what is embedded, what is read from it, and measured reality.

mod colours;
mod ellipsometry;
mod fresnel_reference;
mod generate;
mod lookup;
mod plausible;
mod samples;
mod shortcut;
#[path = "../common/tables.rs"]
mod tables;
