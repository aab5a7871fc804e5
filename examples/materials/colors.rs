//! Colours for the screen.

use brdf::colorimetry::{COLOR_MATCHING, WAVELENGTHS, clamp_to_srgb, xyz_to_linear_srgb};
use brdf::materials::Material;
use brdf::{Fresnel, Illuminant, Observer, ParameterError, Spectrum};
use glam::DVec3;
use plotters::style::RGBColor;

pub const RED: RGBColor = RGBColor(0xc4, 0x2b, 0x1f);
pub const GREEN: RGBColor = RGBColor(0x2a, 0x85, 0x3a);
pub const BLUE: RGBColor = RGBColor(0x1f, 0x5f, 0xb4);
pub const ORANGE: RGBColor = RGBColor(0xd0, 0x72, 0x0a);
pub const PURPLE: RGBColor = RGBColor(0x7b, 0x3f, 0xa0);
pub const GREY: RGBColor = RGBColor(0x60, 0x60, 0x60);

/// Linear sRGB as a screen shows it; what it cannot show is clamped.
fn encode(linear: DVec3) -> RGBColor {
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

/// The visible spectrum: a colour from each wavelength to the next.
pub fn rainbow() -> impl Iterator<Item = (f64, RGBColor)> {
    WAVELENGTHS.into_iter().zip(COLOR_MATCHING).map(|(wavelength, matching)| {
        (wavelength, encode(xyz_to_linear_srgb(0.6 * DVec3::from(matching))))
    })
}

/// The colour of a smooth surface at normal incidence in daylight, if all of it was measured.
pub fn surface(material: &Material) -> Result<Option<RGBColor>, ParameterError> {
    let observer = Observer::new(Illuminant::D65, WAVELENGTHS)?;
    let conductor = material.conductor(Spectrum(WAVELENGTHS)).ok();
    Ok(conductor.map(|metal| encode(observer.linear_srgb(metal.reflectance(1.0)))))
}
