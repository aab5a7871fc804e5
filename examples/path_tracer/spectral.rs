//! Light and reflectance at sixteen wavelengths.

use brdf::{Color, Spectrum};

/// How many wavelengths a path carries.
pub const CHANNELS: usize = 16;

/// A value for each wavelength: a reflectance, or a radiance relative to daylight (D65) whose white
/// has the radiance 1. So what is 1 throughout is white.
pub type Spectral = Spectrum<f32, CHANNELS>;

/// The wavelengths in nanometres, from 400 to 700.
pub const WAVELENGTHS: [f64; CHANNELS] = {
    let mut wavelengths = [0.0; CHANNELS];
    let mut index = 0;
    while index < CHANNELS {
        wavelengths[index] = 400.0 + 20.0 * index as f64;
        index += 1;
    }
    wavelengths
};

pub const BLACK: Spectral = Spectrum([0.0; CHANNELS]);
pub const WHITE: Spectral = Spectrum([1.0; CHANNELS]);

/// The wavelengths as a colour of their own: what a material is asked for.
pub fn wavelengths() -> Spectral {
    Spectrum(WAVELENGTHS.map(|wavelength| wavelength as f32))
}

/// The largest channel.
pub fn largest(color: Spectral) -> f32 {
    color.fold(0.0, f32::max)
}

/// A pigment: its reflectance goes from `short` to `long` around one wavelength, within about
/// 60 nm.
pub fn pigment(short: f32, long: f32, around: f32) -> Spectral {
    wavelengths().map(|wavelength| {
        let part = 1.0 / (1.0 + ((around - wavelength) / 15.0).exp());
        short + (long - short) * part
    })
}

/// Light of the colour of a black body of a temperature in kelvin, relative to that of 6504 K, the
/// temperature of daylight, and 1 at 560 nm.
pub fn black_body(kelvin: f32) -> Spectral {
    let planck = |wavelength: f32, kelvin: f32| {
        // hc/k in nm·K; what does not depend on the temperature cancels.
        1.0 / (1.438_777e7 / (wavelength * kelvin)).exp_m1()
    };
    let relative = |wavelength| planck(wavelength, kelvin) / planck(wavelength, 6504.0);
    wavelengths().map(|wavelength| relative(wavelength) / relative(560.0))
}
