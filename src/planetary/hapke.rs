use core::f64::consts::FRAC_1_PI;

use super::chandrasekhar::HFunction;
use super::phase;
use super::roughness::Roughness;
use crate::brdf::{Brdf, Sample};
use crate::direction::{above_or_normal, above_surface, both_above};
use crate::error::{ParameterError, range};
use crate::frame::Frame;
use crate::parameter::{Kind, Parameter, Preset, model};
use crate::quadrature::over_hemisphere;
use crate::real::{Color, Real, Vector, lift, positive_zero};
use crate::sampling::{cosine_hemisphere, uniform};

/// Hapke's model of the moon and of other bodies of dark grains: light that grains scatter once and more
/// often, the opposition surge, and slopes too small to be seen.
///
/// # Formula
/// ```text
/// f = w/4π · μ₀ₑ/(μ₀ₑ + μₑ) · ((1 + B) p + H(μ₀ₑ) H(μₑ) − 1) · S/μ₀
/// B = B₀/(1 + tan(g/2)/h)                 tan(g/2) = |L − V|/|L + V|
/// p = (1 − ξ²)/(1 + 2ξ cos g + ξ²)^(3/2)      cos g = L·V
/// ```
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | w | `w` | single scattering albedo: fraction of the light that a grain scatters | 0 … 1 |
/// | ξ | `xi` | asymmetry of Henyey and Greenstein's phase function p; below 0 grains scatter back | −0.999999 … 0.999999, 0 by default |
/// | B₀ | `b0` | height of the opposition surge | 0 … 100, 0 by default |
/// | h | `h` | its width in tan(g/2) | 10⁻⁶ … 10⁴, 0.05 by default |
/// | θ̄ | `theta_bar` | mean slope of the roughness, radians | 0 … π/3, 0 by default |
/// | | `h_function` | [`HFunction`]: how light that is scattered more than once is approximated | that of 1993 by default |
///
/// g is the phase angle between light and viewer; μ₀ₑ, μₑ and S are what the roughness makes of the cosines μ₀ = N·L,
/// μ = N·V and of the brightness: without it μ₀, μ and 1. The printed factor μ₀ₑ S/μ₀ has no quotient by μ₀ here.
///
/// # Energy
/// Reciprocal, to the last bit. **Not** conserving in general: for w = 1 and grains that scatter evenly the albedo is 0.986 … 0.994
/// with the H of 1993 and up to 1.040 with that of 1981; the surge, which adds light and takes none, makes it up to
/// 1.12 and 1.174 for B₀ = 1, ξ = −0.3.
///
/// The directional albedo is an integral over θᵢ and the azimuth, good to 10⁻⁶ for |ξ| ≤ 0.6.
///
/// # Derivatives
/// By w at 1, where √(1 − w) has none: the root, and so H through it, counts as constant there, and
/// the derivative is that by the w outside of it.
///
/// # Sampling
/// With the phase function around the viewer, what falls below the surface mirrored at it, or with cosθ/π, chosen by about
/// how much light is scattered once and more often.
///
/// # Sources
/// B. Hapke, *Bidirectional Reflectance Spectroscopy 1. Theory*, JGR 86, 1981,
/// [doi:10.1029/JB086iB04p03039](https://doi.org/10.1029/JB086iB04p03039); *3. Correction for Macroscopic
/// Roughness*, Icarus 59, 1984, [doi:10.1016/0019-1035(84)90054-X](https://doi.org/10.1016/0019-1035(84)90054-X);
/// *4. The Extinction Coefficient and the Opposition Effect*, Icarus 67, 1986,
/// [doi:10.1016/0019-1035(86)90108-9](https://doi.org/10.1016/0019-1035(86)90108-9). Signs of the roughness differ between
/// reprints: these are those of 1984, and both denominators contain the azimuth. Some descriptions divide by μ where
/// it is μ₀.
///
/// ```
/// use brdf::{Brdf, Hapke};
/// use glam::DVec3;
///
/// let moon = Hapke::new(DVec3::splat(0.25))?
///     .with_phase(-0.3)?
///     .with_surge(1.0, 0.05)?
///     .with_roughness(0.35)?;
/// // The full moon is nearly as bright at its limb as in its middle.
/// let limb = DVec3::new(0.8, 0.0, 0.6);
/// let (middle, edge) = (moon.eval(DVec3::Z, DVec3::Z).x, moon.eval(limb, limb).x * 0.6);
/// assert!((edge / middle - 0.99).abs() < 0.01);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("moon", "regolith", "opposition effect"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hapke<C = glam::Vec3, T = f32> {
    w: C,
    xi: T,
    b0: T,
    h: T,
    roughness: Roughness<T>,
    h_function: HFunction,
}

lift! {
    [T: Real, C: Color<T>] Hapke<C, T> => Hapke<C::Over<U>, U>:
    Hapke { w: color, xi: number, b0: number, h: number, roughness: part, h_function: part }
}

impl<C, T> Hapke<C, T> {
    /// The table of the parameters.
    pub const PARAMETERS: &'static [Parameter] = &[
        model!(@row w: C, UNIT, "w", "single scattering albedo"),
        model!(@row xi: T, PHASE = 0.0, "ξ", "asymmetry of the phase function; below 0 grains scatter back"),
        model!(@row b0: T, SURGE = 0.0, "B₀", "height of the opposition surge"),
        model!(@row h: T, SURGE_WIDTH = 0.05, "h", "width of the opposition surge"),
        model!(@row theta_bar: T, MEAN_SLOPE = 0.0, "θ̄", "mean slope of the roughness, radians"),
        Parameter::new(
            "h_function",
            "H",
            "how light that is scattered more than once is approximated",
            Kind::Word(&["1993", "1981"]),
        )
        .or(Preset::Word("1993")),
    ];
}

