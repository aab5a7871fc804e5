//! Facets of a rough interface, and draws of what they mirror and refract.

use super::crossed::RefractedShadowing;
use super::facet::Facet;
use super::scattered::Scattered;
use super::side::{Viewer, refraction_scale};
use crate::bsdf::{BsdfSample, TransportMode, never};
use crate::direction::{off_surface, off_surface_or_normal, refracted_cosine, turned_over};
use crate::distribution::Smith;
use crate::fresnel::part;
use crate::real::{Mask, Real, Vector};

/// All facets of an interface.
pub(super) struct Facets<'a, T, D, S> {
    pub(super) distribution: &'a D,
    pub(super) shadowing: &'a S,
    /// The index below the surface over that above.
    pub(super) ior: T,
}

/// A facet that a viewer sees.
pub(super) struct Seen<T: Real> {
    /// Where the viewer is below.
    below: T::Mask,
    /// The viewer, turned over to the upper side.
    facing: T::Vec3,
    /// The normal of the facet.
    h: T::Vec3,
    /// Their product.
    along: T,
    /// The cosine of the angle between them.
    cos: T,
}

impl<T: Real, D: Smith<T>, S: RefractedShadowing<T, D>> Facets<'_, T, D, S> {
    /// What scatters `wi` into `wo`.
    #[inline(always)]
    pub(super) fn scattered(&self, wi: T::Vec3, wo: T::Vec3) -> Scattered<'_, T, D, S> {
        Scattered { facets: self, facet: Facet::new(wi, wo, self.ior) }
    }

    /// What of the power the facet that two uniform numbers draw brings back and lets through.
    #[inline(always)]
    pub(super) fn powers(&self, viewer: &Viewer<T>, u: [T; 2]) -> [T; 2] {
        let seen = self.seen(viewer, u);
        let power = |refracts: T::Mask| {
            let drawn = self.drawn(&seen, refracts, TransportMode::Importance);
            self.part(&seen, refracts) * drawn.weight
        };
        [power(never::<T>()), power(never::<T>().not())]
    }

    /// A facet that the viewer sees.
    #[inline(always)]
    pub(super) fn seen(&self, viewer: &Viewer<T>, [x, y]: [T; 2]) -> Seen<T> {
        let facing: T::Vec3 = turned_over::<T, _>(viewer.below, viewer.wo);
        let h = self.shadowing.sample_visible(self.distribution, facing, [x, y]);
        let along = Vector::dot(facing, h);
        Seen { below: viewer.below, facing, h, along, cos: along.max(T::zero()).at_most(T::one()) }
    }

    /// What of the power a seen facet reflects or, where the mask is true, transmits.
    #[inline(always)]
    pub(super) fn part(&self, seen: &Seen<T>, transmitted: T::Mask) -> T {
        part(self.ior, T::select(seen.below, -seen.cos, seen.cos), transmitted)
    }

    /// The draw of what a facet mirrors or, where the mask is true, refracts.
    #[inline(always)]
    pub(super) fn drawn(
        &self,
        seen: &Seen<T>,
        refracts: T::Mask,
        mode: TransportMode,
    ) -> BsdfSample<T, T> {
        let one = T::one();
        let Seen { below, facing, h, along, cos } = *seen;
        let far_over_near = T::select(below, one / self.ior, self.ior);
        let inverse = one / far_over_near;
        let sin_squared = Vector::length_squared(Vector::cross(facing, h));
        let (cos_t, _) = refracted_cosine(cos, sin_squared, inverse);
        let through: T::Vec3 = h * (cos * inverse - cos_t) - facing * inverse;
        let mirrored: T::Vec3 = h * ((along + along) / Vector::length_squared(h)) - facing;
        let light: T::Vec3 = Vector::select(refracts, through, mirrored);
        let wi = turned_over::<T, _>(below, light);

        let exists = off_surface::<T, _>(light);
        let light = off_surface_or_normal::<T, _>(light);
        let facet = Facet::facing(exists, below, [light, facing], self.ior);
        // Nothing is mirrored to the far side, nor refracted to the near one.
        let crosses = facet.crosses;
        let exists = exists.and(refracts.and(crosses).or(refracts.not().and(crosses.not())));
        let scattered = Scattered { facets: self, facet };
        let scale = T::select(refracts, refraction_scale(far_over_near, mode), one);
        let (weight, pdf) = (scattered.weight() * scale, scattered.pdf());
        BsdfSample { wi, weight, pdf, specular: never::<T>() }.only_where(exists)
    }
}
