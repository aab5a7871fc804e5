//! From spectra in a camera to a picture on a screen.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use brdf::{Illuminant, Observer, ParameterError};
use glam::{Vec2, Vec3};
use image::codecs::jpeg::JpegEncoder;
use image::{Rgb, RgbImage};
use rayon::prelude::*;

use crate::draws::Draws;
use crate::screen;
use crate::shape::Ray;
use crate::spectral::{BLACK, Spectral, WAVELENGTHS};

/// A pinhole camera.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    pub position: Vec3,
    pub target: Vec3,
    /// Half the width of the picture over its distance.
    pub half_width: f32,
}

impl Camera {
    /// The ray through a place of the picture: x from −1 to 1, y in the same unit, upwards.
    fn ray(&self, place: Vec2) -> Ray {
        let forward = (self.target - self.position).normalize();
        let right = forward.cross(Vec3::Y).normalize();
        let across = (right * place.x + right.cross(forward) * place.y) * self.half_width;
        Ray { origin: self.position, direction: (forward + across).normalize() }
    }
}

/// Size of a picture in pixels, and paths through each pixel.
#[derive(Clone, Copy, Debug)]
pub struct Film {
    pub width: u32,
    pub height: u32,
    pub samples: u32,
}

impl Film {
    /// Linear sRGB of every pixel; `done` is called after each row.
    ///
    /// # Errors
    /// None: the wavelengths are in order.
    pub fn expose(
        &self,
        camera: &Camera,
        radiance: impl Fn(Ray, &mut Draws) -> Spectral + Sync,
        done: impl Fn() + Sync,
    ) -> Result<Vec<Vec<Vec3>>, ParameterError> {
        let observer = Observer::new(Illuminant::D65, WAVELENGTHS)?;
        let size = Vec2::new(self.width as f32, self.height as f32);
        let pixel = |column: u32, row: u32| {
            let mut sum = BLACK;
            for path in 0..self.samples {
                let mut draws = Draws::new(path, row * self.width + column);
                let [x, y, ..] = draws.four();
                let place = (Vec2::new(column as f32, row as f32) + Vec2::new(x, y)) * 2.0 - size;
                let ray = camera.ray(Vec2::new(place.x, -place.y) / size.x);
                sum = sum + radiance(ray, &mut draws);
            }
            observer.linear_srgb(sum * (self.samples as f32).recip())
        };
        let row = |row| {
            let pixels = (0..self.width).map(|column| pixel(column, row)).collect();
            done();
            pixels
        };
        Ok((0..self.height).into_par_iter().map(row).collect())
    }
}

/// Writes a picture in linear sRGB, as JPEG if the file is called so.
///
/// # Errors
/// If the file cannot be written, or its name does not say what it is.
pub fn save(rows: &[Vec<Vec3>], path: &Path) -> Result<(), Box<dyn Error>> {
    let width = rows.first().map_or(0, Vec::len);
    let picture = RgbImage::from_fn(width as u32, rows.len() as u32, |x, y| {
        Rgb(screen::bytes(screen::value(rows[y as usize][x as usize])))
    });
    if path.extension().is_some_and(|ending| ending == "jpg") {
        let file = BufWriter::new(File::create(path)?);
        return Ok(JpegEncoder::new_with_quality(file, 92).encode_image(&picture)?);
    }
    Ok(picture.save(path)?)
}
