use core::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

use super::term::{Fresnel, incident_cosine, scaled};
use crate::block::{Block, ColorBlock, CosineBlock};
use crate::parameter::model;
use crate::polarization::Polarized;
use crate::quadrature::integrate;
use crate::real::{Color, Mask, Real};

model! {
    /// Fresnel's reflectance of a conductor or any absorbing medium, exact, seen from a transparent
    /// one.
    ///
    /// # Formula
    /// ```text
    /// q = a + ib = √((n + ik)² − s²)    u = |cosθ|    s² = (1 − u)(1 + u)
    /// R_s = |(u − q)/(u + q)|²          R_p = R_s |(u q − s²)/(u q + s²)|²    R = (R_s + R_p)/2
    /// ```
    parameters {
        eta: C, ETA, "n", "real part of the relative index";
        k: C, K, "k", "imaginary part, the extinction coefficient";
    }
    /// | cosθ | `cos_theta` | cosine of the angle of incidence | −1 … 1, the sign is ignored |
    ///
    /// k is the extinction coefficient itself, not κ = k/n. With k = 0 this is
    /// [`Dielectric`](super::Dielectric), total reflection included. At grazing R = 1 but for
    /// rounding, unless n = 1 and k < 10⁻¹⁸: there R falls to 0, that of no surface.
    ///
    /// # Energy
    /// Reciprocal. Conserving: R ≤ 1.
    ///
    /// # Accuracy
    /// The sum of R_s and R_p is evaluated on one fraction line,
    ///
    /// ```text
    /// R = |N² − 1|² (u²h + s⁴) / ((h + u² + 2au)² (u²h + s⁴ + 2au s²))    N = n + ik    h = a² + b²
    /// ```
    ///
    /// where nothing is subtracted: in `f32` R stays within 10⁻⁶ relative of the exact value for every
    /// index and angle, except where |q|² < |N|²/10, close to the critical angle of n < 1 with k near
    /// 0; there see [`Dielectric`](super::Dielectric).
    ///
    /// The average is a quadrature with a relative error below 10⁻¹⁴ for metals (0.04 ≤ n ≤ 10,
    /// 1 ≤ k ≤ 10), 4·10⁻⁷ in the whole range except next to n + ik = 1, where all that is reflected
    /// grazes: it grows to 10⁻⁵ at |N − 1| = 10⁻⁵, 3·10⁻⁴ at 10⁻⁶ and 0.1 at 10⁻⁹.
    ///
    /// # Sources
    /// A. Fresnel 1823, with A. L. Cauchy's complex index. M. Born, E. Wolf, *Principles of Optics*,
    /// section 14.2.
    ///
    /// ```
    /// use brdf::{Conductor, Fresnel};
    /// use glam::DVec3;
    ///
    /// // Gold at 659.5, 548.6 and 450.9 nm.
    /// let gold = Conductor::new(DVec3::new(0.14, 0.43, 1.38), DVec3::new(3.697, 2.455, 1.914))?;
    /// let normal = gold.reflectance(1.0);
    /// assert!(normal.abs_diff_eq(DVec3::new(0.962585, 0.786916, 0.408220), 1e-6));
    /// assert!(gold.reflectance(0.0).abs_diff_eq(DVec3::ONE, 1e-15));
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("metal", "complex IOR"))]
    pub struct Conductor<C = glam::Vec3>;

    /// A medium of the given complex relative index n + ik, per channel.
    pub fn new;
}

impl<C> Conductor<C> {
    /// Whether k is known to be above n in every channel.
    fn is_metallic<T: Real>(&self) -> bool
    where
        C: Color<T>,
    {
        let absorbs = |eta: T, k: T| (eta - k) * (eta + k);
        let real_parts = self.eta.zip(self.k, absorbs);
        real_parts.fold(true, |all, real_part| all && real_part.ge(T::zero()).is_never())
    }

    /// The reflectance of a medium that [is metallic](Self::is_metallic) at a cosine in 0 … 1.
    #[inline(always)]
    fn of_metal<T: Real>(&self, cos: T) -> C
    where
        C: Color<T>,
    {
        self.eta.zip(self.k, |eta, k| Refraction::into_metal(eta, k, cos).unpolarized())
    }
}

