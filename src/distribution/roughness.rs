//! Roughness along the tangent and the bitangent, and what distributions of stretched slopes make
//! of it.

use core::f64::consts::{FRAC_1_PI, LOG2_E, PI};

use crate::error::{ParameterError, range};
use crate::real::{Real, Vector, lift};

/// Roughness along x and y with the quantities that formulas need, computed once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Roughness<T> {
    along: [T; 2],
    inverse: [T; 2],
    /// α²/π.
    squared_over_pi: [T; 2],
    /// log₂e/α².
    octaves: [T; 2],
    /// 1/(π α_x α_y), one over the area of the ellipse with these half axes.
    inverse_area: T,
}

lift! {
    [T: Real] Roughness<T> => Roughness<U>:
    Roughness { along: numbers, inverse: numbers, squared_over_pi: numbers, octaves: numbers, inverse_area: number }
}

impl<T: Copy> Roughness<T> {
    pub(super) fn along(&self) -> [T; 2] {
        self.along
    }
}

impl<T: Real> Roughness<T> {
    pub(super) fn isotropic(roughness: T) -> Result<Self, ParameterError> {
        range::ROUGHNESS.check("roughness", roughness)?;
        Ok(Self::of([roughness, roughness]))
    }

    pub(super) fn anisotropic(along_x: T, along_y: T) -> Result<Self, ParameterError> {
        range::ROUGHNESS.check("along_x", along_x)?;
        range::ROUGHNESS.check("along_y", along_y)?;
        Ok(Self::of([along_x, along_y]))
    }

    fn of(along: [T; 2]) -> Self {
        let one = T::one();
        let inverse = [one / along[0], one / along[1]];
        let octaves = along.map(|along| T::lit(LOG2_E) / along.squared());
        let squared_over_pi = along.map(|along| along.squared() * T::lit(FRAC_1_PI));
        Self {
            along,
            inverse,
            squared_over_pi,
            octaves,
            inverse_area: one / (T::lit(PI) * along[0] * along[1]),
        }
    }

    /// 1/(π α_x α_y): the density of slopes at slope 0.
    #[inline(always)]
    pub(super) fn inverse_area(&self) -> T {
        self.inverse_area
    }

    /// (h_x/α_x)² + (h_y/α_y)²: sin²θ_h over the squared roughness in the plane of `h`.
    #[inline(always)]
    pub(super) fn sin_over_alpha_squared(&self, h: T::Vec3) -> T {
        h.x().squared() * self.inverse[0].squared() + h.y().squared() * self.inverse[1].squared()
    }

    /// ((h_x/α_x)² + (h_y/α_y)²) log₂e of the squares of components, which a density needs for other
    /// things too.
    #[inline(always)]
    pub(super) fn octaves_of_squares(&self, [x, y]: [T; 2]) -> T {
        x * self.octaves[0] + y * self.octaves[1]
    }

    /// ((α_x w_x)² + (α_y w_y)²)/π of the squares of components.
    #[inline(always)]
    pub(super) fn grazing_squared_of_squares(&self, [x, y]: [T; 2]) -> T {
        x * self.squared_over_pi[0] + y * self.squared_over_pi[1]
    }

    /// (α_x w_x)² + (α_y w_y)²: sin²θ times the squared roughness in the plane of `w`.
    #[inline(always)]
    pub(super) fn alpha_sin_squared(&self, w: T::Vec3) -> T {
        w.x().squared() * self.along[0].squared() + w.y().squared() * self.along[1].squared()
    }

    /// A vector along the direction as it is seen after the surface has been stretched to roughness 1.
    #[inline(always)]
    pub(super) fn stretch_along(&self, w: T::Vec3) -> T::Vec3 {
        Vector::new(w.x() * self.along[0], w.y() * self.along[1], w.z())
    }

    /// A vector along the normal of this surface that (x, y, z) becomes when the surface of roughness
    /// 1 is pressed back to its own roughness.
    #[inline(always)]
    pub(super) fn unstretch_along(&self, x: T, y: T, z: T) -> T::Vec3 {
        Vector::new(x * self.along[0], y * self.along[1], z)
    }
}
