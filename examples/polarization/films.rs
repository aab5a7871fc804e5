//! Colours of films and of gold: thickness of the film, or azimuth of the light, to the right; angle of
//! incidence downwards.

use std::error::Error;
use std::path::Path;

use brdf::colorimetry::{WAVELENGTHS, clamp_to_srgb};
use brdf::description::FresnelDescription;
use brdf::fresnel::conductor_polarized;
use brdf::materials::GOLD;
use brdf::{Color, Fresnel, Illuminant, Observer, Spectrum};
use image::{Rgb, RgbImage};

use crate::{lettering, screen};

/// How many wavelengths.
const LINES: usize = WAVELENGTHS.len();

/// A map of colours over two axes.
pub struct Map {
    pub name: &'static str,
    pub title: &'static str,
    /// What says the exposure, and where the indices are from.
    pub caption: &'static str,
    surface: Surface,
    /// The axis to the right, from 0 in steps that are labelled.
    axis: &'static str,
    end: f64,
    step: f64,
    /// What colours are multiplied with, for dark films.
    exposure: f64,
}

/// What reflects.
enum Surface {
    /// The material of a film, and what lies behind it; natural light.
    Film(&'static str, &'static str),
    /// Gold in linear light.
    Gold,
}

const THICKNESS: &str = "thickness of the film / nm";

/// Soap in air, an oxide on its metal, and gold through a polariser.
pub const MAPS: [Map; 3] = [
    Map {
        name: "soap",
        title: "Soap film: water in air, exposure × 4",
        caption: "The reflectance of a film of water in air, four times as bright as it is, by the thickness \
                  and the angle of incidence: coherent films with the index of water at 81 wavelengths, \
                  seen by the standard observer under daylight, D65.",
        surface: Surface::Film("water_daimon", "1"),
        axis: THICKNESS,
        end: 1200.0,
        step: 200.0,
        exposure: 4.0,
    },
    Map {
        name: "oxide",
        title: "Titanium dioxide on titanium",
        caption: "The reflectance of an oxide on its metal, by the thickness of the oxide and the angle of \
                  incidence: coherent films with the measured indices of both at 81 wavelengths, seen by \
                  the standard observer under daylight, D65.",
        surface: Surface::Film("TiO2_film", r#"{"material": "Ti"}"#),
        axis: THICKNESS,
        end: 300.0,
        step: 50.0,
        exposure: 1.0,
    },
    Map {
        name: "gold-polarised",
        title: "Gold through a polariser, from s to p",
        caption: "The reflectance of gold in linear light, by the azimuth of the polariser from s (0°) to p \
                  (90°) and the angle of incidence: R_s cos² + R_p sin² with the indices of Johnson and \
                  Christy at 81 wavelengths, seen by the standard observer under daylight, D65. In p gold \
                  is redder and darker, most at about 65°.",
        surface: Surface::Gold,
        axis: "azimuth of the polariser / °",
        end: 90.0,
        step: 15.0,
        exposure: 0.95,
    },
];

/// All lengths are in pixels, of a map of the whole size.
const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 270.0;
const LEFT: f64 = 74.0;
const RIGHT: f64 = 30.0;
const TOP: f64 = 40.0;
const BOTTOM: f64 = 62.0;
const LETTERS: f64 = 18.0;
const STEEPEST: f64 = 90.0;
const INK: [u8; 3] = [34; 3];

/// The reflectance at every wavelength over the cosine of the angle of incidence.
type Reflectance = Box<dyn Fn(f64) -> Spectrum<f64, LINES>>;

impl Surface {
    /// Of a film of a thickness, or in light of an azimuth.
    fn at(&self, across: f64) -> Result<Reflectance, Box<dyn Error>> {
        match self {
            Self::Film(film, substrate) => {
                let described: FresnelDescription = serde_json::from_str(&format!(
                    r#"{{"stack": {{"layers": [{{"index": {{"material": "{film}"}},
                                                 "thickness": {across}}}],
                                   "substrate": {substrate}}}}}"#
                ))?;
                let stack = described.build_spectrum::<f64, LINES>(&WAVELENGTHS)?;
                Ok(Box::new(move |cos| stack.reflectance(cos)))
            }
            Self::Gold => {
                let gold = GOLD.refractive_index(Spectrum(WAVELENGTHS))?;
                let (sin, cos) = across.to_radians().sin_cos();
                Ok(Box::new(move |angle| {
                    gold.eta.zip(gold.k, |eta, k| {
                        let reflected = conductor_polarized(eta, k, angle);
                        reflected.s * cos * cos + reflected.p * sin * sin
                    })
                }))
            }
        }
    }
}

impl Map {
    /// Exact per wavelength, then seen under daylight; `scale` is 1 for the whole size.
    pub fn draw(&self, folder: &Path, scale: f64) -> Result<(), Box<dyn Error>> {
        let observer = Observer::<f64, LINES>::new(Illuminant::D65, WAVELENGTHS)?;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few pixels")]
        let px = |length: f64| (length * scale).round() as u32;
        let (width, height, left, top) = (px(WIDTH), px(HEIGHT), px(LEFT), px(TOP));
        let size = (left + width + px(RIGHT), top + height + px(BOTTOM));
        let mut image = RgbImage::from_pixel(size.0, size.1, Rgb([255; 3]));
        for column in 0..width {
            let across = self.end * (f64::from(column) + 0.5) / f64::from(width);
            let reflectance = self.surface.at(across)?;
            for row in 0..height {
                let angle = STEEPEST * (f64::from(row) + 0.5) / f64::from(height);
                let seen = observer.linear_srgb(reflectance(angle.to_radians().cos()));
                let shown = screen::encode(clamp_to_srgb(seen * self.exposure).as_vec3());
                image.put_pixel(left + column, top + row, Rgb(screen::bytes(shown)));
            }
        }
        self.label(&mut image, scale)?;
        Ok(image.save(folder.join(format!("{}.png", self.name)))?)
    }

    fn label(&self, image: &mut RgbImage, scale: f64) -> Result<(), Box<dyn Error>> {
        let mut write = |text: &str, x: f64, y: f64| {
            #[allow(clippy::cast_possible_truncation, reason = "pixels")]
            let [x, y, size] = [x, y, LETTERS].map(|length| (length * scale) as f32);
            lettering::centered(image, text, [x, y], size, INK)
        };
        write(self.title, LEFT + 0.5 * WIDTH, 0.5 * TOP)?;
        let bottom = TOP + HEIGHT;
        let mut across = 0.0;
        while across <= self.end {
            let x = LEFT + WIDTH * across / self.end;
            write(&format!("{across:.0}"), x, bottom + 16.0)?;
            across += self.step;
        }
        write(self.axis, LEFT + 0.5 * WIDTH, bottom + 42.0)?;
        for degrees in [0.0, 30.0, 60.0, 90.0] {
            let y = TOP + HEIGHT * degrees / STEEPEST;
            write(&format!("{degrees:.0}°"), LEFT - 24.0, y)?;
        }
        write("angle", LEFT - 40.0, TOP + HEIGHT * 0.5)?;
        Ok(())
    }
}
