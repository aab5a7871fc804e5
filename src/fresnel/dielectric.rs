use super::term::{Fresnel, scaled};
use crate::block::{Block, ColorBlock, CosineBlock};
use crate::parameter::model;
use crate::polarization::Polarized;
use crate::quadrature::integrate;
use crate::real::{Color, Mask, Real, in_place};

model! {
    /// Fresnel's reflectance of a transparent medium, exact, from either side.
    ///
    /// # Formula
    /// ```text
    /// R_s = ((c − q)/(c + q))²    R_p = R_s ((c q − s²)/(c q + s²))²    R = (R_s + R_p)/2
    /// q = √(η² − s²)    η = n₂/n₁    c = |cosθ|    s² = (1 − c)(1 + c)
    /// ```
    parameters {
        ior: C, ETA, "n", "relative index, transmitted over incident medium";
    }
    /// | cosθ | `cos_theta` | cosine of the angle of incidence | −1 … 1 |
    ///
    /// A cosine ≥ 0 means light on the side of the normal (n₁ = 1, n₂ = n), a negative one light that
    /// arrives from the other side (n₁ = n, n₂ = 1). An index below 1 is a dense medium seen from
    /// inside. The index is always the relative one: glass seen from water is 1.5/1.33.
    ///
    /// Beyond the critical angle, where q² < 0, all light is reflected: R = 1. At grazing R = 1. With
    /// n = 1 there is no surface: R = 0 at every angle, also at grazing, where the limits n → 1 and
    /// cosθ → 0 do not commute. At Brewster's angle R_p = 0.
    ///
    /// # Energy
    /// Reciprocal: the same from either side along a refracted ray. Conserving: R ≤ 1.
    ///
    /// # Accuracy
    /// The differences in the textbook's formulas are evaluated as sums, c − q = (1 − η²)/(c + q), so
    /// that the answer keeps its digits for n near 1 and near the normal: in `f32` R stays within
    /// 2·10⁻⁶ relative of the exact value, except where |q²| < η²/10, close to the critical angle.
    /// There the slope of R is infinite, and q² is off by about ε min(η², |η² − 1|), which makes R off
    /// by that over q times 4/c + 2c/s²: a few 10⁻⁶ next to the critical angle, a few 10⁻³ at it.
    ///
    /// The average is exact up to rounding; see [`average`](Fresnel::average).
    ///
    /// # Sources
    /// A. Fresnel, *Mémoire sur la loi des modifications que la réflexion imprime à la lumière
    /// polarisée*, 1823. M. Born, E. Wolf, *Principles of Optics*, section 1.5.
    ///
    /// ```
    /// use brdf::{Dielectric, Fresnel};
    ///
    /// let glass = Dielectric::new(1.5_f64)?;
    /// assert!((glass.reflectance(1.0) - 0.04).abs() < 1e-15);
    /// assert_eq!(glass.reflectance(0.0), 1.0);
    /// assert_eq!(glass.reflectance(-0.5), 1.0); // from inside at 60°: total reflection
    /// assert!((glass.average() - 0.0917779593).abs() < 1e-10);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("IOR", "glass", "refractive index"))]
    pub struct Dielectric<C = glam::Vec3>;

    /// A transparent medium of the given relative index of refraction, per channel.
    pub fn new;
}

impl<C> Dielectric<C> {
    /// Whether the medium is known to be the denser one in every channel.
    fn is_denser<T: Real>(&self) -> bool
    where
        C: Color<T>,
    {
        self.ior.fold(true, |denser, ior| denser && ior.le(T::one()).is_never())
    }

    /// The reflectance of a medium that [is denser](Self::is_denser) at a cosine in 0 … 1.
    #[inline(always)]
    fn of_denser<T: Real>(&self, cos: T) -> C
    where
        C: Color<T>,
    {
        self.ior.map(|ior| Interface::into_denser(ior, cos).unpolarized())
    }
}

