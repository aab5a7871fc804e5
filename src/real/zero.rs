//! Zero without a sign.

use super::traits::{Color, Real};

/// The colour with 0 where it is −0, which lies in every range that begins at 0: no answer made of
/// it has a sign. All other values keep their bits.
#[inline(always)]
pub(crate) fn positive_zero<T: Real, C: Color<T>>(color: C) -> C {
    color.map(|value| value + T::zero())
}
