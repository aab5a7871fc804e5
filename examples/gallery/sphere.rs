//! Pictures of lit spheres.

use std::error::Error;

use brdf::{Brdf, Bsdf, Opaque};
use glam::{Vec2, Vec3};
use image::{Rgb, RgbImage};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use rayon::prelude::*;

use crate::light::Light;
use crate::ray::{Ray, radiance, through};
use crate::solid::Solid;
use crate::{lettering, screen};

/// A model of any kind.
pub type Material = Box<dyn Brdf<Color = Vec3>>;

/// What a square of a picture shows.
pub enum Tile {
    /// A sphere.
    Sphere(Material),
    /// A sphere of which a part of the light is reflected as by a mirror.
    Polished(Box<dyn Bsdf<Color = Vec3>>),
    /// A disc that was brushed in circles.
    Disc(Material),
    /// A sphere that light passes through.
    Solid(Box<dyn Solid>),
    /// The picture of a square minus that of another, both given by their places, so many times, on
    /// a middle grey.
    Difference {
        /// Of this square.
        of: usize,
        /// Minus this square.
        minus: usize,
        /// Times this.
        times: f32,
    },
}

/// Width of a sphere's square in pixels and rays per pixel.
#[derive(Clone, Copy, Debug)]
pub struct Quality {
    /// Pixels.
    pub tile: u32,
    /// Rays per pixel.
    pub rays: u16,
}

/// Radius of a sphere over half the width of its square.
const RADIUS: f32 = 0.88;
/// The background at the top and at the bottom, values of a screen.
const BACKGROUND: [f32; 2] = [0.35, 0.2];

/// The height of the letters over the width of a square.
const LETTERS: f32 = 0.064;
/// The height of a line of letters over that of the letters.
const LINE: f32 = 1.3;
const INK: [u8; 3] = [34; 3];

/// A row of squares with a label under each. Spheres have unit radius and are seen by a distant
/// camera (parallel rays); each is alone in its light: no shadow or reflection of another.
///
/// # Errors
/// If there are no letters for the labels.
pub fn render(
    tiles: &[(String, Tile)],
    light: Light,
    quality: Quality,
) -> Result<RgbImage, Box<dyn Error>> {
    let letters = LETTERS * quality.tile as f32;
    let lines = tiles.iter().map(|(label, _)| label.split('\n').count()).max().unwrap_or(0);
    let band = (letters * LINE * (lines as f32 + 0.5)).ceil() as u32;
    let (width, height) = (quality.tile * tiles.len() as u32, quality.tile + band);
    let mut picture = RgbImage::from_pixel(width, height, Rgb([255; 3]));
    let mut shown: Vec<Vec<Vec3>> = Vec::new();
    for (place, (label, tile)) in tiles.iter().enumerate() {
        let left = place as u32 * quality.tile;
        let reflecting = |material: &Material, shape| {
            let surface = Opaque::new(material);
            square(&|ray, u| radiance(&surface, light, ray, u), shape, light, quality)
        };
        let square = match tile {
            Tile::Sphere(material) => reflecting(material, Ray::at_sphere),
            Tile::Disc(material) => reflecting(material, Ray::at_disc),
            Tile::Polished(surface) => {
                let shade = |ray: &Ray, u| radiance(&**surface, light, ray, u);
                square(&shade, Ray::at_sphere, light, quality)
            }
            Tile::Solid(solid) => {
                let shade = |ray: &Ray, u| through(&**solid, light, ray, u);
                square(&shade, Ray::at_sphere, light, quality)
            }
            Tile::Difference { of, minus, times } => {
                let difference = |(of, minus): (&Vec3, &Vec3)| 0.5 + (*of - *minus) * *times;
                shown[*of].iter().zip(&shown[*minus]).map(difference).collect()
            }
        };
        for (index, value) in square.iter().enumerate() {
            let (x, y) = (index as u32 % quality.tile, index as u32 / quality.tile);
            picture.put_pixel(left + x, y, Rgb(screen::bytes(*value)));
        }
        shown.push(square);
        for (line, text) in label.split('\n').enumerate() {
            let middle = left as f32 + 0.5 * quality.tile as f32;
            let y = quality.tile as f32 + letters * LINE * (line as f32 + 0.75);
            lettering::centered(&mut picture, text, [middle, y], letters, INK)?;
        }
    }
    Ok(picture)
}