impl<T: Real, C: Color<T>> Hapke<C, T> {
    /// A smooth surface of grains that scatter evenly, without a surge, with the H of 1993.
    ///
    /// # Errors
    /// If `w` is not in 0 … 1.
    pub fn new(w: C) -> Result<Self, ParameterError> {
        range::UNIT.check("w", w)?;
        Ok(Self {
            w: positive_zero(w),
            xi: T::zero(),
            b0: T::zero(),
            h: T::lit(0.05),
            roughness: Roughness::new(T::zero()),
            h_function: HFunction::default(),
        })
    }

    /// With grains of this asymmetry.
    ///
    /// # Errors
    /// If `xi` is not in −0.999999 … 0.999999.
    pub fn with_phase(self, xi: T) -> Result<Self, ParameterError> {
        range::PHASE.check("xi", xi)?;
        Ok(Self { xi, ..self })
    }

    /// With an opposition surge of this height and width.
    ///
    /// # Errors
    /// If `b0` is not in 0 … 100, or `h` not in 10⁻⁶ … 10⁴.
    pub fn with_surge(self, b0: T, h: T) -> Result<Self, ParameterError> {
        range::SURGE.check("b0", b0)?;
        range::SURGE_WIDTH.check("h", h)?;
        Ok(Self { b0, h, ..self })
    }

    /// With roughness of this mean slope.
    ///
    /// # Errors
    /// If `theta_bar` is not in 0 … π/3.
    pub fn with_roughness(self, theta_bar: T) -> Result<Self, ParameterError> {
        range::MEAN_SLOPE.check("theta_bar", theta_bar)?;
        Ok(Self { roughness: Roughness::new(theta_bar), ..self })
    }

    /// With another approximation of H.
    #[must_use]
    pub fn with_h_function(self, h_function: HFunction) -> Self {
        Self { h_function, ..self }
    }

    /// p/4π, and with that of the mirror image of `wi` below the surface.
    #[inline(always)]
    fn scattered(&self, wi: T::Vec3, wo: T::Vec3) -> [T; 2] {
        let image = Vector::new(wi.x(), wi.y(), -wi.z());
        let above = phase::density(self.xi, wi, wo);
        [above, above + phase::density(self.xi, image, wo)]
    }

    /// 1 + B.
    #[inline(always)]
    fn surge(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let tiny = T::lit(1e-36);
        let sum = Vector::length_squared(wi + wo).max(tiny).sqrt();
        let difference = Vector::length_squared(wi - wo).max(tiny).sqrt();
        let width = self.h * sum;
        T::one() + self.b0 * (width / (width + difference))
    }

    /// f, without the mask of the surface.
    #[inline(always)]
    fn value(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let seen = self.roughness.seen(wi, wo);
        let [above, _] = self.scattered(wi, wo);
        let once = above * self.surge(wi, wo);
        let quarter = T::lit(0.25 * FRAC_1_PI);
        self.w.map(|w| {
            let again = self.h_function.product_less_one(w, seen.cosines);
            (w * (once + quarter * again) * seen.scale).min(T::max_finite())
        })
    }

    /// The probabilities to draw with the phase function and from the cosine.
    #[inline(always)]
    fn shares(&self, wo: T::Vec3) -> [T; 2] {
        let one = T::one();
        let cos = above_or_normal::<T, T::Vec3>(wo).z().at_most(one);
        let again = self.w.map(|w| self.h_function.product_less_one(w, [cos, T::lit(0.5)]));
        let again = again.mean();
        let once = one / (one + again);
        [once, again * once]
    }

    #[inline(always)]
    fn density(&self, [share, rest]: [T; 2], wi: T::Vec3, wo: T::Vec3) -> T {
        let [_, scattered] = self.scattered(wi, wo);
        let density = share * scattered + rest * (wi.z() * T::lit(FRAC_1_PI));
        density.only_where(both_above::<T>(wi, wo))
    }
}

impl<T: Real, C: Color<T>> Brdf<T> for Hapke<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        self.value(wi, wo).only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        self.density(self.shares(wo), wi, wo)
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let (zero, one) = (T::zero(), T::one());
        let ([u, turn], shares) = (uniform(u), self.shares(wo));
        let [share, rest] = shares;
        let once = u.lt(share);
        let part =
            T::select(once, u / share, (u - share) / rest.max(T::lit(1e-30))).clamp(zero, one);
        let (versine, antiversine) = phase::sample(self.xi, part);
        let sin = (versine * antiversine).sqrt();
        let (sin_phi, cos_phi) = turn.sin_cos_turns();
        let around = Vector::new(sin * cos_phi, sin * sin_phi, one - versine);
        let drawn: T::Vec3 = Frame::from_normal(above_or_normal::<T, _>(wo)).to_world(around);
        let folded: T::Vec3 = Vector::new(drawn.x(), drawn.y(), drawn.z().abs());
        let wi = Vector::select(once, folded, cosine_hemisphere([part, turn]));
        let pdf = self.density(shares, wi, wo);
        let some = pdf.gt(zero);
        let scale = (wi.z() / T::select(some, pdf, one)).min(T::max_finite());
        let weight = (self.eval(wi, wo) * scale).map(|value| value.min(T::max_finite()));
        Sample { wi, weight, pdf }.only_where(some)
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        let albedo = over_hemisphere(wo, |wi, wo| self.value(wi, wo) * wi.z());
        let albedo = albedo.map(|value: T| value.clamp(T::zero(), T::max_finite()));
        albedo.only_where(above_surface::<T, _>(wo))
    }
}
