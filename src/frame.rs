//! The shading frame: world directions into local ones and back.

use crate::real::{Mask, Real, Vector};

/// A right-handed orthonormal frame at a surface point; the normal becomes +z.
///
/// ```
/// use brdf::Frame;
/// use glam::Vec3;
///
/// let frame = Frame::from_normal(Vec3::new(0.0, 0.6, 0.8));
/// let local = frame.to_local(Vec3::new(0.0, 0.6, 0.8));
/// assert!(local.abs_diff_eq(Vec3::Z, 1e-6));
/// assert!(frame.to_world(local).abs_diff_eq(Vec3::new(0.0, 0.6, 0.8), 1e-6));
/// ```
#[doc(alias("ONB", "TBN", "tangent space"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<V> {
    tangent: V,
    bitangent: V,
    normal: V,
}

impl<V> Frame<V> {
    /// The frame around a normal, with a tangent that varies smoothly but for the pole −z
    /// (Duff et al., *Building an Orthonormal Basis, Revisited*, JCGT 6(1), 2017).
    ///
    /// The normal may have any length. Without a direction (not finite, or no component above
    /// 10⁻³⁷) it counts as +z.
    #[must_use]
    pub fn from_normal<T: Real>(normal: V) -> Self
    where
        V: Vector<T>,
    {
        let one = T::one();
        let n = unit_or(normal, V::new(T::zero(), T::zero(), one));
        let sign = one.copysign(n.z());
        let a = -one / (sign + n.z());
        let b = n.x() * n.y() * a;
        Self {
            tangent: V::new(one + sign * n.x() * n.x() * a, sign * b, -(sign * n.x())),
            bitangent: V::new(b, sign + n.y() * n.y() * a, -n.y()),
            normal: n,
        }
    }

    /// The frame around a normal whose tangent is the given one, made perpendicular. Where the
    /// tangent has no direction, or none across the normal (less than 10⁻⁴ of its length), this is
    /// [`from_normal`](Self::from_normal).
    #[must_use]
    pub fn from_normal_and_tangent<T: Real>(normal: V, tangent: V) -> Self
    where
        V: Vector<T>,
    {
        let around = Self::from_normal(normal);
        let n = around.normal;
        let t = unit_or(tangent, n);
        let across = t - n * Vector::dot(t, n);
        // Below this length rounding, not the tangent, would decide the direction.
        let usable = Vector::length_squared(across).gt(T::lit(1e-8));
        let tangent = Vector::normalize_or_normal(V::select(usable, across, around.tangent));
        // What the difference of two near vectors lost, the second time takes nothing away.
        let tangent = Vector::normalize_or_normal(tangent - n * Vector::dot(tangent, n));
        Self { tangent, bitangent: Vector::cross(n, tangent), normal: n }
    }

    /// The unit tangent, local +x.
    #[must_use]
    pub const fn tangent(&self) -> V
    where
        V: Copy,
    {
        self.tangent
    }

    /// The unit bitangent, local +y.
    #[must_use]
    pub const fn bitangent(&self) -> V
    where
        V: Copy,
    {
        self.bitangent
    }

    /// The unit normal, local +z.
    #[must_use]
    pub const fn normal(&self) -> V
    where
        V: Copy,
    {
        self.normal
    }

    /// A world direction in the local frame.
    #[inline(always)]
    #[must_use]
    pub fn to_local<T: Real>(&self, world: V) -> V
    where
        V: Vector<T>,
    {
        V::new(
            Vector::dot(world, self.tangent),
            Vector::dot(world, self.bitangent),
            Vector::dot(world, self.normal),
        )
    }

    /// A local direction in the world.
    #[inline(always)]
    #[must_use]
    pub fn to_world<T: Real>(&self, local: V) -> V
    where
        V: Vector<T>,
    {
        self.tangent * local.x() + self.bitangent * local.y() + self.normal * local.z()
    }
}

/// The unit vector of the same direction, for vectors of any finite length; another one where there
/// is no direction.
fn unit_or<T: Real, V: Vector<T>>(v: V, otherwise: V) -> V {
    let largest = v.x().abs().max(v.y().abs()).max(v.z().abs());
    let usable = largest.gt(T::lit(1e-37)).and(largest.le(T::max_finite()));
    let scale = T::one() / T::select(usable, largest, T::one());
    let scaled = v * scale;
    // The largest of numbers and NaN may be a number; the sum of their squares is NaN.
    let usable = usable.and(Vector::length_squared(scaled).gt(T::lit(0.5)));
    Vector::normalize_or_normal(V::select(usable, scaled, otherwise))
}
