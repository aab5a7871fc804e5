//! Words in a picture of pixels.

use std::error::Error;

use ab_glyph::{Font, FontRef, Glyph, PxScale, ScaleFont, point};
use epaint_default_fonts::UBUNTU_LIGHT;
use image::{Rgb, RgbImage};

/// Writes one line with its middle at a point of the picture, in letters of a height in pixels.
///
/// # Errors
/// If the font cannot be read.
pub fn centered(
    picture: &mut RgbImage,
    text: &str,
    [x, y]: [f32; 2],
    height: f32,
    color: [u8; 3],
) -> Result<(), Box<dyn Error>> {
    let font = FontRef::try_from_slice(UBUNTU_LIGHT)?.into_scaled(PxScale::from(height));
    let mut glyphs: Vec<Glyph> = Vec::new();
    let mut width = 0.0;
    for letter in text.chars() {
        let mut glyph = font.scaled_glyph(letter);
        if let Some(before) = glyphs.last() {
            width += font.kern(before.id, glyph.id);
        }
        glyph.position = point(width, 0.0);
        width += font.h_advance(glyph.id);
        glyphs.push(glyph);
    }
    let baseline = y + 0.5 * (font.ascent() + font.descent());
    for mut glyph in glyphs {
        glyph.position += point(x - 0.5 * width, baseline);
        if let Some(outline) = font.outline_glyph(glyph) {
            let corner = outline.px_bounds().min;
            outline.draw(|column, row, coverage| {
                let place = [corner.x + column as f32, corner.y + row as f32];
                blend(picture, place, color, coverage);
            });
        }
    }
    Ok(())
}

/// Mixes a colour into one pixel, if the picture has it.
fn blend(picture: &mut RgbImage, [x, y]: [f32; 2], color: [u8; 3], coverage: f32) {
    let inside = x >= 0.0 && y >= 0.0 && x < picture.width() as f32 && y < picture.height() as f32;
    if inside {
        let Rgb(pixel) = picture.get_pixel_mut(x as u32, y as u32);
        for (channel, new) in pixel.iter_mut().zip(color) {
            let old = f32::from(*channel);
            *channel = (old + (f32::from(new) - old) * coverage.clamp(0.0, 1.0)).round() as u8;
        }
    }
}
