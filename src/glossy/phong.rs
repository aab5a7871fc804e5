use core::f64::consts::FRAC_1_PI;

use super::cosine_power::{power_of_cosine, power_of_versine, quarter_turn};
use super::mirror::{around_mirror, mirror_versine, sample_power, unit_viewer};
use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above};
use crate::parameter::model;
use crate::real::{Color, Real, Vector};
use crate::sampling::uniform;

model! {
    /// Phong's lobe as a physically plausible BRDF, also called modified Phong.
    ///
    /// # Formula
    /// ```text
    /// f = kₛ (n + 2)/(2π) · max(0, R·V)ⁿ        R = 2N(N·L) − L
    /// ```
    parameters {
        specular: C, UNIT, "kₛ", "directional albedo at normal incidence";
        exponent: T, EXPONENT, "n", "sharpness of the lobe; for 0 it is a constant, where R·V > 0";
    }
    flags {
        normalized: true, "false in descriptions is [`ClassicPhong`](crate::ClassicPhong)";
    }
    ///
    /// R·V is computed as 1 − |R − V|²/2, which keeps the digits of the narrowest lobes: the
    /// relative error in `f32` is at most 5·10⁻⁷ (1 + n (1 − S)/S) with S = R·V.
    ///
    /// In the plane of incidence a Phong lobe of exponent n looks like a
    /// [Blinn–Phong](crate::BlinnPhong) lobe of exponent 4n: cosⁿβ ≈ cos⁴ⁿ(β/2), where the latter is
    /// larger by a factor of about exp(nβ⁴/16).
    ///
    /// # Energy
    /// Reciprocal, to the last bit. Conserving: the directional albedo is kₛ at normal incidence and
    /// falls from there, since part of the lobe sinks below the surface (n = 10: 1, 0.866, 0.505,
    /// 0.124 at 0°, 30°, 60°, 89.9°). The lobe of 1975, without the constant and over the cosine, is
    /// [`ClassicPhong`](crate::ClassicPhong).
    ///
    /// Directional albedo, with s = sinθ, c = cosθ and W(φ) = ∫₀^φ cosⁿ⁺¹:
    /// E = kₛ/2 · (c(1 + W(π/2 − θ)/W(π/2)) + sⁿ⁺²/((n + 1) W(π/2))).
    ///
    /// # Sampling
    /// With density (n + 1)/(2π) (R·V)ⁿ around the mirror direction.
    ///
    /// # Sources
    /// R. R. Lewis, *Making Shaders More Physically Plausible*, Computer Graphics Forum 13(2), 1994,
    /// [doi:10.1111/1467-8659.1320109](https://doi.org/10.1111/1467-8659.1320109);
    /// E. P. Lafortune, Y. D. Willems, *Using the Modified Phong Reflectance Model for Physically
    /// Based Rendering*, report CW 197, KU Leuven, 1994.
    ///
    /// ```
    /// use brdf::{Brdf, Phong};
    /// use glam::DVec3;
    ///
    /// let plastic = Phong::new(DVec3::splat(0.5), 10.0)?;
    /// assert!((plastic.eval(DVec3::Z, DVec3::Z).x - 0.954929658551372).abs() < 1e-14);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct Phong<C = glam::Vec3, T = f32>;

    /// A lobe with the given albedo at normal incidence and exponent.
    pub fn new;
}

impl<T: Real, C: Color<T>> Brdf<T> for Phong<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let above = both_above::<T>(wi, wo);
        let constant = (self.exponent + T::lit(2.0)) * T::lit(0.5 * FRAC_1_PI);
        let value = constant * power_of_versine(mirror_versine::<T>(wi, wo), self.exponent);
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
        let ratio = (self.exponent + T::lit(2.0)) / (self.exponent + T::one());
        let pdf = self.pdf(wi, wo);
        Sample { wi, weight: self.specular * (ratio * wi.z()), pdf }.only_where(pdf.gt(T::zero()))
    }

    #[inline(always)]
    fn albedo(&self, wo: T::Vec3) -> C {
        let one = T::one();
        let w = unit_viewer::<T>(wo);
        let cos = w.z();
        let sin_squared = w.x() * w.x() + w.y() * w.y();
        let (within, whole) = quarter_turn(self.exponent + one, cos, sin_squared.sqrt());
        let beyond = power_of_cosine(sin_squared.sqrt(), cos * cos, self.exponent + T::lit(2.0));
        let value = cos * (one + within) + beyond / ((self.exponent + one) * whole);
        let albedo = self.specular * (value * T::lit(0.5));
        albedo.only_where(above_surface::<T, _>(wo))
    }
}
