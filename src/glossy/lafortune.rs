use alloc::vec::Vec;
use core::f64::consts::{FRAC_1_PI, TAU};

use super::cosine_power::{power_of_cosine, quarter_turn};
use super::mirror::{sample_power, unit_viewer};
use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above};
use crate::error::{ParameterError, Range, range};
use crate::frame::Frame;
use crate::parameter::{Kind, Parameter, model};
use crate::real::{Color, Lift, Mask, Real, Vector, lift, positive_zero};
use crate::sampling::{cosine_hemisphere, uniform};

/// The largest number of lobes of [`Lafortune`].
pub const MAX_LOBES: usize = 64;

/// A generalised cosine lobe of [`Lafortune`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LafortuneLobe<C = glam::Vec3, T = f32> {
    /// The colour that multiplies the power, 0 … 10¹⁰.
    pub specular: C,
    /// c_x, c_y, c_z, each in −10⁴ … 10⁴.
    pub c: [T; 3],
    /// n, 0 … 10⁸.
    pub exponent: T,
}

lift! {
    [T: Real, C: Color<T>] LafortuneLobe<C, T> => LafortuneLobe<C::Over<U>, U>:
    LafortuneLobe { specular: color, c: numbers, exponent: number }
}

/// Lafortune's sum of generalised cosine lobes, with which measured surfaces are fitted.
///
/// # Formula
/// ```text
/// f = ρ/π + Σ ρⱼ (c_x L_x V_x + c_y L_y V_y + c_z L_z V_z)₊ⁿ
/// ```
///
/// # Parameters
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | ρ | `diffuse` | albedo of the diffuse part | 0 … 1, 0 by default |
/// | ρⱼ | `lobes[j].specular` | colour of a lobe | 0 … 10¹⁰, 1 by default |
/// | c | `lobes[j].c` | where the lobe points, and how high it is | −10⁴ … 10⁴ |
/// | n | `lobes[j].exponent` | sharpness of the lobe | 0 … 10⁸ |
///
/// There are at most 64 lobes. −c_x = −c_y = c_z is a Phong lobe around the mirror direction, c_x = c_y > 0 one
/// back to the light, |c_z| below |c_x| one that leans to grazing, c_x ≠ c_y one with grain.
///
/// # Energy
/// Reciprocal, to the last bit. Conserving or not: that is up to the constants. A Phong lobe of −c_x = c_z = c has the albedo
/// 2πcⁿ/(n + 2) at normal incidence, so that c = ((n + 2)/2π)^(1/n) is the largest that
/// conserves. With D = (c_x V_x, c_y V_y, c_z V_z), a lobe reflects |D|ⁿ times what a Phong lobe around
/// D reflects, which is a closed form and an integral on a line; a lobe that points below the surface reflects
/// what of it lies above.
///
/// # Sampling
/// From the diffuse part with density cosθ/π or from a lobe with density (n + 1)/2π cosⁿ around D, chosen by about
/// how much each of them reflects above the surface, where a |D|ⁿ above 10¹⁸ counts as that.
///
/// # Sources
/// E. P. F. Lafortune, S.-C. Foo, K. E. Torrance, D. P. Greenberg, *Non-Linear Approximation of Reflectance
/// Functions*, SIGGRAPH 1997, [doi:10.1145/258734.258801](https://doi.org/10.1145/258734.258801).
///
/// ```
/// use brdf::{Brdf, Lafortune, LafortuneLobe};
/// use glam::DVec3;
///
/// let lobe = LafortuneLobe { specular: DVec3::ONE, c: [-1.0, -1.0, 1.0], exponent: 10.0 };
/// let phong = Lafortune::new(DVec3::splat(0.1), [lobe])?;
/// let f = phong.eval(DVec3::Z, DVec3::Z).x;
/// assert!((f - (1.0 + 0.1 / std::f64::consts::PI)).abs() < 1e-15);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Lafortune<C = glam::Vec3, T = f32> {
    diffuse: C,
    lobes: Vec<LafortuneLobe<C, T>>,
}

impl<T: Real, C: Color<T>> Lift<T> for Lafortune<C, T> {
    type Over<U: Real> = Lafortune<C::Over<U>, U>;

    fn lift<U: Real>(&self, lift: impl Fn(T) -> U + Copy) -> Self::Over<U> {
        let lobes = self.lobes.iter().map(|lobe| lobe.lift(lift)).collect();
        Lafortune { diffuse: self.diffuse.lift(lift), lobes }
    }
}

