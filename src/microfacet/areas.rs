//! Shadowing and masking of a pair whose projected areas are known already: what remains of the
//! kinds of shadowing once a distribution has answered.

use crate::direction::Pair;
use crate::real::Real;

/// The formulas of [`Shadowing`](super::Shadowing) from the projected areas of `wi` and `wo`.
pub(super) trait Areas<T: Real> {
    /// Whether the formulas depend on the areas.
    const NEEDED: bool;

    fn visibility_of(areas: [T; 2], pair: &Pair<T>) -> T;
    fn masking_of(areas: [T; 2], pair: &Pair<T>) -> T;
    fn unshadowed_of(areas: [T; 2], pair: &Pair<T>) -> T;
}
