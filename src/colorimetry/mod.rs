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
//! # One index per channel
//! Renderers often skip the spectrum and give red, green and blue one index each, that of 650,
//! 550 and 450 nm. The error of this shortcut for bare metals under D65, shortcut minus exact, in
//! red, green and blue at angles of incidence from normal to grazing:
//!
//! | metal | 0° | 30° | 60° | 75° | 85° | 89° |
//! |---|---|---|---|---|---|---|
//! | Silver | +0.000 −0.001 +0.003 | +0.000 −0.001 +0.003 | +0.001 −0.001 +0.003 | +0.001 −0.001 +0.002 | +0.001 −0.001 +0.001 | +0.000 −0.000 +0.000 |
//! | Aluminium | −0.002 −0.001 −0.000 | −0.002 −0.001 −0.000 | −0.002 −0.001 −0.000 | −0.003 −0.001 −0.001 | −0.004 −0.003 −0.003 | −0.002 −0.001 −0.001 |
//! | Gold | −0.081 +0.063 +0.044 | −0.080 +0.063 +0.043 | −0.068 +0.054 +0.039 | −0.046 +0.038 +0.029 | −0.020 +0.016 +0.014 | −0.005 +0.004 +0.004 |
//! | Copper | +0.003 +0.001 +0.016 | +0.004 +0.001 +0.016 | +0.006 +0.002 +0.015 | +0.002 +0.005 +0.013 | −0.005 +0.004 +0.008 | −0.002 +0.001 +0.002 |
//! | Brass (70% Cu, 30% Zn) | −0.023 +0.010 +0.011 | −0.022 +0.010 +0.011 | −0.019 +0.009 +0.011 | −0.012 +0.004 +0.009 | −0.005 +0.000 +0.005 | −0.001 −0.000 +0.001 |
//! | largest channel, largest of 36 | 0.085 | 0.084 | 0.073 | 0.063 | 0.036 | 0.009 |
//! | largest channel, mean of 36 | 0.013 | 0.013 | 0.011 | 0.009 | 0.005 | 0.002 |
//!
//! The last rows are over 36 sets: all metals, alloys and second opinions of the crate but those
//! not for colour. Of each the channel with the largest error counts; the rows give the largest and
//! the mean of that.
//! The error is that of the colour at normal incidence and fades towards grazing, where every
//! metal is white: small for grey metals, visible for gold, whose edge lies between two of the
//! wavelengths. Closer to the primaries of sRGB it is not smaller: with their dominant wavelengths,
//! 611, 549 and 464 nm, the mean is 0.023 at normal incidence.
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
