use core::f64::consts::{FRAC_PI_2, PI, SQRT_2};

use super::areas::Areas;
use super::shadowing::{Kinks, Shadowing};
use crate::block::{BLOCK, DrawBlock, Plane};
use crate::direction::{Pair, above_or_normal};
use crate::distribution::Distribution;
use crate::real::{Real, Vector, iterate, lift};
use crate::sampling::uniform;

/// Shadowing and masking in long symmetric V-shaped grooves.
///
/// # Formula
/// ```text
/// G₁(w, h) = min(1, 2 (N·h)(N·w)/(w·h))
/// G(wi, wo, h) = min(G₁(wi, h), G₁(wo, h)) = min(1, γ N·wi, γ N·wo),  γ = 2 (N·h)/(wo·h)
/// ```
///
/// The two sides of a groove have the normals h and h′ = (−h_x, −h_y, h_z), so that G does not
/// depend on the distribution. It is exact for such a surface: the visible facets of every
/// distribution fill the projected area, ∫ G₁ (w·h)₊ D dω = N·w. Symmetric in `wi` and `wo`, to
/// the last bit.
///
/// With d = wo·h/2 and the smaller and the larger of N·wi and N·wo,
///
/// ```text
/// G/(4 (N·wi)(N·wo)) = N·h / (4 larger · max(smaller · N·h, d))
/// ```
///
/// which has no difference and no quotient of vanishing terms: with h the half vector it is at
/// most 1/(2 (wo·h)²), also at grazing.
///
/// # Sampling
/// Heitz and d'Eon draw h from the distribution and keep it with probability
/// (wo·h)₊/((wo·h)₊ + (wo·h′)₊), else take h′; that needs a third random number. Here two are
/// enough. The first decides the tilt of the facet, as in [`Distribution::sample`]. The second is
/// the azimuth, whose density given the tilt is ½(1 + K cosφ)/π around the viewer, cut to 0 … 1/π,
/// with K = tanθ_h tanθ_o on an isotropic surface. Its integral is Kepler's equation; three steps
/// of Laguerre's method solve it, two in `f32`, to 5·10⁻¹³ of the probability in `f64` and 4·10⁻⁷ in
/// `f32`. The azimuth grows with the second number.
///
/// # Sources
/// K. E. Torrance, E. M. Sparrow, "Theory for off-specular reflection from roughened surfaces",
/// JOSA 57, 1967, [doi:10.1364/JOSA.57.001105](https://doi.org/10.1364/JOSA.57.001105).
/// J. F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977,
/// [doi:10.1145/563858.563893](https://doi.org/10.1145/563858.563893).
/// E. Heitz, E. d'Eon, "Importance sampling microfacet-based BSDFs using the distribution of
/// visible normals", EGSR 2014, [doi:10.1111/cgf.12417](https://doi.org/10.1111/cgf.12417).
///
/// ```
/// use brdf::{Beckmann, Pair, Shadowing, VCavity, from_spherical};
///
/// let (wi, wo) = (from_spherical(0.2_f64, 1.0), from_spherical(1.2, 4.0));
/// let pair = Pair::new(wi, wo);
/// let visibility = VCavity.visibility(&Beckmann::new(0.8)?, &pair);
/// let g: f64 = 4.0 * pair.cos_i * pair.cos_o * visibility;
/// assert!((g - 0.830226110201).abs() < 1e-12);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VCavity;

lift!(VCavity);

/// The grooves' shadows do not depend on the distribution.
impl<T: Real> Areas<T> for VCavity {
    const NEEDED: bool = false;

    #[inline(always)]
    fn visibility_of(_: [T; 2], pair: &Pair<T>) -> T {
        let (smaller, larger) = (pair.cos_i.min(pair.cos_o), pair.cos_i.max(pair.cos_o));
        let denominator = larger * (smaller * pair.cos_h).max(half_cos_d(pair));
        (T::lit(0.25) * pair.cos_h / denominator).min(T::max_finite())
    }

    #[inline(always)]
    fn masking_of(_: [T; 2], pair: &Pair<T>) -> T {
        let denominator = (pair.cos_o * pair.cos_h).max(half_cos_d(pair));
        (T::lit(0.25) * pair.cos_h / denominator).min(T::max_finite())
    }

    #[inline(always)]
    fn unshadowed_of(_: [T; 2], pair: &Pair<T>) -> T {
        let masked = (pair.cos_o * pair.cos_h).max(half_cos_d(pair));
        let shadowed = (pair.cos_i * pair.cos_h).max(half_cos_d(pair));
        (pair.cos_i / pair.cos_o * (masked / shadowed)).min(T::one())
    }
}

impl<T: Real, D: Distribution<T>> Shadowing<T, D> for VCavity {
    #[inline(always)]
    fn visibility(&self, _: &D, pair: &Pair<T>) -> T {
        Self::visibility_of([T::zero(); 2], pair)
    }

