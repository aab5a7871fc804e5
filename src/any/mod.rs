//! Any model of the crate, as one type.

mod calls;

use crate::block::{ColorBlock, DrawBlock, PairBlock, Plane, SampleBlock};
use crate::brdf::{Brdf, Sample};
use crate::diffuse::{Eon, Fon, Fujii, Lambert, OrenNayar, OrenNayarFull};
use crate::direction::Pair;
use crate::distribution::AnyDistribution;
use crate::fresnel::AnyFresnel;
use crate::glossy::{
    AshikhminShirley, BlinnPhong, ClassicPhong, Lafortune, Phong, Schlick1994, SchlickPower, Ward,
};
use crate::microfacet::{AnyShadowing, CookTorrance, Scaled, facet};
use crate::planetary::{Hapke, LommelSeeliger, Minnaert};
use crate::polarization::Mueller;
use crate::polarized_brdf::times;
use crate::principled::Disney2012;
use crate::real::{Color, Real, members};
use crate::sum::{SumOfTwo, WeightedSum};

/// The microfacet model of parts that are chosen at run time.
pub type AnyCookTorrance<T = f32, C = <T as Real>::Vec3> =
    CookTorrance<AnyDistribution<T>, AnyFresnel<T, C>, AnyShadowing>;

members! {
    ($) each
    /// Any model of this crate, chosen at run time: what a renderer keeps its materials in.
    ///
    /// One type for all of them, without a box; sums and mixtures own a `Vec`. A call costs one
    /// predicted `match` for the model and one for each part, a [batch](crate::batch) one for each
    /// block, outside its loops, and the answers have the bits of the model inside. Descriptions
    /// build it.
    ///
    /// ```
    /// use brdf::{AnyBrdf, Brdf, CookTorrance, Ggx, Lambert, Schlick};
    /// use glam::Vec3;
    ///
    /// let coat = CookTorrance::new(Ggx::new(0.3)?, Schlick::new(Vec3::splat(0.04))?);
    /// let scene: Vec<AnyBrdf> = vec![Lambert::new(Vec3::splat(0.5))?.into(), coat.into()];
    /// assert_eq!(scene[1].eval(Vec3::Z, Vec3::Z), coat.eval(Vec3::Z, Vec3::Z));
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("material"))]
    pub enum AnyBrdf[T: Real = f32, C: Color<T> = <T as Real>::Vec3][T: Real, C: Color<T>]
        AnyBrdf<T, C> => AnyBrdf<U, C::Over<U>>
    {
        /// Lambert's ideal diffuse surface.
        Lambert(Lambert<C>),
        /// Oren and Nayar's rough diffuse surface.
        OrenNayar(OrenNayar<C, T>),
        /// Oren and Nayar's full model.
        OrenNayarFull(OrenNayarFull<C, T>),
        /// Fujii's fit to it.
        Fujii(Fujii<C, T>),
        /// Fujii's form by roughness.
        Fon(Fon<C, T>),
        /// The same with the light that grooves send to each other.
        Eon(Eon<C, T>),
        /// The energy-conserving form of Phong's lobe.
        Phong(Phong<C, T>),
        /// Phong's highlight of 1975.
        ClassicPhong(ClassicPhong<C, T>),
        /// Blinn's variant of Phong's lobe.
        BlinnPhong(BlinnPhong<C, T>),
        /// Schlick's rational stand-in for a power of the cosine.
        SchlickPower(SchlickPower<C, T>),
        /// Ward's lobe.
        Ward(Ward<C, T>),
        /// Ashikhmin and Shirley's anisotropic Phong model.
        AshikhminShirley(AshikhminShirley<C, T>),
        /// Lafortune's generalised cosine lobes.
        Lafortune(Lafortune<C, T>),
        /// Schlick's model of 1994, without a mirror part.
        Schlick1994(Schlick1994<C, T>),
        /// Minnaert's law.
        Minnaert(Minnaert<C, T>),
        /// The law of Lommel and Seeliger.
        LommelSeeliger(LommelSeeliger<C, T>),
        /// Hapke's model.
        Hapke(Hapke<C, T>),
        /// Disney's principled material.
        Disney2012(Disney2012<C, T>),
        /// The microfacet model.
        CookTorrance(AnyCookTorrance<T, C>): generic,
        /// A printed form of the microfacet model.
        Printed(Scaled<AnyCookTorrance<T, C>, T>): generic,
        /// A weighted sum of models.
        Sum(WeightedSum<AnyBrdf<T, C>, C, T>): generic,
    }
}

impl<T: Real, C: Color<T>> AnyBrdf<T, C> {
    /// The Mueller matrix of a model that knows how it polarises light, as
    /// [`PolarizedBrdf::mueller`](crate::PolarizedBrdf::mueller): of facets whose Fresnel term knows
    /// its [amplitudes](AnyFresnel::amplitudes). `None` of the others.
    #[must_use]
    pub fn mueller(&self, wi: T::Vec3, wo: T::Vec3) -> Option<Mueller<C>> {
        Some(times(self.polarization(wi, wo)?, self.eval(wi, wo)))
    }

