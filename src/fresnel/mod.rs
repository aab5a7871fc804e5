//! Reflectance of a smooth surface.
//!
//! [`Dielectric`] and [`Conductor`] are Fresnel's equations, exact, [`Stack`] those of coherent films, and
//! [`BelcourBarla`] the colour of a film over the whole spectrum; [`Schlick`], [`GeneralSchlick`],
//! [`Hall`] and [`Cook`] approximate them from the colour at normal incidence. [`forms`] has the equations as
//! they are printed in textbooks.

mod amplitudes;
mod any;
mod belcour_barla;
mod conductor;
mod constant;
mod dielectric;
pub mod forms;
mod general_schlick;
mod interpolation;
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
pub(crate) use dielectric::{average as dielectric_average, split, split_polarized};
pub use general_schlick::GeneralSchlick;
pub use interpolation::{Cook, Hall};
pub use normal_incidence::{index_from_normal_incidence, normal_incidence};
pub use schlick::Schlick;
pub use stack::Stack;
pub use term::Fresnel;
