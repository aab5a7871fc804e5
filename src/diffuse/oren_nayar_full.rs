use core::f64::consts::{FRAC_1_PI, FRAC_2_PI, FRAC_PI_2, PI};

use crate::brdf::{Brdf, Sample};
use crate::direction::{above_or_normal, above_surface, both_above};
use crate::parameter::model;
use crate::quadrature::integrate;
use crate::real::{Color, Real, Vector};
use crate::sampling::cosine_hemisphere;

model! {
    /// Oren and Nayar's rough diffuse surface of Lambertian V-grooves, the full model of the paper.
    ///
    /// # Formula
    /// ```text
    /// f  = max(0, f₁ + f₂)
    /// f₁ = ρ/π · (C₁ + cosΔφ C₂ tanβ + (1 − |cosΔφ|) C₃ tan((α + β)/2))
    /// f₂ = 0.17 ρ²/π · σ²/(σ² + 0.13) · (1 − cosΔφ (2β/π)²)
    /// C₁ = 1 − 0.5 σ²/(σ² + 0.33)
    /// C₂ = 0.45 σ²/(σ² + 0.09) · (sinα for cosΔφ ≥ 0, sinα − (2β/π)³ otherwise)
    /// C₃ = 0.125 σ²/(σ² + 0.09) · (4αβ/π²)²
    /// α = max(θᵢ, θₒ)    β = min(θᵢ, θₒ)    Δφ = φᵢ − φₒ
    /// ```
    parameters {
        albedo: C, UNIT, "ρ", "fraction of the light that a facet reflects";
        sigma: T, SIGMA, "σ", "standard deviation of the tilt of the facets, radians";
    }
    flags {
        interreflection: true, "whether light that facets send to each other counts, f₂";
    }
    constants {
        let variance = sigma.squared();
        let shaded = variance / (variance + T::lit(0.09));
        /// C₁.
        c1: T = T::one() - T::lit(0.5) * variance / (variance + T::lit(0.33));
        /// The part of C₂ that is the same for all directions.
        c2: T = T::lit(0.45) * shaded;
        /// The same of C₃.
        c3: T = T::lit(0.125) * shaded;
        /// The same of f₂.
        between: T = if interreflection {
            T::lit(0.17) * variance / (variance + T::lit(0.13))
        } else {
            T::zero()
        };
    }
    ///
    /// At the normal, where there is no azimuth, all that depends on it vanishes. The half angle needs no
    /// arc: tan((α + β)/2) = (sinα + sinβ)/(cosα + cosβ).
    ///
    /// The printed sum is **negative** where both directions graze on opposite sides of a rough and dark
    /// surface: from σ = 0.664 on without interreflection, from 0.703 on for ρ = 0.1 and from 0.953 on for
    /// ρ = 0.5, down to −0.27 ρ/π. There f is 0.
    ///
    /// # Energy
    /// Reciprocal, to the last bit. σ = 0 is [`Lambert`](crate::Lambert) but for rounding. **Not** conserving:
    /// with interreflection the directional albedo reaches 1.0510 for ρ = 1 (σ = 0.305, grazing), without
    /// 1.0037 (σ = 0.14). f grows without bound, as tanβ, where both directions graze; the radiance f cosθᵢ does not.
    ///
    /// The directional albedo is an integral over θᵢ, the one over the azimuth being elementary.
    ///
    /// # Sampling
    /// With density cosθ/π.
    ///
    /// # Sources
    /// M. Oren, S. K. Nayar, *Generalization of Lambert's Reflectance Model*, SIGGRAPH 1994,
    /// [doi:10.1145/192161.192213](https://doi.org/10.1145/192161.192213), equations 14 to 17 of the functional
    /// approximation. [`OrenNayar`](crate::OrenNayar) is their qualitative model,
    /// [`Fujii`](crate::Fujii) a fit to this one.
    ///
    /// ```
    /// use brdf::{Brdf, OrenNayarFull};
    /// use glam::DVec3;
    ///
    /// let plaster = OrenNayarFull::new(DVec3::splat(0.8), 0.3)?;
    /// let f = plaster.eval(DVec3::Z, DVec3::Z);
    /// assert!((f.x - 0.24153188808).abs() < 1e-11);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct OrenNayarFull<C = glam::Vec3, T = f32>;

    /// A rough diffuse surface with the light that facets send to each other.
    pub fn new(interreflection: true);
    /// A rough diffuse surface without it: f₁ alone.
    pub fn without_interreflection(interreflection: false);
}

/// A polar angle θ.
#[derive(Clone, Copy)]
struct Angle<T> {
    sin: T,
    cos: T,
    /// 1 − 2θ/π, with all its digits at grazing.
    rest: T,
}

impl<T: Real> Angle<T> {
    #[inline(always)]
    fn of(w: T::Vec3) -> Self {
        // A root has no derivative at 0.
        let sin = (w.x().squared() + w.y().squared()).max(T::lit(1e-36)).sqrt();
        Self { sin, cos: w.z(), rest: w.z().atan2(sin) * T::lit(FRAC_2_PI) }
    }

    /// Of π/2 − θ.
    #[inline(always)]
    fn above_horizon(height: T) -> Self {
        let (cos, sin) = height.sin_cos();
        Self { sin, cos, rest: height * T::lit(FRAC_2_PI) }
    }

    #[inline(always)]
    fn select(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self {
            sin: T::select(mask, yes.sin, no.sin),
            cos: T::select(mask, yes.cos, no.cos),
            rest: T::select(mask, yes.rest, no.rest),
        }
    }

    /// 2θ/π.
    #[inline(always)]
    fn part(self) -> T {
        T::one() - self.rest
    }
}

