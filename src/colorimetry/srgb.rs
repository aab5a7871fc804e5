//! XYZ and linear sRGB.

use super::matrix::{Matrix, apply, inverse};
use crate::real::{Color, Real, Vector};

/// Chromaticities x, y of red, green and blue: IEC 61966-2-1, Rec. ITU-R BT.709.
const PRIMARIES: [[f64; 2]; 3] = [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]];

/// Chromaticity of the white of sRGB, D65.
const WHITE: [f64; 2] = [0.3127, 0.3290];

/// XYZ with Y = 1 of a chromaticity.
const fn xyz([x, y]: [f64; 2]) -> [f64; 3] {
    [x / y, 1.0, (1.0 - x - y) / y]
}

/// XYZ of the white of sRGB.
pub(super) const SRGB_WHITE: [f64; 3] = xyz(WHITE);

/// The columns are the primaries, as bright as makes their sum the white.
const TO_XYZ: Matrix = {
    let [red, green, blue] = [xyz(PRIMARIES[0]), xyz(PRIMARIES[1]), xyz(PRIMARIES[2])];
    let columns =
        [[red[0], green[0], blue[0]], [red[1], green[1], blue[1]], [red[2], green[2], blue[2]]];
    let [r, g, b] = apply(&inverse(&columns), SRGB_WHITE);
    [
        [r * red[0], g * green[0], b * blue[0]],
        [r * red[1], g * green[1], b * blue[1]],
        [r * red[2], g * green[2], b * blue[2]],
    ]
};

/// From XYZ to linear sRGB.
pub(super) const FROM_XYZ: Matrix = inverse(&TO_XYZ);

/// The product of a matrix and a colour.
pub(super) fn transform<T: Real, V: Vector<T>>(matrix: &Matrix, color: V) -> V {
    let [x, y, z] = matrix
        .map(|[x, y, z]| T::lit(x) * color.x() + T::lit(y) * color.y() + T::lit(z) * color.z());
    Vector::new(x, y, z)
}

/// Linear sRGB of a colour in XYZ. Colours outside the gamut have channels below 0 or above 1,
/// which are kept.
///
/// ```
/// use brdf::colorimetry::xyz_to_linear_srgb;
/// use glam::DVec3;
///
/// let white = xyz_to_linear_srgb(DVec3::new(0.950456, 1.0, 1.089058));
/// assert!(white.abs_diff_eq(DVec3::ONE, 1e-6));
/// ```
#[must_use]
pub fn xyz_to_linear_srgb<T: Real, V: Vector<T>>(xyz: V) -> V {
    transform(&FROM_XYZ, xyz)
}

/// XYZ of a colour in linear sRGB.
///
/// ```
/// use brdf::colorimetry::linear_srgb_to_xyz;
/// use glam::DVec3;
///
/// let red = linear_srgb_to_xyz(DVec3::X);
/// assert!(red.abs_diff_eq(DVec3::new(0.412391, 0.212639, 0.019331), 1e-6));
/// ```
#[must_use]
pub fn linear_srgb_to_xyz<T: Real, V: Vector<T>>(rgb: V) -> V {
    transform(&TO_XYZ, rgb)
}

/// Moves each channel of a colour that sRGB cannot show into 0 … 1. This changes its hue.
///
/// ```
/// use brdf::colorimetry::clamp_to_srgb;
/// use glam::Vec3;
///
/// let gold = Vec3::new(1.038, 0.728, 0.364);
/// assert_eq!(clamp_to_srgb(gold), Vec3::new(1.0, 0.728, 0.364));
/// ```
#[must_use]
pub fn clamp_to_srgb<T: Real, C: Color<T>>(rgb: C) -> C {
    rgb.map(|channel| channel.clamp(T::zero(), T::one()))
}
