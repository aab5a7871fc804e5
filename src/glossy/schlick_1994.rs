use core::f64::consts::FRAC_1_PI;

use super::mirror::unit_viewer;
use super::schlick_layer::{Schlick1994Layer, SchlickShadowing};
use crate::brdf::{Brdf, Sample};
use crate::direction::{Pair, above_or_normal, above_surface, reflect};
use crate::distribution::Spread;
use crate::error::{ParameterError, range};
use crate::microfacet::over_facets;
use crate::parameter::{Kind, Parameter, Preset, model};
use crate::quadrature::over_hemisphere;
use crate::real::{Color, Mask, Real, Vector, lift, positive_zero};
use crate::sampling::{cosine_hemisphere, uniform};

/// Schlick's inexpensive model, complete: one or two layers with a Fresnel term, facets with grain, shadowing, and
/// the split into a diffuse, a glossy and a mirror part.
///
/// # Formula
/// ```text
/// f = S(u) D                                                 one layer
/// f = S(u) D + (1 − S(u)) S′(u) D′                           two, the first on top
/// S(u) = C + (1 − C)(1 − u)⁵
/// Z(t) = r/(1 + rt² − t²)²       A(w) = √(p/(p² − p²w² + w²))       G(v) = v/(r − rv + v)
/// D = Z A/(4π v v′)                                          none
/// D = G(v) G(v′) Z A/(4π v v′)                               schlick
/// D = … + (1 − G(v) G(v′))/(4π v v′)                         reemission_printed
/// D = … + (1 − G(v) G(v′))/π                                 reemission_bounded
/// D ← a/π + b D, and a mirror of weight c                    split
/// b = 4r(1 − r)    r < ½: a = 0, c = 1 − b    otherwise: a = 1 − b, c = 0
/// ```
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | C | `layers[j].specular` | reflectance at normal incidence | 0 … 1 |
/// | r | `layers[j].roughness` | 0 a mirror, 1 diffuse | 10⁻⁸ … 1 |
/// | p | `layers[j].isotropy` | 0 grooves along the tangent, 1 no grain | 10⁻⁴ … 1, 1 by default |
/// | | `shadowing` | [`SchlickShadowing`] | `schlick` by default |
/// | | `split` | whether D stands for a diffuse, a glossy and a mirror part | false by default |
///
/// t = N·H, u = V·H, v = N·V, v′ = N·L, and w is the cosine between the tangent and the projection of H on the surface; where H = N, w = 0.
/// The mirror is a [specular lobe](crate::Bsdf::specular), which this type leaves out:
/// [`SplitSchlick1994`](crate::SplitSchlick1994) has it.
///
/// # Energy
/// Reciprocal. **Not** conserving: Z is GGX with α² = r, but G is too large for it. With G the albedo for
/// C = 1 is below 1 for r ≥ 0.2; for r = 0.1 it is 1.36 at 89.9° and 1.38 at 89.99°, for r = 0.01 4.16 and 4.73.
/// At grazing it comes close to 1/(2√r), but not beyond, for small r. Without G, and with the printed re-emission, it
/// grows without bound as the direction does to grazing; the bounded re-emission has a bound for every r alone,
/// which is 1 more than that with G: for r = 0.01 it makes 5.01 at 89.9° and 5.71 at 89.99°, for r = 10⁻⁴ 49.9 at
/// 89.9999°. A is not normalised: its mean over the
/// azimuth is √p/M(1, p) with the arithmetic–geometric mean M, 0.971 for p = 0.5 and 0.744 for 0.1. For a surface that
/// conserves energy take [`Ggx`](crate::Ggx) with Smith's shadowing.
///
/// The directional albedo is an integral over facets and one over the hemisphere, good to 10⁻⁶ for p ≥ 0.1.
///
/// # Sampling
/// By half vectors with density t Z A M(1, p)/(π √p), of which the azimuth is Jacobi's amplitude
/// am(4K u | 1 − p²), from what is left of its layer; or evenly over the hemisphere (printed re-emission) or with cosθ/π (diffuse part
/// and bounded re-emission). The azimuth in closed form that is seen in public code does not have the density A.
///
/// # Sources
/// C. Schlick, *An Inexpensive BRDF Model for Physically-based Rendering*, Computer Graphics Forum 13(3),
/// 1994, [doi:10.1111/1467-8659.1330233](https://doi.org/10.1111/1467-8659.1330233).
///
/// What could not be established: the weights a, b and c, and 4πvv′ as the denominator of the re-emission, are quoted after
/// summaries of the paper, which agree, and not after its printed page; so are its claims about errors and its own
/// sampling of the azimuth.
///
/// ```
/// use brdf::{Brdf, Schlick1994, Schlick1994Layer, SchlickShadowing};
/// use glam::DVec3;
///
/// let satin = Schlick1994Layer { specular: DVec3::splat(0.5), roughness: 0.2, isotropy: 1.0 };
/// let f = Schlick1994::new(satin)?.eval(DVec3::Z, DVec3::Z).x;
/// assert!((f - 0.5 / (0.2 * 4.0 * std::f64::consts::PI)).abs() < 1e-14); // C/(4π r)
///
/// let at = |roughness, shadowing, degrees: f64| {
///     let layer = Schlick1994Layer { specular: 1.0_f64, roughness, isotropy: 1.0 };
///     let surface = Schlick1994::new(layer)?.with_shadowing(shadowing);
///     Ok::<_, brdf::ParameterError>(surface.albedo(brdf::from_spherical(degrees.to_radians(), 0.0)))
/// };
/// let (shadowed, bounded) = (SchlickShadowing::Schlick, SchlickShadowing::ReemissionBounded);
/// for (roughness, shadowing, degrees, want) in [
///     (0.2, shadowed, 89.99, 0.8992),
///     (0.1, shadowed, 89.99, 1.3760),
///     (0.01, shadowed, 89.9, 4.1600),
///     (0.01, shadowed, 89.99, 4.7256),
///     (0.01, bounded, 89.99, 5.7086),
///     (1e-4, bounded, 89.9999, 49.8984),
/// ] {
///     assert!((at(roughness, shadowing, degrees)? - want).abs() < 1e-4);
/// }
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schlick1994<C = glam::Vec3, T = f32> {
    top: Schlick1994Layer<C, T>,
    /// The same as the first where there is one layer only.
    bottom: Schlick1994Layer<C, T>,
    /// M(1, p)/√p of both.
    evenness: [T; 2],
    double: Layers,
    shadowing: SchlickShadowing,
    split: Split,
}

