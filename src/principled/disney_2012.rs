use core::f64::consts::FRAC_1_PI;

use super::parameters::DisneyParameters;
use crate::brdf::{Brdf, Sample};
use crate::direction::{Pair, above_or_normal, above_surface, reflect};
use crate::distribution::{Distribution, Ggx, Gtr, Smith};
use crate::error::ParameterError;
use crate::microfacet::over_facets;
use crate::quadrature::over_hemisphere;
use crate::real::{Color, Mask, Real, Vector, lift, positive_zero};
use crate::sampling::{cosine_hemisphere, uniform};

/// Disney's principled material of 2012: a retro-reflecting diffuse part, a highlight, a sheen and a
/// clear coat by eleven sliders.
///
/// # Formula
/// ```text
/// f = (lerp(F_d, s, subsurface) base/π + F_H sheen lerp(1, tint, sheen_tint)) (1 − metallic)
///   + D lerp(C₀, 1, F_H) g(N·L) g(N·V)
///   + ¼ clearcoat D_c lerp(0.04, 1, F_H) g_¼(N·L) g_¼(N·V)
/// F_d = (1 + (F₉₀ − 1) F_L)(1 + (F₉₀ − 1) F_V)      F₉₀ = ½ + 2 (L·H)² r
/// s = 1.25 (F_ss (1/(N·L + N·V) − ½) + ½)            F_ss as F_d with F₉₀ = (L·H)² r
/// C₀ = lerp(0.08 specular lerp(1, tint, specular_tint), base, metallic)
/// F_L = (1 − N·L)⁵    F_V = (1 − N·V)⁵    F_H = (1 − L·H)⁵    tint = base/(0.3R + 0.6G + 0.1B)
/// α_x = max(0.001, r²/aspect)    α_y = max(0.001, r² aspect)    aspect = √(1 − 0.9 anisotropic)
/// g = 1/(n + √(a² + n² − a²n²)), a = ((1 + r)/2)²                     2012
/// g = 1/(ω_z + √(α_x² ω_x² + α_y² ω_y² + ω_z²))                       2014
/// ```
///
/// D is [`Ggx`] of α_x and α_y, D_c is [`Gtr`] of γ = 1 and α = lerp(0.1, 0.001, clearcoat_gloss), g_¼ has
/// a = ¼; 1/(4 N·L N·V) is in g g.
///
/// # Parameters
///
/// The sliders are those of [`DisneyParameters`], all 0 … 1; [`DisneyForm`] is the form of g.
///
/// # Energy
/// Reciprocal, to the last bit. **Not** conserving: its parts know nothing of each other. The albedo of a white surface is at most 1.09 for
/// r = 0.5, with all else by default, and 1.60 for r = 1, where the diffuse part alone has 1.55, at grazing; with sheen and clear
/// coat it is 1.20 for r = 0.5. The directional albedo is a sum of integrals over facets and over the hemisphere, good to 10⁻⁶ (with a
/// glossy clear coat 10⁻⁴).
///
/// # Sampling
/// With cosθ/π, by the visible normals of D, or by half vectors with density D_c N·H, chosen by about how much each part
/// reflects.
///
/// # Sources
/// B. Burley, *Physically-Based Shading at Disney*, SIGGRAPH 2012 course; the anisotropic g is that of the program
/// published with it, as of 2014.
///
/// ```
/// use brdf::{Brdf, Disney2012, DisneyParameters};
/// use glam::DVec3;
///
/// let chalk = Disney2012::new(DisneyParameters { specular: 0.0, ..DisneyParameters::of(DVec3::splat(0.5)) })?;
/// assert!((chalk.eval(DVec3::Z, DVec3::Z).x - 0.5 / std::f64::consts::PI).abs() < 1e-15);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("principled", "Burley"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disney2012<C = glam::Vec3, T = f32> {
    roughness: T,
    subsurface: T,
    /// base (1 − metallic).
    diffuse: C,
    /// sheen lerp(1, tint, sheen_tint) (1 − metallic).
    sheen: C,
    /// C₀.
    f0: C,
    facets: Ggx<T>,
    /// clearcoat/4.
    clearcoat: T,
    coat: Gtr<T>,
    form: DisneyForm,
}

/// The forms of the shadowing of [`Disney2012`]'s highlight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DisneyForm {
    /// The same in all directions, of a roughness remapped to ((1 + r)/2)².
    #[default]
    Of2012,
    /// That of the distribution.
    Of2014,
}

lift! { DisneyForm }
lift! {
    [T: Real, C: Color<T>] Disney2012<C, T> => Disney2012<C::Over<U>, U>:
    Disney2012 {
        roughness: number, subsurface: number, diffuse: color, sheen: color, f0: color,
        facets: part, clearcoat: number, coat: part, form: part,
    }
}

/// From `a` to `b`.
#[inline(always)]
fn lerp<T: Real>(a: T, b: T, t: T) -> T {
    a * (T::one() - t) + b * t
}

