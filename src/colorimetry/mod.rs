//! Spectra to colours: the CIE 1931 standard observer, three illuminants, linear sRGB.
//!
//! An [`Observer`] looks at a reflecting surface under an [`Illuminant`]:
//!
//! ```text
//! X = Σ R(λ) S(λ) x̄(λ) / Σ S(λ) ȳ(λ)        Y, Z likewise with ȳ, z̄
//! ```
//!
//! | symbol | meaning |
//! |---|---|
//! | R | reflectance, 0 … 1 |
//! | S | relative spectral power of the illuminant |
//! | x̄, ȳ, z̄ | colour matching functions of the 2° observer |
//! | λ | 380, 385, … 780 nm |
//!
//! so that Y is the luminous reflectance and 1 for the perfect reflector. Linear sRGB follows by
//! the matrix of its primaries and its white D65.
//!
//! # Licence of the tables
//! [`COLOR_MATCHING`] and the powers of the illuminants are the tables of CIE 015 and CIE 018 as
//! shipped by colour-science 0.4.7, copyright 2013 Colour Developers, under the BSD 3-clause
//! licence: the file `LICENSE-BSD-3-Clause-colour-science` beside this crate's own licences.

mod illuminant;
mod matrix;
mod observer;
mod srgb;
#[rustfmt::skip]
mod tables;

pub use illuminant::Illuminant;
pub use observer::Observer;
pub use srgb::{clamp_to_srgb, linear_srgb_to_xyz, xyz_to_linear_srgb};
pub use tables::{COLOR_MATCHING, WAVELENGTHS};
