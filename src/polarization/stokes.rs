use super::complex::Complex;
use crate::real::Real;

/// Light of any state of polarisation, by its Stokes parameters.
///
/// ```text
/// I = |E_s|² + |E_p|²    Q = |E_s|² − |E_p|²    U = 2 Re(E_s E_p*)    V = 2 Im(E_s* E_p)
/// ```
///
/// as means over time. V > 0 is positive helicity: E = (1, i)/√2 in the frame (ŝ, p̂), e^(−iωt).
///
/// ```
/// use brdf::polarization::{Complex, Jones, Stokes};
///
/// let circular = Stokes::of_field([Complex::real(0.5_f64.sqrt()), Complex::new(0.0, 0.5_f64.sqrt())]);
/// assert!((circular.v - 1.0).abs() < 1e-15 && circular.q == 0.0);
/// let behind = Jones::polarizer(0.3_f64).mueller() * Stokes::unpolarized(2.0);
/// assert!((behind.i - 1.0).abs() < 1e-15);
/// assert!((behind.degree_of_polarization() - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stokes<T = f32> {
    /// Power.
    pub i: T,
    /// Power polarised along s minus that along p.
    pub q: T,
    /// Power polarised halfway from s to p minus that across.
    pub u: T,
    /// Power of positive minus power of negative helicity.
    pub v: T,
}

impl<T: Real> Stokes<T> {
    /// Natural light of the given power.
    #[inline(always)]
    #[must_use]
    pub fn unpolarized(power: T) -> Self {
        let zero = T::zero();
        Self { i: power, q: zero, u: zero, v: zero }
    }

    /// Linearly polarised light of the given power, its field at an azimuth from s towards p.
    #[inline(always)]
    #[must_use]
    pub fn linear(power: T, azimuth: T) -> Self {
        let (sin, cos) = (azimuth + azimuth).sin_cos();
        Self { i: power, q: power * cos, u: power * sin, v: T::zero() }
    }

    /// The light of a Jones vector (E_s, E_p).
    #[inline(always)]
    #[must_use]
    pub fn of_field([s, p]: [Complex<T>; 2]) -> Self {
        let (along_s, along_p, mixed) = (s.norm_squared(), p.norm_squared(), s * p.conj());
        Self {
            i: along_s + along_p,
            q: along_s - along_p,
            u: mixed.re + mixed.re,
            v: -(mixed.im + mixed.im),
        }
    }

    /// The four parameters in their order.
    #[inline(always)]
    #[must_use]
    pub fn to_array(self) -> [T; 4] {
        [self.i, self.q, self.u, self.v]
    }

    /// √(Q² + U² + V²)/I: 0 of natural light, 1 of a wave that is known; 0 of darkness.
    #[must_use]
    pub fn degree_of_polarization(self) -> T {
        let lit = self.i.gt(T::zero());
        let scale = T::one() / T::select(lit, self.i, T::one());
        let parts = [self.q, self.u, self.v].map(|part| (part * scale).squared());
        let sum = parts[0] + parts[1] + parts[2];
        let polarized = sum.gt(T::zero());
        T::select(polarized, sum, T::one()).sqrt().only_where(polarized).only_where(lit)
    }
}

impl<T> From<[T; 4]> for Stokes<T> {
    fn from([i, q, u, v]: [T; 4]) -> Self {
        Self { i, q, u, v }
    }
}

macro_rules! glam_vector {
    ($number:ty, $vector:ty) => {
        impl From<Stokes<$number>> for $vector {
            fn from(light: Stokes<$number>) -> Self {
                Self::from_array(light.to_array())
            }
        }
        impl From<$vector> for Stokes<$number> {
            fn from(vector: $vector) -> Self {
                vector.to_array().into()
            }
        }
    };
}
glam_vector!(f32, glam::Vec4);
glam_vector!(f64, glam::DVec4);
