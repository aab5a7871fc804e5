//! What He's model does to polarised light.

use super::he::He1991;
use super::scattering::pair_above;
use crate::bsdf::BsdfSample;
use crate::direction::{Pair, above_or_normal};
use crate::fresnel::{Fresnel, PolarizedFresnel};
use crate::microfacet::facet;
use crate::polarization::{Complex, Mueller, Polarized};
use crate::polarized_brdf::times;
use crate::real::{Color, Real, Vector};

impl<T: Real, C: Color<T>, F: Fresnel<T, Color = C>> He1991<F, C, T> {
    /// The Mueller matrix of a pair in sr⁻¹, without the cosine and without the specular lobe, in the
    /// frames of [`PolarizedBrdf`](crate::PolarizedBrdf). Its first element is
    /// [`eval`](crate::Bsdf::eval), but for rounding.
    ///
    /// Facets reflect in their own frame, as those of [`CookTorrance`](crate::CookTorrance): it is the
    /// stationary point of Kirchhoff's integral. The uniform part depolarises.
    ///
    /// ```
    /// use brdf::polarization::Stokes;
    /// use brdf::{Dielectric, He1991};
    /// use glam::DVec3;
    ///
    /// let glass = He1991::new(200.0, 2000.0, Dielectric::new(1.5)?, 550.0)?;
    /// let (wi, wo) = (DVec3::new(0.8, 0.0, 0.6), DVec3::new(-0.8, 0.0, 0.6));
    /// let light = glass.mueller(wi, wo) * Stokes::unpolarized(1.0);
    /// assert!(light.q > 0.9 * light.i);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[must_use]
    pub fn mueller(&self, wi: T::Vec3, wo: T::Vec3) -> Mueller<C>
    where
        F: PolarizedFresnel<T>,
    {
        let cos = Pair::<T>::new(wi, wo).cos_d;
        self.mueller_of(wi, wo, self.fresnel().amplitudes(cos))
    }

    /// The Mueller matrix of the specular lobe, the ratio of the light's Stokes vectors. Its first element
    /// is the lobe's weight, but for rounding.
    #[must_use]
    pub fn specular_mueller(&self, wo: T::Vec3) -> Mueller<C>
    where
        F: PolarizedFresnel<T>,
    {
        let wo = above_or_normal(wo);
        let amplitudes = self.fresnel().amplitudes(wo.z().at_most(T::one()));
        self.lobe_of(wo, amplitudes)
    }

    /// [`sample`](crate::Bsdf::sample) with the Mueller matrix f cosθᵢ/pdf, or that of the lobe over the
    /// probability of it, in the place of the weight: light is drawn as if it were unpolarised.
    #[must_use]
    pub fn sample_mueller(&self, wo: T::Vec3, u: [T; 3]) -> (BsdfSample<T, C>, Mueller<C>)
    where
        F: PolarizedFresnel<T>,
    {
        let sample = self.scattering.sample(wo, [u[0], u[1]], Some(u[2]));
        let cos = Pair::<T>::new(sample.wi, wo).cos_d;
        let matrix = self.sampled(wo, &sample, self.fresnel().amplitudes(cos));
        (sample, matrix)
    }

    /// [`mueller`](Self::mueller) of amplitudes at V·H.
    pub(crate) fn mueller_of(
        &self,
        wi: T::Vec3,
        wo: T::Vec3,
        amplitudes: Polarized<Complex<C>>,
    ) -> Mueller<C> {
        let pair = pair_above::<T>(wi, wo);
        let diffuse = self.scattering.diffuse(&pair).only_where(pair.above);
        let mut matrix = times(facet(&pair, amplitudes), diffuse);
        matrix.rows[0][0] = self.scattering.eval(wi, wo);
        matrix
    }

    /// The matrix of a sample, of amplitudes at V·H.
    pub(crate) fn sampled(
        &self,
        wo: T::Vec3,
        sample: &BsdfSample<T, C>,
        amplitudes: Polarized<Complex<C>>,
    ) -> Mueller<C> {
        let (zero, one) = (T::zero(), T::one());
        let BsdfSample { wi, weight, pdf, specular } = *sample;
        let pair = Pair::<T>::new(above_or_normal(wi), above_or_normal(wo));
        // The uniform part is in the weight and does not polarise.
        let drawn = pdf.gt(zero);
        let scale = (wi.z() / T::select(drawn, pdf, one)).only_where(drawn);
        let around = (self.scattering.diffuse(&pair) * scale).map(|it| it.min(T::max_finite()));
        let mut matrix = times(facet(&pair, amplitudes), C::choose(specular, weight, around));
        matrix.rows[0][0] = weight;
        matrix
    }

    /// The matrix of the lobe, of amplitudes at N·V.
    pub(crate) fn lobe_of(&self, wo: T::Vec3, amplitudes: Polarized<Complex<C>>) -> Mueller<C> {
        let lobe = self.scattering.specular(wo).reflected;
        let pair = Pair::<T>::new(lobe.wi, wo);
        times(facet(&pair, amplitudes), lobe.weight)
    }
}
