use super::amplitudes::Amplitudes;
use super::complex::Complex;
use super::medium::{Incidence, Medium, check_index};
use super::wave::Wave;
use crate::error::ParameterError;
use crate::real::Real;

/// A plane boundary of two media, each transparent or absorbing.
///
/// # Formula
/// ```text
/// q₁ = n₁ cosθ    q₂ = √(n₂² − n₁² sin²θ), Re q₂ + Im q₂ > 0
/// r_s = (q₁ − q₂)/(q₁ + q₂)    r_p = (n₂² q₁ − n₁² q₂)/(n₂² q₁ + n₁² q₂)    R = |r|²
/// t_s = 2q₁/(q₁ + q₂)          t_p = 2n₁n₂q₁/(n₂² q₁ + n₁² q₂)
/// T_s = |t_s|² Re q₂/Re q₁     T_p = |t_p|² Re(n₂* q₂/n₂)/Re(n₁* q₁/n₁)
/// ```
///
/// | symbol | parameter | meaning | range |
/// |---|---|---|---|
/// | n₁ | `from` | complex index of the medium that the light comes from | n 10⁻⁴ … 10⁴, k 0 … 10⁴ |
/// | n₂ | `to` | complex index of the other one | the same |
/// | cosθ | `cos_theta` | cosine of the angle of incidence in the first medium | 0 … 1 |
///
/// The time factor is e^(−iωt), so that k ≥ 0 absorbs; see [the module](super) for the frames. Beyond
/// the critical angle |r| = 1 and T = 0; arg r_s and arg r_p differ, which a Fresnel rhomb uses.
///
/// Towards grazing r → −1 and T → 0, however little the media differ. Between media that are the same
/// there is no boundary: r = 0 and t = T = 1 at every angle, also at grazing, where the limits n₂ → n₁
/// and cosθ → 0 do not commute.
///
/// # Energy
/// R + T = 1 where the first medium is transparent. In an absorbing one the incident and
/// the reflected wave interfere: R + T ≠ 1, and R may exceed 1 next to total reflection.
///
/// # Accuracy
/// r_s is formed of n₁² − n₂², r_p of r_s: media of nearly the same index lose no digits.
///
/// # Sources
/// A. Fresnel 1823. M. Born, E. Wolf, *Principles of Optics*, sections 1.5 and 14.2.
///
/// ```
/// use brdf::polarization::{Complex, Interface};
///
/// // From glass to air at 0.9 radians, beyond the critical angle.
/// let glass_to_air = Interface::new(Complex::real(1.5_f64), Complex::real(1.0))?;
/// let total = glass_to_air.amplitudes(0.9_f64.cos());
/// assert!((total.reflectance().s - 1.0).abs() < 1e-15 && total.transmittance.s == 0.0);
/// let retardance = (total.r.s * total.r.p.conj()).arg();
/// assert!((retardance - 0.789561961337).abs() < 1e-12);
///
/// // Where there is no boundary, light passes at grazing too.
/// let none = Interface::new(Complex::real(1.5_f64), Complex::real(1.5))?.amplitudes(0.0);
/// assert_eq!((none.reflectance().p, none.transmittance.p), (0.0, 1.0));
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interface<T = f32> {
    from: Complex<T>,
    to: Medium<T>,
}

impl<T: Real> Interface<T> {
    /// The boundary as seen from the first of two media.
    ///
    /// # Errors
    /// If a real part is not in 10⁻⁴ … 10⁴ or an imaginary part not in 0 … 10⁴.
    pub fn new(from: Complex<T>, to: Complex<T>) -> Result<Self, ParameterError> {
        check_index("from", from)?;
        check_index("to", to)?;
        Ok(Self::between(from, to))
    }

    /// The same for indices that are known to be in their ranges.
    #[inline(always)]
    pub(crate) fn between(from: Complex<T>, to: Complex<T>) -> Self {
        Self { from, to: Medium::new(from, from, to) }
    }

    /// The same boundary seen from the other side.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self::between(self.to.index, self.from)
    }

    /// All amplitudes at the given cosine of the angle of incidence, of which the sign is ignored.
    #[inline(always)]
    #[must_use]
    pub fn amplitudes(&self, cos_theta: T) -> Amplitudes<T> {
        let incidence = Incidence::new(self.from, cos_theta);
        let bottom = self.to.normal(&incidence);
        let front = self.from * incidence.cos;
        Wave::bare(&incidence, &self.to, bottom, self.from, front).amplitudes(
            &incidence,
            self.from,
            self.to.index,
            bottom,
        )
    }
}
