//! Diffuse models: light that leaves in all directions.

mod lambert;

pub use lambert::Lambert;
