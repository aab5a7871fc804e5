//! No NaN, no infinity, nothing negative and no panic, whatever the input.

mod colors;
mod geometry;
mod inputs;
mod models;
mod parameters;
mod parts;
mod uniforms;
