//! Models as data: what is read, what is built, what is refused.

#[path = "../common/mod.rs"]
mod common;

mod bounds;
mod build;
mod forms;
mod refusals;
mod tables;
