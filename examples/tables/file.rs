//! The table as a file of bytes.
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
//! The reflected part of light from everywhere is f0 · scale + bias.

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
