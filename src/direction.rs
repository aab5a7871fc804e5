//! Directions: half vector, reflection, refraction, angles.
//!
//! Directions are unit vectors that point away from the surface, in the shading frame where the
//! normal is +z, or in any frame where the normal is given.

use crate::error::{ParameterError, Range};
use crate::real::{Mask, Real, Vector};

/// A pair of directions above the surface and what the models need of it, computed once.
///
/// ```
/// use brdf::Pair;
/// use glam::Vec3;
///
/// let pair = Pair::new(Vec3::new(0.6, 0.0, 0.8), Vec3::new(-0.6, 0.0, 0.8));
/// assert_eq!(pair.h, Vec3::Z);
/// assert!((pair.cos_d - 0.8).abs() < 1e-7);
/// ```
#[doc(alias("half vector"))]
#[derive(Clone, Copy, Debug)]
pub struct Pair<T: Real> {
    /// Towards the light.
    pub wi: T::Vec3,
    /// Towards the viewer.
    pub wo: T::Vec3,
    /// N·L, the cosine of the angle of incidence.
    pub cos_i: T,
    /// N·V, the cosine of the angle of the viewer.
    pub cos_o: T,
    /// wi + wo, which points along the half vector, with a z of at least 2⁻⁶⁰. So it is the normal
    /// where the sum is too short to point anywhere, and two directions that graze by less than
    /// 4·10⁻¹⁹ radians have a half vector as if they grazed by that much.
    pub sum: T::Vec3,
    /// The half vector (wi + wo)/|wi + wo|.
    pub h: T::Vec3,
    /// N·H, the cosine of the tilt of the facet that mirrors `wi` into `wo`.
    pub cos_h: T,
    /// V·H = L·H, the cosine of the angle of incidence on that facet.
    pub cos_d: T,
    /// Where both directions are directions and lie above the surface. Elsewhere a BRDF is zero.
    pub above: T::Mask,
}

impl<T: Real> Pair<T> {
    /// The geometry of a pair of directions in the shading frame.
    #[inline(always)]
    #[must_use]
    pub fn new<V: Vector<T>>(wi: V, wo: V) -> Self
    where
        T: Real<Vec3 = V>,
    {
        Self::where_above(wi, wo, both_above::<T>(wi, wo))
    }

    /// The pair as the side of `wo` sees it: where `wo` lies below the surface, both directions are
    /// mirrored across it, so that a pair below is one above.
    ///
    /// ```
    /// use brdf::Pair;
    /// use glam::Vec3;
    ///
    /// let below = Vec3::new(0.6, 0.0, -0.8);
    /// let pair = Pair::from_either_side(below, below);
    /// assert!(pair.above);
    /// assert_eq!(pair.h, Vec3::new(0.6, 0.0, 0.8));
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn from_either_side<V: Vector<T>>(wi: V, wo: V) -> Self
    where
        T: Real<Vec3 = V>,
    {
        let (_, [wi, wo]) = facing::<T>(wi, wo);
        Self::new(wi, wo)
    }

    /// [`sum`](Self::sum) alone.
    #[inline(always)]
    pub(crate) fn sum(wi: T::Vec3, wo: T::Vec3) -> T::Vec3 {
        let sum = wi + wo;
        Vector::new(sum.x(), sum.y(), sum.z().max(least_height::<T>()))
    }

    /// The same where it is known already which pairs are above the surface.
    #[inline(always)]
    pub(crate) fn where_above(wi: T::Vec3, wo: T::Vec3, above: T::Mask) -> Self {
        let (cos_i, cos_o) = (wi.z(), wo.z());
        // One square root serves h and V·H, since |wi + wo| = 2 V·H for unit directions. The floor,
        // 2⁻⁶⁰, has a square that is precise in single precision.
        let sum = Self::sum(wi, wo);
        let length = Vector::length_squared(sum).sqrt();
        let cos_d = length * T::lit(0.5);
        let h = sum * (T::one() / length);
        Self { wi, wo, cos_i, cos_o, sum, h, cos_h: h.z(), cos_d, above }
    }
}

/// 2⁻⁶⁰. A power of two, so that the length of such a sum has an exact reciprocal.
const FLOOR: f64 = 1.0 / (1_u64 << 60) as f64;

/// The least z of a vector along a half vector.
#[inline(always)]
pub(crate) fn least_height<T: Real>() -> T {
    T::lit(FLOOR)
}

/// How far the squared length of a direction may lie off 1.
const LENGTH_TOLERANCE: f64 = 0.01;

/// Where `w` is a direction above the surface: its z is positive and its squared length lies
/// within 1 % of 1. A length further off is taken for a mistake, not for a direction; one within
/// counts as 1, and its error passes into the answers.
///
/// ```
/// use glam::Vec3;
///
/// assert!(brdf::above_surface(Vec3::new(0.6, 0.0, 0.8)));
/// assert!(!brdf::above_surface(Vec3::new(0.6, 0.0, -0.8)));
/// assert!(!brdf::above_surface(Vec3::new(0.6, 0.0, 0.9)));
/// ```
#[inline(always)]
#[must_use]
pub fn above_surface<T: Real, V: Vector<T>>(w: V) -> T::Mask {
    let off = Vector::length_squared(w) - T::one();
    off.abs().le(T::lit(LENGTH_TOLERANCE)).and(w.z().gt(T::zero()))
}

