//! The eye that makes three numbers of a spectrum.

use core::array::from_fn;

use super::illuminant::Illuminant;
use super::matrix::{Matrix, apply, inverse, product};
use super::srgb::{FROM_XYZ, SRGB_WHITE, transform, xyz_to_linear_srgb};
use super::tables::{COLOR_MATCHING, WAVELENGTHS};
use crate::error::{ParameterError, Range};
use crate::real::{Real, Spectrum, Vector};

/// Bradford's cone responses: K. M. Lam 1985, in the form of CIECAM97s.
const BRADFORD: Matrix =
    [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]];

/// The CIE 1931 standard observer looking at a reflecting surface under an illuminant, for
/// spectra of `N` given wavelengths.
///
/// A spectrum is a straight line between its wavelengths and constant beyond them; the sum over
/// the [`WAVELENGTHS`] of the tables is exact for that. What the observer keeps is one weight
/// per wavelength for each of X, Y and Z, as in ASTM E308.
///
/// # The colour of a metal
/// Fresnel's equations hold per wavelength, and colour comes after them:
///
/// ```
/// # #[cfg(feature = "materials")] {
/// use brdf::materials::GOLD;
/// use brdf::{Fresnel, Illuminant, Observer, Spectrum};
/// use brdf::colorimetry::WAVELENGTHS;
/// use glam::DVec3;
///
/// let observer = Observer::new(Illuminant::D65, WAVELENGTHS)?;
/// let gold = GOLD.conductor(Spectrum(WAVELENGTHS))?;
/// let normal = observer.linear_srgb(gold.reflectance(1.0));
/// assert!(normal.abs_diff_eq(DVec3::new(1.037621, 0.728354, 0.364500), 1e-6));
///
/// // The shortcut: one index per channel, 650, 550 and 450 nm.
/// let shortcut = GOLD.conductor(DVec3::new(650.0, 550.0, 450.0))?.reflectance(1.0);
/// assert!((normal - shortcut).abs_diff_eq(DVec3::new(0.081, -0.063, -0.044), 1e-3));
/// # }
/// # Ok::<(), brdf::ParameterError>(())
/// ```
///
/// The sums are exact for the straight lines between the samples of a material, and no better than
/// these: there are 14 samples of gold in the visible range, 16 to 52 nm apart, and the error of
/// straight lines in its colour is about 0.005 (without every second of them it moves by up to
/// 0.015).
///
/// Gold reflects more red than sRGB can show: channels above 1 and below 0 are returned as they
/// are. [`clamp_to_srgb`](super::clamp_to_srgb) cuts them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observer<T, const N: usize> {
    /// X, Y and Z of each wavelength.
    weights: [[T; 3]; N],
    /// From XYZ to linear sRGB with the white of the illuminant as white.
    to_adapted_srgb: Matrix,
}

impl<T: Real, const N: usize> Observer<T, N> {
    /// An observer under an illuminant, of spectra with values at `wavelengths` in nanometres.
    ///
    /// # Errors
    /// If there is no wavelength, or one is not above the one before it or not in 100 … 10⁵.
    pub fn new(illuminant: Illuminant, wavelengths: [f64; N]) -> Result<Self, ParameterError> {
        Range::new(1.0, f64::INFINITY).check("number of wavelengths", N as f64)?;
        ParameterError::check_ascending("wavelength", Range::new(100.0, 1e5), &wavelengths)?;
        let mut weights = [[0.0; 3]; N];
        let powers = illuminant.power();
        let luminance: f64 = powers.iter().zip(COLOR_MATCHING).map(|(s, [_, y, _])| s * y).sum();
        for ((at, power), matching) in WAVELENGTHS.into_iter().zip(powers).zip(COLOR_MATCHING) {
            for (neighbour, share) in shares(&wavelengths, at) {
                for (weight, matching) in
                    weights.get_mut(neighbour).into_iter().flatten().zip(matching)
                {
                    *weight += share * (power * matching / luminance);
                }
            }
        }
        let adaptation = adaptation(illuminant.white(), SRGB_WHITE);
        Ok(Self {
            weights: weights.map(|weights| weights.map(T::lit)),
            to_adapted_srgb: product(&FROM_XYZ, &adaptation),
        })
    }

    /// XYZ of a reflectance, with Y = 1 for the perfect reflector.
    #[must_use]
    pub fn xyz(&self, reflectance: Spectrum<T, N>) -> T::Vec3 {
        let mut sum = [T::zero(); 3];
        for (weights, value) in self.weights.iter().zip(reflectance.0) {
            sum = from_fn(|axis| sum[axis] + weights[axis] * value);
        }
        let [x, y, z] = sum;
        Vector::new(x, y, z)
    }

    /// Linear sRGB of a reflectance as a camera with sRGB's white sees it: white paper is white
    /// under D65 (to 3·10⁻⁴, the rounding of the chromaticity of sRGB's white) and orange under A.
    #[must_use]
    pub fn linear_srgb(&self, reflectance: Spectrum<T, N>) -> T::Vec3 {
        xyz_to_linear_srgb(self.xyz(reflectance))
    }

    /// Linear sRGB of a reflectance as the eye sees it that has adapted to the light: white paper
    /// is white, (1, 1, 1), under every illuminant. By Bradford's linear transform of the white.
    #[must_use]
    pub fn adapted_linear_srgb(&self, reflectance: Spectrum<T, N>) -> T::Vec3 {
        transform(&self.to_adapted_srgb, self.xyz(reflectance))
    }
}

/// The part that each of the nearest wavelengths has in the value of a spectrum at `at`.
fn shares(wavelengths: &[f64], at: f64) -> [(usize, f64); 2] {
    let above = wavelengths.partition_point(|wavelength| *wavelength <= at);
    let below = above.saturating_sub(1);
    match (wavelengths.get(below), wavelengths.get(above)) {
        (Some(start), Some(end)) if above > below => {
            let part = (at - start) / (end - start);
            [(below, 1.0 - part), (above, part)]
        }
        // Beyond the ends the value is that of the end.
        _ => [(below, 1.0), (below, 0.0)],
    }
}

/// Moves one white to another in Bradford's cone responses.
fn adaptation(from: [f64; 3], to: [f64; 3]) -> Matrix {
    let (from, to) = (apply(&BRADFORD, from), apply(&BRADFORD, to));
    let scaled = from_fn(|cone| BRADFORD[cone].map(|weight| weight * to[cone] / from[cone]));
    product(&inverse(&BRADFORD), &scaled)
}
