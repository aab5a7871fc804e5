use super::calls;
use super::crossed::AnySmith;
use super::mirror::Mirror;
use super::opaque::Opaque;
use super::plastic::Plastic;
use super::rough::RoughDielectric;
use super::smooth::SmoothDielectric;
use super::split_schlick::SplitSchlick1994;
use super::thin::ThinDielectric;
use crate::any::AnyBrdf;
use crate::block::{ColorBlock, EventBlock, PairBlock, Plane, SampleBlock};
use crate::bsdf::{Bsdf, BsdfSample, Lobes, Power, TransportMode};
use crate::direction::Pair;
use crate::distribution::{Beckmann, Ggx};
use crate::fresnel::AnyFresnel;
use crate::polarization::Mueller;
use crate::real::{Color, Real, members};
use crate::wave::{BeckmannKirchhoff, He1991};

members! {
    ($) each
    /// Any model of this crate over the whole sphere, chosen at run time: what a renderer keeps its
    /// materials in.
    ///
    /// One type for all of them, without a box, as [`AnyBrdf`]; the answers have the bits of the model
    /// inside.
    ///
    /// ```
    /// use brdf::{AnyBrdf, AnyBsdf, Bsdf, Lambert, SmoothDielectric, TransportMode};
    /// use glam::DVec3;
    ///
    /// let paper = AnyBrdf::from(Lambert::new(DVec3::splat(0.5))?);
    /// let scene: [AnyBsdf<f64>; 2] = [paper.into(), SmoothDielectric::new(1.5)?.into()];
    /// let lobes = scene[1].specular(DVec3::Z, TransportMode::Importance);
    /// assert!((lobes.transmitted.weight.x - 0.96).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub enum AnyBsdf[T: Real = f32, C: Color<T> = <T as Real>::Vec3][T: Real, C: Color<T>]
        AnyBsdf<T, C> => AnyBsdf<U, C::Over<U>>
    {
        /// A model of reflection.
        Opaque(Opaque<AnyBrdf<T, C>>),
        /// A smooth mirror.
        Mirror(Mirror<AnyFresnel<T, C>>),
        /// Lambert's surface under a smooth dielectric.
        Plastic(Plastic<C, T>),
        /// Schlick's model of 1994 with its mirror part.
        SplitSchlick1994(SplitSchlick1994<C, T>),
        /// A rough surface in Kirchhoff's theory of diffraction.
        BeckmannKirchhoff(BeckmannKirchhoff<AnyFresnel<T, C>, C, T>),
        /// A rough surface of He, Torrance, Sillion and Greenberg.
        He1991(He1991<AnyFresnel<T, C>, C, T>),
        /// A smooth interface.
        SmoothDielectric(SmoothDielectric<C, T>),
        /// A thin plate.
        ThinDielectric(ThinDielectric<C, T>),
        /// A rough interface of Beckmann's facets.
        RoughBeckmann(RoughDielectric<Beckmann<T>, AnySmith, C, T>),
        /// A rough interface of the facets of Trowbridge and Reitz.
        RoughGgx(RoughDielectric<Ggx<T>, AnySmith, C, T>),
    }
}

impl<T: Real, C: Color<T>> From<AnyBrdf<T, C>> for AnyBsdf<T, C> {
    fn from(model: AnyBrdf<T, C>) -> Self {
        Self::Opaque(Opaque::new(model))
    }
}

impl<T: Real, C: Color<T>> AnyBsdf<T, C> {
    /// The Mueller matrix of a model of reflection that knows how it polarises light, without its specular
    /// lobe: as [`AnyBrdf::mueller`], and [`He1991::mueller`] where the Fresnel term knows its
    /// [amplitudes](AnyFresnel::amplitudes). `None` of the others.
    #[must_use]
    pub fn mueller(&self, wi: T::Vec3, wo: T::Vec3) -> Option<Mueller<C>> {
        match self {
            Self::Opaque(opaque) => opaque.model().mueller(wi, wo),
            Self::He1991(model) => {
                let cos = Pair::<T>::new(wi, wo).cos_d;
                Some(model.mueller_of(wi, wo, model.fresnel().amplitudes(cos)?))
            }
            _ => None,
        }
    }
}

impl<T: Real, C: Color<T>> Bsdf<T> for AnyBsdf<T, C> {
    type Color = C;

    fn eval(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> C {
        each!(self, model => calls::eval::of(model, wi, wo, mode))
    }

    fn pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> T {
        each!(self, model => calls::pdf::of(model, wi, wo, mode))
    }

    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3, mode: TransportMode) -> (C, T) {
        each!(self, model => calls::eval_pdf::of(model, wi, wo, mode))
    }

    fn sample(&self, wo: T::Vec3, u: [T; 3], mode: TransportMode) -> BsdfSample<T, C> {
        each!(self, model => calls::sample::of(model, wo, u, mode))
    }

    fn specular(&self, wo: T::Vec3, mode: TransportMode) -> Lobes<T, C> {
        each!(self, model => calls::specular::of(model, wo, mode))
    }

    fn power(&self, wo: T::Vec3) -> Power<C> {
        each!(self, model => model.power(wo))
    }

    fn eval_block(
        &self,
        pairs: PairBlock<'_, T>,
        mode: TransportMode,
        values: &mut ColorBlock<T, C>,
    ) {
        each!(self, model => model.eval_block(pairs, mode, values));
    }

    fn pdf_block(&self, pairs: PairBlock<'_, T>, mode: TransportMode, pdf: &mut Plane<T>) {
        each!(self, model => model.pdf_block(pairs, mode, pdf));
    }

    fn eval_pdf_block(
        &self,
        pairs: PairBlock<'_, T>,
        mode: TransportMode,
        values: &mut ColorBlock<T, C>,
        pdf: &mut Plane<T>,
    ) {
        each!(self, model => model.eval_pdf_block(pairs, mode, values, pdf));
    }

    fn sample_block(
        &self,
        draws: EventBlock<'_, T>,
        mode: TransportMode,
        samples: &mut SampleBlock<T, C>,
        specular: &mut Plane<T>,
    ) {
        each!(self, model => model.sample_block(draws, mode, samples, specular));
    }
}
