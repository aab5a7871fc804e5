use core::f64::consts::SQRT_2;

use super::areas::Areas;
use super::groove_azimuth::visible_azimuth;
use super::shadowing::{Kinks, Shadowing};
use crate::block::{BLOCK, DrawBlock, Plane};
use crate::direction::{Pair, above_or_normal};
use crate::distribution::Distribution;
use crate::real::{Real, Vector, lift};
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
/// with K = tanθ_h tanθ_o on an isotropic surface. Its integral is Kepler's equation; from a good guess one
/// step of Householder's method of third order solves it in `f32`, two in `f64`, to 4·10⁻⁷ and 5·10⁻¹³ of the
/// probability. The azimuth grows with the second number.
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
        Vector::normalize_or_normal(self.sample_visible_along(distribution, wo, u))
    }

    #[inline(always)]
    fn sample_visible_along(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        let facet = distribution.sample_along([u[0], T::lit(EIGHTH)]);
        visible_of_tilt::<T>(facet, wo, uniform(u)[1])
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
        distribution.sample_along_block(draws.of([tilt, &[T::lit(EIGHTH); BLOCK]]), h);
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

/// A vector along the visible normal whose tilt is that of a facet at an eighth of a turn.
#[inline(always)]
fn visible_of_tilt<T: Real>(facet: T::Vec3, wo: T::Vec3, place: T) -> T::Vec3 {
    let (wo, one) = (above_or_normal::<T, _>(wo), T::one());
    // All facets of this tilt: (x cosψ, y sinψ, z), of which one eighth of a turn shows both
    // x/√2 and y/√2.
    let (x, y, z) = (facet.x() * T::lit(SQRT_2), facet.y() * T::lit(SQRT_2), facet.z());
    // wo·h = z wo_z + r cos(ψ − ψ₀) with (r cosψ₀, r sinψ₀) = (x wo_x, y wo_y).
    let (r_cos, r_sin) = (x * wo.x(), y * wo.y());
    let r_squared = r_cos.squared() + r_sin.squared();
    // A smaller r does not change the density of the azimuth by as much as a rounding, and its
    // square has no digits in single precision.
    let tilted = r_squared.gt(T::lit(1e-36));
    let r_squared = T::select(tilted, r_squared, one);
    let inverse_r = one / r_squared.sqrt();
    let cos_0 = T::select(tilted, r_cos * inverse_r, one);
    let sin_0 = (r_sin * inverse_r).only_where(tilted);
    // K = r/(z wo_z) by its square, which does not wait for a root.
    let inverse_z = one / (z * wo.z()).max(T::lit(1e-18));
    let k_squared = T::select(tilted, r_squared * inverse_z.squared(), T::lit(1e-36));
    let (cos, sin) = visible_azimuth(k_squared, (cos_0, sin_0), place);
    Vector::new(x * cos, y * sin, z)
}

/// (wo·h)/2.
#[inline(always)]
fn half_cos_d<T: Real>(pair: &Pair<T>) -> T {
    pair.cos_d * T::lit(0.5)
}
