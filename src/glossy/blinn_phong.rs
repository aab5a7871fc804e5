use core::f64::consts::{FRAC_1_PI, FRAC_PI_2, LN_2, PI, TAU};

use super::cosine_power::power_of_cosine;
use super::mirror::unit_viewer;
use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above, reflect};
use crate::parameter::model;
use crate::quadrature::integrate;
use crate::real::{Color, Mask, Real, Vector};
use crate::sampling::{ln_of_rest, uniform};

model! {
    /// Blinn's variant of Phong's lobe, around the half vector.
    ///
    /// # Formula
    /// ```text
    /// f = kₛ C (N·H)ⁿ
    /// C = (n + 2)(n + 4)/(8π (2^(−n/2) + n))        C = 1 in the classic, unnormalised form
    /// ```
    parameters {
        specular: C, UNIT, "kₛ", "directional albedo at normal incidence";
        exponent: T, EXPONENT, "n", "sharpness of the lobe; 0 is Lambert's surface";
    }
    flags {
        normalized: true, "false is [`unnormalized`](Self::unnormalized)";
    }
    constants {
        let (n_2, n_4) = (exponent + T::lit(2.0), exponent + T::lit(4.0));
        let integral = (exponent * T::lit(-0.5 * LN_2)).exp() + exponent;
        let normalizing = n_2 / integral * n_4 * T::lit(0.125 * FRAC_1_PI);
        /// C.
        c: T = if normalized { normalizing } else { T::one() };
    }
    ///
    /// In the plane of incidence the angle between N and H is half of the angle β between R and V,
    /// and cosⁿβ ≈ cos⁴ⁿ(β/2): the latter is larger by a factor of about exp(nβ⁴/16), a difference of
    /// at most about e⁻²/n, near β = 2/√n. So a Blinn–Phong lobe of exponent 4n looks like a
    /// [Phong](crate::Phong) lobe of exponent n there. Out of the plane it does not: at grazing it is
    /// much narrower across than along.
    ///
    /// (N·H)² is z²/(x² + y² + z²) of wi + wo, a power without a root; the relative error in `f32` is
    /// at most 5·10⁻⁷ (1 + n (1 − S)/S) with S = N·H, for values down to 10⁻³⁰.
    ///
    /// # Energy
    /// Reciprocal, to the last bit. Conserving: with this C, from the integral, the directional
    /// albedo is kₛ at normal incidence and lower elsewhere. The popular (n + 8)/(8π) is a fit to it
    /// that overshoots: 1.024, 1.075, 1.018 kₛ for n = 1, 10, 100.
    ///
    /// The [`unnormalized`](Self::unnormalized) form is **not** conserving for small n: its albedo at
    /// normal incidence is kₛ/C, which is πkₛ for n = 0, 1.50 kₛ for n = 10 and below kₛ from
    /// n ≈ 18.7 on. Blinn, like Phong, wrote an intensity, which is the BRDF times N·L; here (N·H)ⁿ
    /// is the BRDF itself, as renderers use it.
    ///
    /// The directional albedo is an integral over the tilt of the half vector, the one over its
    /// azimuth being elementary.
    ///
    /// # Sampling
    /// By half vectors with density (n + 2)/(2π) (N·H)ⁿ⁺¹, that is (n + 2)/(8π) (N·H)ⁿ⁺¹/(V·H) per
    /// steradian of `wi`.
    ///
    /// # Sources
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
    pub struct BlinnPhong<C = glam::Vec3, T = f32>;

    /// A lobe with the given albedo at normal incidence and exponent.
    pub fn new(normalized: true);
    /// The classic lobe f = kₛ (N·H)ⁿ.
    pub fn unnormalized(normalized: false);
}

