//! Models as data: what is read, what is built, what is refused, and what the example `evaluate`
//! answers.

mod bounds;
mod build;
#[path = "../../examples/evaluate/command.rs"]
mod command;
mod evaluate;
mod forms;
#[path = "../../examples/evaluate/optics.rs"]
mod optics;
#[path = "../../examples/evaluate/question.rs"]
mod question;
mod refusals;
mod spectra;
#[path = "../../examples/evaluate/stream.rs"]
mod stream;
mod tables;