/// Checks that a vector is a direction: that its squared length lies within 1 % of 1.
///
/// What is further off is [no direction](above_surface), and every answer for it is zero: a surface
/// that stays black is often one whose directions were not normalised. A renderer asks this in debug
/// builds, where its directions enter.
///
/// ```
/// use brdf::check_direction;
/// use glam::Vec3;
///
/// let wi = Vec3::new(0.6, 0.0, 0.8);
/// debug_assert_eq!(check_direction(wi), Ok(()));
/// let error = check_direction(Vec3::new(0.6, 0.0, 0.81)).unwrap_err();
/// assert!(error.to_string().starts_with("squared length must be between 0.99 and 1.01, not 1.016"));
/// # Ok::<(), brdf::ParameterError>(())
/// ```
///
/// # Errors
/// If it is not, with the squared length.
pub fn check_direction<T: Real, V: Vector<T>>(w: V) -> Result<(), ParameterError> {
    let off = Vector::length_squared(w) - T::one();
    match off.outside(-LENGTH_TOLERANCE, LENGTH_TOLERANCE) {
        None => Ok(()),
        Some(off) => Err(Range::new(1.0 - LENGTH_TOLERANCE, 1.0 + LENGTH_TOLERANCE)
            .refusal("squared length", 1.0 + off)),
    }
}

/// Where both are directions above the surface: elsewhere every answer of a model is zero.
#[inline(always)]
#[must_use]
pub fn both_above<T: Real>(wi: T::Vec3, wo: T::Vec3) -> T::Mask {
    above_surface::<T, _>(wi).and(above_surface::<T, _>(wo))
}

/// Where `w` is a direction above or below the surface: its z is not 0 and its squared length lies
/// within 1 % of 1, as of [`above_surface`].
///
/// ```
/// use glam::Vec3;
///
/// assert!(brdf::off_surface(Vec3::new(0.6, 0.0, -0.8)));
/// assert!(!brdf::off_surface(Vec3::X));
/// ```
#[inline(always)]
#[must_use]
pub fn off_surface<T: Real, V: Vector<T>>(w: V) -> T::Mask {
    let off = Vector::length_squared(w) - T::one();
    off.abs().le(T::lit(LENGTH_TOLERANCE)).and(w.z().abs().gt(T::zero()))
}

/// A direction above or below the surface; the normal in the place of any other vector.
#[inline(always)]
pub(crate) fn off_surface_or_normal<T: Real, V: Vector<T>>(w: V) -> V {
    let normal = V::new(T::zero(), T::zero(), T::one());
    V::select(off_surface::<T, _>(w), w, normal)
}

/// The mirror direction of the surface itself. There is no −0 in it.
#[inline(always)]
pub(crate) fn mirrored<T: Real, V: Vector<T>>(w: V) -> V {
    V::new(T::zero() - w.x(), T::zero() - w.y(), w.z())
}

/// The mirror image of `w` across the surface where the mask is true, `w` elsewhere.
#[inline(always)]
pub(crate) fn turned_over<T: Real, V: Vector<T>>(mask: T::Mask, w: V) -> V {
    V::new(w.x(), w.y(), T::select(mask, -w.z(), w.z()))
}

/// Both directions as the side of `wo` sees them, mirrored where `wo` lies below the surface, and where
/// it does.
#[inline(always)]
pub(crate) fn facing<T: Real>(wi: T::Vec3, wo: T::Vec3) -> (T::Mask, [T::Vec3; 2]) {
    let below = wo.z().lt(T::zero());
    (below, [turned_over::<T, _>(below, wi), turned_over::<T, _>(below, wo)])
}

/// A direction above the surface; the normal in the place of any other vector.
#[inline(always)]
pub(crate) fn above_or_normal<T: Real, V: Vector<T>>(w: V) -> V {
    let normal = V::new(T::zero(), T::zero(), T::one());
    V::select(above_surface::<T, _>(w), w, normal)
}

/// The mirror direction R = 2N(N·L) − L of a direction that points away from the surface.
///
/// ```
/// use brdf::reflect;
/// use glam::Vec3;
///
/// assert_eq!(reflect(Vec3::new(0.6, 0.0, 0.8), Vec3::Z), Vec3::new(-0.6, 0.0, 0.8));
/// ```
#[inline(always)]
#[must_use]
pub fn reflect<T: Real, V: Vector<T>>(w: V, normal: V) -> V {
    normal * (Vector::dot(w, normal) * T::lit(2.0)) - w
}

/// What [`refract`] answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refraction<V, M> {
    /// The refracted direction, pointing away from the surface on the far side; the mirror
    /// direction where the reflection is total.
    pub direction: V,
    /// Where no light is transmitted (Snell's law has no solution).
    pub total_internal_reflection: M,
}

