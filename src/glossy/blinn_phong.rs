use core::f64::consts::{FRAC_1_PI, FRAC_PI_2, LN_2, PI, TAU};

use super::cosine_power::power_of_cosine;
use super::lobe::check_lobe;
use super::mirror::unit_viewer;
use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above, reflect};
use crate::error::ParameterError;
use crate::quadrature::integrate;
use crate::real::{Color, Mask, Real, Vector, lift};
use crate::sampling::uniform;

/// Blinn's variant of Phong's lobe, around the half vector.
///
/// ```text
/// f = kₛ C (N·H)ⁿ
/// C = (n + 2)(n + 4)/(8π (2^(−n/2) + n))        C = 1 in the classic, unnormalised form
/// ```
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | kₛ | `specular` | directional albedo at normal incidence | 0 … 1 |
/// | n | `exponent` | sharpness of the lobe; 0 is Lambert's surface | 0 … 10⁸ |
///
/// Reciprocal, to the last bit. Conserving: with this C, from the integral, the directional albedo
/// is kₛ at normal incidence and lower elsewhere. The popular (n + 8)/(8π) is a fit to it that
/// overshoots: 1.024, 1.075, 1.018 kₛ for n = 1, 10, 100.
///
/// The [`unnormalized`](Self::unnormalized) form is **not** conserving for small n: its albedo at
/// normal incidence is kₛ/C, which is πkₛ for n = 0, 1.50 kₛ for n = 10 and below kₛ from
/// n ≈ 18.7 on. Blinn, like Phong, wrote an intensity, which is the BRDF times N·L; here (N·H)ⁿ is
/// the BRDF itself, as renderers use it.
///
/// In the plane of incidence the angle between N and H is half of the angle β between R and V, and
/// cosⁿβ ≈ cos⁴ⁿ(β/2): the latter is larger by a factor of about exp(nβ⁴/16), a difference of at
/// most about e⁻²/n, near β = 2/√n. So a Blinn–Phong lobe of exponent 4n looks like a
/// [Phong](crate::Phong) lobe of exponent n there. Out of the plane it does not: at grazing it is
/// much narrower across than along.
///
/// (N·H)² is z²/(x² + y² + z²) of wi + wo, a power without a root; the relative error in `f32` is
/// at most 5·10⁻⁷ (1 + n (1 − S)/S) with S = N·H, for values down to 10⁻³⁰.
///
/// Sampled by half vectors with density (n + 2)/(2π) (N·H)ⁿ⁺¹, that is
/// (n + 2)/(8π) (N·H)ⁿ⁺¹/(V·H) per steradian of `wi`. The directional albedo is an integral over
/// the tilt of the half vector, the one over its azimuth being elementary.
///
/// J. F. Blinn, *Models of Light Reflection for Computer Synthesized Pictures*, SIGGRAPH 1977,
/// [doi:10.1145/563858.563893](https://doi.org/10.1145/563858.563893), for (N·H)ⁿ.
///
/// ```
/// use brdf::{Brdf, BlinnPhong};
/// use glam::DVec3;
///
/// let plastic = BlinnPhong::new(DVec3::splat(0.5), 1.0)?;
/// assert!((plastic.eval(DVec3::Z, DVec3::Z).x - 0.174807763395964).abs() < 1e-14);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlinnPhong<C = glam::Vec3, T = f32> {
    specular: C,
    exponent: T,
    /// C.
    constant: T,
}

impl<C, T> BlinnPhong<C, T> {
    /// A lobe with the given albedo at normal incidence and exponent.
    ///
    /// # Errors
    /// If a channel of `specular` is not in 0 … 1 or `exponent` not in 0 … 10⁸.
    pub fn new(specular: C, exponent: T) -> Result<Self, ParameterError>
    where
        T: Real,
        C: Color<T>,
    {
        let lobe = Self::unnormalized(specular, exponent)?;
        let integral = (exponent * T::lit(-0.5 * LN_2)).exp() + exponent;
        let constant = (exponent + T::lit(2.0)) / integral * (exponent + T::lit(4.0));
        Ok(Self { constant: constant * T::lit(0.125 * FRAC_1_PI), ..lobe })
    }

    /// The classic lobe f = kₛ (N·H)ⁿ.
    ///
    /// # Errors
    /// If a channel of `specular` is not in 0 … 1 or `exponent` not in 0 … 10⁸.
    pub fn unnormalized(specular: C, exponent: T) -> Result<Self, ParameterError>
    where
        T: Real,
        C: Color<T>,
    {
        let specular = check_lobe(specular, exponent)?;
        Ok(Self { specular, exponent, constant: T::one() })
    }
}

lift! {
    [T: Real, C: Color<T>] BlinnPhong<C, T> => BlinnPhong<C::Over<U>, U>:
    BlinnPhong { specular: color, exponent: number, constant: number }
}

