use core::array;

use super::side::{Viewer, nothing_but_lobes};
use crate::block::{BLOCK, EventBlock, Plane, SampleBlock};
use crate::bsdf::{Bsdf, BsdfSample, Lobes, Power, TransportMode};
use crate::fresnel::Fresnel;
use crate::real::{Color, Lift, Real, Vector, lift};

/// A smooth mirror: polished metal, a coated glass of which only the reflection counts.
///
/// # Formula
/// ```text
/// wi = (−x, −y, z)   weight F(N·wo)
/// ```
///
/// # Parameters
///
/// | symbol | parameter | meaning |
/// |---|---|---|
/// | F | `fresnel` | reflectance, any [`Fresnel`] term |
///
/// One [specular lobe](Bsdf::specular) above the surface: value and density are 0 everywhere, and below
/// the surface there is nothing.
///
/// # Energy
/// Reciprocal. Conserving: it reflects F.
///
/// # Sampling
/// Every draw is the lobe, with the weight F.
///
/// ```
/// use brdf::{Bsdf, Constant, Mirror, TransportMode};
/// use glam::DVec3;
///
/// let silver = Mirror::new(Constant::new(DVec3::new(0.97, 0.96, 0.91))?);
/// let lobe = silver.specular(DVec3::new(0.6, 0.0, 0.8), TransportMode::Radiance).reflected;
/// assert_eq!((lobe.wi, lobe.weight.z), (DVec3::new(-0.6, 0.0, 0.8), 0.91));
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("smooth conductor"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror<F> {
    fresnel: F,
}

impl<F> Mirror<F> {
    /// A mirror of this reflectance.
    #[must_use]
    pub const fn new(fresnel: F) -> Self {
        Self { fresnel }
    }

    /// The reflectance.
    #[must_use]
    pub const fn fresnel(&self) -> &F {
        &self.fresnel
    }
}

lift! {
    [T: Real, F: Lift<T>] Mirror<F> => Mirror<F::Over<U>>: Mirror { fresnel: part }
}

impl<T: Real, F: Fresnel<T>> Bsdf<T> for Mirror<F> {
    type Color = F::Color;

    nothing_but_lobes!(T);

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, _: [T; 3], mode: TransportMode) -> BsdfSample<T, F::Color> {
        Viewer::above(wo).sample(&self.specular(wo, mode))
    }

    #[inline(always)]
    fn specular(&self, wo: T::Vec3, _: TransportMode) -> Lobes<T, F::Color> {
        let viewer = Viewer::<T>::above(wo);
        // As a part of a surface: a colour that no light has counts as 0.
        viewer.mirror(self.fresnel.reflected(viewer.wo.z().at_most(T::one()), T::one()))
    }

    fn sample_block(
        &self,
        draws: EventBlock<'_, T>,
        _: TransportMode,
        samples: &mut SampleBlock<T, F::Color>,
        specular: &mut Plane<T>,
    ) {
        let (zero, one) = (T::zero(), T::one());
        let EventBlock { draws, .. } = draws;
        let mut cosines = [zero; BLOCK];
        draws.numbers(
            array::from_mut(&mut cosines),
            #[inline(always)]
            |index| [Viewer::<T>::above(draws.wo(index)).wo.z().at_most(one)],
        );
        self.fresnel.reflectance_block(draws.of([&cosines]), &mut samples.weight);
        for weights in samples.weight.as_mut() {
            draws.changed(
                array::from_mut(weights),
                &mut [],
                #[inline(always)]
                |index, [weight]| {
                    ([weight.only_where(Viewer::<T>::above(draws.wo(index)).exists)], [])
                },
            );
        }
        let mut numbers = [cosines; 5];
        draws.numbers(
            &mut numbers,
            #[inline(always)]
            |index| {
                let viewer = Viewer::<T>::above(draws.wo(index));
                let wi = viewer.mirrored();
                [wi.x(), wi.y(), wi.z(), zero, T::select(viewer.exists, one, zero)]
            },
        );
        let [x, y, z, pdf, one_or_zero] = numbers;
        (samples.wi_pdf, *specular) = ([x, y, z, pdf], one_or_zero);
    }
}
