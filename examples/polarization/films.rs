//! Colours of films: thickness to the right, angle of incidence downwards.

use std::error::Error;
use std::path::Path;

use brdf::colorimetry::WAVELENGTHS;
use brdf::polarization::{Complex, Layer};
use brdf::{Fresnel, Illuminant, Observer, Spectrum, Stack};
use image::{Rgb, RgbImage};
use plotters::style::RGBColor;

use super::colors::encode;

const LINES: usize = WAVELENGTHS.len();
const WIDTH: u32 = 600;
const HEIGHT: u32 = 180;

/// A film on a substrate, and how thick it may be.
pub struct Map {
    name: &'static str,
    film: f64,
    substrate: [f64; 2],
    thickest: f64,
    /// What colours are multiplied with, for dark films.
    exposure: f64,
}

pub fn all() -> [Map; 2] {
    [
        Map { name: "soap", film: 1.33, substrate: [1.0, 0.0], thickest: 1200.0, exposure: 4.0 },
        Map { name: "oxide", film: 2.4, substrate: [2.6, 3.4], thickest: 300.0, exposure: 1.0 },
    ]
}

impl Map {
    /// Exact per wavelength, then seen under daylight.
    pub fn draw(&self, folder: &Path) -> Result<(), Box<dyn Error>> {
        let observer = Observer::<f64, LINES>::new(Illuminant::D65, WAVELENGTHS)?;
        let gray = |n: f64, k: f64| Complex::new(Spectrum([n; LINES]), Spectrum([k; LINES]));
        let [n, k] = self.substrate;
        let mut image = RgbImage::new(WIDTH, HEIGHT);
        for column in 0..WIDTH {
            let thickness = self.thickest * (f64::from(column) + 0.5) / f64::from(WIDTH);
            let film = Layer { index: gray(self.film, 0.0), thickness };
            let stack = Stack::new(gray(1.0, 0.0), &[film], gray(n, k), Spectrum(WAVELENGTHS))?;
            for row in 0..HEIGHT {
                let angle = 85.0 * (f64::from(row) + 0.5) / f64::from(HEIGHT);
                let seen = observer.linear_srgb(stack.reflectance(angle.to_radians().cos()));
                let RGBColor(red, green, blue) = encode(seen * self.exposure);
                image.put_pixel(column, row, Rgb([red, green, blue]));
            }
        }
        Ok(image.save(folder.join(format!("{}.png", self.name)))?)
    }
}
