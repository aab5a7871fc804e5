//! Fresnel terms that know more than a reflectance.

use super::conductor::Conductor;
use super::dielectric::Dielectric;
use super::term::Fresnel;
use crate::polarization::{Complex, Interface, Polarized};
use crate::real::{Color, Real};

/// A Fresnel term that knows what it does to the field of a wave: how it polarises light.
///
/// ```
/// use brdf::Conductor;
/// use brdf::fresnel::PolarizedFresnel;
///
/// // Gold at 659.5 nm turns the phases of s and p by different angles.
/// let r = Conductor::new(0.14, 3.697)?.amplitudes(1.2_f64.cos());
/// assert!((r.s.arg() + 2.952310248).abs() < 1e-9 && (r.p.arg() - 1.311129911).abs() < 1e-9);
/// # Ok::<(), brdf::ParameterError>(())
/// ```
pub trait PolarizedFresnel<T: Real = f32>: Fresnel<T> {
    /// r_s and r_p, the reflected electric field over the incident one, per channel; in the frames of
    /// [`polarization`](crate::polarization), where r_p = −r_s at normal incidence.
    fn amplitudes(&self, cos_theta: T) -> Polarized<Complex<Self::Color>>;
}

/// Amplitudes as colours, of what a formula answers for each channel.
#[inline(always)]
pub(super) fn by_channel<T: Real, C: Color<T>>(
    amplitudes: impl FnMut(usize) -> Polarized<Complex<T>>,
) -> Polarized<Complex<C>> {
    let all = C::by_channel(amplitudes);
    let color = |part: fn(&Polarized<Complex<T>>) -> T| {
        let channel = |channel: usize| all.as_ref().get(channel).map_or(T::zero(), part);
        C::from_channels(C::by_channel(channel))
    };
    Polarized {
        s: Complex::new(color(|r| r.s.re), color(|r| r.s.im)),
        p: Complex::new(color(|r| r.p.re), color(|r| r.p.im)),
    }
}

/// A channel of a colour.
#[inline(always)]
pub(super) fn channel<T: Real, C: Color<T>>(color: C, index: usize) -> T {
    color.channels().as_ref().get(index).copied().unwrap_or(T::zero())
}

impl<T: Real, C: Color<T>> PolarizedFresnel<T> for Dielectric<C> {
    fn amplitudes(&self, cos_theta: T) -> Polarized<Complex<C>> {
        by_channel(|index| {
            let (one, ior) = (T::one(), channel(self.ior(), index));
            let below = cos_theta.lt(T::zero());
            let (from, to) = (T::select(below, ior, one), T::select(below, one, ior));
            Interface::between(Complex::real(from), Complex::real(to)).amplitudes(cos_theta).r
        })
    }
}

impl<T: Real, C: Color<T>> PolarizedFresnel<T> for Conductor<C> {
    fn amplitudes(&self, cos_theta: T) -> Polarized<Complex<C>> {
        by_channel(|index| {
            let to = Complex::new(channel(self.eta(), index), channel(self.k(), index));
            Interface::between(Complex::real(T::one()), to).amplitudes(cos_theta).r
        })
    }
}