impl<T: Real, C: Color<T>> Brdf<T> for BlinnPhong<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let above = both_above::<T>(wi, wo);
        let value = self.c * Halfway::<T>::new(wi, wo).power(self.exponent);
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
        let versine = -(ln_of_rest(u) / (self.exponent + two)).exp_m1();
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
        let scale = self.c * T::lit(2.0 * TAU) / (self.exponent + two);
        let pdf = self.pdf_of(drawn, &halfway);
        Sample { wi, weight: self.specular * (scale * quotient), pdf }
            .only_where(drawn.and(pdf.gt(zero)))
    }

    /// The integral over half vectors, ring by ring.
    fn albedo(&self, wo: T::Vec3) -> C {
        let (zero, half, one, pi) = (T::zero(), T::lit(0.5), T::one(), T::lit(PI));
        let w = unit_viewer::<T>(wo);
        let (sin_o, cos_o) = ((w.x() * w.x() + w.y() * w.y()).sqrt(), w.z());
        let ring = |tilt| Ring::new(sin_o, cos_o, tilt, self.exponent);
        // Rings tilted by less than (π/2 − θₒ)/2 mirror the viewer to above the surface as a whole,
        // those by more than (π/2 + θₒ)/2 not at all. Neither matters where the power is below the
        // last digit.
        let reach = T::lit(9.0) / (self.exponent + one).sqrt();
        let whole_below = (cos_o.atan2(sin_o) * half).min(reach);
        let none_above = ((T::lit(FRAC_PI_2) + sin_o.atan2(cos_o)) * half).min(reach);
        let whole = integrate(zero, whole_below, |tilt| ring(tilt).up_to(pi));
        // In between rings are cut. The integrand begins and ends like a power 3/2, which the
        // substitution of sin² smooths.
        let cut = integrate(zero, one, |t: T| {
            let (sin_t, cos_t) = (t * T::lit(FRAC_PI_2)).sin_cos();
            let ring = ring(whole_below + (none_above - whole_below) * sin_t * sin_t);
            ring.up_to(ring.horizon()) * (sin_t * cos_t * pi * (none_above - whole_below))
        });
        let albedo = self.specular * (self.c * (whole + cut) * T::lit(2.0)).max(zero);
        albedo.only_where(above_surface::<T, _>(wo))
    }
}

/// The half vectors of one tilt θ_h, for a viewer at θₒ.
///
/// Since dωᵢ = 4 V·H dω_h, the directional albedo is the integral of f cosθᵢ 4 V·H over half vectors.
/// With the azimuth φ counted from the viewer's,
///
/// ```text
/// V·H = cosθₒ cosθ_h + sinθₒ sinθ_h cosφ = center + swing cosφ
/// cosθᵢ = 2 (V·H)(N·H) − cosθₒ
/// ```
///
/// so that the integral over φ is one of 1, cosφ and cos²φ. A ring is symmetric: its half counts
/// twice.
struct Ring<T> {
    cos_o: T,
    sin_h: T,
    cos_h: T,
    /// cosθₒ cosθ_h.
    center: T,
    /// sinθₒ sinθ_h.
    swing: T,
    exponent: T,
}

impl<T: Real> Ring<T> {
    #[inline(always)]
    fn new(sin_o: T, cos_o: T, tilt: T, exponent: T) -> Self {
        let (sin_h, cos_h) = tilt.sin_cos();
        Self { cos_o, sin_h, cos_h, center: cos_o * cos_h, swing: sin_o * sin_h, exponent }
    }

    /// The azimuth beyond which the mirrored viewer is below the surface, of a ring that is cut:
    /// cosθᵢ = 0 where V·H = cosθₒ/(2 N·H).
    #[inline(always)]
    fn horizon(&self) -> T {
        let (zero, half, one) = (T::zero(), T::lit(0.5), T::one());
        let swings = self.swing.gt(zero).and(self.cos_h.gt(zero));
        let edge = self.cos_o * half / T::select(swings, self.cos_h, one) - self.center;
        (edge / T::select(swings, self.swing, one)).acos()
    }

    /// sinθ_h (N·H)ⁿ ∫₀^φ cosθᵢ 4 V·H dφ.
    #[inline(always)]
    fn up_to(&self, azimuth: T) -> T {
        let &Self { cos_o, sin_h, cos_h, center, swing, exponent } = self;
        let (half, four) = (T::lit(0.5), T::lit(4.0));
        let (sin, cos) = azimuth.sin_cos();
        // ∫ V·H dφ and ∫ (V·H)² dφ.
        let first = center * azimuth + swing * sin;
        let second = center * first + swing * (center * sin + swing * half * (azimuth + sin * cos));
        let power = power_of_cosine(cos_h, sin_h * sin_h, exponent);
        power * sin_h * four * (T::lit(2.0) * cos_h * second - cos_o * first)
    }
}

impl<T: Real, C> BlinnPhong<C, T> {
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