/// What stands before cosΔφ ≥ 0, before −cosΔφ otherwise, and before 1 − |cosΔφ|.
struct Terms<T> {
    forward: T,
    backward: T,
    aside: T,
}

impl<C, T: Real> OrenNayarFull<C, T> {
    /// For α ≥ β.
    #[inline(always)]
    fn terms(&self, alpha: Angle<T>, beta: Angle<T>) -> Terms<T> {
        let (one, three, limit) = (T::one(), T::lit(3.0), T::max_finite());
        let tan = (beta.sin / beta.cos).min(limit);
        // sinα − (2β/π)³ as the difference of what both lack to 1.
        let cube = beta.rest * (three - beta.rest * (three - beta.rest));
        let less = cube - alpha.cos.squared() / (one + alpha.sin);
        let half = ((alpha.sin + beta.sin) / (alpha.cos + beta.cos)).min(limit);
        Terms {
            forward: self.c2 * (alpha.sin * tan),
            backward: self.c2 * (tan * less.max(T::zero())),
            aside: self.c3 * ((alpha.part() * beta.part()).squared() * half),
        }
    }

    /// π f/ρ without interreflection, not bounded by 0, and what f₂ adds per ρ.
    #[inline(always)]
    fn relative(&self, wi: T::Vec3, wo: T::Vec3) -> [T; 2] {
        let (zero, one, limit) = (T::zero(), T::one(), T::max_finite());
        let (light, viewer) = (Angle::of(wi), Angle::of(wo));
        let lower = wi.z().lt(wo.z());
        let alpha = Angle::select(lower, light, viewer);
        let beta = Angle::select(lower, viewer, light);
        let Terms { forward, backward, aside } = self.terms(alpha, beta);

        let sines = alpha.sin * beta.sin;
        let tilted = sines.gt(T::lit(1e-30));
        let inverse = one / T::select(tilted, sines, one);
        let cos = ((wi.x() * wo.x() + wi.y() * wo.y()) * inverse).only_where(tilted);
        let sin = ((wi.x() * wo.y() - wi.y() * wo.x()) * inverse).only_where(tilted);
        let same_side = cos.ge(zero);
        let magnitude = T::select(same_side, cos, -cos).at_most(one);
        // 1 − |cosΔφ| without the difference.
        let rest = (sin.squared() / (one + magnitude)).at_most(one);
        let turned = magnitude * T::select(same_side, forward, -backward);
        let direct = (self.c1 + turned + rest * aside).min(limit);
        let swing = magnitude * beta.part().squared();
        [direct, self.between * (one - T::select(same_side, swing, -swing))]
    }

    /// π f.
    #[inline(always)]
    fn scaled<D: Color<T>>(albedo: D, [direct, between]: [T; 2]) -> D {
        albedo.map(|rho| rho * (direct + rho * between).max(T::zero()))
    }

    /// The directional albedo over ρ.
    fn relative_albedo(&self, rho: T, wo: T::Vec3) -> T {
        let one = T::one();
        let w = Vector::normalize_or_normal(above_or_normal::<T, T::Vec3>(wo));
        let sin = (w.x().squared() + w.y().squared()).max(T::lit(1e-36)).sqrt();
        // What is closer to the horizon looks the same.
        let height = w.z().max(T::lit(1e-9)).atan2(sin);
        let viewer = Angle::above_horizon(height);
        let ring = |light: Angle<T>, alpha, beta: Angle<T>| {
            self.ring(rho, &self.terms(alpha, beta), beta.part().squared()) * light.sin * light.cos
        };
        let lower = integrate(T::zero(), height, |height| {
            let light = Angle::above_horizon(height);
            ring(light, light, viewer)
        });
        // Light above a viewer that grazes: most changes next to the horizon.
        let rest = T::lit(FRAC_PI_2) - height;
        let upper = integrate(T::zero(), one, |t: T| {
            let (cube, step) = (t.squared() * t, rest * t.squared().squared());
            let light = Angle::above_horizon(height + step);
            ring(light, viewer, light) * (T::lit(4.0) * cube * rest)
        });
        (lower + upper) * T::lit(FRAC_1_PI)
    }

    /// ∫ max(0, π f/ρ) dφ.
    #[inline(always)]
    fn ring(&self, rho: T, terms: &Terms<T>, swing: T) -> T {
        let (one, two, half) = (T::one(), T::lit(2.0), T::lit(0.5));
        let between = rho * self.between;
        let level = self.c1 + terms.aside + between;
        let forward = terms.forward - terms.aside - between * swing;
        let backward = terms.backward + terms.aside - between * swing;
        // On the side across, level − backward |cosΔφ| is bounded by 0.
        let clipped = backward.gt(level);
        let cut = T::select(clipped, level / T::select(clipped, backward, one), half);
        let root = ((one - cut) * (one + cut)).max(T::lit(1e-30)).sqrt();
        let arc = T::select(clipped, cut.asin(), T::lit(FRAC_PI_2));
        let across = level * arc - backward * (one - root.only_where(clipped));
        T::lit(PI) * level + two * forward + two * across
    }
}

impl<T: Real, C: Color<T>> Brdf<T> for OrenNayarFull<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let value = Self::scaled(self.albedo, self.relative(wi, wo)) * T::lit(FRAC_1_PI);
        value.only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        (wi.z() * T::lit(FRAC_1_PI)).only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let wi = cosine_hemisphere(u);
        let weight = Self::scaled(self.albedo, self.relative(wi, wo));
        Sample { wi, weight, pdf: wi.z() * T::lit(FRAC_1_PI) }.only_where(both_above::<T>(wi, wo))
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        let value = self.albedo.map(|rho| rho * self.relative_albedo(rho, wo));
        value.only_where(above_surface::<T, _>(wo))
    }
}
