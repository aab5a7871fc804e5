//! The table as a picture with axes.

use std::error::Error;
use std::path::Path;

use image::{Rgb, RgbImage};

use super::bake::ScaleAndBias;
use super::lettering;

/// At least so many pixels for the table, and around it for the words.
const SIDE: u32 = 512;
const LEFT: u32 = 90;
const TOP: u32 = 54;
const RIGHT: u32 = 40;
const BOTTOM: u32 = 76;
const LETTERS: f32 = 19.0;
const INK: [u8; 3] = [34; 3];

/// Draws the table: scale in red, bias in green; the cosine grows to the right and the roughness
/// upwards, both from 0 to 1.
///
/// # Errors
/// If the file cannot be written.
pub fn draw(rows: &[Vec<ScaleAndBias>], path: &Path) -> Result<(), Box<dyn Error>> {
    let cells = u32::try_from(rows.len())?.max(1);
    let cell = SIDE.div_ceil(cells);
    let side = cell * cells;
    let mut picture = RgbImage::from_pixel(LEFT + side + RIGHT, TOP + side + BOTTOM, Rgb([255; 3]));
    let byte = |value: f64| (value.clamp(0.0, 1.0) * 255.0).round() as u8;
    for y in 0..side {
        for x in 0..side {
            let ScaleAndBias { scale, bias } = rows[(y / cell) as usize][(x / cell) as usize];
            let place = (LEFT + x, TOP + side - 1 - y);
            picture.put_pixel(place.0, place.1, Rgb([byte(scale), byte(bias), 0]));
        }
    }
    let (left, bottom) = (LEFT as f32, (TOP + side) as f32);
    let mut write =
        |text: &str, at: [f32; 2]| lettering::centered(&mut picture, text, at, LETTERS, INK);
    let middle = left + 0.5 * side as f32;
    write("GGX: red scale, green bias; albedo = F₀ · scale + bias", [middle, 26.0])?;
    for tick in 0..=5_u8 {
        let (value, along) = (f32::from(tick) / 5.0, side as f32 * f32::from(tick) / 5.0);
        write(&format!("{value:.1}"), [left + along, bottom + 22.0])?;
        write(&format!("{value:.1}"), [left - 28.0, bottom - along])?;
    }
    write("cosine of the viewer's angle", [middle, bottom + 54.0])?;
    write("α", [left - 66.0, bottom - 0.5 * side as f32])?;
    for tick in 0..=5_u32 {
        let along = side * tick / 5;
        for length in 1..=6 {
            picture.put_pixel(LEFT + along, TOP + side + length - 1, Rgb(INK));
            picture.put_pixel(LEFT - length, TOP + side - along, Rgb(INK));
        }
    }
    Ok(picture.save(path)?)
}
