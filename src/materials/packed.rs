//! The samples of a built-in set, as short as they can be without loss.

use super::constants::{RefractiveIndex, Sample};

/// Ten bytes of a sample: wavelength in three, n in four, k in three.
///
/// A number is a little-endian word: its upper 4 bits are the number of decimal places, the others
/// are the decimal digits as an integer. Both that integer and the power of ten are exact in `f64`,
/// so that their quotient is the `f64` nearest to the decimal number of the source.
pub(super) type Packed = [u8; 10];

const POWERS_OF_TEN: [f64; 16] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

fn long([a, b, c, d]: [u8; 4]) -> f64 {
    f64::from(u32::from_le_bytes([a, b, c, d & 15])) / POWERS_OF_TEN[usize::from(d >> 4)]
}

fn short([a, b, c]: [u8; 3]) -> f64 {
    f64::from(u32::from_le_bytes([a, b, c & 15, 0])) / POWERS_OF_TEN[usize::from(c >> 4)]
}

pub(super) fn wavelength(&[a, b, c, ..]: &Packed) -> f64 {
    short([a, b, c])
}

pub(super) fn sample(bytes: &Packed) -> Sample {
    let &[_, _, _, e0, e1, e2, e3, k0, k1, k2] = bytes;
    let index = RefractiveIndex { eta: long([e0, e1, e2, e3]), k: short([k0, k1, k2]) };
    Sample { wavelength: wavelength(bytes), index }
}
