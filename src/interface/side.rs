//! What the models of this room share: the side of the viewer, and events by chance.

use crate::bsdf::{BsdfSample, Lobe, Lobes, TransportMode, never};
use crate::direction::{
    above_or_normal, above_surface, mirrored, off_surface, off_surface_or_normal,
};
use crate::real::{Color, Mask, Real, Vector};

/// The viewer: a direction on either side of the surface, or above it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Viewer<T: Real> {
    /// The normal in the place of what is no direction.
    pub(super) wo: T::Vec3,
    /// Where it is one.
    pub(super) exists: T::Mask,
    pub(super) below: T::Mask,
}

impl<T: Real> Viewer<T> {
    #[inline(always)]
    pub(super) fn new(given: T::Vec3) -> Self {
        let wo = off_surface_or_normal::<T, _>(given);
        Self { wo, exists: off_surface::<T, _>(given), below: wo.z().lt(T::zero()) }
    }

    /// One that sees nothing from below.
    #[inline(always)]
    pub(super) fn above(given: T::Vec3) -> Self {
        let exists = above_surface::<T, _>(given);
        Self { wo: above_or_normal::<T, _>(given), exists, below: never::<T>() }
    }

    /// The mirror direction.
    #[inline(always)]
    pub(super) fn mirrored(&self) -> T::Vec3 {
        mirrored::<T, _>(self.wo)
    }

    /// The one lobe of a viewer of whom nothing passes.
    #[inline(always)]
    pub(super) fn mirror<C: Color<T>>(&self, weight: C) -> Lobes<T, C> {
        Lobes::mirror(self.wo, weight, self.exists)
    }

    /// The draw of the one lobe.
    #[inline(always)]
    pub(super) fn sample<C: Color<T>>(&self, lobes: &Lobes<T, C>) -> BsdfSample<T, C> {
        let Lobe { wi, weight } = lobes.reflected;
        BsdfSample { wi, weight, pdf: T::zero(), specular: self.exists }
    }

    /// The direction straight through the surface.
    #[inline(always)]
    pub(super) fn opposite(&self) -> T::Vec3 {
        let (zero, wo) = (T::zero(), self.wo);
        Vector::new(zero - wo.x(), zero - wo.y(), -wo.z())
    }

    /// The index on the far side over that on the side of the viewer, of the index below over that
    /// above.
    #[inline(always)]
    pub(super) fn far_over_near(&self, ior: T) -> T {
        T::select(self.below, T::one() / ior, ior)
    }
}

/// The answers of a model of lobes alone but the lobes and their draws, for its [`Bsdf`](crate::Bsdf).
macro_rules! nothing_but_lobes {
    ($t:ty) => {
        #[inline(always)]
        fn eval(
            &self,
            _: <$t as Real>::Vec3,
            _: <$t as Real>::Vec3,
            _: TransportMode,
        ) -> Self::Color {
            Color::splat(<$t>::zero())
        }

        #[inline(always)]
        fn pdf(&self, _: <$t as Real>::Vec3, _: <$t as Real>::Vec3, _: TransportMode) -> $t {
            <$t>::zero()
        }

        fn power(&self, wo: <$t as Real>::Vec3) -> Power<Self::Color> {
            self.specular(wo, TransportMode::Importance).power()
        }
    };
}
pub(super) use nothing_but_lobes;

/// What refraction multiplies by: (n_o/n_i)² for radiance, of the index n_i/n_o of the far side.
#[inline(always)]
pub(super) fn refraction_scale<T: Real>(far_over_near: T, mode: TransportMode) -> T {
    match mode {
        TransportMode::Radiance => (T::one() / far_over_near).squared(),
        TransportMode::Importance => T::one(),
    }
}

/// A sample of two specular lobes of which the first is drawn with the probability `reflectance`, the
/// power that is reflected, and the other one else. `scale` is what the weight of the second has
/// beside its probability.
#[inline(always)]
pub(super) fn sample_lobes<T: Real, C: Color<T>>(
    lobes: &Lobes<T, C>,
    [reflectance, transmittance]: [T; 2],
    scale: T,
    u: T,
    exists: T::Mask,
) -> BsdfSample<T, C> {
    let (zero, one) = (T::zero(), T::one());
    let reflected = u.clamp(zero, one).lt(reflectance).or(transmittance.le(zero));
    let Lobe { wi: back, .. } = lobes.reflected;
    let Lobe { wi: through, .. } = lobes.transmitted;
    let sample = BsdfSample {
        wi: Vector::select(reflected, back, through),
        weight: C::splat(T::select(reflected, one, scale)),
        pdf: zero,
        specular: exists,
    };
    sample.only_where(exists)
}
