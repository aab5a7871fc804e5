//! The trait of models over the whole sphere of directions.

use alloc::boxed::Box;
use alloc::sync::Arc;

use crate::direction::{mirrored, off_surface_or_normal};
use crate::quadrature::mean_over_square;
use crate::real::{Color, Mask, Real, Vector};

/// A model of scattering: reflection on both sides of a surface, and transmission through it.
///
/// Directions live in the shading frame (normal +z), are unit vectors and point away from the
/// surface: `wi` towards the light, `wo` towards the viewer. Those with z < 0 are below the surface.
/// Where either is no direction or lies in the surface, every answer is zero. Answers are finite and
/// never negative: a value too large for its number saturates at the largest finite one.
///
/// What scatters into single directions (a mirror, a smooth interface) has no value per steradian. Such
/// specular lobes are in neither [`eval`](Self::eval) nor [`pdf`](Self::pdf): they are listed by
/// [`specular`](Self::specular), and [`sample`](Self::sample) says when it drew one.
///
/// A [`Brdf`](crate::Brdf) is made one by [`Opaque`](crate::Opaque). The trait is object safe:
///
/// ```
/// use brdf::{Bsdf, Lambert, Opaque, SmoothDielectric, TransportMode};
/// use glam::Vec3;
///
/// let scene: Vec<Box<dyn Bsdf<Color = Vec3>>> = vec![
///     Box::new(Opaque::new(Lambert::new(Vec3::splat(0.5))?)),
///     Box::new(SmoothDielectric::new(1.5_f32)?),
/// ];
/// let glass = scene[1].sample(Vec3::Z, [0.5, 0.5, 0.9], TransportMode::Radiance);
/// assert!(glass.specular && glass.wi == -Vec3::Z);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("BTDF", "BxDF", "transmission", "scattering"))]
pub trait Bsdf<T: Real = f32>: Send + Sync {
    /// What a value has channels for.
    type Color: Color<T>;

    /// The value in sr⁻¹, without the cosine and without specular lobes.
    ///
    /// For [radiance](TransportMode::Radiance) it is f(wi, wo), of light from `wi` seen from `wo`; for
    /// [importance](TransportMode::Importance) f(wo, wi), of light from `wo` seen from `wi`.
    fn eval(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> Self::Color;

    /// The density per steradian with which [`sample`](Self::sample) returns `wi` for `wo`, of draws
    /// that are not specular.
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> T;

    /// [`eval`](Self::eval) and [`pdf`](Self::pdf) of the same pair, for multiple importance sampling.
    #[inline(always)]
    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> (Self::Color, T) {
        (self.eval(wi, wo, mode), self.pdf(wi, wo, mode))
    }

    /// Draws `wi` for `wo` from three independent uniform numbers in [0, 1): two for a direction, the
    /// third for the event, reflection below the probability of it.
    ///
    /// Numbers outside [0, 1) are taken as by [`Brdf::sample`](crate::Brdf::sample).
    fn sample(&self, wo: T::Vec3, u: [T; 3], mode: TransportMode) -> BsdfSample<T, Self::Color>;

    /// The specular lobes: radiance towards `wo` is the sum of their weights, each times the radiance
    /// from its `wi`. There is no probability in the weights.
    fn specular(&self, wo: T::Vec3, mode: TransportMode) -> Lobes<T, Self::Color> {
        let _ = mode;
        Lobes::none(off_surface_or_normal::<T, _>(wo))
    }

    /// Of a beam that arrives along `wo`, the power that returns and that passes, specular lobes
    /// included.
    ///
    /// By default the means of the weights of 33448 samples, for importance.
    fn power(&self, wo: T::Vec3) -> Power<Self::Color> {
        mean_power(self, wo)
    }
}

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

/// A direction drawn by [`Bsdf::sample`].
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

/// How many third numbers the default of [`Bsdf::power`] takes for each of its points.
const EVENTS: u32 = 8;

fn mean_power<T: Real, M: Bsdf<T> + ?Sized>(model: &M, wo: T::Vec3) -> Power<M::Color> {
    let mean = |returns: bool| {
        mean_over_square(|[x, y]| {
            let event = |index: u32| {
                let u = T::lit((f64::from(index) + 0.5) / f64::from(EVENTS));
                let sample = model.sample(wo, [x, y, u], TransportMode::Importance);
                let same_side = (sample.wi.z() * wo.z()).gt(T::zero());
                let counts = if returns { same_side } else { same_side.not() };
                sample.weight.only_where(counts)
            };
            let sum = (1..EVENTS).fold(event(0), |sum, index| sum + event(index));
            sum * T::lit(1.0 / f64::from(EVENTS))
        })
    };
    Power { reflectance: mean(true), transmittance: mean(false) }
}

macro_rules! forward {
    ($pointer:ty) => {
        impl<T: Real, M: Bsdf<T> + ?Sized> Bsdf<T> for $pointer {
            type Color = M::Color;
            #[inline(always)]
            fn eval(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> M::Color {
                (**self).eval(wi, wo, mode)
            }
            #[inline(always)]
            fn pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> T {
                (**self).pdf(wi, wo, mode)
            }
            #[inline(always)]
            fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> (M::Color, T) {
                (**self).eval_pdf(wi, wo, mode)
            }
            #[inline(always)]
            fn sample(
                &self,
                wo: T::Vec3,
                u: [T; 3],
                mode: TransportMode,
            ) -> BsdfSample<T, M::Color> {
                (**self).sample(wo, u, mode)
            }
            #[inline(always)]
            fn specular(&self, wo: T::Vec3, mode: TransportMode) -> Lobes<T, M::Color> {
                (**self).specular(wo, mode)
            }
            fn power(&self, wo: T::Vec3) -> Power<M::Color> {
                (**self).power(wo)
            }
        }
    };
}
forward!(Arc<M>);
forward!(Box<M>);
forward!(&M);
