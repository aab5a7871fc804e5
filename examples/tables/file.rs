//! The table as a file of bytes and as a picture.
//!
//! All numbers are little endian.
//!
//! | bytes | content |
//! |---|---|
//! | 0…7 | `BRDFDFG1` |
//! | 8…11 | columns, `u32`: cosines of the viewer's angle, (column + ½)/columns |
//! | 12…15 | rows, `u32`: roughness α, (row + ½)/rows |
//! | 16… | row by row, two `f32` for each column: scale and bias |
//!
//! The reflected part of light from everywhere is f0 · scale + bias. The picture has the scale in
//! red and the bias in green; roughness grows downwards, the cosine to the right.

use std::path::Path;

use image::{ImageResult, Rgb, RgbImage};

use super::bake::ScaleAndBias;

pub const MAGIC: [u8; 8] = *b"BRDFDFG1";

/// A table as the bytes of its file. All rows are as long as the first.
#[allow(clippy::cast_possible_truncation, reason = "the file holds single precision")]
pub fn bytes(rows: &[Vec<ScaleAndBias>]) -> Vec<u8> {
    let columns = rows.first().map_or(0, Vec::len);
    let mut bytes = MAGIC.to_vec();
    bytes.extend((columns as u32).to_le_bytes());
    bytes.extend((rows.len() as u32).to_le_bytes());
    for cell in rows.iter().flatten() {
        bytes.extend((cell.scale as f32).to_le_bytes());
        bytes.extend((cell.bias as f32).to_le_bytes());
    }
    bytes
}

/// The table as a picture.
///
/// # Errors
/// If the file cannot be written.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "eight bits a channel")]
pub fn picture(rows: &[Vec<ScaleAndBias>], path: &Path) -> ImageResult<()> {
    let columns = rows.first().map_or(0, Vec::len);
    let byte = |value: f64| (value.clamp(0.0, 1.0) * 255.0).round() as u8;
    RgbImage::from_fn(columns as u32, rows.len() as u32, |column, row| {
        let cell = rows[row as usize][column as usize];
        Rgb([byte(cell.scale), byte(cell.bias), 0])
    })
    .save(path)
}
