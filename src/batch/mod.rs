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
//! use brdf::{Brdf, Conductor, CookTorrance, Ggx, SmithCorrelated};
//! use glam::Vec3;
//!
//! let gold = CookTorrance::new(
//!     Ggx::new(0.3)?,
//!     Conductor::new(Vec3::new(0.143, 0.374, 1.442), Vec3::new(3.983, 2.386, 1.603))?,
//! )
//! .with_shadowing(SmithCorrelated);
//!
//! let wi: Vec<Vec3> = (0..1000).map(|i| Vec3::new(i as f32, 0.0, 500.0).normalize()).collect();
//! let wo = vec![Vec3::new(-0.48, 0.36, 0.8); 1000];
//! let mut values = vec![Vec3::ZERO; 1000];
//! gold.eval_batch((&wi).into(), (&wo).into(), (&mut values).into())?;
//! assert_eq!(values[7], gold.eval(wi[7], wo[7]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Layouts
//! Directions are vectors one after the other, or three slices of components, which is faster; one
//! direction may stand for all. Colours are written one after the other, or into a slice for each
//! channel. [`Directions`], [`Uniforms`], [`DirectionBuffer`] and [`ColorBuffer`] are made
//! with `into()`.
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
    BLOCK, BatchError, Block, ColorBlock, ColorBuffer, CosineBlock, DirectionBlock,
    DirectionBuffer, Directions, DrawBlock, InstructionSet, PairBlock, Plane, SampleBlock,
    SampleBuffer, UniformBlock, Uniforms,
};
pub use each::{eval_each, pdf_each, sample_each};
