//! What a model over the whole sphere answers.

use crate::direction::mirrored;
use crate::real::{Color, Mask, Real, Vector};

/// What travels along a path, which refraction scales differently.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum TransportMode {
    /// Radiance, on paths from the viewer. Refraction scales it by (n_o/n_i)², where n_o and n_i are the
    /// indices on the sides of `wo` and `wi`.
    #[default]
    Radiance,
    /// Importance, on paths from the light, and the photons themselves: the transposed function.
    Importance,
}

/// A direction drawn by [`Bsdf::sample`](crate::Bsdf::sample).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BsdfSample<T: Real, C> {
    /// Where the path goes on: towards the light for radiance.
    pub wi: T::Vec3,
    /// f |cosθᵢ|/pdf, or the weight of a lobe over the probability of drawing it; zero where the draw
    /// gives no direction.
    pub weight: C,
    /// Density of `wi` per steradian, the probability of the event included. Zero of a specular lobe,
    /// which has none, where the draw gives no direction, and where a lobe is so narrow that rounding
    /// moved `wi` out of it; the weight then still counts.
    pub pdf: T,
    /// Where a specular lobe was drawn.
    pub specular: T::Mask,
}

/// A specular lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lobe<T: Real, C> {
    /// Where it goes to.
    pub wi: T::Vec3,
    /// The ratio of radiances, or of importances.
    pub weight: C,
}

/// The specular lobes of a viewer. A weight of 0 is no lobe.
#[derive(Clone, Copy, Debug)]
pub struct Lobes<T: Real, C> {
    /// The lobe on the side of the viewer.
    pub reflected: Lobe<T, C>,
    /// The lobe on the other side.
    pub transmitted: Lobe<T, C>,
}

/// Powers of a beam, relative to the arriving one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power<C> {
    /// What returns to the side of the beam.
    pub reflectance: C,
    /// What passes to the other side.
    pub transmittance: C,
}

impl<T: Real, C: Color<T>> Lobes<T, C> {
    /// No lobes, as of a model that scatters into all directions.
    #[inline(always)]
    #[must_use]
    pub fn none(wo: T::Vec3) -> Self {
        let lobe = Lobe { wi: wo, weight: C::splat(T::zero()) };
        Self { reflected: lobe, transmitted: lobe }
    }

    /// The one lobe of a viewer of whom nothing passes, where there is a viewer.
    #[inline(always)]
    pub(crate) fn reflected(wo: T::Vec3, lobe: Lobe<T, C>, exists: T::Mask) -> Self {
        Self { reflected: lobe, ..Self::none(wo) }.only_where(exists)
    }

    /// That of a mirror.
    #[inline(always)]
    pub(crate) fn mirror(wo: T::Vec3, weight: C, exists: T::Mask) -> Self {
        Self::reflected(wo, Lobe { wi: mirrored::<T, _>(wo), weight }, exists)
    }

    /// The powers of a beam, of lobes for importance.
    #[must_use]
    pub fn power(self) -> Power<C> {
        let Self { reflected, transmitted } = self;
        Power { reflectance: reflected.weight, transmittance: transmitted.weight }
    }

    /// The lobes where the mask is true, none elsewhere.
    #[inline(always)]
    #[must_use]
    pub fn only_where(self, mask: T::Mask) -> Self {
        let only = |lobe: Lobe<T, C>| Lobe { wi: lobe.wi, weight: lobe.weight.only_where(mask) };
        Self { reflected: only(self.reflected), transmitted: only(self.transmitted) }
    }
}

/// False everywhere.
#[inline(always)]
pub(crate) fn never<T: Real>() -> T::Mask {
    T::one().lt(T::zero())
}

impl<T: Real, C: Color<T>> BsdfSample<T, C> {
    /// The sample where the mask is true, no direction (weight and pdf zero) elsewhere.
    #[inline(always)]
    #[must_use]
    pub fn only_where(self, mask: T::Mask) -> Self {
        Self {
            wi: self.wi,
            weight: self.weight.only_where(mask),
            pdf: self.pdf.only_where(mask),
            specular: self.specular.and(mask),
        }
    }

    /// `yes` where the mask is true, `no` elsewhere.
    #[inline(always)]
    #[must_use]
    pub fn choose(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self {
            wi: Vector::select(mask, yes.wi, no.wi),
            weight: C::choose(mask, yes.weight, no.weight),
            pdf: T::select(mask, yes.pdf, no.pdf),
            specular: mask.and(yes.specular).or(mask.not().and(no.specular)),
        }
    }
}
