//! Which shadowing a distribution has if nothing else is said.

use alloc::boxed::Box;
use alloc::sync::Arc;

use super::any_shadowing::AnyShadowing;
use super::smith::SmithCorrelated;
use super::v_cavity::VCavity;
use crate::distribution::{
    AnyDistribution, AnyMixture, Beckmann, Blinn, Distribution, Gaussian, Ggx, Mixture, Smith,
};
use crate::real::Real;

/// The shadowing that [`CookTorrance::new`](crate::CookTorrance::new) gives a distribution:
/// [`SmithCorrelated`] where Smith's term is known of the type, [`VCavity`] otherwise. An [`AnyMixture`]
/// may consist of anything; as an [`AnyDistribution`] it has the shadowing that its terms allow.
///
/// Whoever writes a distribution of their own says so in two lines; or they build the surface by
/// [`CookTorrance::from_parts`](crate::CookTorrance::from_parts), which needs no default.
///
/// ```
/// use brdf::{CookTorrance, DefaultShadowing, Distribution, Schlick, VCavity};
/// use glam::Vec3;
///
/// /// All facets equally likely: D = 1/π.
/// struct Hemisphere;
///
/// impl Distribution for Hemisphere {
///     fn density(&self, h: Vec3) -> f32 {
///         if h.z > 0.0 { std::f32::consts::FRAC_1_PI } else { 0.0 }
///     }
///     fn sample(&self, [u0, u1]: [f32; 2]) -> Vec3 {
///         brdf::from_spherical(u0.sqrt().asin(), std::f32::consts::TAU * u1)
///     }
/// }
///
/// impl DefaultShadowing for Hemisphere {
///     type Shadowing = VCavity;
/// }
///
/// let dull = CookTorrance::new(Hemisphere, Schlick::new(Vec3::splat(0.04))?);
/// # use brdf::Brdf;
/// # assert!((dull.eval(Vec3::Z, Vec3::Z).x - 0.01 / std::f32::consts::PI).abs() < 1e-8);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say which shadowing its facets have",
    note = "implement `brdf::DefaultShadowing` for it, or use `CookTorrance::from_parts`"
)]
pub trait DefaultShadowing {
    /// The shadowing.
    type Shadowing: Default;
}

macro_rules! usual {
    ($shadowing:ty: $([$($parameters:tt)*] $distribution:ty),+) => {
        $(impl<$($parameters)*> DefaultShadowing for $distribution {
            type Shadowing = $shadowing;
        })+
    };
}

usual!(SmithCorrelated: [T] Beckmann<T>, [T] Ggx<T>, [T: Real] dyn Smith<T>);
usual!(
    VCavity:
    [T] Gaussian<T>, [T] Blinn<T>, [T: Real] AnyMixture<T>, [T: Real] dyn Distribution<T>
);
usual!(AnyShadowing: [T: Real] AnyDistribution<T>);
usual!(D::Shadowing: [T, D: DefaultShadowing, const N: usize] Mixture<T, D, N>);
usual!(
    D::Shadowing:
    [D: DefaultShadowing + ?Sized] Arc<D>, [D: DefaultShadowing + ?Sized] Box<D>,
    [D: DefaultShadowing + ?Sized] &D
);