impl<C, T> Lafortune<C, T> {
    /// The table of the parameters.
    pub const PARAMETERS: &'static [Parameter] = &[
        model!(@row diffuse: C, UNIT = 0.0, "ρ", "albedo of the diffuse part"),
        Parameter::new("lobes", "ρⱼ, c, n", "the lobes", Kind::List(Self::LOBE)),
    ];

    /// The table of the parameters of a lobe.
    pub const LOBE: &'static [Parameter] = &[
        model!(@row specular: C, WEIGHT = 1.0, "ρⱼ", "colour of the lobe"),
        Parameter::new("c", "c", "where the lobe points: c_x, c_y, c_z", Kind::Vector(range::LOBE)),
        model!(@row exponent: T, EXPONENT, "n", "sharpness of the lobe"),
    ];

    /// The lobes.
    #[must_use]
    pub fn lobes(&self) -> &[LafortuneLobe<C, T>] {
        &self.lobes
    }
}

/// How many lobes there may be.
pub(crate) fn check_lobes(count: usize) -> Result<(), ParameterError> {
    Range::new(0.0, MAX_LOBES as f64).check("number of lobes", count as f64)
}

impl<T: Real, C: Color<T>> Lafortune<C, T> {
    /// A surface with a diffuse part and these lobes.
    ///
    /// # Errors
    /// If `diffuse` is not in 0 … 1, if there are more than 64 lobes, or if a number of one of them is not in its
    /// range.
    pub fn new(
        diffuse: C,
        lobes: impl IntoIterator<Item = LafortuneLobe<C, T>>,
    ) -> Result<Self, ParameterError> {
        range::UNIT.check("diffuse", diffuse)?;
        let mut kept = Vec::new();
        for lobe in lobes {
            check_lobes(kept.len() + 1)?;
            range::WEIGHT.check("specular", lobe.specular)?;
            for c in lobe.c {
                range::LOBE.check("c", c)?;
            }
            range::EXPONENT.check("exponent", lobe.exponent)?;
            kept.push(LafortuneLobe { specular: positive_zero(lobe.specular), ..lobe });
        }
        Ok(Self { diffuse: positive_zero(diffuse), lobes: kept })
    }

    /// The parts from which a sample may come for a viewer: the diffuse one, then the lobes.
    #[inline(always)]
    fn ground(&self) -> T {
        self.diffuse.mean()
    }

    /// What all parts reflect, about.
    #[inline(always)]
    fn total(&self, viewer: T::Vec3) -> T {
        self.lobes.iter().fold(self.ground(), |sum, lobe| sum + lobe.towards(viewer).share)
    }
}

/// A lobe as a viewer sees it.
struct Towards<T: Real> {
    axis: T::Vec3,
    /// |D|.
    length: T,
    /// |D|ⁿ, saturated; 0 for D = 0.
    height: T,
    /// |D|^(n/2), saturated.
    root: T,
    /// About what it reflects.
    share: T,
}

impl<T: Real, C: Color<T>> LafortuneLobe<C, T> {
    #[inline(always)]
    fn towards(&self, viewer: T::Vec3) -> Towards<T> {
        let (one, two) = (T::one(), T::lit(2.0));
        let [x, y, z] = self.c;
        let d: T::Vec3 = Vector::new(x * viewer.x(), y * viewer.y(), z * viewer.z());
        // Squares of what is too small vanish: it is stretched first.
        let largest = d.x().abs().max(d.y().abs()).max(d.z().abs()).held();
        let some = largest.gt(T::zero());
        let small = largest.lt(T::lit(1e-15));
        let unit = T::select(small, largest.max(T::lit(4.0) / T::max_finite()), one);
        let d = d * (one / unit);
        let squared = Vector::length_squared(d).max(T::lit(1e-36));
        let root = squared.sqrt();
        let axis = Vector::normalize_or_normal(d * (one / root));
        // A lobe of no length reflects nothing.
        let length = T::select(some, root * unit, one);
        let half = self.exponent * T::lit(0.5);
        let (base, power) =
            (T::select(small, length, squared), T::select(small, self.exponent, half));
        let height = base.powf(power).min(T::max_finite()).only_where(some);
        let root_of_height = base.powf(power * T::lit(0.5)).min(T::max_finite()).only_where(some);
        // What of it lies above the surface falls like that, where it points below.
        let sine = (axis.x().squared() + axis.y().squared()).max(T::lit(1e-36));
        let depth = axis.z().squared();
        let above = sine.power_of_part(depth, half + one) / (one + depth * (self.exponent + two));
        let sunk = axis.z().lt(T::zero());
        let spread = one / (self.exponent + two).sqrt();
        let above = axis.z().max(T::zero()) + T::select(sunk, spread * above, spread);
        let mean = self.specular.mean();
        let share = mean * height.min(T::lit(1e18)) * above * (T::lit(TAU) / (self.exponent + one));
        // So large that the quotient of shares has its digits.
        let share = share.max(T::lit(1e-30)).only_where(some.and(mean.gt(T::zero())));
        Towards { axis, length, height, root: root_of_height, share }
    }

