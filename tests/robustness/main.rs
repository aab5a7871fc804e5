//! No NaN, no infinity, nothing negative and no panic, whatever the input.

#[path = "../common/mod.rs"]
mod common;

mod geometry;
mod inputs;
mod models;
mod parameters;
mod uniforms;
