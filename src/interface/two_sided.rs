use crate::bsdf::{Bsdf, BsdfSample, Lobe, Lobes, Power, TransportMode};
use crate::direction::{facing, turned_over};
use crate::real::{Lift, Real, Vector, lift};

/// A model whose front is on both sides of the surface, as of a sheet of paper.
///
/// Below the surface the model answers for the mirror images of the directions.
///
/// # Limits
/// For models of reflection: those keep their reciprocity. What a model transmits it transmits from either
/// side as from above, so that light which passes does not find its way back, and the answers for
/// importance are not the transposes of those for radiance. An interface, such as
/// [`SmoothDielectric`](super::SmoothDielectric), knows both its sides and needs no second one.
///
/// ```
/// use brdf::{Bsdf, Lambert, Opaque, TransportMode, TwoSided};
/// use glam::Vec3;
///
/// let paper = TwoSided::new(Opaque::new(Lambert::new(Vec3::splat(0.5))?));
/// let below = Vec3::new(0.6, 0.0, -0.8);
/// assert!(paper.eval(below, -Vec3::Z, TransportMode::Radiance).x > 0.159);
/// assert!(paper.sample(below, [0.2, 0.7, 0.5], TransportMode::Radiance).wi.z < 0.0);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoSided<M> {
    model: M,
}

impl<M> TwoSided<M> {
    /// The model on both sides.
    #[must_use]
    pub const fn new(model: M) -> Self {
        Self { model }
    }

    /// The model.
    #[must_use]
    pub const fn model(&self) -> &M {
        &self.model
    }
}

lift! {
    [T: Real, M: Lift<T>] TwoSided<M> => TwoSided<M::Over<U>>: TwoSided { model: part }
}

impl<T: Real, M: Bsdf<T>> Bsdf<T> for TwoSided<M> {
    type Color = M::Color;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> M::Color {
        let (_, [wi, wo]) = facing::<T>(wi, wo);
        self.model.eval(wi, wo, mode)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> T {
        let (_, [wi, wo]) = facing::<T>(wi, wo);
        self.model.pdf(wi, wo, mode)
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> (M::Color, T) {
        let (_, [wi, wo]) = facing::<T>(wi, wo);
        self.model.eval_pdf(wi, wo, mode)
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 3], mode: TransportMode) -> BsdfSample<T, M::Color> {
        let below = wo.z().lt(T::zero());
        let sample = self.model.sample(turned_over::<T, _>(below, wo), u, mode);
        BsdfSample { wi: turned_over::<T, _>(below, sample.wi), ..sample }
    }

    #[inline(always)]
    fn specular(&self, wo: T::Vec3, mode: TransportMode) -> Lobes<T, M::Color> {
        let below = wo.z().lt(T::zero());
        let Lobes { reflected, transmitted } =
            self.model.specular(turned_over::<T, _>(below, wo), mode);
        let turned =
            |lobe: Lobe<T, M::Color>| Lobe { wi: turned_over::<T, _>(below, lobe.wi), ..lobe };
        Lobes { reflected: turned(reflected), transmitted: turned(transmitted) }
    }

    fn power(&self, wo: T::Vec3) -> Power<M::Color> {
        self.model.power(turned_over::<T, _>(wo.z().lt(T::zero()), wo))
    }
}