    /// D·L.
    #[inline(always)]
    fn product(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let [x, y, z] = self.c;
        x * (wi.x() * wo.x()) + y * (wi.y() * wo.y()) + z * (wi.z() * wo.z())
    }

    /// The power, saturated.
    #[inline(always)]
    fn power(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let sum = self.product(wi, wo);
        let positive = sum.gt(T::zero());
        let power = T::select(positive, sum, T::one()).powf(self.exponent);
        power.min(T::max_finite()).only_where(positive)
    }

    /// Density of a sample of the lobe.
    #[inline(always)]
    fn density(&self, towards: &Towards<T>, wi: T::Vec3, wo: T::Vec3) -> T {
        let (half, one) = (T::lit(0.5), T::one());
        let Towards { axis, length, .. } = *towards;
        // Whichever of the cosine and what it lacks to 1 has the digits; at the edge of the lobe with the
        // error that the value has.
        let versine = Vector::length_squared(wi - axis) * half;
        let cos = T::select(versine.lt(half), one - versine, self.product(wi, wo) / length);
        let positive = cos.gt(T::zero());
        let part = T::select(positive, cos, one).max(T::lit(2e-38));
        let power = part.power_of_part(versine, self.exponent).only_where(positive);
        (self.exponent + one) * T::lit(0.5 * FRAC_1_PI) * power
    }

    /// (n + 2)/2π ∫ (D̂·L)₊ⁿ (N·L)₊ dω around an axis, as of Phong's lobe. Around one that points below the
    /// surface it is that of its mirror image without the cosine.
    fn reflected(&self, axis: T::Vec3) -> T {
        let (one, two) = (T::one(), T::lit(2.0));
        let cos = axis.z().abs();
        let sin_squared = axis.x().squared() + axis.y().squared();
        let sin = sin_squared.max(T::lit(1e-36)).sqrt();
        let (within, whole) = quarter_turn(self.exponent + one, cos, sin);
        let beyond = power_of_cosine(sin, cos * cos, self.exponent + two);
        let value = axis.z() + cos * within + beyond / ((self.exponent + one) * whole);
        (value * T::lit(0.5)).max(T::zero())
    }
}

