//! Weighted sums of models.

mod terms;
mod two;
mod weighted;

pub use two::SumOfTwo;
pub use weighted::WeightedSum;
