//! Shadowing and masking of light that crosses a rough interface.

use super::beta::scaled_beta;
use crate::direction::Pair;
use crate::distribution::Smith;
use crate::microfacet::{Kinks, Shadowing, SmithCorrelated, SmithSeparable};
use crate::real::{Real, lift};

/// Shadowing of which it is known how it acts on light that is refracted, seen from one side and lit
/// from the other.
pub trait RefractedShadowing<T: Real, D: Smith<T>>: Shadowing<T, D> {
    /// G/(G₁(wi) G₁(wo)) for refracted light, of (1 + Λ(wi), 1 + Λ(wo)), each at most 10⁹: in 0 … 1.
    fn refracted(&self, one_and_lambda: [T; 2]) -> T;
}

/// G = B(1 + Λ(wi), 1 + Λ(wo)), Euler's beta function: a facet that is high is seen from above, and
/// hidden from below.
impl<T: Real, D: Smith<T>> RefractedShadowing<T, D> for SmithCorrelated {
    #[inline(always)]
    fn refracted(&self, [x, y]: [T; 2]) -> T {
        scaled_beta(x, y)
    }
}

impl<T: Real, D: Smith<T>> RefractedShadowing<T, D> for SmithSeparable {
    #[inline(always)]
    fn refracted(&self, _: [T; 2]) -> T {
        T::one()
    }
}

/// Either kind of Smith's shadowing, chosen at run time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AnySmith {
    /// [`SmithCorrelated`].
    #[default]
    Correlated,
    /// [`SmithSeparable`].
    Separable,
}

lift!(AnySmith);

impl From<SmithCorrelated> for AnySmith {
    fn from(_: SmithCorrelated) -> Self {
        Self::Correlated
    }
}

impl From<SmithSeparable> for AnySmith {
    fn from(_: SmithSeparable) -> Self {
        Self::Separable
    }
}

macro_rules! either {
    ($any:expr, $one:ident => $result:expr) => {
        match $any {
            AnySmith::Correlated => {
                let $one = SmithCorrelated;
                $result
            }
            AnySmith::Separable => {
                let $one = SmithSeparable;
                $result
            }
        }
    };
}

impl<T: Real, D: Smith<T>> Shadowing<T, D> for AnySmith {
    #[inline(always)]
    fn visibility(&self, distribution: &D, pair: &Pair<T>) -> T {
        either!(self, one => one.visibility(distribution, pair))
    }

    #[inline(always)]
    fn masking(&self, distribution: &D, pair: &Pair<T>) -> T {
        either!(self, one => one.masking(distribution, pair))
    }

    #[inline(always)]
    fn unshadowed(&self, distribution: &D, pair: &Pair<T>) -> T {
        either!(self, one => one.unshadowed(distribution, pair))
    }

    #[inline(always)]
    fn sample_visible(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        distribution.sample_visible(wo, u)
    }

    #[inline(always)]
    fn sample_visible_along(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        distribution.sample_visible_along(wo, u)
    }

    fn kinks(&self, _: &D) -> Option<Kinks> {
        Some(Kinks::None)
    }
}

impl<T: Real, D: Smith<T>> RefractedShadowing<T, D> for AnySmith {
    #[inline(always)]
    fn refracted(&self, one_and_lambda: [T; 2]) -> T {
        either!(self, one => RefractedShadowing::<T, D>::refracted(&one, one_and_lambda))
    }
}