    #[inline(always)]
    fn masking(&self, _: &D, pair: &Pair<T>) -> T {
        Self::masking_of([T::zero(); 2], pair)
    }

    #[inline(always)]
    fn unshadowed(&self, _: &D, pair: &Pair<T>) -> T {
        Self::unshadowed_of([T::zero(); 2], pair)
    }

    #[inline(always)]
    fn sample_visible(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        let [tilt, place] = uniform(u);
        visible_of_tilt::<T>(distribution.sample([tilt, T::lit(EIGHTH)]), wo, place)
    }

    fn kinks(&self, _: &D) -> Option<Kinks> {
        Some(Kinks::Grooves)
    }

    fn sample_visible_block(
        &self,
        distribution: &D,
        draws: DrawBlock<'_, T>,
        h: &mut [Plane<T>; 4],
    ) {
        let [_, _, _, tilt, _] = draws.planes;
        distribution.sample_block(draws.of([tilt, &[T::lit(EIGHTH); BLOCK]]), h);
        visible_block(draws, h);
    }
}

/// The second stage of a block of visible normals: it is the same for all distributions.
#[inline(never)]
fn visible_block<T: Real>(draws: DrawBlock<'_, T>, h: &mut [Plane<T>; 4]) {
    draws.changed(
        h,
        &mut [],
        #[inline(always)]
        |index, [x, y, z, _]| {
            let [_, place] = uniform(draws.u(index));
            let h = visible_of_tilt::<T>(Vector::new(x, y, z), draws.wo(index), place);
            ([h.x(), h.y(), h.z(), T::zero()], [])
        },
    );
}

/// An eighth of a turn.
const EIGHTH: f64 = 0.125;

/// The visible normal whose tilt is that of a facet at an eighth of a turn.
#[inline(always)]
fn visible_of_tilt<T: Real>(facet: T::Vec3, wo: T::Vec3, place: T) -> T::Vec3 {
    let (wo, one) = (above_or_normal::<T, _>(wo), T::one());
    // All facets of this tilt: (x cosψ, y sinψ, z), of which one eighth of a turn shows both
    // x/√2 and y/√2.
    let (x, y, z) = (facet.x() * T::lit(SQRT_2), facet.y() * T::lit(SQRT_2), facet.z());
    // wo·h = z wo_z + r cos(ψ − ψ₀) with (r cosψ₀, r sinψ₀) = (x wo_x, y wo_y).
    let (r_cos, r_sin) = (x * wo.x(), y * wo.y());
    let r = (r_cos.squared() + r_sin.squared()).sqrt();
    // A smaller r does not change the density of the azimuth by as much as a rounding, and its
    // square has no digits in single precision.
    let tilted = r.gt(T::lit(1e-18));
    let inverse = one / T::select(tilted, r, one);
    let cos_0 = T::select(tilted, r_cos * inverse, one);
    let sin_0 = (r_sin * inverse).only_where(tilted);
    let k = (r / (z * wo.z())).only_where(tilted);
    let (cos, sin) = visible_azimuth(k, place);
    let facet: T::Vec3 =
        Vector::new(x * (cos_0 * cos - sin_0 * sin), y * (sin_0 * cos + cos_0 * sin), z);
    Vector::normalize_or_normal(facet)
}

/// (wo·h)/2.
#[inline(always)]
fn half_cos_d<T: Real>(pair: &Pair<T>) -> T {
    pair.cos_d * T::lit(0.5)
}

/// Cosine and sine of the azimuth φ in [−π, π] from the viewer for a number in [0, 1]: of two
/// opposite facets with areas (1 ± K cosφ)₊ one is chosen in proportion to the areas.
#[inline(always)]
fn visible_azimuth<T: Real>(k: T, u: T) -> (T, T) {
    let (zero, one, two) = (T::zero(), T::one(), T::lit(2.0));
    let (quarter_turn, half_turn) = (T::lit(FRAC_PI_2), T::lit(PI));
    // The end of K: beyond it the azimuths that see both facets have a probability below 10⁻¹⁵,
    // and K² would leave the range of single precision.
    let k = k.min(T::lit(1e15));
    // Both halves are alike. Counted from behind, at ε = π − |φ|, the probability is τ/π.
    let signed = u * two - one;
    let tau = (one - signed.abs()) * half_turn;
    // No facet is visible for ε < first; one of two for ε > π − first; between them, over the
    // width 2 (π/2 − first), ∫(1 − K cosε)dε = τ, or with x = ε − first and
    // (a, b) = K (cos first, sin first): x − a sin x + b (1 − cos x) = τ.
    let a = k.min(one);
    let b = ((k - one) * (k + one)).max(zero).sqrt();
    let half_width = one.atan2(b);
    let width = half_width * two;
    let target = tau.min(width);
    let equation = Kepler { a, b, target };
    let first = (target * width).sqrt();
    let x = if T::SPACING > 1e-9 {
        iterate::<2, _>(
            first,
            #[inline(always)]
            |x| equation.step(x, width),
        )
    } else {
        iterate::<3, _>(
            first,
            #[inline(always)]
            |x| equation.step(x, width),
        )
    };
    let x = x.as_solution_of(|x| {
        let (value, slope, _) = equation.at(x);
        (value, slope)
    });
    let both_visible = tau.lt(width);
    let from_behind =
        T::select(both_visible, quarter_turn - half_width + x, quarter_turn + tau * T::lit(0.5));
    let (sin, cos) = from_behind.sin_cos();
    (-cos, sin.copysign(signed))
}