impl<T: Real, C: Color<T>> Fresnel<T> for Dielectric<C> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        self.ior.map(|ior| Interface::new(ior, cos_theta).unpolarized())
    }

    /// A block without light from the other side has nothing to choose. One that turns out to have
    /// some is computed again.
    fn reflectance_block(&self, cosines: CosineBlock<'_, T>, values: &mut ColorBlock<T, C>) {
        let (zero, one) = (T::zero(), T::one());
        let done = self.is_denser()
            && cosines.colors_unless(
                values,
                #[inline(always)]
                |index| {
                    let cos = cosines.cos(index);
                    (self.of_denser(cos.at_most(one)), cos.lt(zero))
                },
            );
        if !done {
            cosines.colors(
                values,
                #[inline(always)]
                |index| self.reflectance(cosines.cos(index)),
            );
        }
    }

    #[inline(always)]
    fn reflected(&self, cos: T, scale: T) -> C {
        in_place!(
            T,
            #[inline(always)]
            || {
                let above = self.ior.map(|ior| Interface::from_above(ior, cos).unpolarized());
                scaled(above, scale)
            },
        )
    }

    #[inline(never)]
    fn reflected_block(&self, mirrored: Block<'_, T, 2>, values: &mut ColorBlock<T, C>) {
        let [cos, scale] = mirrored.planes;
        if self.is_denser() {
            mirrored.colors(
                values,
                #[inline(always)]
                |index| scaled(self.of_denser(cos[index]), scale[index]),
            );
        } else {
            mirrored.colors(
                values,
                #[inline(always)]
                |index| self.reflected(cos[index], scale[index]),
            );
        }
    }

    /// The average for light on the side of the normal, to the last digits for every index.
    ///
    /// With z = (p + q)² the integrals are those of rational functions. That of R_s is
    /// r(3n + 1)/(3(n + 1)) with r = (n − 1)/(n + 1). That of R_p also has a closed form (J. W. T.
    /// Walsh, 1926), but its terms are up to (n − 1)⁻³ times as large as their sum. Here it is a
    /// 48-point quadrature over ln(z/(n² − 1) − ρ), ρ = (n² − 1)/(n² + 1), where the integrand is
    /// positive and its nearest singularity stays far away for every index. An index below 1 uses
    /// F(n) = 1 − n²(1 − F(1/n)). At n = 1, where its slopes are −7/3 below and 1/3 above, its
    /// derivative is the one above.
    fn average(&self) -> C {
        self.ior.map(average)
    }

    /// The cosine of the critical angle, √(1 − n²).
    fn kinks(&self) -> Option<C> {
        Some(self.ior.map(|ior| {
            let one = T::one();
            ((one - ior) * (one + ior)).max(T::lit(1e-30)).sqrt().only_where(ior.lt(one))
        }))
    }
}

/// R_s and R_p of a transparent medium of relative index `ior` (10⁻⁴ … 10⁴), as in [`Dielectric`].
///
/// ```
/// let glass = brdf::fresnel::dielectric_polarized(1.5, 0.5_f64.cos());
/// assert!((glass.s - 0.0559419508).abs() < 1e-10);
/// assert!((glass.p - 0.0265413548).abs() < 1e-10);
/// ```
#[inline(always)]
#[must_use]
pub fn dielectric_polarized<T: Real>(ior: T, cos_theta: T) -> Polarized<T> {
    Interface::new(ior, cos_theta).polarized()
}

/// What R_s and R_p consist of. The index η is that of the far side over that of the near one.
struct Interface<T: Real> {
    /// η² − 1, positive when the light enters the denser medium.
    difference: T,
    /// η².
    eta_squared: T,
    /// (c + q)².
    sum_squared: T,
    /// c q, which is η cosθ₁ cosθ₂.
    cosines: T,
    /// s², which is η sinθ₁ sinθ₂.
    sines: T,
    /// Where the reflection is total.
    total: T::Mask,
}

impl<T: Real> Interface<T> {
    #[inline(always)]
    fn new(ior: T, cos_theta: T) -> Self {
        let (zero, one) = (T::zero(), T::one());
        let from_below = cos_theta.lt(zero);
        // What depends on the index alone is chosen, not computed, for each side.
        let (squared, contrast) = (ior * ior, (ior - one) * (ior + one));
        let inverse = one / squared;
        let eta_squared = T::select(from_below, inverse, squared);
        let difference = T::select(from_below, -contrast * inverse, contrast);
        Self::of(difference, eta_squared, cos_theta.abs().at_most(one))
    }

    /// The same for light on the side of the normal, at a cosine in 0 … 1.
    #[inline(always)]
    fn from_above(ior: T, cos: T) -> Self {
        let one = T::one();
        Self::of((ior - one) * (ior + one), ior * ior, cos)
    }

    /// The same for an index above 1: never total, and nothing vanishes.
    #[inline(always)]
    fn into_denser(ior: T, cos: T) -> Self {
        let one = T::one();
        let difference = (ior - one) * (ior + one);
        let q_squared = difference + cos * cos;
        let cosines = cos * q_squared.sqrt();
        Self {
            difference,
            eta_squared: ior * ior,
            sum_squared: q_squared + (cos * cos + (cosines + cosines)),
            cosines,
            sines: (one - cos) * (one + cos),
            total: q_squared.lt(T::zero()),
        }
    }

    /// From η² − 1, η² and a cosine in 0 … 1.
    #[inline(always)]
    fn of(difference: T, eta_squared: T, cos: T) -> Self {
        let (zero, one) = (T::zero(), T::one());
        let (cos_squared, sin_squared) = (cos * cos, (one - cos) * (one + cos));

        // q², by whichever of the two equal forms cancels less towards the critical angle.
        let q_squared = T::select(
            eta_squared.lt(T::lit(0.5)),
            eta_squared - sin_squared,
            difference + cos_squared,
        );
        // A root has no derivative at 0.
        let above_zero = q_squared.max(T::lit(1e-37));
        let cosines = cos * above_zero.sqrt();

        // Small terms first: one rounding at grazing. The least difference of two f64 indices is
        // 2·10⁻¹⁶, so the floor only ever replaces what is no surface, or reflects totally.
        let sum_squared = above_zero + (cos_squared + (cosines + cosines));
        let sum_squared = sum_squared.max(T::lit(1e-16));
        let total = q_squared.lt(zero);
        Self { difference, eta_squared, sum_squared, cosines, sines: sin_squared, total }
    }

