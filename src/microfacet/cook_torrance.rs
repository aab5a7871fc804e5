use super::directional_albedo::albedo;
use super::shadowing::{Draw, Mirrored, Shadowing};
use super::smith::SmithCorrelated;
use super::usual::DefaultShadowing;
use crate::block::{BLOCK, ColorBlock, DrawBlock, PairBlock, Plane, SampleBlock};
use crate::brdf::{Brdf, Sample, mean_weight};
use crate::distribution::Distribution;
use crate::fresnel::Fresnel;
use crate::real::{Lift, Real, lift};

/// The microfacet model: a surface of small mirrors.
///
/// # Formula
/// ```text
/// f = F(V·H) D(H) G / (4 (N·L) (N·V))
/// ```
///
/// # Parameters
///
/// | symbol | part | meaning |
/// |---|---|---|
/// | D | `distribution` | density of the facets' normals, normalised to ∫ D cosθ_h dω = 1 |
/// | F | `fresnel` | reflectance of a facet |
/// | G | `shadowing` | fraction of facets that light and viewer both see: [`SmithCorrelated`], [`SmithSeparable`](crate::SmithSeparable) or [`VCavity`](crate::VCavity); [by default](DefaultShadowing) the first where it is known of D, the last elsewhere |
///
/// # Energy
/// Reciprocal, to the last bit. Conserving: with F = 1 the directional albedo is at most 1; what
/// is missing is light that a real surface reflects more than once. Measured with F = 1 at 0°,
/// 60°, 80°, 89.9°: V-cavity with Beckmann's distribution 1.000, 0.999, 0.942, 0.998 at roughness
/// 0.1 and 0.605, 0.839, 0.949, 0.9995 at 0.8; Smith's with GGX 0.307, 0.451, 0.668, 0.989 at
/// roughness 1.
///
/// # Albedo
/// [`albedo`](Brdf::albedo) is an integral over facets by Gauss–Legendre rules, cut where G or F is
/// not smooth. Its relative error is below 10⁻⁶, in `f32` as in `f64`, for the distributions,
/// shadowings and Fresnel terms of this crate, roughness 0.01 … 1, up to 89°. Two exceptions are known:
/// Beckmann's distribution with roughness 1 along one axis and a tenth or less along the other,
/// before a medium of an index below 1, where it reaches 4·10⁻⁵; and films of several wavelengths,
/// whose fringes over the angle may be finer than the rule. A medium of an index
/// below 1 takes one more integral for each different index among the channels. With a distribution
/// or a shadowing that was written elsewhere the albedo is the default's mean over samples, and a
/// Fresnel term that was written elsewhere must be a smooth function of the cosine.
///
/// # Sampling
/// By visible normals: the density of a sample is G₁(V) D/(4 N·V) and its weight F G/G₁(V), never
/// above F.
///
/// # The constants of the literature
/// The form F D G/(π (N·L)(N·V)) with D = exp(−tan²θ_h/α²)/(4 α² cos⁴θ_h) is the same as this one with
/// the normalised [`Beckmann`](crate::Beckmann), D = exp(−tan²θ_h/α²)/(π α² cos⁴θ_h): the 4 and the π
/// change places. Cook and Torrance print D without the 4, which makes their surface four times
/// too bright: [`CookTorrance1982Printed`](crate::CookTorrance1982Printed). It is a BRDF, although
/// it is often called an intensity.
///
/// # Limits
/// One reflection, no interreflection, no diffraction. Where the lobe is narrower than the
/// rounding of the directions (roughness below about 10⁻⁶ in `f32`) a sample keeps its weight but
/// its density is that of the rounded direction.
///
/// # Sources
/// R. L. Cook, K. E. Torrance, "A reflectance model for computer graphics", ACM TOG 1(1), 1982,
/// [doi:10.1145/357290.357293](https://doi.org/10.1145/357290.357293);
/// K. E. Torrance, E. M. Sparrow, JOSA 57, 1967,
/// [doi:10.1364/JOSA.57.001105](https://doi.org/10.1364/JOSA.57.001105).
///
/// ```
/// use brdf::{Beckmann, Brdf, Conductor, CookTorrance};
/// use glam::Vec3;
///
/// let gold = CookTorrance::new(
///     Beckmann::new(0.3)?,
///     Conductor::new(Vec3::new(0.14, 0.43, 1.38), Vec3::new(3.697, 2.455, 1.914))?,
/// );
/// let f = gold.eval(Vec3::Z, Vec3::Z);
/// assert!((f.x - 0.851106).abs() < 1e-5); // F D/4 = 0.962586 · 3.536777/4
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("microfacet", "rough conductor", "Torrance-Sparrow"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CookTorrance<D, F, S = SmithCorrelated> {
    distribution: D,
    fresnel: F,
    shadowing: S,
}

impl<D: DefaultShadowing, F> CookTorrance<D, F, D::Shadowing> {
    /// A surface with these normals and this reflectance.
    ///
    /// Its shadowing is Smith's, correlated by height, where that is known: for
    /// [`Beckmann`](crate::Beckmann), [`Ggx`](crate::Ggx) and mixtures of them. For other
    /// distributions it is that of V-cavities.
    ///
    /// ```
    /// use brdf::{Brdf, Constant, CookTorrance, Ggx};
    /// use glam::DVec3;
    ///
    /// let mirrors = CookTorrance::new(Ggx::new(1.0)?, Constant::new(DVec3::ONE)?);
    /// let lost = 1.0 - mirrors.albedo(DVec3::Z).x;
    /// assert!((lost - 2.0_f64.ln()).abs() < 1e-9);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[must_use]
    pub fn new(distribution: D, fresnel: F) -> Self {
        Self::from_parts(distribution, fresnel, D::Shadowing::default())
    }
}

impl<D, F, S> CookTorrance<D, F, S> {
    /// A surface with these normals, this reflectance and this shadowing.
    #[must_use]
    pub const fn from_parts(distribution: D, fresnel: F, shadowing: S) -> Self {
        Self { distribution, fresnel, shadowing }
    }

    /// The same surface with another shadowing.
    ///
    /// ```
    /// use brdf::{Brdf, Constant, CookTorrance, Ggx, VCavity};
    /// use glam::DVec3;
    ///
    /// let smith = CookTorrance::new(Ggx::new(0.8)?, Constant::new(DVec3::ONE)?);
    /// let cavities = smith.with_shadowing(VCavity);
    /// assert!(cavities.albedo(DVec3::Z).x > smith.albedo(DVec3::Z).x);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[must_use]
    pub fn with_shadowing<G>(self, shadowing: G) -> CookTorrance<D, F, G> {
        CookTorrance { distribution: self.distribution, fresnel: self.fresnel, shadowing }
    }

    /// The distribution, the Fresnel term and the shadowing.
    pub(crate) fn into_parts(self) -> (D, F, S) {
        (self.distribution, self.fresnel, self.shadowing)
    }

    /// The distribution of the facets' normals.
    #[must_use]
    pub const fn distribution(&self) -> &D {
        &self.distribution
    }

    /// The reflectance of a facet.
    #[must_use]
    pub const fn fresnel(&self) -> &F {
        &self.fresnel
    }

    /// The shadowing.
    #[must_use]
    pub const fn shadowing(&self) -> &S {
        &self.shadowing
    }
}

lift! {
    [T: Real, D: Lift<T>, F: Lift<T>, S: Lift<T>] CookTorrance<D, F, S>
        => CookTorrance<D::Over<U>, F::Over<U>, S::Over<U>>:
    CookTorrance { distribution: part, fresnel: part, shadowing: part }
}

impl<T, D, F, S> Brdf<T> for CookTorrance<D, F, S>
where
    T: Real,
    D: Distribution<T>,
    F: Fresnel<T>,
    S: Shadowing<T, D>,
{
    type Color = F::Color;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> F::Color {
        let Mirrored { cos, scale } = self.shadowing.mirrored(&self.distribution, wi, wo);
        self.fresnel.reflected(cos, scale)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        self.shadowing.pdf(&self.distribution, wi, wo)
    }

    #[inline(always)]
    fn eval_pdf(&self, wi: T::Vec3, wo: T::Vec3) -> (F::Color, T) {
        let (Mirrored { cos, scale }, pdf) =
            self.shadowing.mirrored_pdf(&self.distribution, wi, wo);
        (self.fresnel.reflected(cos, scale), pdf)
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, F::Color> {
        let (distribution, shadowing) = (&self.distribution, &self.shadowing);
        let h = shadowing.sample_visible_along(distribution, wo, u);
        let Draw { wi, pdf, weight } = shadowing.mirror(distribution, wo, h);
        Sample { wi, weight: self.fresnel.reflected(weight.cos, weight.scale), pdf }
    }

    fn albedo(&self, wo: T::Vec3) -> F::Color {
        albedo(&self.distribution, &self.fresnel, &self.shadowing, wo)
            .unwrap_or_else(|| mean_weight(self, wo))
    }

    // In stages, each a loop of its own. A stage is compiled once for each pair of distribution and
    // shadowing and once for each Fresnel term, not for each combination of all three; and the
    // shorter a loop, the more of its turns a processor works on at once.

    fn eval_block(&self, pairs: PairBlock<'_, T>, values: &mut ColorBlock<T, F::Color>) {
        let mut mirrored = [[T::zero(); BLOCK]; 2];
        self.shadowing.mirrored_block(&self.distribution, pairs, &mut mirrored);
        self.fresnel.reflected_block(pairs.of(mirrored.each_ref()), values);
    }

    fn pdf_block(&self, pairs: PairBlock<'_, T>, pdf: &mut Plane<T>) {
        self.shadowing.pdf_block(&self.distribution, pairs, pdf);
    }

    fn eval_pdf_block(
        &self,
        pairs: PairBlock<'_, T>,
        values: &mut ColorBlock<T, F::Color>,
        pdf: &mut Plane<T>,
    ) {
        let mut mirrored = [[T::zero(); BLOCK]; 2];
        self.shadowing.mirrored_pdf_block(&self.distribution, pairs, &mut mirrored, pdf);
        self.fresnel.reflected_block(pairs.of(mirrored.each_ref()), values);
    }

    fn sample_block(&self, draws: DrawBlock<'_, T>, samples: &mut SampleBlock<T, F::Color>) {
        let SampleBlock { weight, wi_pdf } = samples;
        let mut mirrored = [[T::zero(); BLOCK]; 2];
        self.shadowing.sample_visible_block(&self.distribution, draws, wi_pdf);
        self.shadowing.mirror_block(&self.distribution, draws, wi_pdf, &mut mirrored);
        self.fresnel.reflected_block(draws.of(mirrored.each_ref()), weight);
    }
}
