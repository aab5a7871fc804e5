//! Diffuse models: light that leaves in all directions.

mod lambert;
mod oren_nayar;

pub use lambert::Lambert;
pub use oren_nayar::OrenNayar;