/// How many layers there are.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Layers {
    One,
    Two,
}

/// Whether D stands for three parts.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Split {
    Whole,
    Parts,
}

lift! { Layers }
lift! { Split }
lift! {
    [T: Real, C: Color<T>] Schlick1994<C, T> => Schlick1994<C::Over<U>, U>:
    Schlick1994 {
        top: part, bottom: part, evenness: numbers, double: part, shadowing: part, split: part
    }
}

/// How many layers there may be.
#[cfg(feature = "serde")]
pub(crate) fn check_schlick_layers(count: usize) -> Result<(), ParameterError> {
    crate::error::Range::new(1.0, 2.0).check("number of layers", count as f64)
}

impl<C, T> Schlick1994<C, T> {
    /// The table of the parameters.
    pub const PARAMETERS: &'static [Parameter] = &[
        Parameter::new("layers", "C, r, p", "one or two layers", Kind::List(Self::LAYER)),
        Parameter::new(
            "shadowing",
            "G",
            "shadowing of the facets, and what becomes of the light",
            Kind::Word(&["schlick", "none", "reemission_printed", "reemission_bounded"]),
        )
        .or(Preset::Word("schlick")),
        Parameter::new(
            "split",
            "a, b, c",
            "whether a layer has a diffuse, a glossy and a mirror part",
            Kind::Flag,
        )
        .or(Preset::Flag(false)),
    ];

    /// The table of the parameters of a layer.
    pub const LAYER: &'static [Parameter] = &[
        model!(@row specular: C, UNIT, "C", "reflectance at normal incidence"),
        model!(@row roughness: T, SQUARED_ROUGHNESS, "r", "0 a mirror, 1 diffuse"),
        model!(@row isotropy: T, ISOTROPY = 1.0, "p", "0 grooves along the tangent, 1 no grain"),
    ];
}

impl<T: Real, C: Color<T>> Schlick1994<C, T> {
    /// A surface of one layer.
    ///
    /// # Errors
    /// If a parameter of the layer is not in its range.
    pub fn new(layer: Schlick1994Layer<C, T>) -> Result<Self, ParameterError> {
        Self::of(layer, layer, Layers::One)
    }

    /// A surface of two layers, the first on top.
    ///
    /// # Errors
    /// If a parameter of a layer is not in its range.
    pub fn double(
        top: Schlick1994Layer<C, T>,
        bottom: Schlick1994Layer<C, T>,
    ) -> Result<Self, ParameterError> {
        Self::of(top, bottom, Layers::Two)
    }