/// 1 − (1 − u)⁵ without the difference.
#[inline(always)]
fn entering<T: Real>(cos: T) -> T {
    let (five, ten) = (T::lit(5.0), T::lit(10.0));
    cos * (five - cos * (ten - cos * (ten - cos * (five - cos))))
}

/// (1 − u)⁵.
#[inline(always)]
fn schlick<T: Real>(cos: T) -> T {
    let versine = T::one() - cos.at_most(T::one());
    versine.squared().squared() * versine
}

impl<T: Real, C: Color<T>> Disney2012<C, T> {
    /// A material of these sliders, in the form of 2012.
    ///
    /// # Errors
    /// If a slider is not in 0 … 1.
    pub fn new(sliders: DisneyParameters<C, T>) -> Result<Self, ParameterError> {
        Self::with_luminance(sliders, sliders.luminance())
    }

    /// The same, where the channels of the base colour do not tell its luminance.
    pub(crate) fn with_luminance(
        sliders: DisneyParameters<C, T>,
        luminance: T,
    ) -> Result<Self, ParameterError> {
        sliders.check()?;
        let (one, least) = (T::one(), T::lit(0.001));
        let (base, tint) = (positive_zero(sliders.base_color), sliders.tint(luminance));
        let dielectric = one - sliders.metallic;
        let aspect = (one - T::lit(0.9) * sliders.anisotropic).sqrt();
        let alpha = sliders.roughness.squared();
        let gray = T::lit(0.08) * sliders.specular;
        let gloss = lerp(T::lit(0.1), least, sliders.clearcoat_gloss);
        Ok(Self {
            roughness: sliders.roughness,
            subsurface: sliders.subsurface,
            diffuse: base * dielectric,
            sheen: tint
                .map(|tint| sliders.sheen * lerp(one, tint, sliders.sheen_tint) * dielectric),
            f0: base.zip(tint, |base, tint| {
                lerp(gray * lerp(one, tint, sliders.specular_tint), base, sliders.metallic)
            }),
            facets: Ggx::anisotropic((alpha / aspect).max(least), (alpha * aspect).max(least))?,
            clearcoat: T::lit(0.25) * sliders.clearcoat,
            coat: Gtr::new(gloss, one)?,
            form: DisneyForm::default(),
        })
    }

    /// The same material in another form.
    #[must_use]
    pub fn with_form(self, form: DisneyForm) -> Self {
        Self { form, ..self }
    }

    /// g of an isotropic roughness.
    #[inline(always)]
    fn isotropic(a: T, cos: T) -> T {
        let squared = a.squared();
        let rest = cos.squared() * (T::one() - squared);
        T::one() / (cos + (squared + rest).sqrt())
    }

    /// g of the distribution's own roughness.
    #[inline(always)]
    fn own(&self, w: T::Vec3, cos: T) -> T {
        T::one() / (cos + self.facets.projected_area(w))
    }

    /// g g of the highlight.
    #[inline(always)]
    fn visibility(&self, pair: &Pair<T>, [i, o]: [T; 2]) -> T {
        match self.form {
            DisneyForm::Of2012 => {
                let a = (T::lit(0.5) + T::lit(0.5) * self.roughness).squared();
                Self::isotropic(a, i) * Self::isotropic(a, o)
            }
            DisneyForm::Of2014 => self.own(pair.wi, i) * self.own(pair.wo, o),
        }
    }

    /// Both cosines, at most 1; 1 where they are not above the surface.
    #[inline(always)]
    fn cosines(pair: &Pair<T>) -> [T; 2] {
        let one = T::one();
        [pair.cos_i, pair.cos_o].map(|cos| T::select(pair.above, cos, one).at_most(one))
    }

    /// The diffuse part and the sheen.
    #[inline(always)]
    fn base(&self, [i, o]: [T; 2], cos_d: T) -> C {
        let (half, one, two) = (T::lit(0.5), T::one(), T::lit(2.0));
        let (light, viewer, edge) = (entering(i), entering(o), schlick(cos_d));
        let steep = cos_d.squared() * self.roughness;
        let faces = |f90: T| lerp(f90, one, light) * lerp(f90, one, viewer);
        let retro = faces(half + two * steep);
        let sum = (one / (i + o)).min(T::lit(1e30));
        let within = T::lit(1.25) * (faces(steep) * (sum - half) + half);
        let diffuse = lerp(retro, within, self.subsurface) * T::lit(FRAC_1_PI);
        self.diffuse * diffuse + self.sheen * edge
    }

    /// The highlight over D.
    #[inline(always)]
    fn highlight(&self, pair: &Pair<T>, cosines: [T; 2]) -> C {
        let visibility = self.visibility(pair, cosines);
        let edge = schlick(pair.cos_d);
        self.f0.map(|f0| lerp(f0, T::one(), edge) * visibility)
    }

