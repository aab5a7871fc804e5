//! Batches say what single calls say, bit for bit, on every instruction set of the machine.

mod bits;
mod bsdf;
mod each;
mod errors;
mod padding;
mod parallel;
mod parts;
