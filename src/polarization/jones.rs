use core::ops::Mul;

use super::complex::Complex;
use super::mueller::Mueller;
use crate::real::Real;

/// What an optical element does to the field (E_s, E_p) of a wave: a Jones matrix.
///
/// The product of matrices runs from right to left: `b * a` is the light that meets `a` first.
///
/// # Sources
/// R. C. Jones, *A New Calculus for the Treatment of Optical Systems*, JOSA 31, 1941,
/// doi:10.1364/JOSA.31.000488.
///
/// ```
/// use brdf::polarization::Jones;
/// use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
///
/// // A quarter-wave plate makes circular light of linear light.
/// let circular = Jones::retarder(FRAC_PI_2, 0.0) * Jones::polarizer(FRAC_PI_4);
/// let light = circular.mueller() * brdf::polarization::Stokes::unpolarized(2.0);
/// assert!((light.v - 1.0).abs() < 1e-15 && light.q.abs() < 1e-15 && light.u.abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jones<T = f32> {
    /// The rows are outgoing s and p, the columns incoming s and p.
    pub rows: [[Complex<T>; 2]; 2],
}

impl<T: Real> Jones<T> {
    /// The matrix that multiplies s and p with a number each.
    #[inline(always)]
    #[must_use]
    pub fn diagonal(s: Complex<T>, p: Complex<T>) -> Self {
        let zero = Complex::real(T::zero());
        Self { rows: [[s, zero], [zero, p]] }
    }

    /// A frame turned by an angle from s towards p around the direction of propagation; the light
    /// stays as it is.
    #[must_use]
    pub fn rotation(angle: T) -> Self {
        let (sin, cos) = angle.sin_cos();
        let [sin, cos] = [sin, cos].map(Complex::real);
        Self { rows: [[cos, sin], [-sin, cos]] }
    }

    /// An ideal polariser, which passes the field at an azimuth from s towards p.
    #[must_use]
    pub fn polarizer(azimuth: T) -> Self {
        let (sin, cos) = azimuth.sin_cos();
        let [ss, sp, pp] = [cos * cos, cos * sin, sin * sin].map(Complex::real);
        Self { rows: [[ss, sp], [sp, pp]] }
    }

    /// A retarder: diag(1, e^(iδ)) along the axis at an azimuth from s towards p and across it, for a
    /// retardance δ.
    #[must_use]
    pub fn retarder(retardance: T, azimuth: T) -> Self {
        let (sin, cos) = retardance.sin_cos();
        let delayed = Self::diagonal(Complex::real(T::one()), Complex::new(cos, sin));
        Self::rotation(-azimuth) * delayed * Self::rotation(azimuth)
    }

    /// The field that leaves of the field (E_s, E_p) that enters.
    #[inline(always)]
    #[must_use]
    pub fn apply(self, [s, p]: [Complex<T>; 2]) -> [Complex<T>; 2] {
        self.rows.map(|[from_s, from_p]| from_s * s + from_p * p)
    }

    /// What it does to light of any state, A (J ⊗ J*) A⁻¹.
    #[must_use]
    pub fn mueller(self) -> Mueller<T> {
        let half = T::lit(0.5);
        let [[a, b], [c, d]] = self.rows;
        let [aa, bb, cc, dd] = [a, b, c, d].map(|z| z.norm_squared() * half);
        let (ab, cd) = (a * b.conj(), c * d.conj());
        let (ac, bd) = (a * c.conj(), b * d.conj());
        let (ad, bc) = (a * d.conj(), b * c.conj());
        Mueller {
            rows: [
                [(aa + bb) + (cc + dd), (aa - bb) + (cc - dd), ab.re + cd.re, ab.im + cd.im],
                [(aa + bb) - (cc + dd), (aa - bb) - (cc - dd), ab.re - cd.re, ab.im - cd.im],
                [ac.re + bd.re, ac.re - bd.re, ad.re + bc.re, ad.im - bc.im],
                [-(ac.im + bd.im), bd.im - ac.im, -(ad.im + bc.im), ad.re - bc.re],
            ],
        }
    }
}

impl<T: Real> Mul for Jones<T> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let [[a, b], [c, d]] = other.rows;
        Self { rows: self.rows.map(|[s, p]| [s * a + p * c, s * b + p * d]) }
    }
}