    fn of(
        top: Schlick1994Layer<C, T>,
        bottom: Schlick1994Layer<C, T>,
        double: Layers,
    ) -> Result<Self, ParameterError> {
        let checked = |layer: Schlick1994Layer<C, T>| {
            range::UNIT.check("specular", layer.specular)?;
            range::SQUARED_ROUGHNESS.check("roughness", layer.roughness)?;
            range::ISOTROPY.check("isotropy", layer.isotropy)?;
            Ok(Schlick1994Layer { specular: positive_zero(layer.specular), ..layer })
        };
        let (top, bottom) = (checked(top)?, checked(bottom)?);
        let evenness = [top.evenness(), bottom.evenness()];
        let shadowing = SchlickShadowing::default();
        Ok(Self { top, bottom, evenness, double, shadowing, split: Split::Whole })
    }

    /// The same surface with another shadowing.
    #[must_use]
    pub fn with_shadowing(self, shadowing: SchlickShadowing) -> Self {
        Self { shadowing, ..self }
    }

    /// The same surface with layers of a diffuse, a glossy and a mirror part, or of one part.
    #[must_use]
    pub fn with_split(self, split: bool) -> Self {
        Self { split: if split { Split::Parts } else { Split::Whole }, ..self }
    }

    /// a, b and c of a layer.
    #[inline(always)]
    fn parts(&self, layer: &Schlick1994Layer<C, T>) -> [T; 3] {
        match self.split {
            Split::Whole => [T::zero(), T::one(), T::zero()],
            Split::Parts => layer.parts(),
        }
    }

    /// What is before the layers: S, and (1 − S) S′ where there are two.
    #[inline(always)]
    fn fresnel(&self, cos: T) -> [C; 2] {
        let above = self.top.reflectance(cos);
        let below = match self.double {
            Layers::One => C::splat(T::zero()),
            Layers::Two => {
                let behind = self.bottom.reflectance(cos);
                above.zip(behind, |above, behind| (T::one() - above) * behind)
            }
        };
        [above, below]
    }

    /// What the layer has in the place of D.
    #[inline(always)]
    fn layer(&self, layer: &Schlick1994Layer<C, T>, pair: &Pair<T>) -> T {
        let [a, b, _] = self.parts(layer);
        a * T::lit(FRAC_1_PI) + b * layer.facets(self.shadowing, pair)
    }

    /// The weight of the mirror part.
    #[inline(always)]
    pub(crate) fn mirror(&self, wo: T::Vec3) -> C {
        let cos = above_or_normal::<T, T::Vec3>(wo).z().at_most(T::one());
        let [above, below] = self.fresnel(cos);
        let [[_, _, c], [_, _, d]] = [self.parts(&self.top), self.parts(&self.bottom)];
        above * c + below * d
    }

    /// The probabilities of the half vectors of both layers, not divided by the sum of them and of that of the rest, which
    /// comes last.
    #[inline(always)]
    fn shares(&self, wo: T::Vec3) -> [T; 3] {
        let (one, half) = (T::one(), T::lit(0.5));
        let cos = above_or_normal::<T, T::Vec3>(wo).z().at_most(one);
        let rest = one - cos;
        let edge = T::lit(20.0) * (rest.squared().squared() * rest) + one;
        let edge = edge * T::lit(1.0 / 21.0);
        let reflected = |layer: &Schlick1994Layer<C, T>| {
            let mean = layer.specular.mean();
            mean + (one - mean) * edge
        };
        let above = reflected(&self.top);
        let below = match self.double {
            Layers::One => T::zero(),
            Layers::Two => (one - above).max(T::lit(1e-3)) * reflected(&self.bottom),
        };
        let share = |layer: &Schlick1994Layer<C, T>, reflected: T| {
            let [a, b, _] = self.parts(layer);
            let again = if self.shadowing.emits() {
                layer.hidden(cos) + layer.hidden(half)
            } else {
                T::zero()
            };
            [reflected * b, reflected * (a + b * again)]
        };
        let [[first, even], [second, other]] =
            [share(&self.top, above), share(&self.bottom, below)];
        [first, second, even + other]
    }

    /// Density of the directions that come from no half vector.
    #[inline(always)]
    fn even_density(&self, cos: T) -> T {
        match self.shadowing {
            SchlickShadowing::ReemissionPrinted => T::lit(0.5 * FRAC_1_PI),
            _ => cos * T::lit(FRAC_1_PI),
        }
    }

