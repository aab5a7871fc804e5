//! The samples of a set, as short as they can be without loss.

/// A complex refractive index n + ik, or the indices of several wavelengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefractiveIndex<C = f64> {
    /// Real part n.
    pub eta: C,
    /// Imaginary part k, the extinction coefficient, zero or positive.
    pub k: C,
}

/// The index at one wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Wavelength in nanometres.
    pub wavelength: f64,
    /// Index there.
    pub index: RefractiveIndex,
}

/// Samples in the order of their wavelengths, ten bytes each: wavelength in three, n in four, k in
/// three.
///
/// A number is a little-endian word: its upper 4 bits are the number of decimal places, the others
/// are the decimal digits as an integer. Both that integer and the power of ten are exact in `f64`,
/// so that their quotient is the `f64` nearest to the decimal number of the source.
#[derive(Clone, Copy)]
pub(super) struct Samples(&'static [[u8; 10]]);

const POWERS_OF_TEN: [f64; 16] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

fn long([a, b, c, d]: [u8; 4]) -> f64 {
    f64::from(u32::from_le_bytes([a, b, c, d & 15])) / POWERS_OF_TEN[usize::from(d >> 4)]
}

fn short([a, b, c]: [u8; 3]) -> f64 {
    f64::from(u32::from_le_bytes([a, b, c & 15, 0])) / POWERS_OF_TEN[usize::from(c >> 4)]
}

fn wavelength(&[a, b, c, ..]: &[u8; 10]) -> f64 {
    short([a, b, c])
}

fn sample(bytes: &[u8; 10]) -> Sample {
    let &[_, _, _, e0, e1, e2, e3, k0, k1, k2] = bytes;
    let index = RefractiveIndex { eta: long([e0, e1, e2, e3]), k: short([k0, k1, k2]) };
    Sample { wavelength: wavelength(bytes), index }
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
