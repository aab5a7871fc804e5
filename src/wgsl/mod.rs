//! Models as the text of shaders, in WGSL.

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
mod value;
mod vector;

pub use error::ShaderError;
pub use expr::{Expr, ExprMask};
pub use function::{Answer, Argument, Arguments};
pub use module::Module;
pub use parameters::{Binding, Field, Parameters, Uniforms};
pub use vector::ExprVec3;
