use core::array::from_fn;
use core::ops::Mul;

use super::complex::Complex;
use super::stokes::Stokes;
use crate::real::{Color, Real};

/// What an optical element does to light of any state of polarisation: a Mueller matrix.
///
/// The elements are numbers, or colours with a matrix for each channel. The product of matrices
/// runs from right to left: `b * a` is the light that meets `a` first.
///
/// # Sources
/// W. A. Shurcliff, *Polarized Light*, Harvard University Press 1962. S. R. Cloude, *Conditions for
/// the physical realisability of matrix operators in polarimetry*, Proc. SPIE 1166, 1989,
/// doi:10.1117/12.962889.
///
/// ```
/// use brdf::polarization::{Complex, Interface, Mueller, Stokes};
///
/// // Light that glass reflects at Brewster's angle is polarised along s.
/// let glass = Interface::new(Complex::real(1.0_f64), Complex::real(1.5))?;
/// let cos_theta = brdf::brewster_angle(1.0_f64, 1.5).cos();
/// let mirror: Mueller<f64> = glass.amplitudes(cos_theta).mueller_reflection();
/// let light = mirror * Stokes::unpolarized(1.0);
/// assert!((light.degree_of_polarization() - 1.0).abs() < 1e-15);
/// assert!(mirror.realizability() > -1e-15);
///
/// // As a matrix of glam.
/// let vector = glam::DMat4::from(mirror) * glam::DVec4::X;
/// assert!((vector.y - light.q).abs() < 1e-17);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mueller<V = f32> {
    /// The rows make I, Q, U and V of the light that leaves.
    pub rows: [[V; 4]; 4],
}

impl<T: Real> Mueller<T> {
    /// A depolariser, which passes a part of the power as natural light.
    #[must_use]
    pub fn depolarizer(part: T) -> Self {
        let mut rows = [[T::zero(); 4]; 4];
        rows[0][0] = part;
        Self { rows }
    }

    /// A frame turned by an angle from s towards p around the direction of propagation; the light
    /// stays as it is.
    #[must_use]
    pub fn rotation(angle: T) -> Self {
        let (sin, cos) = (angle + angle).sin_cos();
        Self::rotation_of_twice(sin, cos)
    }

    /// The same from the sine and cosine of twice the angle.
    #[inline(always)]
    pub(crate) fn rotation_of_twice(sin: T, cos: T) -> Self {
        let (zero, one) = (T::zero(), T::one());
        Self {
            rows: [
                [one, zero, zero, zero],
                [zero, cos, sin, zero],
                [zero, -sin, cos, zero],
                [zero, zero, zero, one],
            ],
        }
    }

    /// How far a matrix is from making states of light that do not exist: below 0, by more than
    /// rounding, if some state of light that may be entangled with another would become one.
    ///
    /// The matrix is physically realisable, a sum of Jones matrices' ones, if Cloude's coherency
    /// matrix has no negative eigenvalue. That is so if the sums of the products of two, three and
    /// all four eigenvalues are not negative, those of eigenvalues that are divided by their sum
    /// M₀₀. The smallest of the three sums is the answer: 0 but for rounding where there is one
    /// Jones matrix. It implies M₀₀ ≥ √(M₀₁² + M₀₂² + M₀₃²). A matrix with M₀₀ ≤ 0 answers −1
    /// unless it is 0.
    #[must_use]
    pub fn realizability(&self) -> T {
        let (zero, one) = (T::zero(), T::one());
        let whole = self.rows[0][0];
        let largest = self.rows.iter().flatten().fold(zero, |most, m| most.max(m.abs()));
        let lit = whole.gt(zero);
        let scale = one / T::select(lit, whole, one);
        let coherency = self.coherency().map(|row| row.map(|element| element * scale));
        let square = product(&coherency, &coherency);
        let trace = |a: &Hermitian<T>, b: &Hermitian<T>| {
            let terms = a.iter().flatten().zip(b.iter().flatten());
            terms.fold(zero, |sum, (a, b)| sum + (*a * b.conj()).re)
        };
        // Newton's identities, from the traces of the powers.
        let (p2, p3, p4) =
            (trace(&coherency, &coherency), trace(&square, &coherency), trace(&square, &square));
        let e2 = (one - p2) * T::lit(0.5);
        let e3 = (e2 - p2 + p3) * T::lit(1.0 / 3.0);
        let e4 = (e3 - e2 * p2 + p3 - p4) * T::lit(0.25);
        let dark = T::select(largest.gt(zero), -one, zero);
        T::select(lit, e2.min(e3).min(e4), dark)
    }

