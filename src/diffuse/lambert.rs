use core::f64::consts::FRAC_1_PI;

use crate::brdf::{Brdf, Sample};
use crate::direction::{above_surface, both_above};
use crate::error::{ParameterError, range};
use crate::real::{Color, Real, Vector, lift, unsigned};
use crate::sampling::cosine_hemisphere;

/// Lambert's ideal diffuse surface: equal radiance in all directions.
///
/// ```text
/// f = ρ/π
/// ```
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | ρ | `albedo` | fraction of the light that is reflected | 0 … 1 |
///
/// Reciprocal. Conserving: the directional albedo is ρ at every angle. Sampled with density
/// cosθ/π, so that every sample has weight ρ.
///
/// J. H. Lambert, *Photometria*, 1760.
///
/// ```
/// use brdf::{Brdf, Lambert};
/// use glam::DVec3;
///
/// let paper = Lambert::new(DVec3::new(0.8, 0.8, 0.7))?;
/// assert_eq!(paper.albedo(DVec3::Z).z, 0.7);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambert<C = glam::Vec3> {
    albedo: C,
}

impl<C> Lambert<C> {
    /// A diffuse surface of the given albedo.
    ///
    /// # Errors
    /// If a channel of `albedo` is not in 0 … 1.
    pub fn new<T: Real>(albedo: C) -> Result<Self, ParameterError>
    where
        C: Color<T>,
    {
        range::UNIT.check("albedo", albedo)?;
        Ok(Self { albedo: unsigned(albedo) })
    }
}

lift! {
    [T: Real, C: Color<T>] Lambert<C> => Lambert<C::Over<U>>:
    Lambert { albedo: color }
}

impl<T: Real, C: Color<T>> Brdf<T> for Lambert<C> {
    type Color = C;

    #[inline(always)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> C {
        let above = both_above::<T>(wi, wo);
        (self.albedo * T::lit(FRAC_1_PI)).only_where(above)
    }

    #[inline(always)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        let above = both_above::<T>(wi, wo);
        (wi.z() * T::lit(FRAC_1_PI)).only_where(above)
    }

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, C> {
        let wi = cosine_hemisphere(u);
        Sample { wi, weight: self.albedo, pdf: wi.z() * T::lit(FRAC_1_PI) }
            .only_where(both_above::<T>(wi, wo))
    }

    #[inline(always)]
    fn albedo(&self, wo: T::Vec3) -> C {
        C::choose(above_surface::<T, _>(wo), self.albedo, C::splat(T::zero()))
    }
}