/// The equation x − a sin x + b (1 − cos x) = `target`.
struct Kepler<T> {
    a: T,
    b: T,
    target: T,
}

impl<T: Real> Kepler<T> {
    /// One step of Laguerre's method, as of a polynomial of degree 5.
    #[inline(always)]
    fn step(&self, x: T, width: T) -> T {
        let (value, slope, curvature) = self.at(x);
        let discriminant = T::lit(16.0) * slope.squared() - T::lit(20.0) * value * curvature;
        // Both terms are zero only at the solution x = 0, where the value is zero too.
        let denominator = (slope + discriminant.abs().sqrt()).max(T::lit(1e-30));
        (x - T::lit(5.0) * value / denominator).clamp(T::zero(), width)
    }

    /// How far the left side is above the right one, its slope and its curvature.
    #[inline(always)]
    fn at(&self, x: T) -> (T, T, T) {
        let &Self { a, b, target } = self;
        let (one, two) = (T::one(), T::lit(2.0));
        let (sin_half, cos_half) = (x * T::lit(0.5)).sin_cos();
        let sin = two * sin_half * cos_half;
        let one_minus_cos = two * sin_half.squared();
        let value = x - a * sin + b * one_minus_cos - target;
        let slope = (one - a) + a * one_minus_cos + b * sin;
        (value, slope, a * sin + b * (one - one_minus_cos))
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use super::visible_azimuth;

    /// The probability that the azimuth is at most φ, by the closed integral of its density.
    fn probability(k: f64, cos: f64, sin: f64) -> f64 {
        let behind = sin.abs().atan2(-cos);
        let half_width = 1.0_f64.atan2(((k - 1.0) * (k + 1.0)).max(0.0).sqrt());
        let first = FRAC_PI_2 - half_width;
        let tail = if behind > PI - first {
            2.0 * behind / PI - 1.0
        } else {
            let ends = |angle: f64| angle - k * angle.sin();
            (ends(behind) - ends(first)).max(0.0) / PI
        };
        if sin.is_sign_negative() { 0.5 * tail } else { 1.0 - 0.5 * tail }
    }

    /// Flat, mildly tilted, just not and just hidden, almost vertical facets.
    const K: [f64; 14] =
        [0.0, 1e-9, 0.1, 0.5, 0.9, 0.99, 0.999999, 1.0, 1.000001, 1.01, 1.1, 2.0, 30.0, 1e4];

    #[test]
    fn the_azimuth_inverts_its_probability() {
        let (mut worst_f32, mut worst_f64) = (0.0_f64, 0.0_f64);
        for k in K {
            let even = (0..=4096_u16).map(|step| f64::from(step) / 4096.0);
            let small = (0..=512_u16).map(|step| (-f64::from(step) / 16.0).exp());
            for u in even.chain(small) {
                let (cos, sin) = visible_azimuth(k, u);
                worst_f64 = worst_f64.max((probability(k, cos, sin) - u).abs());
                #[allow(clippy::cast_possible_truncation, reason = "single precision is tested")]
                let (single_k, single_u) = (k as f32, u as f32);
                let (cos, sin) = visible_azimuth(single_k, single_u);
                let got = probability(f64::from(single_k), f64::from(cos), f64::from(sin));
                worst_f32 = worst_f32.max((got - f64::from(single_u)).abs());
            }
        }
        assert!(worst_f64 < 5e-13, "{worst_f64:e}");
        assert!(worst_f32 < 4e-7, "{worst_f32:e}");
    }

    #[test]
    fn the_azimuth_grows_with_the_number() {
        for k in K {
            let angle = |step: u16| {
                let (cos, sin) = visible_azimuth(k, f64::from(step) / 4096.0);
                sin.atan2(cos)
            };
            for step in 1..=4095 {
                assert!(angle(step) > angle(step - 1) - 1e-15 || step == 1, "{k} {step}");
            }
        }
    }

    #[test]
    fn vertical_facets_and_the_ends_of_the_numbers_are_harmless() {
        for k in [1e10, 1e15, 1e30, f64::MAX, f64::INFINITY] {
            for u in [0.0, 1e-300, 1e-16, 0.25, 0.5, 0.75, 1.0 - 1e-16, 1.0] {
                let (cos, sin) = visible_azimuth(k, u);
                assert!((cos * cos + sin * sin - 1.0).abs() < 1e-15, "{k} {u}");
                assert!(cos > -1e-9, "{k} {u}: faces away by {cos}");
            }
        }
    }
}