/// The refracted direction by Snell's law, sinθ₂/sinθ₁ = n₁/n₂.
///
/// `w` is a unit vector that points away from the surface, `normal` the unit normal. `eta_above` and
/// `eta_below`, both positive, are the indices on the side that the normal points to and on the
/// other; `w` may lie on either side.
/// T = (n₁₂ N·L − √(1 − n₁₂²(1 − (N·L)²))) N − n₁₂ L with N on the side of L and n₁₂ = n₁/n₂. Equal
/// indices let light pass straight through.
///
/// ```
/// use brdf::refract;
/// use glam::DVec3;
///
/// let w = DVec3::new(0.5, 0.0, 0.75_f64.sqrt()); // 30°
/// let into_glass = refract(w, DVec3::Z, 1.0, 1.5);
/// assert!(into_glass.direction.abs_diff_eq(DVec3::new(-1.0 / 3.0, 0.0, -0.942809041582), 1e-12));
/// let grazing = DVec3::new(0.9, 0.0, 0.19_f64.sqrt());
/// assert!(refract(grazing, DVec3::Z, 1.5, 1.0).total_internal_reflection);
/// ```
#[inline(always)]
#[must_use]
pub fn refract<T: Real, V: Vector<T>>(
    w: V,
    normal: V,
    eta_above: T,
    eta_below: T,
) -> Refraction<V, T::Mask> {
    let cos = Vector::dot(w, normal);
    let from_below = cos.lt(T::zero());
    let n12 = T::select(from_below, eta_below / eta_above, eta_above / eta_below);
    let facing = normal * T::select(from_below, T::lit(-1.0), T::one());
    // sin² from the vector product: 1 − cos² has no digits left near the normal.
    let sin_squared = Vector::length_squared(Vector::cross(w, normal));
    let (cos_t, total) = refracted_cosine(cos, sin_squared, n12);
    let transmitted = facing * (n12 * cos.abs() - cos_t) - w * n12;
    Refraction {
        direction: V::select(total, reflect(w, normal), transmitted),
        total_internal_reflection: total,
    }
}

/// cosθ₂ by Snell's law from cosθ₁, sin²θ₁ and n₁/n₂, and where the reflection is total.
///
/// cos²θ₂ = 1 − n₁₂² sin²θ₁ as a change of cos²θ₁: nothing changes where the index does not.
#[inline(always)]
pub(crate) fn refracted_cosine<T: Real>(cos: T, sin_squared: T, n12: T) -> (T, T::Mask) {
    let one = T::one();
    let squared = cos.squared() + (one - n12) * (one + n12) * sin_squared;
    // A root has no derivative at 0.
    (squared.max(T::lit(1e-37)).sqrt(), squared.lt(T::zero()))
}

/// The angle of incidence in radians from which on all light is reflected, sinθ = n₂/n₁; π/2
/// where every angle transmits (n₂ ≥ n₁). Both indices are positive.
///
/// ```
/// assert!((brdf::critical_angle(1.5, 1.0) - 0.7297276562_f64).abs() < 1e-10);
/// ```
#[inline(always)]
#[must_use]
pub fn critical_angle<T: Real>(n1: T, n2: T) -> T {
    (n2 / n1).asin()
}

/// Brewster's angle in radians, tanθ = n₂/n₁, where no light polarised in the plane of
/// incidence is reflected. Both indices are positive.
///
/// ```
/// assert!((brdf::brewster_angle(1.0, 1.5) - 0.9827937232_f64).abs() < 1e-10);
/// ```
#[inline(always)]
#[must_use]
pub fn brewster_angle<T: Real>(n1: T, n2: T) -> T {
    n2.atan2(n1)
}

/// The direction at polar angle `theta` from the normal and azimuth `phi` from the tangent, both
/// in radians.
///
/// ```
/// use glam::Vec3;
///
/// let w = brdf::from_spherical(0.5_f64, 0.25);
/// let (theta, phi) = brdf::to_spherical(w);
/// assert!((theta - 0.5).abs() < 1e-15 && (phi - 0.25).abs() < 1e-15);
///
/// let w: Vec3 = brdf::from_spherical(0.5, 0.25); // the vector tells that the angles are f32
/// assert!((w.z - 0.87758256).abs() < 1e-7);
/// ```
#[inline(always)]
#[must_use]
pub fn from_spherical<T: Real<Vec3 = V>, V: Vector<T>>(theta: T, phi: T) -> V {
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    Vector::new(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta)
}

/// Polar angle in [0, π] and azimuth in [−π, π] of a unit direction, in radians; precise also close
/// to the normal, down to 10⁻¹⁸ radians in `f32` and 10⁻¹⁵⁰ in `f64`. Azimuth 0 at the normal
/// itself, −π where y is −0 and x negative.
#[inline(always)]
#[must_use]
pub fn to_spherical<T: Real, V: Vector<T>>(w: V) -> (T, T) {
    let sin = (w.x() * w.x() + w.y() * w.y()).sqrt();
    (sin.atan2(w.z()), w.y().atan2(w.x()))
}
