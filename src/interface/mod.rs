//! Surfaces over the whole sphere of directions: interfaces between two media, mirrors, and what makes
//! a [`Brdf`](crate::Brdf) a [`Bsdf`](crate::Bsdf).

mod beta;
mod crossed;
mod crossing;
mod opaque;
mod rough;
mod side;
mod smooth;
mod thin;
mod two_sided;

pub use crossed::{AnySmith, RefractedShadowing};
pub use opaque::Opaque;
pub use rough::RoughDielectric;
pub use smooth::SmoothDielectric;
pub use thin::ThinDielectric;
pub use two_sided::TwoSided;
