//! Surfaces of many small mirrors: distribution of their normals, shadowing, reflection.

mod beckmann;
mod blinn;
mod blinn_1977;
mod cook_torrance;
mod distribution;
mod facets;
mod gaussian;
mod gaussian_tilts;
mod ggx;
mod historical;
pub(crate) mod mixture;
mod normal_slopes;
mod roughness;
mod shadowing;
mod smith;
mod v_cavity;

pub use beckmann::Beckmann;
pub use blinn::Blinn;
pub use blinn_1977::Blinn1977;
pub use cook_torrance::CookTorrance;
pub use distribution::{Distribution, Smith};
pub use gaussian::Gaussian;
pub use ggx::Ggx;
pub use historical::{Blinn1977Printed, CookTorrance1982Printed};
pub use mixture::Mixture;
pub use shadowing::Shadowing;
pub use smith::{SmithCorrelated, SmithSeparable};
pub use v_cavity::VCavity;
