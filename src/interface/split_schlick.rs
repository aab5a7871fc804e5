use super::side::Viewer;
use crate::brdf::Brdf;
use crate::bsdf::{Bsdf, BsdfSample, Lobes, Power, TransportMode, never};
use crate::direction::above_surface;
use crate::glossy::Schlick1994;
use crate::real::{Color, Mask, Real, lift};

/// Schlick's model of 1994 with its mirror part.
///
/// # Formula
/// ```text
/// f as of Schlick1994, and a specular lobe of weight S(N·V) c + (1 − S(N·V)) S′(N·V) c′
/// ```
///
/// # Energy
/// Reciprocal. Not conserving, as [`Schlick1994`].
///
/// # Sampling
/// The third number chooses between the lobe and the rest, by the weight of the lobe.
///
/// ```
/// use brdf::{Bsdf, Schlick1994, Schlick1994Layer, SplitSchlick1994, TransportMode};
/// use glam::DVec3;
///
/// let polish = Schlick1994Layer { specular: DVec3::splat(0.5), roughness: 0.1, isotropy: 1.0 };
/// let polish = SplitSchlick1994::new(Schlick1994::new(polish)?);
/// let lobe = polish.specular(DVec3::Z, TransportMode::Radiance).reflected;
/// assert!((lobe.weight.x - 0.5 * 0.64).abs() < 1e-15); // C (1 − 2r)²
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplitSchlick1994<C = glam::Vec3, T = f32> {
    model: Schlick1994<C, T>,
}

lift! {
    [T: Real, C: Color<T>] SplitSchlick1994<C, T> => SplitSchlick1994<C::Over<U>, U>:
    SplitSchlick1994 { model: part }
}

impl<T: Real, C: Color<T>> SplitSchlick1994<C, T> {
    /// The surface with layers of a diffuse, a glossy and a mirror part.
    #[must_use]
    pub fn new(model: Schlick1994<C, T>) -> Self {
        Self { model: model.with_split(true) }
    }

    /// The model without the mirror part.
    #[must_use]
    pub const fn model(&self) -> &Schlick1994<C, T> {
        &self.model
    }

    /// The probability of the lobe, below 1.
    #[inline(always)]
    fn share(&self, wo: T::Vec3) -> T {
        self.model.mirror(wo).mean().min(T::lit(0.9))
    }
}

impl<T: Real, C: Color<T>> Bsdf<T> for SplitSchlick1994<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3, _: TransportMode) -> C {
        self.model.eval(wi, wo)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3, _: TransportMode) -> T {
        self.model.pdf(wi, wo) * (T::one() - self.share(wo))
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, [x, y, u]: [T; 3], mode: TransportMode) -> BsdfSample<T, C> {
        let (zero, one) = (T::zero(), T::one());
        let (above, share) = (above_surface::<T, _>(wo), self.share(wo));
        let lobe = self.specular(wo, mode).reflected;
        let mirrored = u.clamp(zero, one).lt(share);
        let chance = T::select(mirrored, share, one);
        let specular = BsdfSample {
            wi: lobe.wi,
            weight: lobe.weight * (one / chance),
            pdf: zero,
            specular: above,
        };
        let rest = one - share;
        let sample = self.model.sample(wo, [x, y]);
        let glossy = BsdfSample {
            wi: sample.wi,
            weight: (sample.weight * (one / rest)).map(|value| value.min(T::max_finite())),
            pdf: sample.pdf * rest,
            specular: never::<T>(),
        };
        let drawn = mirrored.or(sample.pdf.gt(zero));
        BsdfSample::choose(mirrored, specular, glossy).only_where(above.and(drawn))
    }

    #[inline(always)]
    fn specular(&self, wo: T::Vec3, _: TransportMode) -> Lobes<T, C> {
        Viewer::<T>::above(wo).mirror(self.model.mirror(wo))
    }

    fn power(&self, wo: T::Vec3) -> Power<C> {
        let lobe = self.specular(wo, TransportMode::Importance).power();
        let reflectance = self.model.albedo(wo) + lobe.reflectance;
        Power { reflectance, transmittance: C::splat(T::zero()) }
    }
}
