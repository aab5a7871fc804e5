use super::amplitudes::{PolarizedFresnel, by_channel, channel};
use super::conductor::{Refraction, average};
use super::term::{Fresnel, incident_cosine};
use crate::parameter::model;
use crate::polarization::{Complex, Interface, Polarized};
use crate::real::{Color, Real};

model! {
    /// Gulbrandsen's metals for artists: Fresnel's equations of the index that a reflectance and a tint at the edge
    /// stand for.
    ///
    /// # Formula
    /// ```text
    /// n  = g (1 − r)/(1 + r) + (1 − g)(1 + √r)/(1 − √r)
    /// k² = (r (n + 1)² − (n − 1)²)/(1 − r) = (n_max − n)(n − 1/n_max)     n_max = (1 + √r)/(1 − √r)
    /// F as of a conductor of n + ik
    /// ```
    parameters {
        reflectivity: C, BELOW_ONE, "r", "reflectance at normal incidence";
        edge_tint: C, UNIT, "g", "0 is the index without absorption, 1 the smallest n";
    }
    constants {
        /// n.
        eta: C = reflectivity.zip(edge_tint, |r, g| index(r, g)[0]);
        /// k.
        k: C = reflectivity.zip(edge_tint, |r, g| index(r, g)[1]);
    }
    /// | u | `cos_theta` | cosine of the angle of incidence | −1 … 1, the sign is ignored |
    ///
    /// All factors of k² are formed without a difference: the printed form has none of its digits for
    /// small r. The index of r = 1 is infinite; r is at most 0.9999.
    ///
    /// # Energy
    /// Reciprocal. Conserving. The reflectance at normal incidence is r whatever the tint.
    ///
    /// # Derivatives
    /// By g at 0, where k goes like √g, and by r at 0: none, they are answered as 0.
    ///
    /// # Sources
    /// O. Gulbrandsen, *Artist Friendly Metallic Fresnel*, JCGT 3(4), 2014,
    /// <https://jcgt.org/published/0003/04/03/>.
    ///
    /// ```
    /// use brdf::{Fresnel, Gulbrandsen};
    ///
    /// let metal = Gulbrandsen::new(0.5_f64, 0.5)?;
    /// assert!((metal.eta() - 3.08088022903976).abs() < 1e-13);
    /// assert!((metal.k() - 2.82727048379713).abs() < 1e-13);
    /// assert!((metal.reflectance(1.0) - 0.5).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct Gulbrandsen<C = glam::Vec3>;

    /// A metal of the given reflectance at normal incidence and tint at the edge.
    pub fn new;
}

impl<C: Copy> Gulbrandsen<C> {
    /// n.
    #[must_use]
    pub fn eta(&self) -> C {
        self.eta
    }

    /// k.
    #[must_use]
    pub fn k(&self) -> C {
        self.k
    }
}

/// n and k. With s = √r both n_max − n and n − 1/n_max have the factor 2s:
///
/// ```text
/// n_max − n_min = 2s (1 + s)/((1 − s)(1 + r))     n_max − 1/n_max = 4s/(1 − r)
/// n_min − 1/n_max = 2s (1 − s)/((1 + s)(1 + r))   n_min = (1 − r)/(1 + r)
/// ```
fn index<T: Real>(r: T, g: T) -> [T; 2] {
    let (one, two) = (T::one(), T::lit(2.0));
    // A root has no derivative at 0.
    let s = r.max(T::lit(1e-36)).sqrt();
    let rest = one - s;
    let quotient = (one + s) / rest;
    let n = g * ((one - r) / (one + r)) + (one - g) * quotient;
    let below = g * quotient / (one + r);
    let above = (one - g) * two / (one - r) + g / (quotient * (one + r));
    let k = two * s * (below * above).max(T::lit(1e-36)).sqrt();
    [n, k]
}

impl<T: Real, C: Color<T>> Fresnel<T> for Gulbrandsen<C> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        let cos = incident_cosine(cos_theta);
        self.eta.zip(self.k, |eta, k| Refraction::new(eta, k, cos).unpolarized())
    }

    fn average(&self) -> C {
        self.eta.zip(self.k, average)
    }
}

impl<T: Real, C: Color<T>> PolarizedFresnel<T> for Gulbrandsen<C> {
    fn amplitudes(&self, cos_theta: T) -> Polarized<Complex<C>> {
        by_channel(|index| {
            let to = Complex::new(channel(self.eta, index), channel(self.k, index));
            Interface::between(Complex::real(T::one()), to).amplitudes(cos_theta).r
        })
    }
}
