// The labels of links and pictures are defined in front of the page, see `guide`.
#![cfg_attr(all(doc, not(doctest)), doc = include_str!("guide/links.md"))]
#![cfg_attr(all(doc, not(doctest)), doc = include_str!("guide/pictures.md"))]
#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]
#![warn(unreachable_pub, clippy::unwrap_used, clippy::expect_used, clippy::panic)]
#![cfg_attr(not(feature = "std"), no_std)]

extern crate alloc;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("brdf needs the feature `std` or the feature `libm`");

mod any;
pub mod batch;
mod block;
mod brdf;
mod bsdf;
pub mod colorimetry;
#[cfg(feature = "serde")]
pub mod description;
pub mod diffuse;
mod direction;
pub mod distribution;
mod error;
#[cfg(feature = "fit")]
pub mod fit;
mod frame;
pub mod fresnel;
pub mod glossy;
mod gradient;
#[cfg(doc)]
pub mod guide;
pub mod interface;
pub mod materials;
pub mod microfacet;
pub mod parameter;
pub mod planetary;
pub mod polarization;
mod polarized_brdf;
pub mod principled;
pub mod quadrature;
mod real;
mod sampling;
mod sum;
pub mod wave;
#[cfg(feature = "wgsl")]
pub mod wgsl;

/// The vectors and colours of `f32` and `f64`, in the version that this crate uses.
pub use glam;

pub use any::{AnyBrdf, AnyCookTorrance};
pub use brdf::{Brdf, Sample};
pub use bsdf::{Bsdf, BsdfSample, Lobe, Lobes, Power, TransportMode};
pub use colorimetry::{Illuminant, Observer};
pub use diffuse::{Eon, Fon, Fujii, Lambert, OrenNayar, OrenNayarFull};
pub use direction::{
    Pair, Refraction, above_surface, both_above, brewster_angle, check_direction, critical_angle,
    from_spherical, off_surface, reflect, refract, to_spherical,
};
pub use distribution::{
    AnyDistribution, AnyMixture, Beckmann, Blinn, Blinn1977, Distribution, Gaussian, Ggx, Gtr,
    Mixture, Smith, StudentT,
};
pub use error::{ParameterError, Range};
pub use frame::Frame;
pub use fresnel::{
    AnyFresnel, BelcourBarla, Conductor, Constant, Cook, Dielectric, F82, F82Tint, Fresnel,
    GeneralSchlick, Gulbrandsen, Hall, Lazanyi, Schlick, Stack,
};
pub use glossy::{
    AshikhminShirley, BlinnPhong, ClassicPhong, Lafortune, LafortuneLobe, Phong, Schlick1994,
    Schlick1994Layer, SchlickPower, SchlickShadowing, Ward, WardForm,
};
pub use gradient::{Differentiated, Gradient, gradient};
pub use interface::{
    AnyBsdf, AnySmith, Mirror, Opaque, Plastic, RefractedShadowing, RetroReflector,
    RoughDielectric, SmoothDielectric, SplitSchlick1994, ThinDielectric, TwoSided,
};
pub use microfacet::{
    AnyShadowing, Blinn1977Printed, CookTorrance, CookTorrance1982Printed, DefaultShadowing,
    Scaled, Shadowing, SmithCorrelated, SmithSeparable, VCavity,
};
pub use parameter::Parameter;
pub use planetary::{HFunction, Hapke, LommelSeeliger, Minnaert};
pub use polarized_brdf::PolarizedBrdf;
pub use principled::{Disney2012, DisneyForm, DisneyParameters};
pub use real::{Color, Dual, Lanes, Lift, Mask, Real, Spectrum, Vector, Vector3};
pub use sum::{SumOfTwo, WeightedSum};
pub use wave::{BeckmannKirchhoff, He1991, Masking};
