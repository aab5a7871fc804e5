//! Two directions off a rough interface, and the facet that mirrors or refracts one into the other.

use crate::direction::{Pair, facing, least_height, off_surface};
use crate::real::{Mask, Real, Vector};

/// A pair of directions and the facet between them. The same for light in either direction, to the last
/// bit, but for the order of the two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet<T: Real> {
    /// Both directions turned over to the upper side, along the normal of the facet `sum`, and where
    /// there is a facet `above`. The cosine is that of the direction above where light passes.
    pub(super) pair: Pair<T>,
    /// Where the viewer is below.
    pub(super) below: T::Mask,
    /// Where the directions lie on different sides.
    pub(super) crosses: T::Mask,
    /// Where the facet refracts one into the other; elsewhere it mirrors.
    pub(super) passes: T::Mask,
    /// What of the density of facets comes into that of directions where light passes: cosine above
    /// times cosine below over |M|², M = direction above + n · direction below. 1 elsewhere.
    pub(super) spread: T,
}

impl<T: Real> Facet<T> {
    /// Of the index below over that above.
    ///
    /// With q = 1 + a·b = |a + b|²/2 for a above and b below, and d = n − 1, no difference of near
    /// numbers is left but those of the directions: M = (a + b) + d b, a·M = n q − d, b·M = q + d. Where
    /// both are on one side, M is their sum.
    #[inline(always)]
    pub(super) fn new(wi: T::Vec3, wo: T::Vec3, ior: T) -> Self {
        let exist = off_surface::<T, _>(wi).and(off_surface::<T, _>(wo));
        let normal = <T::Vec3 as Vector<T>>::new(T::zero(), T::zero(), T::one());
        let [wi, wo]: [T::Vec3; 2] = [wi, wo].map(
            #[inline(always)]
            |w| Vector::select(exist, w, normal),
        );
        let (below, facing) = facing::<T>(wi, wo);
        Self::facing(exist, below, facing, ior)
    }

    /// Of both as the side of the viewer sees them, where the first mask says that they are directions.
    #[inline(always)]
    pub(super) fn facing(
        exist: T::Mask,
        below: T::Mask,
        [light, viewer]: [T::Vec3; 2],
        ior: T,
    ) -> Self {
        let (zero, one) = (T::zero(), T::one());
        let crosses = light.z().lt(zero);
        let light: T::Vec3 = Vector::new(light.x(), light.y(), light.z().abs());

        let above: T::Vec3 = Vector::select(below, light, viewer);
        let under: T::Vec3 = Vector::select(below, viewer, light);
        let under_z = T::select(crosses, -under.z(), under.z());
        let under: T::Vec3 = Vector::new(under.x(), under.y(), under_z);
        let sum: T::Vec3 = above + under;
        let q = Vector::length_squared(sum) * T::lit(0.5);

        let difference = ior - one;
        let contrast = difference.abs();
        // The facet's normal points to the rarer medium.
        let turned = T::select(difference.lt(zero), one, -one);
        let m: T::Vec3 = Vector::select(crosses, (sum + under * difference) * turned, sum);
        let along: T::Vec3 = Vector::new(m.x(), m.y(), m.z().max(least_height::<T>()));
        let length = Vector::length_squared(along).sqrt();
        let inverse = one / length;
        let cos_above = (contrast + turned * (ior * q)) * inverse;
        let cos_below = (contrast - turned * q) * inverse;
        let refracts =
            contrast.gt(zero).and(m.z().gt(zero)).and(cos_above.gt(zero)).and(cos_below.gt(zero));
        let passes = crosses.and(refracts);
        let cos_d = T::select(passes, cos_above, length * T::lit(0.5)).at_most(one);
        let spread = cos_d * T::select(passes, cos_below, one).at_most(one) * (inverse * inverse);
        let h = along * inverse;
        let pair = Pair {
            wi: light,
            wo: viewer,
            cos_i: light.z(),
            cos_o: viewer.z(),
            sum: along,
            h,
            cos_h: h.z(),
            cos_d,
            above: exist.and(crosses.not().or(refracts)),
        };
        Self { pair, below, crosses, passes, spread: T::select(passes, spread, one) }
    }
}
