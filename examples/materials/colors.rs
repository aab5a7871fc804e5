//! Colours for the screen.

use brdf::colorimetry::{COLOR_MATCHING, WAVELENGTHS, clamp_to_srgb, xyz_to_linear_srgb};
use brdf::materials::Material;
use brdf::{Fresnel, Illuminant, Observer, ParameterError, Spectrum};
use glam::DVec3;
use plotters::style::RGBColor;

/// Okabe and Ito's palette, which stays distinct for colour-blind readers.
pub const RED: RGBColor = RGBColor(213, 94, 0);
pub const GREEN: RGBColor = RGBColor(0, 158, 115);
pub const BLUE: RGBColor = RGBColor(0, 114, 178);
pub const ORANGE: RGBColor = RGBColor(230, 159, 0);
pub const PURPLE: RGBColor = RGBColor(204, 121, 167);
pub const INK: RGBColor = RGBColor(20, 20, 20);
pub const GREY: RGBColor = RGBColor(110, 110, 110);
pub const GRID: RGBColor = RGBColor(221, 221, 221);

/// Linear sRGB as a screen shows it; what it cannot show is clamped.
pub fn encode(linear: DVec3) -> RGBColor {
    let byte = |value: f64| {
        let encoded =
            if value <= 0.0031308 { 12.92 * value } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
        let byte = (255.0 * encoded).round() as u8;
        byte
    };
    let shown = clamp_to_srgb(linear);
    RGBColor(byte(shown.x), byte(shown.y), byte(shown.z))
}

/// The visible spectrum: a saturated colour around each wavelength, pale where the eye is blind.
pub fn rainbow() -> impl Iterator<Item = (f64, RGBColor)> {
    WAVELENGTHS.into_iter().zip(COLOR_MATCHING).map(|(wavelength, matching)| {
        let hue: DVec3 = clamp_to_srgb(xyz_to_linear_srgb(DVec3::from(matching)));
        let brightest = hue.max_element().max(1e-9);
        let strength = (brightest / 0.15).min(1.0);
        (wavelength, encode(DVec3::ONE.lerp(hue / brightest, strength)))
    })
}

/// The colour of a smooth surface at normal incidence in daylight, if all of it was measured.
pub fn surface(material: &Material) -> Result<Option<RGBColor>, ParameterError> {
    let observer = Observer::new(Illuminant::D65, WAVELENGTHS)?;
    let conductor = material.conductor(Spectrum(WAVELENGTHS)).ok();
    Ok(conductor.map(|metal| encode(observer.linear_srgb(metal.reflectance(1.0)))))
}
