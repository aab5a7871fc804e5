//! Surfaces of many small mirrors: distribution of their normals, shadowing, reflection.

mod beckmann;
mod cook_torrance;
mod distribution;
mod ggx;
mod normal_slopes;
mod roughness;
mod shadowing;
mod smith;
mod v_cavity;

pub use beckmann::Beckmann;
pub use cook_torrance::CookTorrance;
pub use distribution::{Distribution, Smith};
pub use ggx::Ggx;
pub use shadowing::Shadowing;
pub use smith::{SmithCorrelated, SmithSeparable};
pub use v_cavity::VCavity;
