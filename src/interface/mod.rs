//! Surfaces over the whole sphere of directions: interfaces between two media, mirrors, and what makes
//! a [`Brdf`](crate::Brdf) a [`Bsdf`](crate::Bsdf).

mod any;
mod beta;
mod calls;
mod crossed;
mod drawn;
mod facet;
mod mirror;
mod opaque;
mod plastic;

mod retro_reflector;
mod rough;
mod scattered;
mod side;
mod smooth;
mod split_schlick;
mod thin;
mod two_sided;

pub use any::AnyBsdf;
pub use crossed::{AnySmith, RefractedShadowing};
pub use mirror::Mirror;
pub use opaque::Opaque;
pub use plastic::Plastic;
pub use retro_reflector::RetroReflector;
#[cfg(feature = "serde")]
pub(crate) use rough::ROUGH_IOR;
pub use rough::RoughDielectric;
pub use smooth::SmoothDielectric;
pub use split_schlick::SplitSchlick1994;
pub use thin::ThinDielectric;
pub use two_sided::TwoSided;
