//! Models as the text of shaders, in WGSL (feature `wgsl`).
//!
//! [`Expr`] is a number like `f32`: a model over it runs once on symbols, and what it does to them is
//! printed. [`Module`] is the text, and [the guide](crate::guide::shaders) shows how to use it.
//!
//! # Elementary functions
//! A shader's `exp` or `sin` may be off by thousands of roundings, so the crate's own functions for
//! `f32` come with the text, those that it uses. They are written so that compilers for graphics,
//! which take (x + y) − y for x, cannot undo them. The largest errors on Mesa's software device, in
//! units in the last place, for results that are normal numbers:
//!
//! | function | error | remarks |
//! |---|---|---|
//! | `exp`, `exp_m1` | 1.3 | |
//! | `ln` | 0.85 | the least number where there is none |
//! | `ln_1p` | 1.4 | the same |
//! | `powf` | 1.6 | up to \|y\| = 40; 4.5 beyond. A negative base counts as 0 |
//! | `sin`, `cos` | 1.1 | for \|x\| ≤ 10⁴ |
//! | `sin_cos_turns` | 2.2 | for \|x\| ≤ 10⁶ |
//! | `tan` | 3.0 | for \|x\| ≤ 10⁴ |
//! | `asin` | 2.2 | |
//! | `acos` | 1.25 | |
//! | `angle_squared` | 1.0 | for 0 ≤ x ≤ 1 |
//! | `atan2` | 1.6 | |
//! | `erf` | 2.0 | |
//! | `erfc` | 5.0 | |
//! | `decay`, `erfcx`, `ierfc`, `power_of_part` | | as in `f32` |
//! | `erf_inv` | 3.5 | |
//! | `rsqrt` | 1.5 | |
//!
//! Quotients and square roots are those of the device. One that rounds them worse than by half a
//! unit, or takes subnormal numbers for 0, as the language allows, adds its own errors.

#[cfg(feature = "serde")]
mod described;
mod error;
mod expr;
mod function;
mod graph;
mod literal;
mod module;
mod name;
mod parameters;
mod prelude;
mod print;
mod simplify;
#[cfg(test)]
mod tests;
mod traced;
mod value;

pub use error::ShaderError;
pub use expr::{Expr, ExprMask, ExprVec3};
pub use function::{Answer, Argument, Arguments};
pub use module::Module;
pub use parameters::{Binding, Field, Parameters, Uniforms};
