use core::f64::consts::FRAC_1_PI;

use super::phase;
use crate::brdf::{Brdf, Sample};
use crate::direction::{above_or_normal, above_surface, both_above};
use crate::frame::Frame;
use crate::parameter::model;
use crate::quadrature::integrate;
use crate::real::{Color, Real, Vector};
use crate::sampling::uniform;

model! {
    /// The law of Lommel and Seeliger: light that the grains of a dark surface scatter once.
    ///
    /// # Formula
    /// ```text
    /// f = w p(g)/(4π (N·L + N·V))
    /// p = (1 − ξ²)/(1 + 2ξ cos g + ξ²)^(3/2)    cos g = L·V
    /// ```
    parameters {
        w: C, UNIT, "w", "single scattering albedo: fraction of the light that a grain scatters";
        xi: T, PHASE = 0.0, "ξ", "asymmetry of Henyey and Greenstein's phase function p; below 0 grains scatter back";
    }
    /// | g | | phase angle between light and viewer; 0 at full moon | 0 … π |
    ///
    /// With ξ = 0 grains scatter evenly, and the full disc is equally bright up to its limb, as the full
    /// moon nearly is.
    ///
    /// # Energy
    /// Reciprocal, to the last bit. Conserving: what is scattered more than once is left out. For ξ = 0
    /// the directional albedo is w/2 · (1 − μ ln(1 + 1/μ)) with μ = N·V, at most w/2; otherwise it is an
    /// integral over the phase angle, the one over the azimuth around the viewer being elementary: in
    /// `f64` good to 10⁻⁷ for |ξ| ≤ 0.97, to 10⁻⁴ beyond, where next to all light goes one way; in
    /// `f32` within 5·10⁻⁷ of that.
    ///
    /// # Sampling
    /// With the phase function around the viewer; what falls below the surface is mirrored at it.
    /// The density is (p(g) + p(g*))/4π, g* belonging to the mirror image, and a sample weighs
    /// w p(g)/(p(g) + p(g*)) · N·L/(N·L + N·V), never above w.
    ///
    /// # Sources
    /// H. von Seeliger 1887, E. Lommel 1889; as a BRDF in B. Hapke, *Theory of Reflectance and
    /// Emittance Spectroscopy*, Cambridge University Press, 2nd edition 2012, section 8.5. L. G. Henyey, J. L.
    /// Greenstein, *Diffuse radiation in the Galaxy*, Astrophysical Journal 93, 1941,
    /// [doi:10.1086/144246](https://doi.org/10.1086/144246).
    ///
    /// ```
    /// use brdf::{Brdf, LommelSeeliger};
    /// use glam::DVec3;
    ///
    /// let dust = LommelSeeliger::new(DVec3::splat(0.3), 0.0)?;
    /// assert!((dust.eval(DVec3::Z, DVec3::Z).x - 0.011936620731892).abs() < 1e-15); // w/8π
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct LommelSeeliger<C = glam::Vec3, T = f32>;

    /// A surface of grains of the given single scattering albedo and asymmetry.
    pub fn new;
}

impl<C, T: Real> LommelSeeliger<C, T> {
    /// p(g)/4π, and with that of the mirror image of `wi` below the surface.
    #[inline(always)]
    fn scattered(&self, wi: T::Vec3, wo: T::Vec3) -> (T, T) {
        let image = Vector::new(wi.x(), wi.y(), -wi.z());
        let above = phase::density(self.xi, wi, wo);
        (above, above + phase::density(self.xi, image, wo))
    }

    /// The directional albedo for w = 1: the mean of N·L/(N·L + N·V), 0 below the surface, over the
    /// scattered light.
    ///
    /// Directions of one phase angle g form a circle around the viewer, with N·L = c + b cosφ,
    /// c = N·V cos g, b = sinθₒ sin g. It lies above the surface up to g = π/2 − θₒ, is cut up to
    /// π/2 + θₒ, and lies below it beyond.
    fn relative_albedo(&self, wo: T::Vec3) -> T {
        let viewer = above_or_normal::<T, T::Vec3>(wo);
        let mu = viewer.z();
        let sin = (viewer.x().squared() + viewer.y().squared()).sqrt();
        let circle = |u: T| {
            let (versine, antiversine) = phase::sample(self.xi, u);
            mean_over_circle(mu, sin, versine, antiversine)
        };
        // 1 − sinθₒ without the difference.
        let (more, less) = (T::one() + sin, mu.squared() / (T::one() + sin));
        let first = phase::distribution(self.xi, (more, less));
        let second = phase::distribution(self.xi, (less, more));
        let width = (second - first).max(T::zero());
        // At both of its ends the arc grows like a root.
        let cut = integrate(T::zero(), T::one(), |t: T| {
            let place = first + width * t * t * (T::lit(3.0) - T::lit(2.0) * t);
            circle(place) * (T::lit(6.0) * t * (T::one() - t) * width)
        });
        // What exceeds it is rounding, or a viewer that is no unit vector.
        (cut + integrate(second, T::one(), circle)).at_most(T::one())
    }
}

