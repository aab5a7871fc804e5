//! A colour of any fixed number of wavelengths.

use core::fmt::Debug;
use core::ops::{Add, Mul, Sub};

use super::traits::{Color, Real};

/// `N` wavelengths at once: a colour with a channel for each.
///
/// What depends on directions only, as the distribution of a microfacet surface, is computed once
/// for all of them, the rest per channel with the bits that one wavelength alone would give. Which
/// wavelengths the channels stand for is up to the caller.
///
/// ```
/// use brdf::{Beckmann, Brdf, Conductor, CookTorrance, Spectrum};
/// use glam::DVec3;
///
/// // Gold at 450.9, 548.6, 582.1 and 659.5 nm.
/// let eta = Spectrum([1.38, 0.43, 0.29, 0.14]);
/// let k = Spectrum([1.914, 2.455, 2.863, 3.697]);
/// let gold = CookTorrance::new(Beckmann::new(0.3)?, Conductor::new(eta, k)?);
/// let f: Spectrum<f64, 4> = gold.eval(DVec3::Z, DVec3::Z);
/// assert!((f.0[3] / f.0[0] - 0.962585 / 0.408220).abs() < 1e-5);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spectrum<T, const N: usize>(pub [T; N]);

macro_rules! channelwise {
    ($($operator:ident $method:ident)*) => {$(
        impl<T: Real, const N: usize> $operator for Spectrum<T, N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, T::$method)
            }
        }
    )*};
}
channelwise!(Add add Sub sub Mul mul);

impl<T: Real, const N: usize> Mul<T> for Spectrum<T, N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, scale: T) -> Self {
        self.map(|value| value * scale)
    }
}

impl<T: Real, const N: usize> Color<T> for Spectrum<T, N> {
    type Over<U: Real> = Spectrum<U, N>;
    type Channels<E: Debug + Send> = [E; N];

    #[inline(always)]
    fn by_channel<E: Debug + Send>(make: impl FnMut(usize) -> E) -> [E; N] {
        core::array::from_fn(make)
    }
    #[inline(always)]
    fn channels(self) -> [T; N] {
        self.0
    }
    #[inline(always)]
    fn from_channels(channels: [T; N]) -> Self {
        Self(channels)
    }
    #[inline(always)]
    #[allow(clippy::needless_range_loop, reason = "an iterator would be another function")]
    fn fill<const PLACES: usize, const M: usize>(
        channels: &mut [[T; PLACES]; N],
        numbers: &mut [[T; PLACES]; M],
        formula: impl Fn(usize) -> (Self, [T; M]),
    ) {
        for index in 0..PLACES {
            let (color, beside) = formula(index);
            for channel in 0..N {
                channels[channel][index] = color.0[channel];
            }
            for number in 0..M {
                numbers[number][index] = beside[number];
            }
        }
    }
    #[inline(always)]
    fn splat(value: T) -> Self {
        Self([value; N])
    }
    #[inline(always)]
    fn map(self, formula: impl Fn(T) -> T) -> Self {
        let mut out = self.0;
        for value in &mut out {
            *value = formula(*value);
        }
        Self(out)
    }
    #[inline(always)]
    fn zip(self, other: Self, formula: impl Fn(T, T) -> T) -> Self {
        let mut out = self.0;
        for (value, other) in out.iter_mut().zip(other.0) {
            *value = formula(*value, other);
        }
        Self(out)
    }
    #[inline(always)]
    fn lift<U: Real>(self, lift: impl Fn(T) -> U) -> Spectrum<U, N> {
        Spectrum(self.0.map(lift))
    }
    #[inline(always)]
    fn fold<A>(self, start: A, step: impl Fn(A, T) -> A) -> A {
        self.0.into_iter().fold(start, step)
    }
}
