//! Surfaces of many small mirrors: distribution of their normals, shadowing, reflection.

mod beckmann;
mod distribution;
mod ggx;
mod normal_slopes;
mod roughness;
mod shadowing;

pub use beckmann::Beckmann;
pub use distribution::{Distribution, Smith};
pub use ggx::Ggx;
pub use shadowing::Shadowing;