    /// The clear coat over D_c.
    #[inline(always)]
    fn coating(&self, pair: &Pair<T>, [i, o]: [T; 2]) -> T {
        let quarter = T::lit(0.25);
        let visibility = Self::isotropic(quarter, i) * Self::isotropic(quarter, o);
        self.clearcoat * lerp(T::lit(0.04), T::one(), schlick(pair.cos_d)) * visibility
    }

    #[inline(always)]
    fn value(&self, pair: &Pair<T>) -> C {
        let (cosines, limit) = (Self::cosines(pair), T::max_finite());
        let density = self.facets.density_along(pair.sum);
        let coat = self.coat.density(pair.h) * self.coating(pair, cosines);
        let base = self.base(cosines, pair.cos_d.at_most(T::one()));
        let highlight = self.highlight(pair, cosines) * density;
        base.zip(highlight, |base, highlight| (base + highlight + coat).min(limit))
    }

    /// The probabilities of the cosine, the visible normals and the half vectors of the coat.
    #[inline(always)]
    fn shares(&self, wo: T::Vec3) -> [T; 3] {
        let one = T::one();
        let cos = above_or_normal::<T, T::Vec3>(wo).z();
        let edge = (T::lit(20.0) * schlick(cos) + one) * T::lit(1.0 / 21.0);
        let base = self.diffuse.mean() + T::lit(0.25) * self.sheen.mean();
        let highlight = lerp(self.f0.mean(), one, edge);
        let coat = self.clearcoat * lerp(T::lit(0.04), one, edge) * T::lit(2.0);
        let scale = one / (base + highlight + coat);
        [base * scale, highlight * scale, coat * scale]
    }

    #[inline(always)]
    fn density(&self, [base, highlight, coat]: [T; 3], pair: &Pair<T>) -> T {
        let [i, o] = Self::cosines(pair);
        let facets = self.facets.density_along(pair.sum) * self.own(pair.wo, o) * T::lit(0.5);
        let coated = self.coat.density(pair.h) * pair.cos_h * (T::lit(0.25) / pair.cos_d);
        let density = base * (i * T::lit(FRAC_1_PI)) + highlight * facets + coat * coated;
        density.min(T::max_finite()).only_where(pair.above)
    }
}

impl<T: Real, C: Color<T>> Brdf<T> for Disney2012<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let pair = Pair::new(wi, wo);
        self.value(&pair).only_where(pair.above)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        self.density(self.shares(wo), &Pair::new(wi, wo))
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let (zero, one) = (T::zero(), T::one());
        let ([u, turn], shares) = (uniform(u), self.shares(wo));
        let [base, highlight, coat] = shares;
        let part = |start: T, share: T| {
            ((u - start) / T::select(share.gt(zero), share, one)).clamp(zero, one)
        };
        let viewer = Vector::normalize_or_normal(above_or_normal::<T, T::Vec3>(wo));
        let evenly: T::Vec3 = cosine_hemisphere([part(zero, base), turn]);
        let visible = self.facets.sample_visible(wo, [part(base, highlight), turn]);
        let coated = self.coat.sample([part(base + highlight, coat), turn]);
        let in_highlight = highlight.gt(zero).and(u.ge(base));
        let in_coat = coat.gt(zero).and(u.ge(base + highlight));
        let wi = Vector::select(in_highlight, reflect::<T, T::Vec3>(viewer, visible), evenly);
        let wi = Vector::select(in_coat, reflect::<T, T::Vec3>(viewer, coated), wi);
        let pair = Pair::new(wi, wo);
        let pdf = self.density(shares, &pair);
        let drawn = pdf.gt(zero);
        let scale = (pair.cos_i / T::select(drawn, pdf, one)).min(T::max_finite());
        let weight = (self.value(&pair) * scale).map(|value| value.min(T::max_finite()));
        Sample { wi, weight, pdf }.only_where(drawn)
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        let cosines = |pair: &Pair<T>| {
            let least = T::lit(1e-18);
            [pair.cos_i.max(least), pair.cos_o.max(least)]
        };
        let spreads = self.facets.spreads().unwrap_or_default();
        let highlight = over_facets(&spreads, wo, |pair: &Pair<T>| {
            self.highlight(pair, cosines(pair)) * pair.cos_i
        });
        let spreads = self.coat.spreads().unwrap_or_default();
        let coat = over_facets(&spreads, wo, |pair: &Pair<T>| {
            C::splat(self.coating(pair, cosines(pair)) * pair.cos_i)
        });
        let base = over_hemisphere(wo, |wi: T::Vec3, wo: T::Vec3| {
            let cos_d = (Vector::length_squared(wi + wo).sqrt() * T::lit(0.5)).at_most(T::one());
            self.base([wi.z(), wo.z()], cos_d) * wi.z()
        });
        (base + highlight + coat).only_where(above_surface::<T, _>(wo))
    }
}
