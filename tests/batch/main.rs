//! Batches say what single calls say, bit for bit, on every instruction set of the machine.

#[path = "../common/mod.rs"]
mod common;

mod bits;
mod each;
mod errors;
mod parallel;
mod parts;
