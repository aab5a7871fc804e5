//! What the tests of shader text have: a validator, and a device that runs it.

pub mod device;
pub mod recorded;
pub mod validate;