/// The mean of N·L/(N·L + N·V), 0 below the surface, over a circle around the viewer.
///
/// ```text
/// (1/π) ∫₀^Φ 1 − μ/(a + b cosφ) dφ = (Φ − μ J)/π    a = c + μ    cosΦ = −c/b
/// J = 2/√((a + b)(a − b)) arctan(B/A)               A² = (a + b)(b − c)
/// J = 2/√((a + b)(b − a)) artanh(B/A)  for a < b    B² = |a − b| (b + c)    |A² ± B²| = 2bμ
/// ```
///
/// Where a − b vanishes, a difference that is too small to matter takes its place.
#[inline(always)]
fn mean_over_circle<T: Real>(mu: T, sin: T, versine: T, antiversine: T) -> T {
    let tiny = T::lit(1e-30);
    let (b, c) = (sin * (versine * antiversine).sqrt(), mu * (T::one() - versine));
    let a = mu * antiversine;
    // Above the surface reaches the arc with tan²(Φ/2) = above/below.
    let (above, below) = ((b + c).max(tiny), (b - c).max(tiny));
    let arc = T::lit(2.0) * above.sqrt().atan2(below.sqrt());
    let sum = a + b;
    let distance = (a - b).abs().max(sum * T::lit(1e-8));
    let (root_a, root_b) = ((sum * below).sqrt(), (distance * above).sqrt());
    let artanh = root_b * (root_a + root_b) / (b * mu).max(tiny);
    let angle = T::select(a.gt(b), root_b.atan2(root_a), T::lit(0.5) * artanh.ln_1p());
    let j = T::lit(2.0) * angle / (sum * distance).sqrt();
    ((arc - mu * j) * T::lit(FRAC_1_PI)).max(T::zero())
}

impl<T: Real, C: Color<T>> Brdf<T> for LommelSeeliger<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let above = both_above::<T>(wi, wo);
        let cosines = T::select(above, wi.z() + wo.z(), T::one());
        let value = (phase::density(self.xi, wi, wo) / cosines).min(T::max_finite());
        (self.w * value).only_where(above)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let (_, density) = self.scattered(wi, wo);
        density.only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let [u, turn] = uniform(u);
        let (versine, antiversine) = phase::sample(self.xi, u);
        let sin = (versine * antiversine).sqrt();
        let (sin_phi, cos_phi) = turn.sin_cos_turns();
        let around = Vector::new(sin * cos_phi, sin * sin_phi, T::one() - versine);
        let drawn: T::Vec3 = Frame::from_normal(above_or_normal::<T, _>(wo)).to_world(around);
        let wi: T::Vec3 = Vector::new(drawn.x(), drawn.y(), drawn.z().abs());
        let above = both_above::<T>(wi, wo);
        let (scattered, pdf) = self.scattered(wi, wo);
        let cosines = T::select(above, wi.z() + wo.z(), T::one());
        let weight = self.w * (scattered / pdf * (wi.z() / cosines));
        Sample { wi, weight, pdf }.only_where(above)
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        (self.w * self.relative_albedo(wo)).only_where(above_surface::<T, _>(wo))
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use glam::DVec3;

    use super::*;

    /// The closed form for grains that scatter evenly.
    #[test]
    fn the_albedo_of_even_scattering_is_the_closed_form() {
        let dust = LommelSeeliger::new(1.0_f64, 0.0).unwrap();
        for step in 1..=200 {
            let mu = f64::from(step) / 200.0;
            let wo = DVec3::new((1.0 - mu * mu).sqrt(), 0.0, mu);
            let want = 0.5 * (1.0 - mu * (1.0 / mu).ln_1p());
            let got = dust.albedo(wo);
            assert!((got - want).abs() < 1e-7, "{mu}: {got} {want}");
        }
    }

    /// In single precision too, for viewers of all heights, also where next to all light goes one way.
    #[test]
    #[allow(clippy::cast_possible_truncation, reason = "single precision is tested")]
    fn the_albedo_is_that_of_double_precision() {
        for xi in [-0.999999, -0.99, -0.9, -0.3, 0.0, 0.5, 0.9, 0.99, 0.999, 0.9999, 0.999999] {
            let (single, double) = (f64::from(xi as f32), xi as f32);
            let exact = LommelSeeliger::new(1.0_f64, single).unwrap();
            let rounded = LommelSeeliger::new(1.0_f32, double).unwrap();
            for step in 1..=400 {
                let mu = (f64::from(step) / 400.0).powi(3);
                let wo = glam::Vec3::new((1.0 - mu * mu).sqrt() as f32, 0.0, mu as f32).normalize();
                let want = exact.albedo(wo.as_dvec3().normalize());
                let got = f64::from(rounded.albedo(wo));
                assert!((0.0..=0.500001).contains(&got), "{xi} {mu}: {got}");
                assert!((got - want).abs() < 5e-7, "{xi} {mu}: {got} {want}");
            }
        }
    }

    #[test]
    fn the_distribution_function_inverts_the_samples() {
        for xi in [-0.999, -0.5, -1e-3, 0.0, 1e-3, 0.3, 0.9, 0.999] {
            for step in 0..=50 {
                let u = f64::from(step) / 50.0;
                let (versine, antiversine) = phase::sample(xi, u);
                assert!((versine + antiversine - 2.0).abs() < 1e-12, "{xi} {u}");
                let got = phase::distribution(xi, (versine, antiversine));
                assert!((got - u).abs() < 1e-9, "{xi} {u} {got}");
            }
        }
        assert!((phase::density(0.0, DVec3::X, DVec3::Z) * 4.0 * PI - 1.0).abs() < 1e-15);
    }
}
