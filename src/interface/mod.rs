//! Surfaces over the whole sphere of directions: interfaces between two media, mirrors, and what makes
//! a [`Brdf`](crate::Brdf) a [`Bsdf`](crate::Bsdf).

mod opaque;
mod side;
mod smooth;
mod thin;
mod two_sided;

pub use opaque::Opaque;
pub use smooth::SmoothDielectric;
pub use thin::ThinDielectric;
pub use two_sided::TwoSided;
