//! Many directions at once.
//!
//! [`Brdf::eval_batch`](crate::Brdf::eval_batch), [`pdf_batch`](crate::Brdf::pdf_batch),
//! [`eval_pdf_batch`](crate::Brdf::eval_pdf_batch) and
//! [`sample_batch`](crate::Brdf::sample_batch) run a model over slices, at the speed of SIMD code:
//! every model has them, boxed and described ones too, and those of other crates. They write into the
//! caller's memory and allocate none. Any length will do, but a model is asked for 128 elements at a
//! time: where there are fewer it is asked again for the first of them, and what it says is dropped.
//!
//! ```
//! use brdf::{Brdf, Conductor, CookTorrance, Ggx};
//! use glam::Vec3;
//!
//! let gold = CookTorrance::new(
//!     Ggx::new(0.3)?,
//!     Conductor::new(Vec3::new(0.143, 0.374, 1.442), Vec3::new(3.983, 2.386, 1.603))?,
//! );
//!
//! let wi: Vec<Vec3> = (0..1000).map(|i| Vec3::new(i as f32, 0.0, 500.0).normalize()).collect();
//! let wo = vec![Vec3::new(-0.48, 0.36, 0.8); 1000];
//! let mut values = vec![Vec3::ZERO; 1000];
//! gold.eval_batch((&wi).into(), (&wo).into(), (&mut values).into())?;
//! assert_eq!(values[7], gold.eval(wi[7], wo[7]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Models over the whole sphere, [`Bsdf`](crate::Bsdf), have the same batches, with the mode of transport
//! and three uniform numbers; what they sample goes to a [`BsdfSampleBuffer`].
//!
//! # Layouts
//! Directions are vectors one after the other, or three slices of components, which is faster; one
//! direction may stand for all. Colours are written one after the other, or into a slice for each
//! channel. [`Directions`], [`Uniforms`], [`DirectionBuffer`] and [`ColorBuffer`] are made
//! with `into()`.
//!
//! # Models of your own
//! A type with `eval`, `pdf` and `sample` has all batches. Its loops become SIMD code if all that the
//! three methods call is inlined into them: the methods themselves and every function between them and
//! this crate carry `#[inline(always)]`, since `#[inline]` is not enough; so do closures on the way. No
//! `if` on a value: a choice between two results is made by `select` or by an `if` around finished
//! values. The parts of this crate are ready for it. A model that consists of others, or that chooses
//! between formulas, overrides the block methods instead ([`eval_block`](crate::Brdf::eval_block) and its
//! like) and asks its parts block by block.
//!
//! ```
//! use brdf::{Brdf, CookTorrance, Fresnel, Ggx, Lambert, Pair, Sample, Schlick};
//! use glam::Vec3;
//!
//! /// A diffuse base that sees what a coat lets through.
//! struct Plastic {
//!     base: Lambert,
//!     schlick: Schlick,
//!     coat: CookTorrance<Ggx, Schlick>,
//! }
//!
//! impl Brdf for Plastic {
//!     type Color = Vec3;
//!
//!     #[inline(always)]
//!     fn eval(&self, wi: Vec3, wo: Vec3) -> Vec3 {
//!         let kept = Vec3::ONE - self.schlick.reflectance(Pair::new(wi, wo).cos_d);
//!         kept * self.base.eval(wi, wo) + self.coat.eval(wi, wo)
//!     }
//!
//!     #[inline(always)]
//!     fn pdf(&self, wi: Vec3, wo: Vec3) -> f32 {
//!         self.base.pdf(wi, wo) // sampled as the base is: simple, and noisy for smooth coats
//!     }
//!
//!     #[inline(always)]
//!     fn sample(&self, wo: Vec3, u: [f32; 2]) -> Sample<f32, Vec3> {
//!         let Sample { wi, pdf, .. } = self.base.sample(wo, u);
//!         let scale = if pdf > 0.0 { wi.z / pdf } else { 0.0 };
//!         Sample { wi, weight: self.eval(wi, wo) * scale, pdf }
//!     }
//! }
//!
//! let schlick = Schlick::new(Vec3::splat(0.04))?;
//! let base = Lambert::new(Vec3::new(0.8, 0.2, 0.1))?;
//! let plastic = Plastic { base, schlick, coat: CookTorrance::new(Ggx::new(0.3)?, schlick) };
//! let wi: Vec<Vec3> = (0..200).map(|i| Vec3::new(i as f32, 0.0, 50.0).normalize()).collect();
//! let mut values = vec![Vec3::ZERO; 200];
//! plastic.eval_batch((&wi).into(), Vec3::Z.into(), (&mut values).into())?;
//! assert_eq!(values[99], plastic.eval(wi[99], Vec3::Z));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Parameters that vary
//! [`eval_each`] and its like take a model for each element.
//!
//! # Instruction sets
//! With the feature `simd`, which is on by default, the formulas are compiled for several instruction
//! sets, and [`InstructionSet`] tells which one runs. Without it they are compiled for the target of
//! the build. All give the bits of the single calls.

mod each;
#[cfg(feature = "rayon")]
pub mod parallel;

pub use crate::block::{
    BLOCK, BatchError, Block, BsdfSampleBuffer, ColorBlock, ColorBuffer, CosineBlock,
    DirectionBlock, DirectionBuffer, Directions, DrawBlock, EventBlock, InstructionSet, PairBlock,
    Plane, SampleBlock, SampleBuffer, UniformBlock, Uniforms,
};
pub use each::{eval_each, eval_pdf_each, pdf_each, sample_each};