    /// Cloude's coherency matrix, ½ of the one whose trace is 2 M₀₀.
    fn coherency(&self) -> Hermitian<T> {
        let m = &self.rows;
        let half = T::lit(0.5);
        // J_ij J_kl* = ½ Σ, from what the elements of E E† are made of: the column (j, l) of A⁻¹, the
        // row (i, k) of A⁻¹ again.
        from_fn(|row| {
            from_fn(|column| {
                let ((i, j), (k, l)) = ((row / 2, row % 2), (column / 2, column % 2));
                let (left, right) = (basis::<T>(i, k), basis::<T>(j, l));
                let mut sum = Complex::real(T::zero());
                for (left, row) in left.into_iter().zip(m) {
                    for (right, element) in right.into_iter().zip(row) {
                        sum = sum + left * right.conj() * *element;
                    }
                }
                sum * half * half
            })
        })
    }
}

/// A Hermitian matrix.
type Hermitian<T> = [[Complex<T>; 4]; 4];

/// The coefficients of I, Q, U and V in 2 E_a E_b*.
fn basis<T: Real>(a: usize, b: usize) -> [Complex<T>; 4] {
    let (zero, one) = (Complex::real(T::zero()), Complex::real(T::one()));
    let i = Complex::new(T::zero(), T::one());
    match (a, b) {
        (0, 0) => [one, one, zero, zero],
        (1, 1) => [one, -one, zero, zero],
        (0, _) => [zero, zero, one, -i],
        _ => [zero, zero, one, i],
    }
}

fn product<T: Real>(a: &Hermitian<T>, b: &Hermitian<T>) -> Hermitian<T> {
    from_fn(|row| {
        from_fn(|column| {
            (0..4).fold(Complex::real(T::zero()), |sum, k| sum + a[row][k] * b[k][column])
        })
    })
}

impl<T: Real> Mul for Mueller<T> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let b = &other.rows;
        let row = |a: [T; 4]| {
            from_fn(|k| (a[0] * b[0][k] + a[1] * b[1][k]) + (a[2] * b[2][k] + a[3] * b[3][k]))
        };
        Self { rows: self.rows.map(row) }
    }
}

impl<T: Real> Mul<Stokes<T>> for Mueller<T> {
    type Output = Stokes<T>;

    #[inline(always)]
    fn mul(self, light: Stokes<T>) -> Stokes<T> {
        let Stokes { i, q, u, v } = light;
        self.rows.map(|m| (m[0] * i + m[1] * q) + (m[2] * u + m[3] * v)).into()
    }
}

impl<V> Mueller<V> {
    /// The matrix of each channel.
    #[must_use]
    pub fn channels<T: Real>(&self) -> V::Channels<Mueller<T>>
    where
        V: Color<T>,
    {
        V::by_channel(|channel| Mueller {
            rows: self.rows.each_ref().map(|row| {
                row.each_ref().map(|color| {
                    color.channels().as_ref().get(channel).copied().unwrap_or(T::zero())
                })
            }),
        })
    }
}

macro_rules! glam_matrix {
    ($number:ty, $matrix:ty) => {
        impl From<Mueller<$number>> for $matrix {
            fn from(mueller: Mueller<$number>) -> Self {
                Self::from_cols_array_2d(&mueller.rows).transpose()
            }
        }
        impl From<$matrix> for Mueller<$number> {
            fn from(matrix: $matrix) -> Self {
                Self { rows: matrix.transpose().to_cols_array_2d() }
            }
        }
    };
}
glam_matrix!(f32, glam::Mat4);
glam_matrix!(f64, glam::DMat4);
