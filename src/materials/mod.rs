//! Refractive indices of metals, alloys, semiconductors and transparent media over the wavelength:
//! measured ones, and one's own.
//!
//! There are 74 sets of the complex index n + ik against the wavelength, from the ultraviolet to the near
//! infrared, each with its source. They come from the refractiveindex.info database
//! (commit ff11b5897ef0 of 2026-06-14), which is in the public domain (CC0 1.0); the sources in
//! [`Material::citation`] deserve to be cited. Each set is a static of its own: a program carries
//! only the sets that it names, all of them (118 kB) if it uses [`find`] or [`ALL`], and nothing
//! if it uses none.
//!
//! ```
//! use brdf::materials::{self, GOLD};
//! use brdf::{Beckmann, Brdf, Conductor, CookTorrance, Fresnel, Spectrum};
//! use glam::{DVec3, Vec3};
//!
//! // Red, green and blue as three wavelengths in nanometres.
//! let gold: Conductor<Vec3> = GOLD.conductor(Vec3::new(650.0, 550.0, 450.0))?;
//! assert!(gold.reflectance(1.0_f32).abs_diff_eq(Vec3::new(0.956522, 0.791553, 0.408194), 1e-6));
//!
//! // The index by itself, at one wavelength.
//! let silver = materials::find("silver")?;
//! let index = silver.refractive_index(550.0_f64)?;
//! assert!((index.eta - 0.0596).abs() < 1e-4 && (index.k - 3.5974).abs() < 1e-4);
//!
//! // A rough surface at eight wavelengths at once.
//! let wavelengths = Spectrum([400.0, 450.0, 500.0, 550.0, 600.0, 650.0, 700.0, 750.0]);
//! let copper = materials::find("Cu")?.conductor(wavelengths)?;
//! let f = CookTorrance::new(Beckmann::new(0.3)?, copper).eval(DVec3::Z, DVec3::Z);
//! assert!(f.0[7] > 1.5 * f.0[0]);
//!
//! // Beyond its measured range a material has no index.
//! let error = GOLD.refractive_index(250.0_f64).unwrap_err();
//! assert_eq!(error.to_string(), "wavelength must be between 292.4 and 1088, not 250");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Materials of one's own
//! [`OpticalConstants`] are made of samples, or of the text of a file: a table with commas, or a record of
//! the refractiveindex.info database. They need no feature; the built-in sets are the feature
//! `materials`. A [`Material`] hands out the same methods:
//!
//! ```
//! use brdf::materials::{GOLD, OpticalConstants};
//!
//! fn red(metal: &OpticalConstants) -> Result<f64, brdf::ParameterError> {
//!     Ok(metal.refractive_index(650.0)?.k)
//! }
//!
//! let own = OpticalConstants::from_csv("wavelength_nm,n,k\n600,0.2,3\n700,0.1,4\n")?;
//! assert_eq!(red(&own)?, 3.5);
//! assert!((red(&GOLD)? - 3.6024).abs() < 1e-4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Under another medium
//! [`conductor`](OpticalConstants::conductor) and [`dielectric`](OpticalConstants::dielectric) are seen from
//! air, whose index counts as 1. Under water, or under a coat, the index that matters is the relative one:
//! [`conductor_in`](OpticalConstants::conductor_in) and [`dielectric_in`](OpticalConstants::dielectric_in).
//!
//! # Second opinions
//! Measurements of one metal differ by how it was made, polished and oxidised. Where the
//! collection holds two sets, of a metal or of a transparent medium, the key without an author and
//! the plain name mean one of them, and its documentation says whose it is; the other has the
//! author in its key. The rays of a crystal are no opinions. [`GOLD`] is Johnson and
//! Christy 1972, [`GOLD_MCPEAK_2015`] an evaporated film that reflects more red and green.
//! [`Material::alternatives`] lists them.
//!
//! # Limits
//! Some sets count n and the wavelength from vacuum, others, as those of Schott's glasses and of
//! most crystals, from air. The difference, 2.8·10⁻⁴ of the value, is below that between two
//! measurements. [`TANTALUM`] and [`ZINC`] are not to be used for colour: they have
//! [`Kind::Caution`], and [`Material::remark`] and their pages say what is wrong with them.
//! Crystals have one set for the ordinary and one for the extraordinary ray.

mod constants;
#[cfg(feature = "materials")]
mod lookup;
#[cfg(feature = "materials")]
mod material;
#[cfg(feature = "materials")]
mod packed;
#[cfg(feature = "materials")]
#[rustfmt::skip]
mod sets;
mod text;

pub use constants::{OpticalConstants, RefractiveIndex, Sample};
#[cfg(feature = "materials")]
pub use lookup::{LookupError, find};
#[cfg(feature = "materials")]
pub use material::{Form, Kind, Material};
#[cfg(feature = "materials")]
pub use sets::*;
pub use text::{TextError, TextProblem};
