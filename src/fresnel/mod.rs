//! Reflectance of a smooth surface.
//!
//! [`Dielectric`] and [`Conductor`] are Fresnel's equations, exact, [`Gulbrandsen`] those of an artist's metal, [`Stack`] those of coherent films, and
//! [`BelcourBarla`] the colour of a film over the whole spectrum; [`Schlick`], [`GeneralSchlick`],
//! [`Lazanyi`], [`F82`], [`F82Tint`], [`Hall`] and [`Cook`] approximate them from the colour at normal incidence. [`forms`] has the equations as
//! they are printed in textbooks.

mod amplitudes;
mod any;
mod belcour_barla;
mod clamped;
mod conductor;
mod constant;
mod dielectric;
mod f82;
pub mod forms;
mod general_schlick;
mod gulbrandsen;
mod interpolation;
mod lazanyi;
mod normal_incidence;
mod schlick;
mod stack;
mod term;

pub use crate::polarization::Polarized;
pub use amplitudes::PolarizedFresnel;
pub use any::AnyFresnel;
pub use belcour_barla::BelcourBarla;
#[cfg(feature = "serde")]
pub(crate) use belcour_barla::xyz_in_linear_srgb;
pub use conductor::{Conductor, conductor_polarized};
pub use constant::Constant;
pub use dielectric::{Dielectric, dielectric_polarized};
pub(crate) use dielectric::{average as dielectric_average, part, split, split_polarized};
pub use f82::{F82, F82Tint};
pub use general_schlick::GeneralSchlick;
pub use gulbrandsen::Gulbrandsen;
pub use interpolation::{Cook, Hall};
pub use lazanyi::Lazanyi;
pub use normal_incidence::{index_from_normal_incidence, normal_incidence};
pub use schlick::Schlick;
pub use stack::Stack;
pub use term::Fresnel;
