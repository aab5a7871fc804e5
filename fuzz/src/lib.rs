//! What the fuzz targets share: inputs made of arbitrary bytes, and what must hold of the answers.

pub mod geometry;
pub mod lanes;
pub mod models;
pub mod numbers;
#[path = "../../tests/checks/src/sound.rs"]
pub mod sound;
