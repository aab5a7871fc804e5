//! Diffuse models: light that leaves in all directions.

mod clipped_cosine;
mod eon;
mod fon;
mod fujii;
mod grooves;
mod lambert;
mod oren_nayar;
mod oren_nayar_full;

pub use eon::Eon;
pub use fon::Fon;
pub use fujii::Fujii;
pub use lambert::Lambert;
pub use oren_nayar::OrenNayar;
pub use oren_nayar_full::OrenNayarFull;
