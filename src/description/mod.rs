//! Models as data: a scene file names a model and its parameters, and [`build`] makes the model.
//!
//! [`BrdfDescription`], [`BsdfDescription`], [`FresnelDescription`] and [`DistributionDescription`] can be read from and
//! written to every format of serde that describes itself and names its keys: JSON, RON, TOML, CBOR,
//! MessagePack with named fields. Formats without keys, as postcard and MessagePack's default, can
//! write them but not read them. YAML writes the name of a form as a tag: `!lambert {albedo: 0.5}`.
//!
//! The forms are externally tagged, in snake case. A colour C is `0.5` or `[r, g, b]`; a roughness R is `0.3` or
//! `[along_x, along_y]`. Where a value is shown for a key, the key may be left out and has that
//! value. Ranges are those of the type with the same name; [`forms`] has all names, ranges and
//! defaults as data.
//!
//! | Brdf B | |
//! |---|---|
//! | `{"lambert": {"albedo": C}}` | |
//! | `{"oren_nayar": {"albedo": C, "sigma": s, "interreflection": false}}` | sigma in radians |
//! | `{"phong": {"specular": C, "exponent": n, "normalized": true}}` | `false` for the highlight of 1975 over the cosine |
//! | `{"blinn_phong": {"specular": C, "exponent": n, "normalized": true}}` | `false` for the classic lobe |
//! | `{"schlick_power": {"specular": C, "exponent": n, "normalized": true}}` | `false` for the classic lobe |
//! | `{"minnaert": {"albedo": C, "k": k}}` | |
//! | `{"lommel_seeliger": {"w": C, "xi": 0}}` | below 0 grains scatter back |
//! | `{"cook_torrance": {"distribution": D, "fresnel": F, "shadowing": S}}` | S is `"smith"` (height-correlated) or `"smith_separable"`, both for Beckmann, GGX and mixtures of them, or `"v_cavity"`; the default is `"smith"` where it is known and `"v_cavity"` elsewhere |
//! | `{"torrance_sparrow_1967": {"c": c, "fresnel": F}}` | c in 1/degree |
//! | `{"cook_torrance_1982_printed": {"roughness": R, "fresnel": F}}` | |
//! | `{"blinn_1977_printed": {"distribution": W, "beta": b, "fresnel": F}}` | W is `"d1"`, `"d2"` or `"d3"`; beta in radians |
//! | `{"sum": [{"weight": C, "brdf": B}, …]}` | |
//!
//! | Bsdf, over the whole sphere | |
//! |---|---|
//! | every Brdf | zero below the surface |
//! | `{"mirror": {"fresnel": F}}` | one specular lobe; `{"constant": 1}` is the default |
//! | `{"plastic": {"diffuse": C, "ior": 1.5, "nonlinear": true}}` | Lambert's surface under a smooth dielectric, n ≥ 1, or measured: M |
//! | `{"beckmann_kirchhoff_1963": {"sigma": s, "correlation": t, "fresnel": F, "wavelength": [650, 550, 450]}}` | lengths in nanometres; F is `{"constant": 1}` by default |
//! | `{"he_1991": {"sigma": s, "correlation": t, "fresnel": F, "uniform_diffuse": 0, "masking": "corrected", "wavelength": [650, 550, 450]}}` | lengths in nanometres, the uniform part in sr⁻¹; the masking is also `"printed"` |
//! | `{"dielectric": {"ior": n}}` | a smooth interface; n is the index below over that above, or M |
//! | `{"thin_dielectric": {"ior": n}}` | a plane plate with all its internal reflections; n or M |
//! | `{"rough_dielectric": {"distribution": D, "ior": n, "shadowing": S}}` | n or M; D is `beckmann` or `ggx`, S `"smith"` (the default) or `"smith_separable"` |
//!
//! | Fresnel F | |
//! |---|---|
//! | `{"constant": C}` | same at all angles |
//! | `{"dielectric": {"ior": C}}` | relative index, transmitted over incident; below 1 is from inside; or measured: M, with `"outside"` |
//! | `{"conductor": {"eta": C, "k": C}}` | |
//! | `{"metal": "Au"}` | measured index at 650, 550 and 450 nm, by symbol or name (feature `materials`); `Ta` and `Zn` are accepted although their sets are not for colour; or M, with `"outside"` |
//! | `{"schlick": {"f0": C, "f90": 1, "exponent": 5}}` | reflectance at normal and at grazing incidence |
//! | `{"hall": {"f0": C, "ior": 1.5}}` | interpolation driven by the exact curve of the index; or of a conductor's, `[eta, k]` |
//! | `{"cook": {"f0": C, "light": C, "ior": 1.5}}` | likewise; contains the light |
//! | `{"stack": {"outside": 1, "layers": [{"index": I, "thickness": d}, …], "substrate": I, "wavelength": [650, 550, 450]}}` | coherent films, at most 64, lengths in nanometres |
//! | `{"belcour_barla": {"film": n, "thickness": d, "substrate": I, "outside": 1}}` | a film over the whole spectrum; the index of the substrate is the same in all channels |
//!
//! An index I is `n`, or `[n, k]`, or `{"eta": C, "k": C}` for each channel, or measured: M.
//!
//! M is the index of a material at the wavelengths of the channels, `{"material": "Au"}` (feature
//! `materials`), or that of samples, `{"samples": [[λ, n, k], …]}`: at least two, λ in nanometres and each
//! above the one before it, as [`OpticalConstants`](crate::materials::OpticalConstants). In
//! `metal` and in the Fresnel term `dielectric` the light may come from a transparent medium other than air:
//! `{"metal": {"material": "Au", "outside": 1.33}}`, `{"dielectric": {"ior": {"material": "BK7",
//! "outside": {"material": "water"}}}}`. Outside is a colour C or M, 1 by default. An index `ior` is
//! that of a transparent medium: k is at most 10⁻³, and left out.
//!
//! # Wavelengths
//! [`build`] makes models of three channels, red, green and blue, at 650, 550 and 450 nm.
//! [`build_spectrum`](BrdfDescription::build_spectrum) makes them at any wavelengths, with the index of
//! every material at each of them.
//!
//! | Distribution D | |
//! |---|---|
//! | `{"gaussian": {"roughness": m}}` | the same in all directions |
//! | `{"beckmann": {"roughness": R}}`, `{"ggx": {"roughness": R}}` | |
//! | `{"blinn": {"exponent": n}}` | |
//! | `{"mixture": [{"weight": w, "distribution": D}, …]}` | weights are divided by their sum |
//!
//! # Errors
//! Reading checks everything. An unknown, missing or repeated key, a wrong type and a value out of
//! range are errors that name the place; a value out of range names the range too:
//!
//! ```
//! use brdf::description::BrdfDescription;
//!
//! let error = |text| serde_json::from_str::<BrdfDescription>(text).unwrap_err().to_string();
//! assert_eq!(
//!     error(r#"{"cook_torrance": {"distribution": {"ggx": {"roughness": -1}},
//!                                 "fresnel": {"schlick": {"f0": 0.04}}}}"#),
//!     "cook_torrance.distribution.ggx.roughness must be between 1e-8 and 10000, not -1"
//! );
//! assert_eq!(
//!     error(r#"{"lambert": {"albedo": "white"}}"#),
//!     "lambert.albedo: invalid type: string \"white\", expected a number or a list of 3 numbers \
//!      at line 1 column 30"
//! );
//! ```
//!
//! The place is counted from the description: where that is a part of a structure of your own, the
//! path does not contain the keys that lead to it.
//!
//! Numbers are as exact as the format: `serde_json` reads every `f64` that it has written with its
//! feature `float_roundtrip`, and without it may be one unit in the last place off.
//!
//! # Bounds
//! At most [`MAX_DEPTH`] sums and mixtures stand inside each other, and all of them together have
//! at most [`MAX_TERMS`] terms; a description beyond that is an error before it is read further.
//! Samples of indices are at most [`MAX_SAMPLES`] altogether.
//! So a file from an unknown source can neither overflow the stack nor fill the memory, in any
//! format, and the cost of a model stays bounded. A format may have a narrower bound of its own: RON
//! stops at a depth of about 20 unless its option `recursion_limit` is raised.
//!
//! # Cost
//! What is built is one type for all forms, [`AnyBrdf`](crate::AnyBrdf): a call costs one predicted
//! `match` for the model and one for each of its parts, and a batch one for each block.
//!
//! [`build`]: BrdfDescription::build

mod bounds;
mod brdf;
mod bsdf;
mod build;
mod channels;
mod check;
mod described;
mod distribution;
mod error;
mod form;
mod fresnel;
mod index;
mod leaf;
mod measured;
mod numbers;
mod path;
mod place;
mod read;
mod value;
mod write;

pub use bounds::{MAX_DEPTH, MAX_SAMPLES, MAX_TERMS};
pub use described::{
    BrdfDescription, BsdfDescription, DistributionDescription, FresnelDescription,
};
pub use error::{DescriptionError, Problem};
pub use form::{Content, Form, forms};
pub use numbers::Number;
pub use path::Path;