/// Radiance towards the camera along a ray, from five uniform numbers.
type Shade<'a> = &'a (dyn Fn(&Ray, [f32; 5]) -> Vec3 + Sync);

/// The ray at a place of the picture, in units of the radius, if there is something.
type Shape = fn(Vec2) -> Option<Ray>;

/// One square as a screen's values, 0 … 1. The pixels of all squares draw the same numbers, so that
/// differences are of the models and not of the noise.
fn square(shade: Shade<'_>, shape: Shape, light: Light, quality: Quality) -> Vec<Vec3> {
    let pixel = |index: u32| {
        let corner = Vec2::new((index % quality.tile) as f32, (index / quality.tile) as f32);
        let mut random = Pcg32::seed_from_u64(index.into());
        pixel_value((shade, shape), light, corner, quality, random.random())
    };
    (0..quality.tile * quality.tile).into_par_iter().map(pixel).collect()
}

/// A pixel as a screen's value. What is shown and background are averaged apart and joined after the tone
/// curve, so that bright edges are smooth.
fn pixel_value(
    (shade, shape): (Shade<'_>, Shape),
    light: Light,
    corner: Vec2,
    quality: Quality,
    offset: [f32; 6],
) -> Vec3 {
    let tile = quality.tile as f32;
    let (mut sum, mut hits) = (Vec3::ZERO, 0.0);
    for index in 0..quality.rays {
        // Even point sets, each in another order, so that they do not follow each other.
        let shuffled = |factor: u32| u32::from(index) * factor % u32::from(quality.rays);
        let [ax, ay] = point(shuffled(1), Vec2::new(offset[0], offset[1]));
        let [u0, u1] = point(shuffled(29), Vec2::new(offset[2], offset[3]));
        let [u2, u3] = point(shuffled(43), Vec2::new(offset[4], offset[5]));
        let [u4, _] = point(shuffled(13), Vec2::new(offset[5], offset[0]));
        let position = (corner + Vec2::new(ax, ay)) * (2.0 / tile) - 1.0;
        let position = Vec2::new(position.x, -position.y) / RADIUS;
        if let Some(ray) = shape(position) {
            sum += shade(&ray, [u0, u1, u2, u3, u4]);
            hits += 1.0;
        }
    }
    let [top, bottom] = BACKGROUND;
    let background = match light {
        Light::Furnace => Vec3::ONE,
        Light::Sun { .. } => Vec3::ZERO,
        _ => Vec3::splat(top + (bottom - top) * corner.y / tile),
    };
    if hits == 0.0 {
        return background;
    }
    let radiance = sum / hits;
    let shown = match light {
        Light::Furnace => screen::encode(furnace_tone(radiance)),
        _ => screen::value(radiance),
    };
    background.lerp(shown, hits / f32::from(quality.rays))
}

/// A point of the unit square: additive recurrence with powers of the root of x³ = x + 1
/// (M. Roberts, *The unreasonable effectiveness of quasirandom sequences*, 2018), shifted.
fn point(index: u32, offset: Vec2) -> [f32; 2] {
    const ROOT: f64 = 1.324717957244746;
    let turn = |shift: f32, step: f64| {
        let value = f64::from(shift) + step * f64::from(index);
        // Rounding to single precision may reach 1.
        ((value - value.floor()) as f32).min(1.0 - f32::EPSILON)
    };
    [turn(offset.x, 1.0 / ROOT), turn(offset.y, 1.0 / (ROOT * ROOT))]
}

/// In a furnace a radiance is shown as it is, and the redder the more it is above 1.
fn furnace_tone(radiance: Vec3) -> Vec3 {
    // The noise of a white surface is no energy.
    let excess = (radiance.max_element() - 1.01).max(0.0);
    let red = Vec3::new(1.0, 1.0 / (1.0 + excess), 1.0 / (1.0 + excess));
    radiance.min(Vec3::ONE) * red
}
