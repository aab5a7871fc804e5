//! Surfaces of many small mirrors: distribution of their normals, shadowing, reflection.

mod distribution;
mod shadowing;

pub use distribution::{Distribution, Smith};
pub use shadowing::Shadowing;