impl<T: Real, C: Color<T>> Fresnel<T> for Conductor<C> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        let cos = incident_cosine(cos_theta);
        self.eta.zip(self.k, |eta, k| Refraction::new(eta, k, cos).unpolarized())
    }

    fn reflectance_block(&self, cosines: CosineBlock<'_, T>, values: &mut ColorBlock<T, C>) {
        if self.is_metallic() {
            cosines.colors(
                values,
                #[inline(always)]
                |index| self.of_metal(incident_cosine(cosines.cos(index))),
            );
        } else {
            cosines.colors(
                values,
                #[inline(always)]
                |index| self.reflectance(cosines.cos(index)),
            );
        }
    }

    #[inline(never)]
    fn reflected_block(&self, mirrored: Block<'_, T, 2>, values: &mut ColorBlock<T, C>) {
        let [cos, scale] = mirrored.planes;
        if self.is_metallic() {
            mirrored.colors(
                values,
                #[inline(always)]
                |index| scaled(self.of_metal(cos[index]), scale[index]),
            );
        } else {
            mirrored.colors(
                values,
                #[inline(always)]
                |index| self.reflected(cos[index], scale[index]),
            );
        }
    }

    fn average(&self) -> C {
        self.eta.zip(self.k, average)
    }
}

/// R_s and R_p of a medium of complex relative index `eta` + i `k`, as in [`Conductor`].
///
/// R_p is as accurate as R except where it almost vanishes, at the pseudo-Brewster angle of a
/// weak absorber.
///
/// ```
/// // Gold at 659.5 nm.
/// let gold = brdf::fresnel::conductor_polarized(0.14, 3.697, 1.2_f64.cos());
/// assert!((gold.s - 0.9866897397).abs() < 1e-10);
/// assert!((gold.p - 0.9253824968).abs() < 1e-10);
/// ```
#[inline(always)]
#[must_use]
pub fn conductor_polarized<T: Real>(eta: T, k: T, cos_theta: T) -> Polarized<T> {
    Refraction::new(eta, k, incident_cosine(cos_theta)).polarized()
}

/// The refracted wave and what the reflectances take from it.
pub(super) struct Refraction<T: Real> {
    /// u, the cosine of the angle of incidence.
    cos: T,
    /// u².
    cos_squared: T,
    /// 1 − u².
    sin_squared: T,
    /// |q|² = a² + b², q = a + ib being the normal component of the refracted wave vector over
    /// that in vacuum.
    modulus_squared: T,
    /// √2 times the larger of a and b.
    larger: T,
    /// 2ab = 2nk.
    product: T,
    /// Where a is the larger one.
    propagates: T::Mask,
    /// |N² − 1|².
    contrast: T,
}

impl<T: Real> Refraction<T> {
    #[inline(always)]
    pub(super) fn new(eta: T, k: T, cos: T) -> Self {
        let one = T::one();

        // Real parts of N² − 1 and of q² = N² − s², by whichever of two equal forms cancels less:
        // around N = 1 that is counted from N² − 1, around 0 from N².
        let squared = (eta - k) * (eta + k);
        let large = squared.ge(T::lit(0.5));
        let contrast = T::select(large, (eta - one) * (eta + one) - k * k, squared - one);
        let sin_squared = (one - cos) * (one + cos);
        let x = T::select(large, contrast + cos * cos, squared - sin_squared);
        Self::of([eta, k], cos, contrast, x, x.ge(T::zero()))
    }

    /// The same for a real part of N² below 0, where there is nothing to choose.
    #[inline(always)]
    fn into_metal(eta: T, k: T, cos: T) -> Self {
        let one = T::one();
        let squared = (eta - k) * (eta + k);
        let x = squared - (one - cos) * (one + cos);
        Self::of([eta, k], cos, squared - one, x, T::zero().lt(T::zero()))
    }