    /// (R_s + R_p)/2 on one fraction line.
    #[inline(always)]
    fn unpolarized(self) -> T {
        let squares = self.cosines.squared() + self.sines.squared();
        let below = (self.sum_squared * (self.cosines + self.sines)).squared();
        self.bounded(self.difference.squared() * squares / below)
    }

    /// At most 1, but for rounding and in total reflection: there c² is less than 1 − η², and nothing
    /// changes.
    #[inline(always)]
    fn bounded(&self, reflectance: T) -> T {
        let one = T::one();
        T::select(self.total, reflectance.min(one).held(), reflectance.at_most(one))
    }

    #[inline(always)]
    fn polarized(self) -> Polarized<T> {
        let s = self.bounded((self.difference / self.sum_squared).squared());
        let cosines = T::select(self.total, T::zero(), self.cosines);
        let ratio = (cosines - self.sines) / (cosines + self.sines);
        Polarized { s, p: s * ratio.squared() }
    }

    /// T_s = 4 c q/(c + q)² and T_p = T_s η²/(c q + s²)², without the difference 1 − R; at most 1,
    /// but for rounding.
    #[inline(always)]
    fn transmitted(&self) -> Polarized<T> {
        let (zero, one) = (T::zero(), T::one());
        // Without a surface the cosine is in no term; the quotient would lose it at grazing.
        let none = self.difference.abs().le(zero);
        let s = T::lit(4.0) * self.cosines / self.sum_squared;
        let p = s * self.eta_squared / (self.cosines + self.sines).squared();
        Polarized { s, p }.map(|transmitted| {
            let transmitted = T::select(none, one, transmitted.at_most(one));
            T::select(self.total, zero, transmitted)
        })
    }
}

/// What a transparent medium reflects and transmits of unpolarised light, of powers. Both are given
/// to the last digits, also where one of them vanishes.
#[inline(always)]
pub(crate) fn split<T: Real>(ior: T, cos_theta: T) -> [T; 2] {
    let interface = Interface::new(ior, cos_theta);
    let transmitted = interface.transmitted().unpolarized();
    [interface.unpolarized(), transmitted]
}

/// What a transparent medium of an index other than 1 reflects of unpolarised light or, where the mask
/// is true, transmits: one of [`split`], by one division.
#[inline(always)]
pub(crate) fn part<T: Real>(ior: T, cos_theta: T, transmitted: T::Mask) -> T {
    let Interface { difference, eta_squared, sum_squared, cosines, sines, total } =
        Interface::new(ior, cos_theta);
    let (zero, one, sum) = (T::zero(), T::one(), cosines + sines);
    let through = (cosines + cosines) * (sum.squared() + eta_squared) * sum_squared;
    let back = difference.squared() * (cosines.squared() + sines.squared());
    let part = T::select(transmitted, through, back) / (sum_squared * sum).squared();
    // At most 1, but for rounding.
    T::select(total, T::select(transmitted, zero, one), part.at_most(one))
}

/// The same of each polarisation: reflected and transmitted.
#[inline(always)]
pub(crate) fn split_polarized<T: Real>(ior: T, cos_theta: T) -> [Polarized<T>; 2] {
    let interface = Interface::new(ior, cos_theta);
    let transmitted = interface.transmitted();
    [interface.polarized(), transmitted]
}

/// 2 ∫₀¹ R μ dμ for one index.
pub(crate) fn average<T: Real>(ior: T) -> T {
    let (zero, one, two) = (T::zero(), T::one(), T::lit(2.0));
    let inside = ior.lt(one);
    let n = T::select(inside, one / ior, ior);
    // r = (n − 1)/(n + 1) and 1 − r, both without cancellation; the same for n and 1/n.
    let r = T::select(inside, one - ior, ior - one) / (ior + one);
    let rest = two * T::select(inside, ior, one) / (ior + one);
    let rho = two * r / (one + r * r);
    let one_minus_rho = rest * rest / (one + r * r);

    let s = r * (T::lit(3.0) * n + one) / (T::lit(3.0) * (n + one));
    // The floor keeps the logarithm finite at n = 1, where the factor ρ is 0.
    let length = (n / r.max(T::lit(1e-17))).ln();
    let integral = integrate(zero, one, |x| {
        let e = (length * x).exp_m1();
        let y = one + one_minus_rho * e;
        e / (one + e) * (y + one) * ((one - rho * e) / y).squared()
    });
    let p = rho * one_minus_rho * T::lit(0.5) * length * integral;
    let outside = (s + p) * T::lit(0.5);
    // At most 1, but for rounding.
    T::select(inside, (one - ior) * (one + ior) + ior * ior * outside, outside).at_most(one)
}
