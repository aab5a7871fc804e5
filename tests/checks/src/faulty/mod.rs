//! A number that errs: `f64`, but for one place of the source where an operation gives a wrong
//! result on purpose.
//!
//! Every formula of the crate is written over any number, and every operation of this one asks
//! where in the source it was called from. So a bug is seeded without a trace in the crate: the
//! place is data, and the fault is active only on the thread and for the time that it is armed.

mod model;
mod number;
pub mod place;
mod source;
mod vector;

pub use model::Seeded;
pub use number::Faulty;
pub use place::{Fault, Operation, Place, Wrong, armed, record};
pub use source::source;
pub use vector::FaultyVector;
