//! A layer of Schlick's model of 1994.

use core::f64::consts::{FRAC_1_PI, TAU};

use crate::direction::Pair;
use crate::real::{Color, Real, Vector, lift};
use crate::sampling::uniform;

/// A layer of [`Schlick1994`](crate::Schlick1994).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schlick1994Layer<C = glam::Vec3, T = f32> {
    /// C, reflectance at normal incidence, 0 … 1.
    pub specular: C,
    /// r, 10⁻⁸ … 1: 0 would be a mirror, 1 is diffuse. The square of the roughness of GGX.
    pub roughness: T,
    /// p, 10⁻⁴ … 1: 0 would be grooves along the tangent, 1 is no grain.
    pub isotropy: T,
}

lift! {
    [T: Real, C: Color<T>] Schlick1994Layer<C, T> => Schlick1994Layer<C::Over<U>, U>:
    Schlick1994Layer { specular: color, roughness: number, isotropy: number }
}

/// What facets of [`Schlick1994`](crate::Schlick1994) hide from each other, and what becomes of that light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SchlickShadowing {
    /// Nothing is hidden: D = Z A/(4π v v′).
    None,
    /// Schlick's G, and what is hidden is lost.
    #[default]
    Schlick,
    /// What is hidden comes back as (1 − G G′)/(4π v v′), as printed.
    ReemissionPrinted,
    /// What is hidden comes back as (1 − G G′)/π.
    ReemissionBounded,
}

lift! { SchlickShadowing }

impl SchlickShadowing {
    /// Whether hidden light comes back.
    pub(super) const fn emits(self) -> bool {
        matches!(self, Self::ReemissionPrinted | Self::ReemissionBounded)
    }
}

/// Steps of the arithmetic–geometric mean, enough for 10⁻⁴.
const STEPS: usize = 7;

impl<T: Real, C: Color<T>> Schlick1994Layer<C, T> {
    /// S(u).
    #[inline(always)]
    pub(super) fn reflectance(&self, cos: T) -> C {
        let one = T::one();
        let versine = one - cos;
        let weight = versine.squared().squared() * versine;
        self.specular.map(|f0| f0 + (one - f0) * weight)
    }

    /// a, b and c.
    #[inline(always)]
    pub(super) fn parts(&self) -> [T; 3] {
        let (one, two) = (T::one(), T::lit(2.0));
        let r = self.roughness;
        let b = T::lit(4.0) * r * (one - r);
        // 1 − b = (1 − 2r)².
        let rest = (one - two * r).squared();
        let smooth = r.lt(T::lit(0.5));
        [rest - rest.only_where(smooth), b, rest.only_where(smooth)]
    }

    /// 1 − G(v).
    #[inline(always)]
    pub(super) fn hidden(&self, cos: T) -> T {
        let (one, r) = (T::one(), self.roughness);
        let dark = r * (one - cos.at_most(one));
        dark / (dark + cos)
    }

    /// √((h_x² + p² h_y²)/(h_x² + h_y²)) of a vector: the root under A, of cos²ψ + p² sin²ψ. p where there is no azimuth, so
    /// that A is that of w = 0.
    #[inline(always)]
    fn grain(&self, h: T::Vec3) -> T {
        let (x, y) = (h.x().squared(), h.y().squared());
        let across = x + y;
        let tilted = across.gt(T::lit(1e-36));
        let p_squared = self.isotropy.squared();
        let squared = (x + p_squared * y) / T::select(tilted, across, T::one());
        T::select(tilted, squared, p_squared).max(T::lit(1e-36)).sqrt()
    }

    /// Z.
    #[inline(always)]
    fn zenith(&self, pair: &Pair<T>) -> T {
        let sum = pair.sum;
        let across = sum.x().squared() + sum.y().squared();
        let along = sum.z().squared();
        let whole = across + along;
        let below = (across + self.roughness * along).max(whole * T::lit(1e-18));
        (self.roughness * (whole / below).squared()).min(T::max_finite())
    }

    /// A.
    #[inline(always)]
    pub(super) fn anisotropy(&self, h: T::Vec3) -> T {
        self.isotropy.sqrt() / self.grain(h)
    }

