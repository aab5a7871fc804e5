//! What holds of every model of the registry, `tests/common/models`. One program, because building
//! all models takes longer than testing them.

#[path = "../common/mod.rs"]
mod common;

mod batch;
mod descriptions;
mod energy;
mod mutants;
mod numbers;
mod precision;
mod reciprocity;
mod registry;
mod robustness;
mod sampling;
