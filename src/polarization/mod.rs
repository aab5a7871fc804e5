//! Polarised light: amplitudes of boundaries and films, Jones and Mueller calculus.
//!
//! [`Interface`] is the boundary of two media, [`Layers`] a coherent stack of films, [`Plates`] a pile
//! of thick plates. The first two answer with [`Amplitudes`]. [`Jones`] and [`Mueller`] are what
//! optical elements do to the field of a wave and to light of any state, which [`Stokes`] describes;
//! `Mueller` and `Stokes` turn into glam's `Mat4` and `Vec4`, `DMat4` and `DVec4`.
//!
//! # Conventions
//! For a ray with the propagation direction k, at a surface with the normal N:
//!
//! ```text
//!                N
//!    ↘ k         ↑          ↗ k'          ŝ = k × N/|k × N|     p̂ = k × ŝ
//!      ↘         │        ↗
//!     ⊙ŝ ↘       │      ↗ ⊙ŝ'             so that (ŝ, p̂, k) is right-handed, before and
//!   p̂ ↙    ↘     │    ↗    ↘ p̂'           after; ⊙ points out of the page. At normal
//!            ↘   │  ↗                     incidence p̂' = −p̂, and so r_p = −r_s.
//!              ↘ │↗              n₁
//!  ──────────────┼────────────────        E = E_s ŝ + E_p p̂, time factor e^(−iωt)
//!                │↘              n₂       n + ik, where k ≥ 0 absorbs
//!                │  ↘
//!                │ ⊙ŝ" ↘                  I = |E_s|² + |E_p|²    Q = |E_s|² − |E_p|²
//!                │p̂" ↙  ↘ k"              U = 2 Re(E_s E_p*)    V = 2 Im(E_s* E_p)
//! ```
//!
//! Where k is parallel to N, ŝ is +y of the shading frame. V > 0 is positive helicity, E = (1, i)/√2.
//! Azimuths count from s towards p. Matrices act from the left, so that a chain of elements is their
//! product from right to left.
//!
//! ```
//! use brdf::polarization::{Complex, Interface, Jones, Stokes};
//! use std::f64::consts::FRAC_PI_4;
//!
//! // Fresnel's rhomb: two total reflections in glass make linear light circular.
//! let inside = Interface::new(Complex::real(1.51_f64), Complex::real(1.0))?;
//! let turn = inside.amplitudes(54.62_f64.to_radians().cos()).mueller_reflection();
//! let light = turn * (turn * Stokes::linear(1.0, FRAC_PI_4));
//! assert!((light.v.abs() - 1.0).abs() < 1e-5);
//! # Ok::<(), brdf::ParameterError>(())
//! ```

mod amplitude;
mod amplitudes;
mod bounces;
mod coherent;
mod complex;
mod interface;
mod jones;
mod medium;
mod mueller;
mod plates;
mod polarized;
mod stokes;
mod wave;

pub use amplitudes::Amplitudes;
pub(crate) use bounces::Bounces;
#[cfg(feature = "serde")]
pub(crate) use coherent::check_count;
pub use coherent::{Layer, Layers, MAX_LAYERS};
pub use complex::Complex;
pub use interface::Interface;
pub use jones::Jones;
pub(crate) use medium::check_index;
pub use mueller::Mueller;
pub use plates::{Incoherent, MAX_PLATES, Plates};
pub use polarized::Polarized;
pub use stokes::Stokes;