impl<T: Real, C: Color<T>> Brdf<T> for Lafortune<C, T> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let mut sum = self.diffuse * T::lit(FRAC_1_PI);
        for lobe in &self.lobes {
            sum =
                sum + (lobe.specular * lobe.power(wi, wo)).map(|value| value.min(T::max_finite()));
        }
        let above = both_above::<T>(wi, wo);
        sum.map(|value| value.min(T::max_finite())).only_where(above)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let viewer = unit_viewer::<T>(wo);
        let mut sum = self.ground() * (wi.z() * T::lit(FRAC_1_PI));
        let mut total = self.ground();
        for lobe in &self.lobes {
            let towards = lobe.towards(viewer);
            sum = sum + towards.share * lobe.density(&towards, wi, wo);
            total = total + towards.share;
        }
        let some = total.gt(T::zero());
        let density = (sum / T::select(some, total, T::one())).min(T::max_finite());
        density.only_where(some.and(both_above::<T>(wi, wo)))
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let (zero, one) = (T::zero(), T::one());
        let ([u, turn], viewer) = (uniform(u), unit_viewer::<T>(wo));
        let place = u * self.total(viewer);
        let stretched = |start: T, share: T| {
            let part = (place - start) / T::select(share.gt(zero), share, one);
            part.clamp(zero, one)
        };
        // Of the parts that begin at or before the place the last one draws.
        let mut wi: T::Vec3 = cosine_hemisphere([stretched(zero, self.ground()), turn]);
        let mut start = self.ground();
        for lobe in &self.lobes {
            let Towards { axis, share, .. } = lobe.towards(viewer);
            let versine = sample_power(lobe.exponent, stretched(start, share));
            let sin = (versine * (T::lit(2.0) - versine)).max(zero).sqrt();
            let (sin_phi, cos_phi) = turn.sin_cos_turns();
            let around = Vector::new(sin * cos_phi, sin * sin_phi, one - versine);
            let drawn: T::Vec3 = Frame::from_normal(axis).to_world(around);
            let reached = share.gt(zero).and(place.ge(start));
            wi = Vector::select(reached, drawn, wi);
            start = start + share;
        }
        let pdf = self.pdf(wi, wo);
        let drawn = pdf.gt(zero);
        let scale = (wi.z() / T::select(drawn, pdf, one)).min(T::max_finite());
        let weight = (self.eval(wi, wo) * scale).map(|value| value.min(T::max_finite()));
        Sample { wi, weight, pdf }.only_where(drawn)
    }

    fn albedo(&self, wo: T::Vec3) -> C {
        let viewer = unit_viewer::<T>(wo);
        let mut sum = self.diffuse;
        for lobe in &self.lobes {
            let Towards { axis, height, root, .. } = lobe.towards(viewer);
            let part = lobe.reflected(axis) * (T::lit(TAU) / (lobe.exponent + T::lit(2.0)));
            // A height that is too large may have a small part above the surface.
            let large = height.ge(T::max_finite());
            let high = (part * root).min(T::max_finite()) * root;
            let reflected = T::select(large, high, height * part).min(T::max_finite());
            sum = sum + (lobe.specular * reflected).map(|value| value.min(T::max_finite()));
        }
        sum.map(|value| value.min(T::max_finite())).only_where(above_surface::<T, _>(wo))
    }
}

#[cfg(test)]
mod tests {
    use super::{Brdf, Lafortune, LafortuneLobe};
    use crate::quadrature::mean_over_square;
    use glam::{DVec3, Vec3};

    fn lobe(c: [f64; 3], exponent: f64, diffuse: f64) -> Lafortune<f64, f64> {
        Lafortune::new(diffuse, [LafortuneLobe { specular: 1.0, c, exponent }]).unwrap()
    }

    #[test]
    fn high_lobes_have_the_albedo_of_their_samples() {
        let high = lobe([-2.0, -2.0, 2.0], 100.0, 0.0);
        let want = 2.0_f64.powi(100) * core::f64::consts::TAU / 102.0;
        assert!((high.albedo(DVec3::Z) / want - 1.0).abs() < 1e-13);
        let mean = mean_over_square(|u| high.sample(DVec3::Z, u).weight);
        assert!((mean / want - 1.0).abs() < 1e-3);
        let c = [-1e4, -1e4, 1e4];
        let most = Lafortune::new(0.0_f32, [LafortuneLobe { specular: 1.0, c, exponent: 1e3 }]);
        assert_eq!(most.unwrap().albedo(Vec3::Z), f32::MAX);
    }

    #[test]
    fn low_lobes_have_the_albedo_of_their_samples() {
        for exponent in [0.0, 0.1, 2.0] {
            let low = lobe([-1e-20, -1e-20, 1e-20], exponent, 0.0);
            let want = 1e-20_f64.powf(exponent) * core::f64::consts::TAU / (exponent + 2.0);
            assert!((low.albedo(DVec3::Z) / want - 1.0).abs() < 1e-12, "{exponent}");
            let mean = mean_over_square(|u| low.sample(DVec3::Z, u).weight);
            assert!((mean / want - 1.0).abs() < 1e-3, "{exponent}");
        }
        let flat = lobe([-1.0, -1.0, 0.0], 0.0, 0.0);
        assert_eq!((flat.eval(DVec3::Z, DVec3::Z), flat.albedo(DVec3::Z)), (0.0, 0.0));
        assert_eq!(flat.pdf(DVec3::Z, DVec3::Z), 0.0);
    }

    #[test]
    fn a_lobe_below_the_surface_takes_few_draws() {
        let sunk = lobe([-1.0, -1.0, -2.0], 10.0, 0.5);
        let drawn = mean_over_square(|u| f64::from(u8::from(sunk.sample(DVec3::Z, u).pdf > 0.0)));
        assert!(drawn > 0.99, "{drawn}");
    }
}