    #[inline(always)]
    fn value(&self, pair: &Pair<T>) -> C {
        let [above, below] = self.fresnel(pair.cos_d.at_most(T::one()));
        let (top, bottom) = (self.layer(&self.top, pair), self.layer(&self.bottom, pair));
        (above * top + below * bottom).map(|value| value.min(T::max_finite()))
    }

    #[inline(always)]
    fn density(&self, shares: [T; 3], pair: &Pair<T>) -> T {
        let [first, second, even] = shares;
        let quarter = T::lit(0.25) / pair.cos_d;
        let [of_top, of_bottom] = self.evenness;
        let lobes = first * self.top.half_vectors(of_top, pair)
            + second * self.bottom.half_vectors(of_bottom, pair);
        let all = first + second + even;
        let some = all.gt(T::zero());
        let sum = lobes * quarter + even * self.even_density(pair.cos_i);
        let density = (sum / T::select(some, all, T::one())).min(T::max_finite());
        density.only_where(pair.above.and(some))
    }
}

impl<T: Real, C: Color<T>> Brdf<T> for Schlick1994<C, T> {
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
        let [first, second, even] = shares;
        let place = u * (first + second + even);
        let part = |start: T, share: T| {
            ((place - start) / T::select(share.gt(zero), share, one)).clamp(zero, one)
        };
        let viewer = unit_viewer::<T>(wo);
        let of = |layer: &Schlick1994Layer<C, T>, u: T| {
            let h: T::Vec3 = layer.half_vector([u, turn]);
            reflect::<T, T::Vec3>(viewer, h)
        };
        let of_top = of(&self.top, part(zero, first));
        let of_bottom = match self.double {
            Layers::One => of_top,
            Layers::Two => of(&self.bottom, part(first, second)),
        };
        let rest = part(first + second, even);
        let evenly: T::Vec3 = match self.shadowing {
            SchlickShadowing::ReemissionPrinted => {
                let sin = ((one - rest) * (one + rest)).max(T::lit(1e-30)).sqrt();
                let (sin_phi, cos_phi) = turn.sin_cos_turns();
                Vector::new(sin * cos_phi, sin * sin_phi, rest)
            }
            _ => cosine_hemisphere([rest, turn]),
        };
        let in_second = second.gt(zero).and(place.ge(first));
        let in_rest = even.gt(zero).and(place.ge(first + second));
        let wi = Vector::select(in_second, of_bottom, of_top);
        let wi = Vector::select(in_rest, evenly, wi);
        let pair = Pair::new(wi, wo);
        let pdf = self.density(shares, &pair);
        let drawn = pdf.gt(zero);
        let scale = (pair.cos_i / T::select(drawn, pdf, one)).min(T::max_finite());
        let weight = (self.value(&pair) * scale).map(|value| value.min(T::max_finite()));
        Sample { wi, weight, pdf }.only_where(drawn)
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        let one = T::one();
        let mut sum = C::splat(T::zero());
        for (index, layer) in [&self.top, &self.bottom].into_iter().enumerate() {
            let [a, b, _] = self.parts(layer);
            let before = |cos: T| {
                let [above, below] = self.fresnel(cos.at_most(one));
                if index == 0 { above } else { below }
            };
            let spread = Spread::ellipsoid([layer.roughness.sqrt(); 2]);
            let of_facets = over_facets(&[(one, spread)], wo, |pair: &Pair<T>| {
                let cosines = [pair.cos_i.max(T::lit(1e-18)), pair.cos_o];
                let visible = layer.visible(self.shadowing, cosines) * cosines[0];
                let scale = layer.mean_anisotropy(pair.sum, pair.wo) * visible * T::lit(0.25);
                before(pair.cos_d) * (b * scale)
            });
            let even = over_hemisphere(wo, |wi: T::Vec3, wo: T::Vec3| {
                let cos = Vector::length_squared(wi + wo).sqrt() * T::lit(0.5);
                let emitted = layer.emitted(self.shadowing, [wi.z(), wo.z()]);
                before(cos) * ((a * T::lit(FRAC_1_PI) + b * emitted) * wi.z())
            });
            sum = sum + of_facets + even;
            if self.double == Layers::One {
                break;
            }
        }
        sum.map(|value| value.min(T::max_finite())).only_where(above_surface::<T, _>(wo))
    }
}
