//! The loop behind batches: slices of directions in and out, block by block, compiled for several
//! instruction sets. It runs formulas and knows no model.

mod error;
mod input;
mod instruction_set;
mod output;
mod planes;
mod run;

pub use error::BatchError;
pub(crate) use input::{Cosines, Draws, Normals, Pairs};
pub use input::{Directions, Uniforms};
pub use instruction_set::InstructionSet;
pub(crate) use output::Numbers;
pub use output::{BsdfSampleBuffer, ColorBuffer, DirectionBuffer, SampleBuffer};
pub use planes::{
    BLOCK, Block, ColorBlock, CosineBlock, DirectionBlock, DrawBlock, EventBlock, PairBlock, Plane,
    SampleBlock, UniformBlock,
};
#[cfg(feature = "rayon")]
pub(crate) use run::{Input, Output};
pub(crate) use run::{check, run};
