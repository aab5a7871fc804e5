//! Surfaces of many small mirrors: shadowing of the facets, and their reflection.

mod any_shadowing;
mod areas;
mod cook_torrance;
mod directional_albedo;
mod groove_azimuth;
mod historical;
mod mixture_block;
mod planes;
mod polarized;
mod scaled;
mod shadowing;
mod smith;
mod usual;
mod v_cavity;

pub use any_shadowing::AnyShadowing;
pub use cook_torrance::CookTorrance;
pub(crate) use directional_albedo::over_facets;
pub use historical::{Blinn1977Printed, CookTorrance1982Printed};
pub(crate) use polarized::facet;
pub use scaled::Scaled;
pub(crate) use shadowing::Kinks;
pub use shadowing::Shadowing;
pub use smith::{SmithCorrelated, SmithSeparable};
pub use usual::DefaultShadowing;
pub use v_cavity::VCavity;
