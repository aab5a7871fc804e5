//! Two directions on different sides of a rough interface, and the facet that refracts one into the
//! other.

use crate::direction::off_surface;
use crate::real::{Mask, Real, Vector};

/// A pair of directions on different sides, and the facet between them. The same for light in either
/// direction, to the last bit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing<T: Real> {
    /// The direction above the surface.
    pub(super) above: T::Vec3,
    /// The mirror image of the direction below.
    pub(super) below: T::Vec3,
    /// The normal of the facet, above the surface.
    pub(super) h: T::Vec3,
    /// The cosine of the angle on the facet of the direction above.
    pub(super) cos_above: T,
    /// cosine above times cosine below over |M|², M = `above` + n · direction below: what of the density
    /// of facets comes into that of directions.
    pub(super) spread: T,
    /// Where a facet refracts one direction into the other.
    pub(super) exists: T::Mask,
}

impl<T: Real> Crossing<T> {
    /// Of the index below over that above.
    ///
    /// With q = 1 + a·b = |a + b|²/2 for a above and b below, and d = n − 1, no difference of near
    /// numbers is left but those of the directions: M = (a + b) + d b, a·M = n q − d, b·M = q + d.
    #[inline(always)]
    pub(super) fn new(wi: T::Vec3, wo: T::Vec3, ior: T) -> Self {
        let (zero, one) = (T::zero(), T::one());
        let normal = <T::Vec3 as Vector<T>>::new(zero, zero, one);
        let from_below = wo.z().lt(zero);
        let above: T::Vec3 = Vector::select(from_below, wi, wo);
        let below: T::Vec3 = Vector::select(from_below, wo, wi);
        let apart = off_surface::<T, _>(wi)
            .and(off_surface::<T, _>(wo))
            .and(above.z().gt(zero))
            .and(below.z().lt(zero));
        let above = Vector::select(apart, above, normal);
        let below = Vector::select(apart, below, -normal);

        let difference = ior - one;
        // The facet's normal points to the rarer medium.
        let turned = T::select(difference.lt(zero), one, -one);
        let contrast = difference.abs();
        let sum: T::Vec3 = above + below;
        let q = Vector::length_squared(sum) * T::lit(0.5);
        let m: T::Vec3 = (sum + below * difference) * turned;
        let length_squared = Vector::length_squared(m).max(T::lit(1e-36));
        let inverse = one / length_squared.sqrt();
        let h = m * inverse;
        let cos_above = (contrast + turned * (ior * q)) * inverse;
        let cos_below = (contrast - turned * q) * inverse;
        let exists = apart
            .and(contrast.gt(zero))
            .and(h.z().gt(zero))
            .and(cos_above.gt(zero))
            .and(cos_below.gt(zero));
        let cos_above = T::select(exists, cos_above.at_most(one), one);
        let cos_below = T::select(exists, cos_below.at_most(one), one);
        Self {
            above,
            below: Vector::new(below.x(), below.y(), -below.z()),
            h: Vector::select(exists, h, normal),
            cos_above,
            spread: cos_above * cos_below * (inverse * inverse),
            exists,
        }
    }
}
