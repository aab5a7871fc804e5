//! Light that a rough interface refracts: value, density and weight of a pair of directions.

use super::crossed::RefractedShadowing;
use super::crossing::Crossing;
use crate::bsdf::TransportMode;
use crate::distribution::Smith;
use crate::fresnel::split;
use crate::real::{Real, Vector};

/// 1 + Λ up to which refracted light is followed: beyond it there is next to none.
const HIDDEN: f64 = 1e9;

/// What value and density of a pair have in common.
#[derive(Clone, Copy)]
pub(super) struct Refracted<T: Real> {
    crossing: Crossing<T>,
    /// (1 − F) D times the spread of directions.
    scale: T,
    /// |N·w| + Λ(w) |N·w| of both, above and below.
    seen: [T; 2],
    /// 1 + Λ(w) of both.
    hidden: [T; 2],
}

impl<T: Real> Refracted<T> {
    #[inline(always)]
    pub(super) fn new<D: Smith<T>>(distribution: &D, ior: T, wi: T::Vec3, wo: T::Vec3) -> Self {
        let crossing = Crossing::new(wi, wo, ior);
        let [_, transmitted] = split(ior, crossing.cos_above);
        let density = distribution.density_along(crossing.h);
        let ends = [crossing.above, crossing.below];
        let areas = ends.map(|w| distribution.lambda_cos(w));
        let [above, below] = ends.map(|w| w.z());
        let hidden = |area: T, cos: T| T::one() + (area / cos).min(T::lit(HIDDEN - 1.0));
        Self {
            crossing,
            scale: (transmitted * crossing.spread * density).min(T::max_finite()),
            seen: [above + areas[0], below + areas[1]],
            hidden: [hidden(areas[0], above), hidden(areas[1], below)],
        }
    }

    /// The value for a viewer above, or below where the mask is true.
    #[inline(always)]
    pub(super) fn value<D: Smith<T>, S: RefractedShadowing<T, D>>(
        &self,
        shadowing: &S,
        ior: T,
        below: T::Mask,
        mode: TransportMode,
    ) -> T {
        let (one, squared, largest) = (T::one(), ior.squared(), T::max_finite());
        let [above, under] = self.seen;
        // n_o² = 1 is scaled after the bound: both directions have the same bits.
        let value = (self.scale * shadowing.refracted(self.hidden) / (above * under)).min(largest);
        let index_squared = match mode {
            TransportMode::Radiance => T::select(below, squared, one),
            TransportMode::Importance => T::select(below, one, squared),
        };
        (value * index_squared).min(largest).only_where(self.crossing.exists)
    }

    /// The density of refracted draws for a viewer above, or below where the mask is true.
    #[inline(always)]
    pub(super) fn pdf(&self, ior: T, below: T::Mask) -> T {
        let (one, [above, under]) = (T::one(), self.seen);
        let turned = T::select(below, one / under, ior.squared() / above);
        (self.scale * turned).min(T::max_finite()).only_where(self.crossing.exists)
    }

    /// G/G₁(wo), what a draw of a visible normal weighs for importance.
    #[inline(always)]
    pub(super) fn weight<D: Smith<T>, S: RefractedShadowing<T, D>>(
        &self,
        shadowing: &S,
        below: T::Mask,
    ) -> T {
        let [above, under] = [self.crossing.above, self.crossing.below].map(|w| w.z());
        // G₁ of the light.
        let lit = T::select(below, above / self.seen[0], under / self.seen[1]);
        shadowing.refracted(self.hidden) * lit.at_most(T::one())
    }
}
