use super::side::{Viewer, nothing_but_lobes, sample_lobes};
use crate::bsdf::{Bsdf, BsdfSample, Lobe, Lobes, Power, TransportMode};
use crate::error::{ParameterError, range};
use crate::fresnel::split_polarized;
use crate::parameter::model;
use crate::real::{Color, Real, Vector};

model! {
    /// A plane plate of a transparent medium, so thin that light leaves it where it entered: a window
    /// pane, with all reflections between its faces.
    ///
    /// # Formula
    /// ```text
    /// reflected:    wi = (−x, −y, z)   weight 2R/(1 + R)
    /// transmitted:  wi = −wo           weight (1 − R)/(1 + R)
    /// ```
    ///
    /// with R the reflectance of one face, for s and p polarised light apart; unpolarised light has the
    /// means.
    parameters {
        ior: T, ETA, "n", "index of the plate over that around it";
    }
    constants {
        /// What has the channels of the answers: 1.
        white: C = C::splat(T::one());
    }
    /// Two [specular lobes](Bsdf::specular): value and density are 0 everywhere.
    ///
    /// # Energy
    /// Reciprocal, the same for radiance and importance. Conserving and lossless: both weights have the
    /// sum 1.
    ///
    /// # Sampling
    /// The third number chooses: reflection below its weight. Every draw has the weight 1.
    ///
    /// # Limits
    /// No absorption, no interference, no shift of the light inside the plate. A mean over polarisations
    /// is taken once, so two plates in a row reflect a little less than light whose polarisation is
    /// followed; see [`Plates`](crate::polarization::Plates).
    ///
    /// # Sources
    /// G. G. Stokes, "On the intensity of the light reflected from or transmitted through a pile of
    /// plates", Proc. Royal Society 11, 1862.
    ///
    /// ```
    /// use brdf::{Bsdf, ThinDielectric, TransportMode};
    /// use glam::DVec3;
    ///
    /// let pane = ThinDielectric::new(1.5_f64)?;
    /// let lobes = pane.specular(DVec3::Z, TransportMode::Radiance);
    /// assert!((lobes.reflected.weight.x - 0.08 / 1.04).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("window", "pane"))]
    pub struct ThinDielectric<C = glam::Vec3, T = f32>;
}

impl<T: Real> ThinDielectric<T::Vec3, T> {
    /// A plate with this index over that of the medium around it.
    ///
    /// # Errors
    /// If `ior` is not in 10⁻⁴ … 10⁴.
    pub fn new(ior: T) -> Result<Self, ParameterError> {
        range::ETA.check("ior", ior)?;
        Ok(Self { ior, white: Color::splat(T::one()) })
    }
}

impl<C, T: Real> ThinDielectric<C, T> {
    /// The same plate with answers in other channels.
    #[must_use]
    pub fn in_channels<D: Color<T>>(&self) -> ThinDielectric<D, T> {
        ThinDielectric { ior: self.ior, white: D::splat(T::one()) }
    }

    /// What is reflected and transmitted in all. Both faces reflect alike, so that the side does not
    /// matter.
    #[inline(always)]
    fn powers(&self, cos: T) -> [T; 2] {
        let (one, two) = (T::one(), T::lit(2.0));
        let [reflected, transmitted] = split_polarized(self.ior, cos.abs());
        let back = reflected.map(|r| two * r / (one + r)).unpolarized();
        // (1 − R)/(1 + R) of T = 1 − R.
        let through = transmitted.map(|t| t / (two - t)).unpolarized();
        [back, through]
    }
}

impl<T: Real, C: Color<T>> Bsdf<T> for ThinDielectric<C, T> {
    type Color = C;

    nothing_but_lobes!(T);

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, [_, _, u]: [T; 3], mode: TransportMode) -> BsdfSample<T, C> {
        let viewer = Viewer::<T>::new(wo);
        let powers = self.powers(viewer.wo.z());
        sample_lobes(&self.specular(wo, mode), powers, T::one(), u, viewer.exists)
    }

    #[inline(always)]
    fn specular(&self, wo: T::Vec3, _: TransportMode) -> Lobes<T, C> {
        let viewer = Viewer::<T>::new(wo);
        let [back, through] = self.powers(viewer.wo.z());
        let lobes = Lobes {
            reflected: Lobe { wi: viewer.mirrored(), weight: self.white * back },
            transmitted: Lobe { wi: viewer.opposite(), weight: self.white * through },
        };
        lobes.only_where(viewer.exists)
    }
}