impl<T: Real, C: Color<T>> Brdf<T> for BlinnPhong<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let above = both_above::<T>(wi, wo);
        let value = self.constant * Halfway::<T>::new(wi, wo).power(self.exponent);
        (self.specular * value).only_where(above)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let above = both_above::<T>(wi, wo);
        self.pdf_of(above, &Halfway::new(wi, wo))
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let (zero, one, two) = (T::zero(), T::one(), T::lit(2.0));
        let [u, turn] = uniform(u);
        let versine = -((-u).ln_1p() / (self.exponent + two)).exp_m1();
        let sin = (versine * (two - versine)).max(zero).sqrt();
        let cos_h = one - versine;
        let (sin_phi, cos_phi) = turn.sin_cos_turns();
        let h = <T::Vec3 as Vector<T>>::new(sin * cos_phi, sin * sin_phi, cos_h);
        let viewer = unit_viewer::<T>(wo);
        let wi = reflect(viewer, h);
        // Half vectors that the viewer sees from behind give no direction.
        let cos_d = Vector::dot(viewer, h);
        let drawn = both_above::<T>(wi, wo).and(cos_d.gt(zero));
        // f cosθᵢ / pdf, where N·L < |wi + wo|·(N·H) makes the quotient by N·H harmless. All from
        // the rounded direction, as in `eval` and `pdf`: at grazing the V·H of the drawn half
        // vector is a small difference.
        let halfway = Halfway::new(wi, wo);
        let quotient = halfway.whole() * (wi.z() / T::select(drawn, halfway.height, one));
        let scale = self.constant * T::lit(2.0 * TAU) / (self.exponent + two);
        let pdf = self.pdf_of(drawn, &halfway);
        Sample { wi, weight: self.specular * (scale * quotient), pdf }
            .only_where(drawn.and(pdf.gt(zero)))
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        let (zero, half, one, pi) = (T::zero(), T::lit(0.5), T::one(), T::lit(PI));
        let w = unit_viewer::<T>(wo);
        let cos = w.z();
        let sin = (w.x() * w.x() + w.y() * w.y()).sqrt();
        // All half vectors with a tilt below `first` mirror the viewer to above the surface, none
        // beyond `last`. Neither matters where the power is below the last digit.
        let reach = T::lit(9.0) / (self.exponent + one).sqrt();
        let first = (cos.atan2(sin) * half).min(reach);
        let last = ((T::lit(FRAC_PI_2) + sin.atan2(cos)) * half).min(reach);
        let whole = integrate(zero, first, |tilt| self.ring((sin, cos), tilt, |_, _, _| pi));
        // In between, those with azimuth below acos((cosθ/(2 N·H) − center)/swing). The integrand
        // begins and ends like a power 3/2, which sin² smooths.
        let cut = integrate(zero, one, |t: T| {
            let (sin_t, cos_t) = (t * T::lit(FRAC_PI_2)).sin_cos();
            let tilt = first + (last - first) * sin_t * sin_t;
            let ring = self.ring((sin, cos), tilt, |cos_h, center, swing| {
                let swings = swing.gt(zero).and(cos_h.gt(zero));
                let edge = cos * half / T::select(swings, cos_h, one) - center;
                (edge / T::select(swings, swing, one)).acos()
            });
            ring * (sin_t * cos_t * pi * (last - first))
        });
        let albedo = self.specular * (self.constant * (whole + cut) * T::lit(2.0)).max(zero);
        C::choose(above_surface::<T, _>(wo), albedo, C::splat(zero))
    }
}

impl<T: Real, C> BlinnPhong<C, T> {
    /// ∫ (N·H)ⁿ cosθᵢ 4 V·H over the half vectors of one tilt with azimuths, from the viewer's on,
    /// up to an angle; V·H = center + swing · cos(azimuth) and cosθᵢ = 2 (V·H)(N·H) − cosθₒ.
    #[inline(always)]
    fn ring(&self, (sin_o, cos_o): (T, T), tilt: T, azimuth: impl Fn(T, T, T) -> T) -> T {
        let (half, four) = (T::lit(0.5), T::lit(4.0));
        let (sin_h, cos_h) = tilt.sin_cos();
        let (center, swing) = (cos_o * cos_h, sin_o * sin_h);
        let azimuth = azimuth(cos_h, center, swing);
        let (sin, cos) = azimuth.sin_cos();
        let first = center * azimuth + swing * sin;
        let second = center * first + swing * (center * sin + swing * half * (azimuth + sin * cos));
        let power = power_of_cosine(cos_h, sin_h * sin_h, self.exponent);
        power * sin_h * four * (T::lit(2.0) * cos_h * second - cos_o * first)
    }

    #[inline(always)]
    fn pdf_of(&self, above: T::Mask, halfway: &Halfway<T>) -> T {
        // (n + 2)/(8π) (N·H)ⁿ (N·H)/(V·H), where V·H is half the length of wi + wo.
        let density = (self.exponent + T::lit(2.0)) * T::lit(0.25 * FRAC_1_PI);
        let whole = T::select(above, halfway.whole(), T::one());
        let value = density * halfway.power(self.exponent) * (halfway.height / whole);
        value.min(T::max_finite()).only_where(above)
    }
}

/// The vector wi + wo, twice V·H long: its component along the normal, and the squares of its
/// components along the normal and across.
struct Halfway<T> {
    height: T,
    along: T,
    across: T,
}

impl<T: Real> Halfway<T> {
    #[inline(always)]
    fn new(wi: T::Vec3, wo: T::Vec3) -> Self {
        let sum = wi + wo;
        // Two directions that graze so much that the square has no digits, or is 0, count as
        // grazing less: 10⁻¹⁹ radians in single precision.
        let along = sum.z().squared().max(T::lit(4.0) / T::max_finite());
        Self { height: sum.z(), along, across: sum.x().squared() + sum.y().squared() }
    }

    /// |wi + wo|².
    #[inline(always)]
    fn whole(&self) -> T {
        self.along + self.across
    }

    /// (N·H)ⁿ, without a root.
    #[inline(always)]
    fn power(&self, exponent: T) -> T {
        self.along.power_of_part(self.across, exponent * T::lit(0.5))
    }
}
