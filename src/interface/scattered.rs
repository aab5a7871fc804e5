//! Light that a facet of a rough interface mirrors or refracts: value, density and weight of a pair of
//! directions.

use super::crossed::RefractedShadowing;
use super::drawn::Facets;
use super::facet::Facet;
use crate::bsdf::TransportMode;
use crate::distribution::Smith;
use crate::fresnel::part;
use crate::microfacet::{Shadowing, SmithSeparable};
use crate::real::{Mask, Real};

/// 1 + Λ up to which refracted light is followed: beyond it there is next to none.
const HIDDEN: f64 = 1e9;

/// A pair of directions and the facet between them.
pub(super) struct Scattered<'a, T: Real, D, S> {
    pub(super) facets: &'a Facets<'a, T, D, S>,
    pub(super) facet: Facet<T>,
}

impl<T: Real, D: Smith<T>, S: RefractedShadowing<T, D>> Scattered<'_, T, D, S> {
    /// F D or, where light passes, (1 − F) D times the spread of directions.
    #[inline(always)]
    fn scale(&self) -> T {
        let Facet { pair, below, passes, spread, .. } = self.facet;
        let mirrors_below = below.and(passes.not());
        let cos = T::select(mirrors_below, -pair.cos_d, pair.cos_d);
        let density = self.facets.distribution.density_along(pair.sum);
        (part(self.facets.ior, cos, passes) * spread * density).min(T::max_finite())
    }

    /// G/(G₁(wi) G₁(wo)) of light that passes.
    #[inline(always)]
    fn refracted(&self) -> T {
        let (pair, one, half) = (self.facet.pair, T::one(), T::lit(0.5));
        // At cosines of less, 1 + Λ is at its bound.
        let [cos_i, cos_o] = [pair.cos_i, pair.cos_o].map(
            #[inline(always)]
            |cos| cos.max(T::lit(1e-18)),
        );
        let inverse = one / (cos_i * cos_o);
        // 1 + Λ = (A/N·w + 1)/2.
        let hidden = |w: T::Vec3, over_cos: T| {
            let area = self.facets.distribution.projected_area(w);
            (area * over_cos * half + half).min(T::lit(HIDDEN))
        };
        let [light, viewer] = [hidden(pair.wi, inverse * cos_o), hidden(pair.wo, inverse * cos_i)];
        self.facets.shadowing.refracted([light, viewer])
    }

    /// The value.
    #[inline(always)]
    pub(super) fn value(&self, mode: TransportMode) -> T {
        let (one, squared, largest) = (T::one(), self.facets.ior.squared(), T::max_finite());
        let Facet { pair, below, passes, .. } = self.facet;
        let mirrored = self.facets.shadowing.visibility(self.facets.distribution, &pair);
        // G/(4 N·wi N·wo) of what passes is that of independent directions times what the beta function
        // adds, and there is no 4 in it.
        let visibility = if passes.is_never() {
            mirrored
        } else {
            let separate = SmithSeparable.visibility(self.facets.distribution, &pair);
            let refracted = self.refracted() * T::lit(4.0) * separate;
            T::select(passes, refracted, mirrored)
        };
        // n_o² = 1 is scaled after the bound: both directions have the same bits.
        let value = (self.scale() * visibility).min(largest);
        let dense = match mode {
            TransportMode::Radiance => below,
            TransportMode::Importance => below.not(),
        };
        let index_squared = T::select(passes.and(dense), squared, one);
        (value * index_squared).min(largest).only_where(pair.above)
    }

    /// The density of draws.
    #[inline(always)]
    pub(super) fn pdf(&self) -> T {
        let (one, four, largest) = (T::one(), T::lit(4.0), T::max_finite());
        let Facet { pair, below, passes, .. } = self.facet;
        let density = self.scale() * self.facets.shadowing.masking(self.facets.distribution, &pair);
        // 4 n_i².
        let turned = T::select(below, four, four * self.facets.ior.squared());
        let turned = T::select(passes, turned, one);
        (density.min(largest) * turned).min(largest).only_where(pair.above)
    }

    /// G/G₁(wo), what a draw of a visible normal weighs for importance. Also where rounding leaves no
    /// facet between the two.
    #[inline(always)]
    pub(super) fn weight(&self) -> T {
        let Facet { pair, crosses, .. } = self.facet;
        let mirrored = self.facets.shadowing.unshadowed(self.facets.distribution, &pair);
        let refracted =
            self.refracted() * SmithSeparable.unshadowed(self.facets.distribution, &pair);
        T::select(crosses, refracted, mirrored)
    }
}
