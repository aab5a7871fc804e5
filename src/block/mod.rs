//! The loops behind batches: slices of directions in and out, block by block, compiled for several
//! instruction sets. They run formulas and know no model.

mod error;
pub(crate) mod formula;
mod input;
mod instruction_set;
mod output;
pub(crate) mod parts;
pub(crate) mod planes;
pub(crate) mod run;
pub(crate) mod values;

pub use error::BatchError;
pub use input::{Directions, Uniforms};
pub use instruction_set::InstructionSet;
pub use output::{ColorBuffer, DirectionBuffer, SampleBuffer};
