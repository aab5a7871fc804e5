use super::areas::Areas;
use super::shadowing::{Kinks, Shadowing};
use crate::block::{DrawBlock, Plane};
use crate::direction::Pair;
use crate::distribution::Smith;
use crate::real::{Real, lift};

/// Smith's shadowing and masking of a random surface, correlated by height: a high facet is seen
/// by both the light and the viewer.
///
/// # Formula
/// ```text
/// G = 1/(1 + Λ(wi) + Λ(wo))
/// G₁(w) = 1/(1 + Λ(w))
/// ```
///
/// Λ belongs to the distribution; written with [`Smith::projected_area`], A(w) = (1 + 2Λ(w)) N·w,
/// which is finite at grazing,
///
/// ```text
/// G/(4 (N·wi)(N·wo)) = 1/(2 (A(wi) N·wo + A(wo) N·wi))
/// ```
///
/// is one quotient. Symmetric in `wi` and `wo`, to the last bit. The
/// visible facets fill the projected area, ∫ G₁ (w·h)₊ D dω = N·w. Never less than
/// [`SmithSeparable`].
///
/// # Sources
/// B. G. Smith, "Geometrical shadowing of a random rough surface", IEEE Trans. Antennas and
/// Propagation 15, 1967, [doi:10.1109/TAP.1967.1138991](https://doi.org/10.1109/TAP.1967.1138991).
/// E. Heitz, "Understanding the masking-shadowing function in microfacet-based BRDFs", JCGT 3(2),
/// 2014, eq. 99.
///
/// ```
/// use brdf::{Beckmann, Pair, Shadowing, SmithCorrelated, from_spherical};
///
/// let (wi, wo) = (from_spherical(0.2_f64, 1.0), from_spherical(1.2, 4.0));
/// let pair = Pair::new(wi, wo);
/// let visibility = SmithCorrelated.visibility(&Beckmann::new(0.8)?, &pair);
/// let g: f64 = 4.0 * pair.cos_i * pair.cos_o * visibility;
/// assert!((g - 0.824802340778).abs() < 1e-12);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("height-correlated"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SmithCorrelated;

/// Smith's shadowing and masking with both directions independent.
///
/// # Formula
/// ```text
/// G = G₁(wi) G₁(wo),  G₁(w) = 1/(1 + Λ(w))
/// ```
///
/// Darker than [`SmithCorrelated`], most where both directions graze: the albedo of GGX with
/// roughness 1 is 0.613 instead of 0.989 at 89.9°. Symmetric in `wi` and `wo`, to the last bit.
///
/// # Sources
/// B. G. Smith, 1967, as for [`SmithCorrelated`]; B. Walter et al., "Microfacet models for
/// refraction through rough surfaces", EGSR 2007, eq. 23.
///
/// ```
/// use brdf::{Ggx, Pair, Shadowing, SmithSeparable, from_spherical};
///
/// let (wi, wo) = (from_spherical(0.2_f64, 1.0), from_spherical(1.2, 4.0));
/// let pair = Pair::new(wi, wo);
/// let visibility = SmithSeparable.visibility(&Ggx::new(0.8)?, &pair);
/// let g: f64 = 4.0 * pair.cos_i * pair.cos_o * visibility;
/// assert!((g - 0.604354289427).abs() < 1e-12);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SmithSeparable;

lift!(SmithCorrelated);
lift!(SmithSeparable);

/// Both kinds mask alike, so that the same normals are visible.
macro_rules! sampled_by_the_distribution {
    () => {
        #[inline(always)]
        fn sample_visible(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
            distribution.sample_visible(wo, u)
        }

        #[inline(always)]
        fn sample_visible_along(&self, distribution: &D, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
            distribution.sample_visible_along(wo, u)
        }

        fn sample_visible_block(
            &self,
            distribution: &D,
            draws: DrawBlock<'_, T>,
            h: &mut [Plane<T>; 4],
        ) {
            distribution.sample_visible_block(draws, h);
        }
    };
}

/// Shadowing and masking from the projected areas A(wi) and A(wo).
macro_rules! from_areas {
    ($kind:ident) => {
        impl<T: Real, D: Smith<T>> Shadowing<T, D> for $kind {
            #[inline(always)]
            fn visibility(&self, distribution: &D, pair: &Pair<T>) -> T {
                Self::visibility_of(areas(distribution, pair), pair)
            }

            #[inline(always)]
            fn masking(&self, distribution: &D, pair: &Pair<T>) -> T {
                Self::masking_of(areas(distribution, pair), pair)
            }

            #[inline(always)]
            fn unshadowed(&self, distribution: &D, pair: &Pair<T>) -> T {
                Self::unshadowed_of(areas(distribution, pair), pair)
            }

            fn kinks(&self, _: &D) -> Option<Kinks> {
                Some(Kinks::None)
            }

            sampled_by_the_distribution!();
        }
    };
}
from_areas!(SmithCorrelated);
from_areas!(SmithSeparable);

impl<T: Real> Areas<T> for SmithCorrelated {
    const NEEDED: bool = true;

    #[inline(always)]
    fn visibility_of([area_i, area_o]: [T; 2], pair: &Pair<T>) -> T {
        (T::lit(0.5) / (pair.cos_o * area_i + pair.cos_i * area_o)).min(T::max_finite())
    }

    #[inline(always)]
    fn masking_of([_, area_o]: [T; 2], pair: &Pair<T>) -> T {
        masking(area_o, pair)
    }

    #[inline(always)]
    fn unshadowed_of([area_i, area_o]: [T; 2], pair: &Pair<T>) -> T {
        let seen = pair.cos_o * area_i + pair.cos_i * area_o;
        // At most 1, but for rounding.
        (pair.cos_i * (pair.cos_o + area_o) / seen).at_most(T::one())
    }
}

impl<T: Real> Areas<T> for SmithSeparable {
    const NEEDED: bool = true;

    #[inline(always)]
    fn visibility_of([area_i, area_o]: [T; 2], pair: &Pair<T>) -> T {
        let seen_twice = (pair.cos_i + area_i, pair.cos_o + area_o);
        (T::one() / (seen_twice.0 * seen_twice.1)).min(T::max_finite())
    }

    #[inline(always)]
    fn masking_of([_, area_o]: [T; 2], pair: &Pair<T>) -> T {
        masking(area_o, pair)
    }

    #[inline(always)]
    fn unshadowed_of([area_i, _]: [T; 2], pair: &Pair<T>) -> T {
        // At most 1, but for rounding.
        let seen_twice = pair.cos_i + area_i;
        (T::lit(2.0) * pair.cos_i / seen_twice).at_most(T::one())
    }
}

/// A(wi) and A(wo) with A(w) = (1 + 2Λ(w)) N·w.
#[inline(always)]
fn areas<T: Real>(distribution: &impl Smith<T>, pair: &Pair<T>) -> [T; 2] {
    [distribution.projected_area(pair.wi), distribution.projected_area(pair.wo)]
}

/// G₁/(4 N·wo) = 1/(2 (N·wo + A(wo))).
#[inline(always)]
fn masking<T: Real>(area_o: T, pair: &Pair<T>) -> T {
    (T::lit(0.5) / (pair.cos_o + area_o)).min(T::max_finite())
}
