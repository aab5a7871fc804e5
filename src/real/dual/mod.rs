//! Numbers with derivatives.

mod functions;
mod operators;

use super::traits::{Mask, Real, Vector};
use super::vector3::Vector3;

/// A number with its derivatives by `N` others: forward differentiation.
///
/// A formula that runs on duals answers its value and, beside it, how the value changes with each of
/// `N` numbers, exactly and in one go. The value has the bits that the formula gives over `T`. `T` is
/// any [`Real`]: `f64` for fits, `f32`, [`Lanes`](crate::Lanes), or a dual again for second
/// derivatives.
///
/// [`gradient`](crate::gradient()) is the short way: it makes the duals and takes them apart. By hand:
///
/// ```
/// use brdf::{Brdf, Conductor, CookTorrance, Dual, Ggx, Vector3};
/// use glam::DVec3;
///
/// // Gold at one wavelength, by the roughness: the first of one number to differentiate by.
/// let roughness = Dual::variable(0.3, 0);
/// let gold = CookTorrance::new(
///     Ggx::new(roughness)?,
///     Conductor::new(Dual::constant(0.143), Dual::constant(3.983))?,
/// );
/// let mirrored: Vector3<Dual<f64, 1>> = Dual::vector(DVec3::Z);
/// let f = gold.eval(mirrored, mirrored);
/// // The peak goes with the inverse square of the roughness.
/// assert!((f.derivatives[0] + 2.0 / 0.3 * f.value).abs() < 1e-13 * f.value);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
///
/// # Which derivative
/// Formulas of this crate are smooth where the model is. Elsewhere:
///
/// - At a kink, where [`min`](Real::min), [`max`](Real::max) or [`abs`](Real::abs) change sides, the
///   derivative is the mean of those of both sides, which is what a central difference tells: V-cavities
///   have one where both directions are equally steep, Oren and Nayar's model where they are at a
///   right angle in azimuth, Schlick's power in the samples of exponent 1.
/// - Where a root, an arc or a logarithm has an infinite slope, it counts as 0. The angle of the
///   viewer is such a root at the normal, where all that depends on it is even. Next to the critical
///   angle of a Fresnel term the slope is large, at it 0.
/// - A derivative too large for its number is infinite, or none where it meets another: that of a value
///   that grows like the inverse of a cosine, by the direction, is so at the very horizon (not yet at
///   cosines of 10⁻¹⁰ in `f32`, of 10⁻¹⁰⁰ in `f64`).
/// - A saturated value, one that would exceed the largest number, does not change.
/// - The result of an iteration has the derivatives of the equation that it solves
///   ([`as_solution_of`](Real::as_solution_of)), the albedo by samples those of the integral, not of
///   the moving samples.
/// - At an end of the range of a parameter the derivative is the one towards the inside, where the
///   formula has no other.
///
/// # Samples
/// The derivatives of a [`Sample`](crate::Sample) are those of a draw from fixed uniform numbers: how
/// its direction, weight and density move with the parameters and the viewer (reparametrisation).
/// Such a draw has no derivative
///
/// - for a viewer at the normal, by the direction of the viewer: the azimuth of the draw is
///   counted from that of the viewer, which the normal does not have;
/// - at the ends 0 and 1 of the uniform numbers, and by them there;
/// - where it jumps from one term of a sum or mixture to another, and where it falls to the horizon and
///   counts no more.
///
/// What is answered there is one of the sides, finite where the answer is.
///
/// # Cost
/// A few times that of the value alone: [the guide](crate::guide::numbers#what-derivatives-cost) has the
/// figures, by `cargo bench --bench gradients`. Several passes of four derivatives or less are better than
/// one of eight. Batches of duals run, but they are no faster than single calls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<T, const N: usize> {
    /// The number itself.
    pub value: T,
    /// Its derivatives.
    pub derivatives: [T; N],
}

impl<T: Real, const N: usize> Dual<T, N> {
    /// A number that does not change.
    #[inline(always)]
    #[must_use]
    pub fn constant(value: T) -> Self {
        Self { value, derivatives: [T::zero(); N] }
    }

    /// The number to differentiate by at one of the places 0 … N − 1; a constant beyond.
    #[inline(always)]
    #[must_use]
    pub fn variable(value: T, place: usize) -> Self {
        let mut variable = Self::constant(value);
        if let Some(own) = variable.derivatives.get_mut(place) {
            *own = T::one();
        }
        variable
    }

    /// A direction or colour that does not change.
    #[inline(always)]
    #[must_use]
    pub fn vector(constant: T::Vec3) -> Vector3<Self> {
        let (x, y, z) = (constant.x(), constant.y(), constant.z());
        Vector3 { x: Self::constant(x), y: Self::constant(y), z: Self::constant(z) }
    }

    /// A function of this number from its value and its slope there. Where it is flat, an infinite
    /// derivative of the number does not matter, and an infinite slope not where the number is still.
    #[inline(always)]
    fn chain(self, value: T, slope: T) -> Self {
        let (zero, largest) = (T::zero(), T::max_finite());
        let flat = slope.abs().le(zero);
        let slope = slope.clamp(-largest, largest);
        // Where a number with derivatives is 0, it still changes: the curvature at a flat place.
        let chained = |derivative: T| {
            let product = derivative * slope;
            if T::HAS_DERIVATIVES {
                let finite = derivative.abs().le(largest);
                return T::select(flat.and(finite.not()), zero, product);
            }
            T::select(flat, zero, product)
        };
        Self { value, derivatives: each(self.derivatives, chained) }
    }

    /// A function of two numbers from its value and its slopes along both.
    #[inline(always)]
    fn chain_two(self, other: Self, value: T, [slope, other_slope]: [T; 2]) -> Self {
        let (own, theirs) = (self.chain(value, slope), other.chain(value, other_slope));
        Self { value, derivatives: zip(own.derivatives, theirs.derivatives, |a, b| a + b) }
    }
}

// Plain loops, as for lanes.

/// A formula for each derivative.
#[inline(always)]
fn each<T: Copy, const N: usize>(derivatives: [T; N], formula: impl Fn(T) -> T) -> [T; N] {
    let mut out = derivatives;
    for derivative in &mut out {
        *derivative = formula(*derivative);
    }
    out
}

/// A formula for each pair of derivatives.
#[inline(always)]
fn zip<T: Copy, const N: usize>(
    first: [T; N],
    second: [T; N],
    formula: impl Fn(T, T) -> T,
) -> [T; N] {
    let mut out = first;
    for (out, second) in out.iter_mut().zip(second) {
        *out = formula(*out, second);
    }
    out
}
