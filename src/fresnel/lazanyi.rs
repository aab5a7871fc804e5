use super::clamped::{average, unit};
use super::term::{Fresnel, incident_cosine};
use crate::parameter::model;
use crate::real::{Color, Real};

model! {
    /// Lazányi and Szirmay-Kalos' correction of Schlick's polynomial for metals, whose reflectance dips before
    /// it rises to the edge.
    ///
    /// # Formula
    /// ```text
    /// F = F₀ + (1 − F₀)(1 − u)⁵ − a u (1 − u)^α, held in 0 … 1
    /// average F₀ + (1 − F₀)/21 − 4a/((α + 1)(α + 2)(α + 3)) where nothing is held
    /// ```
    parameters {
        f0: C, UNIT, "F₀", "reflectance at normal incidence";
        a: C, DIP, "a", "depth of the dip";
        alpha: C, EDGE_EXPONENT, "α", "how close to the edge the dip is";
    }
    /// | u | `cos_theta` | cosine of the angle of incidence (V·H on microfacets) | −1 … 1, the sign is ignored |
    ///
    /// # Energy
    /// Reciprocal. Conserving: F ≤ 1. A dip too deep would make F negative: there it is 0. `average` is a
    /// quadrature there and loses digits: F₀ = 0.5, α = 0.1 with a = 10 is off by 4·10⁻⁴; with a = 1000 the
    /// average is 3·10⁻⁷ and the answer 0.04. No fit to a metal comes near that.
    ///
    /// # Accuracy
    /// With a fit of a and α the largest error is 0.0049 for aluminium at 550 nm (F₀ = 0.915678, a = 1.33,
    /// α = 5.7382; Schlick's alone: 0.0801), 0.0102 at 700 nm (0.895076, 2.5679, 6.7481), 0.0128 for an index of 2.95 + 2.93i
    /// (0.512143, 3.2752, 6.3216), 0.0010 for gold at 659.5 nm (0.962585, 0.1761, 3.9241).
    ///
    /// # Sources
    /// I. Lazányi, L. Szirmay-Kalos, *Fresnel Term Approximations for Metals*, WSCG 2005 short papers.
    ///
    /// ```
    /// use brdf::{Fresnel, Lazanyi};
    ///
    /// let aluminium = Lazanyi::new(0.91568_f64, 1.5, 6.0)?;
    /// assert!((aluminium.reflectance(0.3) - 0.8769096124).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct Lazanyi<C = glam::Vec3>;

    /// A surface of the given reflectance at normal incidence, with a dip.
    pub fn new;
}

impl<C> Lazanyi<C> {
    /// What is not held in 0 … 1.
    #[inline(always)]
    fn printed<T: Real>(&self, cos: T) -> C
    where
        C: Color<T>,
    {
        let one = T::one();
        let versine = one - cos;
        let fifth = versine.squared().squared() * versine;
        // A power of 0 has no derivative by its exponent.
        let oblique = versine.gt(T::zero());
        let base = T::select(oblique, versine, one);
        let schlick = self.f0.map(|f0| f0 + (one - f0) * fifth);
        let dip = self.a.zip(self.alpha, |a, alpha| a * (cos * base.powf(alpha)));
        schlick.zip(dip, |schlick, dip| schlick - dip.only_where(oblique))
    }
}

impl<T: Real, C: Color<T>> Fresnel<T> for Lazanyi<C> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        unit(self.printed(incident_cosine(cos_theta)))
    }

    fn average(&self) -> C {
        let (one, two, three) = (T::one(), T::lit(2.0), T::lit(3.0));
        let schlick = self.f0.map(|f0| f0 + (one - f0) * T::lit(1.0 / 21.0));
        let dip = self.a.zip(self.alpha, |a, alpha| {
            a / (alpha + one) * T::lit(4.0) / ((alpha + two) * (alpha + three))
        });
        average(schlick.zip(dip, |schlick, dip| schlick - dip), |cos| self.printed(cos))
    }
}
