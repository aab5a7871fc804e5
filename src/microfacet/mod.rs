//! Surfaces of many small mirrors: shadowing of the facets, and their reflection.

mod cook_torrance;
mod facets;
mod historical;
mod shadowing;
mod smith;
mod v_cavity;

pub use cook_torrance::CookTorrance;
pub use historical::{Blinn1977Printed, CookTorrance1982Printed};
pub use shadowing::Shadowing;
pub use smith::{SmithCorrelated, SmithSeparable};
pub use v_cavity::VCavity;
