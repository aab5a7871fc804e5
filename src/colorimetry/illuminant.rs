//! Standard light.

use super::tables::{A, COLOR_MATCHING, D65, WAVELENGTHS};

/// A light: the CIE's standard illuminants D65 and A, and equal energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Illuminant {
    /// Daylight at noon, 6504 K: the white of sRGB.
    D65,
    /// A tungsten lamp, 2856 K.
    A,
    /// Equal power at all wavelengths: the CIE's equal-energy spectrum, which is no standard
    /// illuminant.
    E,
}

impl Illuminant {
    /// Relative power at the [`WAVELENGTHS`], 100 at 560 nm.
    #[must_use]
    pub const fn power(self) -> [f64; WAVELENGTHS.len()] {
        match self {
            Self::D65 => D65,
            Self::A => A,
            Self::E => [100.0; WAVELENGTHS.len()],
        }
    }

    /// XYZ of the perfect reflector under this light, with Y = 1.
    ///
    /// ```
    /// use brdf::Illuminant;
    ///
    /// let [x, y, z] = Illuminant::A.white();
    /// assert!((x - 1.0985).abs() < 1e-4 && y == 1.0 && (z - 0.3558).abs() < 1e-4);
    /// ```
    #[must_use]
    pub fn white(self) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (power, matching) in self.power().into_iter().zip(COLOR_MATCHING) {
            for (sum, matching) in sum.iter_mut().zip(matching) {
                *sum += power * matching;
            }
        }
        sum.map(|value| value / sum[1])
    }
}
