use core::array;

use crate::block::{BLOCK, ColorBlock, EventBlock, PairBlock, Plane, SampleBlock};
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

    fn eval_block(
        &self,
        pairs: PairBlock<'_, T>,
        mode: TransportMode,
        values: &mut ColorBlock<T, M::Color>,
    ) {
        let turned = turned_pairs(pairs);
        self.model.eval_block(pairs.of(turned.each_ref()), mode, values);
    }

    fn pdf_block(&self, pairs: PairBlock<'_, T>, mode: TransportMode, pdf: &mut Plane<T>) {
        let turned = turned_pairs(pairs);
        self.model.pdf_block(pairs.of(turned.each_ref()), mode, pdf);
    }

    fn eval_pdf_block(
        &self,
        pairs: PairBlock<'_, T>,
        mode: TransportMode,
        values: &mut ColorBlock<T, M::Color>,
        pdf: &mut Plane<T>,
    ) {
        let turned = turned_pairs(pairs);
        self.model.eval_pdf_block(pairs.of(turned.each_ref()), mode, values, pdf);
    }

    fn sample_block(
        &self,
        draws: EventBlock<'_, T>,
        mode: TransportMode,
        samples: &mut SampleBlock<T, M::Color>,
        specular: &mut Plane<T>,
    ) {
        let EventBlock { draws, event } = draws;
        let [x, y, z, u0, u1] = draws.planes;
        let mut up = [T::zero(); BLOCK];
        let zero = T::zero();
        draws.numbers(
            array::from_mut(&mut up),
            #[inline(always)]
            |index| [T::select(z[index].lt(zero), -z[index], z[index])],
        );
        let turned = EventBlock { draws: draws.of([x, y, &up, u0, u1]), event };
        self.model.sample_block(turned, mode, samples, specular);
        draws.changed(
            &mut samples.wi_pdf,
            &mut [],
            #[inline(always)]
            |index, [x, y, up, pdf]| ([x, y, T::select(z[index].lt(zero), -up, up), pdf], []),
        );
    }
}

/// Pairs turned over where the viewer is below the surface.
#[inline(never)]
fn turned_pairs<T: Real>(pairs: PairBlock<'_, T>) -> [Plane<T>; 6] {
    let mut turned = [[T::zero(); BLOCK]; 6];
    pairs.numbers(
        &mut turned,
        #[inline(always)]
        |index| {
            let (_, [wi, wo]) = facing::<T>(pairs.wi(index), pairs.wo(index));
            [wi.x(), wi.y(), wi.z(), wo.x(), wo.y(), wo.z()]
        },
    );
    turned
}
