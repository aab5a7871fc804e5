use core::f64::consts::{FRAC_1_PI, PI, TAU};

use super::cosine_power::{power_of_versine, quarter_turn};
use super::mirror::{around_mirror, mirror_versine, sample_power, unit_viewer};
use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above};
use crate::parameter::model;
use crate::real::{Color, Real, Vector};
use crate::sampling::uniform;

model! {
    /// Phong's highlight as printed in 1975, for pictures that must match it.
    ///
    /// # Formula
    /// ```text
    /// I = kₛ max(0, R·V)ⁿ                 the intensity of the highlight, of a light of intensity 1
    /// f = kₛ max(0, R·V)ⁿ / (N·L)         the BRDF that gives f cosθᵢ = I
    /// ```
    parameters {
        specular: C, UNIT, "kₛ", "intensity at the centre of the highlight";
        exponent: T, EXPONENT, "n", "sharpness of the highlight";
    }
    ///
    /// # Energy
    /// **Not** reciprocal: the cosine belongs to the light alone. **Not** conserving: the
    /// directional albedo is 2πkₛ/(n + 1) at normal incidence and falls from there, so it exceeds kₛ
    /// for n < 2π − 1 (n = 0: 6.28, n = 1: 3.14) and fades for larger n. f grows without bound where
    /// the light grazes; the radiance f cosθᵢ does not. [`Phong`](crate::Phong) is the lobe for
    /// physically based rendering.
    ///
    /// Directional albedo E = kₛ π/(n + 1) · (1 + W(π/2 − θ)/W(π/2)) with W(φ) = ∫₀^φ cosⁿ.
    ///
    /// # Sampling
    /// With density (n + 1)/(2π) (R·V)ⁿ around the mirror direction.
    ///
    /// # Sources
    /// B. T. Phong, *Illumination for Computer Generated Pictures*, CACM 18(6), 1975,
    /// [doi:10.1145/360825.360839](https://doi.org/10.1145/360825.360839).
    ///
    /// ```
    /// use brdf::{Brdf, ClassicPhong};
    /// use glam::DVec3;
    ///
    /// let highlight = ClassicPhong::new(DVec3::ONE, 10.0)?;
    /// let (wi, wo) = (DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.6, 0.0, 0.8));
    /// assert!((highlight.eval(wi, wo).x * wi.z - 1.0).abs() < 1e-14);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct ClassicPhong<C = glam::Vec3, T = f32>;

    /// A highlight with the given intensity at its centre and exponent.
    pub fn new;
}

impl<T: Real, C: Color<T>> Brdf<T> for ClassicPhong<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let above = both_above::<T>(wi, wo);
        let cos = T::select(above, wi.z(), T::one());
        let power = power_of_versine(mirror_versine::<T>(wi, wo), self.exponent);
        let value = (power / cos).min(T::max_finite());
        (self.specular * value).only_where(above)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let above = both_above::<T>(wi, wo);
        let constant = (self.exponent + T::one()) * T::lit(0.5 * FRAC_1_PI);
        let value = constant * power_of_versine(mirror_versine::<T>(wi, wo), self.exponent);
        value.only_where(above)
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let [u, turn] = uniform(u);
        let wi = around_mirror::<T>(wo, sample_power(self.exponent, u), turn);
        let weight = self.specular * (T::lit(TAU) / (self.exponent + T::one()));
        let pdf = self.pdf(wi, wo);
        Sample { wi, weight, pdf }.only_where(pdf.gt(T::zero()))
    }

    #[inline(always)]
    fn is_reciprocal(&self) -> bool {
        false
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        let one = T::one();
        let w = unit_viewer::<T>(wo);
        let sin = (w.x() * w.x() + w.y() * w.y()).sqrt();
        let (within, _) = quarter_turn(self.exponent, w.z(), sin);
        let albedo = self.specular * (T::lit(PI) / (self.exponent + one) * (one + within));
        albedo.only_where(above_surface::<T, _>(wo))
    }
}
