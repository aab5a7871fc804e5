//! Numbers: the trait that formulas are written over, and the numbers they run on.

mod dual;
mod float;
mod inlining;
mod lanes;
mod lift;
mod math;
mod members;
mod spectrum;
mod traits;
mod vector3;
mod zero;

pub use dual::Dual;
pub(crate) use inlining::{call, in_place, iterate};
pub use lanes::Lanes;
pub use lift::Lift;
pub(crate) use lift::lift;
pub(crate) use math::ierfc;
pub(crate) use members::members;
pub use spectrum::Spectrum;
pub use traits::{Color, Mask, Real, Vector};
pub use vector3::Vector3;
pub(crate) use zero::positive_zero;
