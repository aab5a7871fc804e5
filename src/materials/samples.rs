//! The samples of a set, as short as they can be without loss.

use super::material::{RefractiveIndex, Sample};

/// Samples in the order of their wavelengths, twelve bytes each: wavelength, n and k.
///
/// A number is a little-endian word: a decimal mantissa in the lower 28 bits, in the upper 4 the
/// number of decimal places. Mantissa and power of ten are exact in `f64`, so that their quotient
/// is the `f64` nearest to the decimal number of the source.
#[derive(Clone, Copy)]
pub(super) struct Samples(&'static [[u8; 12]]);

const MANTISSA_BITS: u32 = 28;

const POWERS_OF_TEN: [f64; 16] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

fn decimal(bytes: [u8; 4]) -> f64 {
    let word = u32::from_le_bytes(bytes);
    let mantissa = word & ((1 << MANTISSA_BITS) - 1);
    f64::from(mantissa) / POWERS_OF_TEN[(word >> MANTISSA_BITS) as usize]
}

fn wavelength(&[a, b, c, d, ..]: &[u8; 12]) -> f64 {
    decimal([a, b, c, d])
}

fn sample(bytes: &[u8; 12]) -> Sample {
    let &[.., e0, e1, e2, e3, k0, k1, k2, k3] = bytes;
    let (eta, k) = (decimal([e0, e1, e2, e3]), decimal([k0, k1, k2, k3]));
    Sample { wavelength: wavelength(bytes), index: RefractiveIndex { eta, k } }
}

impl Samples {
    pub(super) const fn new(bytes: &'static [u8]) -> Self {
        Self(bytes.as_chunks().0)
    }

    pub(super) fn iter(self) -> impl ExactSizeIterator<Item = Sample> + DoubleEndedIterator {
        self.0.iter().map(sample)
    }

    /// The first and the last wavelength.
    pub(super) fn range(self) -> (f64, f64) {
        match self.0 {
            [first, .., last] => (wavelength(first), wavelength(last)),
            _ => (f64::NAN, f64::NAN),
        }
    }

    /// The index at a wavelength in the range, on the line between its neighbours.
    pub(super) fn interpolate(self, at: f64) -> RefractiveIndex<f64> {
        // An end of the range rounded to single precision may lie just outside.
        let (first, last) = self.range();
        let at = at.max(first).min(last);
        // The last sample has no successor: it is the upper end of the last interval.
        let after = self.0.partition_point(|bytes| wavelength(bytes) <= at);
        let upper = after.min(self.0.len() - 1);
        let (below, above) = (sample(&self.0[upper - 1]), sample(&self.0[upper]));
        let part = (at - below.wavelength) / (above.wavelength - below.wavelength);
        let between = |below: f64, above: f64| below * (1.0 - part) + above * part;
        RefractiveIndex {
            eta: between(below.index.eta, above.index.eta),
            k: between(below.index.k, above.index.k),
        }
    }
}
