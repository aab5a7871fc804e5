//! Distributions of facet normals: how the small mirrors of a rough surface are tilted.

mod any;
mod any_mixture;
mod beckmann;
mod blinn;
mod blinn_1977;
mod gaussian;
mod gaussian_tilts;
mod ggx;
mod gtr;
mod mixture;
mod normal_slopes;
mod roughness;
mod scales;
mod spread;
mod student_t;
mod traits;

pub use any::{AnyDistribution, AnyMixture};
pub(crate) use any::{each_distribution, each_single_smith, each_smith};
pub use beckmann::Beckmann;
pub use blinn::Blinn;
pub use blinn_1977::Blinn1977;
pub use gaussian::Gaussian;
pub use ggx::Ggx;
pub use gtr::Gtr;
pub use mixture::Mixture;
pub use scales::{alpha_of_pbrt_roughness, alpha_of_perceptual_roughness};
pub(crate) use spread::{Spread, Tilt, asinh, sinh};
pub use student_t::StudentT;
pub use traits::{Distribution, Smith};
