use super::clamped::unit;
use super::term::{Fresnel, incident_cosine};
use crate::parameter::model;
use crate::quadrature::integrate;
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
    /// Reciprocal. Conserving: F ≤ 1. A dip too deep would make F negative: there it is 0.
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
        let free = schlick.zip(dip, |schlick, dip| schlick - dip);
        let (free, f0) = (free.channels(), self.f0.channels());
        let (a, alpha) = (self.a.channels(), self.alpha.channels());
        let (free, f0, a, alpha) = (free.as_ref(), f0.as_ref(), a.as_ref(), alpha.as_ref());
        unit(C::from_channels(C::by_channel(|channel| {
            let term = Lazanyi { f0: f0[channel], a: a[channel], alpha: alpha[channel] };
            term.held_average(free[channel])
        })))
    }
}

impl<T: Real> Lazanyi<T> {
    /// The average where F is held at 0 between two cosines, otherwise what it is where nothing is held: F
    /// over what it loses to the dip has one minimum, and F₀ + (1 − F₀)(1 − u)⁵ and the dip have closed
    /// integrals from the upper one on.
    fn held_average(&self, free: T) -> T {
        let (zero, one, two, three) = (T::zero(), T::one(), T::lit(2.0), T::lit(3.0));
        let Self { f0, a, alpha } = *self;
        let lowest = last(zero, one, |cos| {
            let rest = one - cos;
            let fifth = rest.squared().squared() * rest;
            let schlick = (f0 + (one - f0) * fifth).max(T::lit(1e-36));
            // −u (1 − u) times the slope of the logarithm of the ratio.
            (rest + cos * (T::lit(5.0) * (one - f0) * fifth / schlick - alpha)).gt(zero)
        });
        let held = self.printed(lowest).lt(zero);
        let lower = last(zero, lowest, |cos| self.printed(cos).ge(zero));
        let upper = last(lowest, one, |cos| self.printed(cos).lt(zero));
        // Next to the end of the range the power may be steep.
        let below = integrate(zero, one, |part: T| {
            let cos = lower * (part * (two - part));
            self.printed(cos) * (T::lit(4.0) * cos * lower * (one - part))
        });
        let rest = one - upper;
        let some = rest.gt(zero);
        let rest = T::select(some, rest, one);
        let (square, power) = (rest.squared(), rest.powf(alpha + one));
        let sixth = square.squared() * square;
        let schlick = f0 * (rest - square * T::lit(0.5))
            + (one - f0) * sixth * (T::lit(1.0 / 6.0) - rest * T::lit(1.0 / 7.0));
        let dip = one / (alpha + one) - two * rest / (alpha + two) + square / (alpha + three);
        let above = (two * (schlick - a * power * dip)).max(zero).only_where(some);
        T::select(held, below + above, free)
    }
}

/// The last number up to which something is true, by halving; it does not change with the parameters, as F is 0
/// there.
fn last<T: Real>(lower: T, upper: T, holds: impl Fn(T) -> T::Mask) -> T {
    let (mut lower, mut upper) = (lower.held(), upper.held());
    for _ in 0..48 {
        let middle = (lower + upper) * T::lit(0.5);
        let beyond = holds(middle);
        lower = T::select(beyond, middle, lower);
        upper = T::select(beyond, upper, middle);
    }
    upper
}

#[cfg(test)]
mod tests {
    use super::{Fresnel, Lazanyi};
    use crate::quadrature::integrate;

    #[test]
    fn averages_of_deep_dips_are_those_of_what_is_held() {
        for f0 in [0.0, 0.1, 0.5, 0.95, 1.0] {
            for a in [1.0, 10.0, 1e3, 1e4] {
                for alpha in [0.1, 1.0, 6.0, 30.0] {
                    let term = Lazanyi::new(f0, a, alpha).unwrap();
                    // In panels that become narrow at both ends, where the kinks are.
                    let reference = |from: f64, to: f64| -> f64 {
                        let at = |i: i32| from + (to - from) * f64::from(i) / 200.0;
                        let panel = |i| {
                            integrate(at(i), at(i + 1), |t: f64| {
                                let rest = t * (1.0 - t);
                                let slope = 30.0 * rest * rest;
                                let cos = t * t * t * (10.0 - t * (15.0 - 6.0 * t));
                                2.0 * cos * slope * term.reflectance(cos)
                            })
                        };
                        (0..200).map(panel).sum()
                    };
                    let want = reference(0.0, 1.0);
                    let got = term.average();
                    assert!((got - want).abs() < 1e-6, "{f0} {a} {alpha}: {got:e} {want:e}");
                }
            }
        }
        let deep = Lazanyi::new(0.5_f64, 1e4, 0.1).unwrap().average();
        assert!(deep > 2e-9 && deep < 4e-9, "{deep:e}");
    }
}