    /// A, averaged with that of the mirror image of h across the plane of a viewer.
    pub(super) fn mean_anisotropy(&self, h: T::Vec3, wo: T::Vec3) -> T {
        let (two, tiny) = (T::lit(2.0), T::lit(1e-36));
        let (x, y) = (wo.x(), wo.y());
        let squared = x.squared() + y.squared();
        let tilted = squared.gt(tiny);
        let along = T::select(tilted, (h.x() * x + h.y() * y) / squared.max(tiny), T::zero());
        let image = Vector::new(two * along * x - h.x(), two * along * y - h.y(), h.z());
        (self.anisotropy(h) + self.anisotropy(image)) * T::lit(0.5)
    }

    /// 1/(v v′), or with G and G′ as factors.
    #[inline(always)]
    pub(super) fn visible(&self, shadowing: SchlickShadowing, [i, o]: [T; 2]) -> T {
        let one = T::one();
        let shaded = |cos: T| self.roughness * (one - cos.at_most(one)) + cos;
        let product = match shadowing {
            SchlickShadowing::None => (i * o).max(T::lit(1e-37)),
            _ => shaded(i) * shaded(o),
        };
        one / product
    }

    /// What of D comes from hidden light.
    #[inline(always)]
    pub(super) fn emitted(&self, shadowing: SchlickShadowing, [i, o]: [T; 2]) -> T {
        let (dark_i, dark_o) = (self.hidden(i), self.hidden(o));
        let hidden = dark_i + dark_o - dark_i * dark_o;
        match shadowing {
            SchlickShadowing::None | SchlickShadowing::Schlick => T::zero(),
            SchlickShadowing::ReemissionPrinted => {
                let product = (i * o).max(T::lit(1e-37));
                (hidden * T::lit(0.25 * FRAC_1_PI) / product).min(T::max_finite())
            }
            SchlickShadowing::ReemissionBounded => hidden * T::lit(FRAC_1_PI),
        }
    }

    /// D in one of its forms.
    #[inline(always)]
    pub(super) fn facets(&self, shadowing: SchlickShadowing, pair: &Pair<T>) -> T {
        let cosines = [pair.cos_i, pair.cos_o].map(|cos| T::select(pair.above, cos, T::one()));
        let density = self.zenith(pair) * self.anisotropy(pair.sum) * T::lit(0.25 * FRAC_1_PI);
        let visible = density * self.visible(shadowing, cosines);
        (visible + self.emitted(shadowing, cosines)).min(T::max_finite())
    }

    /// M(1, p)/√p, by which A is to be multiplied to be 1 on average.
    pub(super) fn evenness(&self) -> T {
        let ([mean, _], _) = self.means();
        mean / self.isotropy.sqrt()
    }

    /// M(1, p) and its last step, and c/a of all steps.
    #[inline(always)]
    fn means(&self) -> ([T; 2], [T; STEPS]) {
        let half = T::lit(0.5);
        let (mut a, mut b) = (T::one(), self.isotropy);
        let mut quotients = [T::zero(); STEPS];
        for quotient in &mut quotients {
            let (sum, difference) = (half * (a + b), half * (a - b));
            *quotient = difference / sum;
            (a, b) = (sum, (a * b).sqrt());
        }
        ([a, b], quotients)
    }

    /// Density of half vectors per steradian.
    #[inline(always)]
    pub(super) fn half_vectors(&self, evenness: T, pair: &Pair<T>) -> T {
        let anisotropy = self.anisotropy(pair.sum) * evenness;
        let density = pair.cos_h * self.zenith(pair) * anisotropy * T::lit(FRAC_1_PI);
        density.min(T::max_finite())
    }

    /// Draws a half vector: tan²θ_h = r (1 − u)/u of the first number, and the azimuth whose incomplete
    /// elliptic integral is the part u of the whole, by descending Landen steps.
    #[inline(always)]
    pub(super) fn half_vector(&self, u: [T; 2]) -> T::Vec3 {
        let ([u, turn], half) = (uniform(u), T::lit(0.5));
        let (_, quotients) = self.means();
        let mut angle = turn * T::lit(TAU * f64::from(1_u32 << STEPS));
        for quotient in quotients.into_iter().rev() {
            angle = half * (angle + (quotient * angle.sin()).asin());
        }
        let (sin_phi, cos_phi) = angle.sin_cos();
        let sin = (self.roughness * (T::one() - u)).sqrt();
        let h: T::Vec3 = Vector::new(sin * cos_phi, sin * sin_phi, u.sqrt());
        Vector::normalize_or_normal(h)
    }
}
