//! Models as the text of shaders: whether it is valid, and what a device makes of it.

mod device;
mod ends;
mod gradients;
mod interfaces;
mod prelude;
mod text;