    /// From the real parts of N² − 1 and of q² and where the latter is not negative.
    #[inline(always)]
    fn of([eta, k]: [T; 2], cos: T, contrast: T, x: T, propagates: T::Mask) -> Self {
        let one = T::one();
        let product = T::lit(2.0) * eta * k;
        let y_squared = product.squared();

        // The floor stands where q = 0, at a critical angle; it is below the rounding of x² there.
        let modulus_squared = (x * x + y_squared.max(T::lit(1e-37))).sqrt();
        // Chosen and not |x|, so that both sides of 0 have their slopes.
        let magnitude = T::select(propagates, x, -x);
        Self {
            cos,
            cos_squared: cos * cos,
            sin_squared: (one - cos) * (one + cos),
            modulus_squared,
            larger: (modulus_squared + magnitude).sqrt(),
            product,
            propagates,
            contrast: contrast.squared() + y_squared,
        }
    }

    /// a and b, the smaller one without a difference.
    #[inline(always)]
    pub(super) fn parts(&self) -> (T, T) {
        let larger = self.larger * T::lit(FRAC_1_SQRT_2);
        let smaller = self.product / (self.larger * T::lit(SQRT_2));
        (T::select(self.propagates, larger, smaller), T::select(self.propagates, smaller, larger))
    }

    /// |u + q|² = |q|² + u² + 2au times `scale`, from 2au times `scale`.
    #[inline(always)]
    fn sum_squared(&self, twice_au: T, scale: T) -> T {
        (self.modulus_squared + self.cos_squared) * scale + twice_au
    }

    /// |u q|² + s⁴ and 2 a u s², half the sum and a quarter of the difference of |u q ± s²|², times
    /// `scale`, from 2au times `scale`.
    #[inline(always)]
    fn parallel(&self, twice_au: T, scale: T) -> (T, T) {
        let mean = self.cos_squared * self.modulus_squared + self.sin_squared.squared();
        (mean * scale, twice_au * self.sin_squared)
    }

    /// (R_s + R_p)/2.
    ///
    /// Where b is the larger of a and b, a = n k/b, and numerator and denominator are taken (√2 b)³
    /// times as large: one quotient is enough.
    #[inline(always)]
    pub(super) fn unpolarized(self) -> T {
        let scale = T::select(self.propagates, T::one(), self.larger);
        let root_of_two_a = T::select(self.propagates, self.larger, self.product);
        let twice_au = root_of_two_a * (self.cos * T::lit(SQRT_2));
        let (mean, cross) = self.parallel(twice_au, scale);
        let below = self.sum_squared(twice_au, scale).squared() * (mean + cross);
        // At most 1, but for rounding. In `f32` both may underflow where N = 1 but for k < 10⁻¹⁰
        // and u < k; this makes it the 1 of grazing.
        (self.contrast * scale.squared() * mean / below).at_most(T::one())
    }

    #[inline(always)]
    fn polarized(self) -> Polarized<T> {
        let (one, (a, b)) = (T::one(), self.parts());
        let twice_au = (a + a) * self.cos;
        let (mean, cross) = self.parallel(twice_au, one);
        let s = (self.contrast / self.sum_squared(twice_au, one).squared()).at_most(one);
        let real = self.cos * a - self.sin_squared;
        let imaginary = self.cos * b;
        let ratio = (real.squared() + imaginary.squared()) / (mean + cross);
        Polarized { s, p: s * ratio.at_most(one) }
    }
}

/// 2 ∫₀¹ R μ dμ for one index.
///
/// For n < 1 and small k the reflectance has a kink near the critical angle. The integral is split
/// there, and the nodes crowd there as squares.
pub(super) fn average<T: Real>(eta: T, k: T) -> T {
    let (zero, one) = (T::zero(), T::one());
    let split_squared = ((one - eta) * (one + eta) + k * k).clamp(zero, one);
    let splits = split_squared.gt(zero);
    let split = (T::select(splits, split_squared, one).sqrt()).only_where(splits);
    let rest = one - split;
    let weighted = |cos: T| Refraction::new(eta, k, cos).unpolarized() * cos;
    let integral = integrate(zero, one, |root| {
        let square = root * root;
        let below = weighted(split * (one - square)) * split;
        let above = weighted(split + rest * square) * rest;
        (below + above) * root
    });
    (integral * T::lit(4.0)).at_most(one)
}
