//! What holds of every model of the registry, `tests/registry.jsonl`, and of the formulas it is made
//! of.

mod albedo;
mod batch;
mod derivatives;
mod energy;
mod interfaces;
mod mutants;
mod numbers;
mod precision;
mod reciprocity;
mod registry;
mod robustness;
mod sampling;
mod values;
mod wave;
