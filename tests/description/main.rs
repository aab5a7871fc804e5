//! Models as data: what is read, what is built, what is refused.

mod bounds;
mod build;
mod forms;
mod refusals;
