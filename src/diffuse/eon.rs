use core::f64::consts::FRAC_1_PI;

use super::clipped_cosine::ClippedCosine;
use super::grooves::{AT_GRAZING, missing, shape};
use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above};
use crate::parameter::model;
use crate::real::{Color, Mask, Real, Vector};

model! {
    /// "EON", a rough diffuse surface that keeps all energy: [`Fon`](crate::Fon) and the light that its
    /// grooves send to each other.
    ///
    /// # Formula
    /// ```text
    /// f = ρ/π · A (1 + r s/t′) + ρₘ/π · (1 − E(θᵢ)) (1 − E(θₒ))/(1 − Ē)
    /// ρₘ = ρ² Ē/(1 − ρ (1 − Ē))       A = 1/(1 + (½ − 2/(3π)) r)
    /// E(θ) = A (1 + r G(θ)/π)         Ē = A (1 + (2/3 − 28/(15π)) r)
    /// ```
    ///
    /// s/t′ and G are those of [`Fon`](crate::Fon); E is its albedo for ρ = 1, exact and not the fit, and Ē the
    /// average of E over the cosine.
    parameters {
        albedo: C, UNIT, "ρ", "fraction of the light that a facet reflects";
        roughness: T, UNIT, "r", "roughness: 0 is Lambert's surface, 1 the roughest";
    }
    constants {
        let a = T::one() / (T::one() + T::lit(AT_GRAZING) * roughness);
        let average = a * (T::one() + T::lit(2.0 / 3.0 - 28.0 / 15.0 * FRAC_1_PI) * roughness);
        /// ρ A.
        direct: C = albedo * a;
        /// ρₘ.
        multiple: C = albedo.map(|rho| {
            rho * (rho * average) / ((T::one() - rho) + rho * average)
        });
        /// A r, so that 1 − E(θ) is A r (½ − 2/(3π) − G/π).
        dark: T = a * roughness;
    }
    ///
    /// 1 − E and 1 − Ē have the factor A r in common, which is taken out of the quotient: r = 0 is no
    /// 0/0, and at grazing, where E comes close to 1, nothing cancels.
    ///
    /// # Energy
    /// Reciprocal, to the last bit. Conserving: the directional albedo is ρ E + ρₘ (1 − E), which is 1 at all angles
    /// for ρ = 1 and at most ρ below. A rough surface of many colours is more saturated than its
    /// facets. r = 0 is [`Lambert`](crate::Lambert) but for rounding. f grows without bound, as 1/t′, where
    /// both directions graze side by side; the radiance f cosθᵢ does not.
    ///
    /// # Sampling
    /// As its authors do: a part of the directions is uniform, which bounds the weights, the others follow a
    /// cosine that a linear transformation leans towards the viewer, clipped at the horizon. Their fit of
    /// the coefficient d exceeds 0 within 0.8° of the normal, where the clipping would have the wrong side; there it is 0.
    ///
    /// # Sources
    /// J. Portsmouth, P. Kutz, S. Hill, *EON: A Practical Energy-Preserving Rough Diffuse BRDF*, JCGT 14(1),
    /// 2025, <https://jcgt.org/published/0014/01/06/>.
    ///
    /// ```
    /// use brdf::{Brdf, Eon};
    /// use glam::DVec3;
    ///
    /// let snow = Eon::new(DVec3::ONE, 0.8)?;
    /// assert!((snow.albedo(DVec3::new(0.6, 0.0, 0.8)).x - 1.0).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("OpenPBR", "energy-preserving Oren-Nayar"))]
    pub struct Eon<C = glam::Vec3, T = f32>;

    /// A rough diffuse surface.
    pub fn new;
}

/// (1 − Ē)/(A r) = 6/(5π) − 1/6.
const AVERAGE_MISSING: f64 = 1.2 * FRAC_1_PI - 1.0 / 6.0;

impl<T: Real, C: Color<T>> Brdf<T> for Eon<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        // A direction that is a little too long makes s a little less than −1.
        let single = (T::one() + self.roughness * shape::<T>(wi, wo)).max(T::zero());
        let again = self.dark * T::lit(1.0 / AVERAGE_MISSING);
        let multiple = again * (missing::<T>(wi) * missing::<T>(wo));
        let value = self.direct * single + self.multiple * multiple;
        (value * T::lit(FRAC_1_PI)).only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let density = ClippedCosine::new(self.roughness, wo).pdf(wi);
        density.only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let lobe = ClippedCosine::new(self.roughness, wo);
        let wi = lobe.sample(u);
        let above = both_above::<T>(wi, wo);
        let pdf = lobe.pdf(wi).only_where(above);
        let drawn = above.and(pdf.gt(T::zero()));
        let weight = self.eval(wi, wo) * (wi.z() / T::select(drawn, pdf, T::one()));
        Sample { wi, weight, pdf }.only_where(drawn)
    }

    #[inline(always)]
    fn albedo(&self, wo: T::Vec3) -> C {
        let missing = self.dark * missing::<T>(wo);
        let value = self.albedo * (T::one() - missing) + self.multiple * missing;
        value.only_where(above_surface::<T, _>(wo))
    }
}