    /// A sample with its Mueller matrix, as
    /// [`PolarizedBrdf::sample_mueller`](crate::PolarizedBrdf::sample_mueller); `None` as of
    /// [`mueller`](Self::mueller).
    #[must_use]
    pub fn sample_mueller(&self, wo: T::Vec3, u: [T; 2]) -> Option<(Sample<T, C>, Mueller<C>)> {
        let sample = self.sample(wo, u);
        Some((sample, times(self.polarization(sample.wi, wo)?, sample.weight)))
    }

    fn polarization(&self, wi: T::Vec3, wo: T::Vec3) -> Option<Mueller<C>> {
        let facets = match self {
            Self::CookTorrance(model) => model,
            Self::Printed(scaled) => scaled.model(),
            _ => return None,
        };
        let pair = Pair::<T>::new(wi, wo);
        Some(facet(&pair, facets.fresnel().amplitudes(pair.cos_d)?))
    }
}

impl<T: Real, C: Color<T>> Brdf<T> for AnyBrdf<T, C> {
    type Color = C;

    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        each!(self, model => calls::eval::of(model, wi, wo))
    }

    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        each!(self, model => calls::pdf::of(model, wi, wo))
    }

    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3) -> (C, T) {
        each!(self, model => calls::eval_pdf::of(model, wi, wo))
    }

    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        each!(self, model => calls::sample::of(model, wo, u))
    }

    fn is_reciprocal(&self) -> bool {
        each!(self, model => model.is_reciprocal())
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        each!(self, model => model.albedo(wo))
    }

    fn eval_block(&self, pairs: PairBlock<'_, T>, values: &mut ColorBlock<T, C>) {
        each!(self, model => model.eval_block(pairs, values));
    }

    fn pdf_block(&self, pairs: PairBlock<'_, T>, pdf: &mut Plane<T>) {
        each!(self, model => model.pdf_block(pairs, pdf));
    }

    fn eval_pdf_block(
        &self,
        pairs: PairBlock<'_, T>,
        values: &mut ColorBlock<T, C>,
        pdf: &mut Plane<T>,
    ) {
        each!(self, model => model.eval_pdf_block(pairs, values, pdf));
    }

    fn sample_block(&self, draws: DrawBlock<'_, T>, samples: &mut SampleBlock<T, C>) {
        each!(self, model => model.sample_block(draws, samples));
    }
}

/// Static parts become parts that are chosen at run time.
impl<D, F, S> CookTorrance<D, F, S> {
    fn into_any<T, C>(self) -> AnyCookTorrance<T, C>
    where
        T: Real,
        C: Color<T>,
        D: Into<AnyDistribution<T>>,
        F: Into<AnyFresnel<T, C>>,
        S: Into<AnyShadowing>,
    {
        let (distribution, fresnel, shadowing) = self.into_parts();
        CookTorrance::from_parts(distribution.into(), fresnel.into(), shadowing.into())
    }
}

impl<T, C, D, F, S> From<CookTorrance<D, F, S>> for AnyBrdf<T, C>
where
    T: Real,
    C: Color<T>,
    D: Into<AnyDistribution<T>>,
    F: Into<AnyFresnel<T, C>>,
    S: Into<AnyShadowing>,
{
    fn from(model: CookTorrance<D, F, S>) -> Self {
        Self::CookTorrance(model.into_any())
    }
}

impl<T, C, D, F, S> From<Scaled<CookTorrance<D, F, S>, T>> for AnyBrdf<T, C>
where
    T: Real,
    C: Color<T>,
    D: Into<AnyDistribution<T>>,
    F: Into<AnyFresnel<T, C>>,
    S: Into<AnyShadowing>,
{
    fn from(printed: Scaled<CookTorrance<D, F, S>, T>) -> Self {
        let scale = printed.scale();
        Self::Printed(Scaled::of(printed.into_model().into_any(), scale))
    }
}

impl<T, C, M> From<WeightedSum<M, C, T>> for AnyBrdf<T, C>
where
    T: Real,
    C: Color<T>,
    M: Into<Self>,
{
    fn from(sum: WeightedSum<M, C, T>) -> Self {
        Self::Sum(sum.map(Into::into))
    }
}

impl<T, C, A, B> From<SumOfTwo<A, B, C, T>> for AnyBrdf<T, C>
where
    T: Real,
    C: Color<T>,
    A: Into<Self>,
    B: Into<Self>,
{
    fn from(sum: SumOfTwo<A, B, C, T>) -> Self {
        Self::Sum(sum.into_sum())
    }
}
