use super::clamped::{dip, dipped, dipped_average, schlick_at_peak, unit};
use super::term::{Fresnel, incident_cosine};
use crate::parameter::model;
use crate::real::{Color, Real};

model! {
    /// Hoffman's correction of Schlick's polynomial for metals, by the colour that it has at 82°.
    ///
    /// # Formula
    /// ```text
    /// F = F_Schlick(u) − b u (1 − u)⁶, held in 0 … 1     b = (F_Schlick(1/7) − F₈₂)/((1/7)(6/7)⁶)
    /// average F₀ + (1 − F₀)/21 − b/126 where nothing is held
    /// ```
    parameters {
        f0: C, UNIT, "F₀", "reflectance at normal incidence";
        f82: C, UNIT, "F₈₂", "reflectance at u = 1/7, 81.8°, where the correction is largest";
    }
    constants {
        /// b.
        b: C = f0.zip(f82, dip);
    }
    /// | u | `cos_theta` | cosine of the angle of incidence (V·H on microfacets) | −1 … 1, the sign is ignored |
    ///
    /// # Energy
    /// Reciprocal. Conserving: F ≤ 1. An F₈₂ far from Schlick's value would make F leave 0 … 1: there it is
    /// the nearer end.
    ///
    /// # Accuracy
    /// With F₈₂ from the exact curve the largest error is 0.0060 for aluminium at 550 nm (Schlick's alone: 0.0801), 0.0190 at
    /// 700 nm, 0.0187 for an index of 2.95 + 2.93i.
    ///
    /// # Sources
    /// N. Hoffman, *Fresnel Equations Considered Harmful*, Eurographics Workshop on Material Appearance
    /// Modeling 2019, [doi:10.2312/mam.20191305](https://doi.org/10.2312/mam.20191305).
    ///
    /// ```
    /// use brdf::{F82, Fresnel};
    ///
    /// let aluminium = F82::new(0.91568_f64, 0.87489)?;
    /// assert!((aluminium.reflectance(1.0 / 7.0) - 0.87489).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct F82<C = glam::Vec3>;

    /// A metal of the given reflectances at normal incidence and at 81.8°.
    pub fn new;
}

impl<T: Real, C: Color<T>> Fresnel<T> for F82<C> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        unit(dipped(self.f0, self.b, incident_cosine(cos_theta)))
    }

    fn average(&self) -> C {
        dipped_average(self.f0, self.b)
    }
}

model! {
    /// [`F82`] by a tint: the factor by which the metal is darker at 82° than Schlick's polynomial.
    ///
    /// # Formula
    /// ```text
    /// F as of F82 with F₈₂ = t F_Schlick(1/7)
    /// ```
    parameters {
        f0: C, UNIT, "F₀", "reflectance at normal incidence";
        tint: C, UNIT = 1.0, "t", "reflectance at u = 1/7 over that of Schlick's polynomial";
    }
    constants {
        /// b.
        b: C = f0.zip(tint, |f0, tint| dip(f0, tint * schlick_at_peak(f0)));
    }
    /// | u | `cos_theta` | cosine of the angle of incidence (V·H on microfacets) | −1 … 1, the sign is ignored |
    ///
    /// # Energy
    /// Reciprocal. Conserving: F is at most [`Schlick`](super::Schlick)'s, which it is for t = 1. A tint too
    /// dark would make F negative: there it is 0.
    ///
    /// # Sources
    /// P. Kutz, M. Hašan, D. Edmondson, *Novel Aspects of the Adobe Standard Material*, technical report,
    /// Adobe, 2023.
    ///
    /// ```
    /// use brdf::{F82Tint, Fresnel, Schlick};
    ///
    /// let (plain, tinted) = (F82Tint::new(0.9_f64, 1.0)?, F82Tint::new(0.9, 0.8)?);
    /// assert!((plain.reflectance(0.3) - Schlick::new(0.9)?.reflectance(0.3)).abs() < 1e-15);
    /// assert!(tinted.reflectance(0.3) < plain.reflectance(0.3));
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct F82Tint<C = glam::Vec3>;

    /// A metal of the given reflectance at normal incidence, tinted towards the edge.
    pub fn new;
}

impl<T: Real, C: Color<T>> Fresnel<T> for F82Tint<C> {
    type Color = C;

    #[inline(always)]
    fn reflectance(&self, cos_theta: T) -> C {
        unit(dipped(self.f0, self.b, incident_cosine(cos_theta)))
    }

    fn average(&self) -> C {
        dipped_average(self.f0, self.b)
    }
}
