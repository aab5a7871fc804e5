use super::side::{Viewer, nothing_but_lobes, refraction_scale, sample_lobes};
use crate::bsdf::{Bsdf, BsdfSample, Lobe, Lobes, Power, TransportMode};
use crate::direction::refracted_cosine;
use crate::error::{ParameterError, range};
use crate::fresnel::split;
use crate::parameter::model;
use crate::real::{Color, Real, Vector};

model! {
    /// A smooth interface between two transparent media: a pane of which only one face counts, the
    /// surface of water, the face of a prism.
    ///
    /// # Formula
    /// ```text
    /// reflected:    wi = (−x, −y, z)             weight R
    /// transmitted:  wi = (−x/η, −y/η, ∓cosθ_t)   weight T (n_o/n_i)² for radiance, T for importance
    /// η = n_i/n_o    cosθ_t = √(1 − sin²θ/η²)    R, T: Fresnel's, T = 1 − R
    /// ```
    parameters {
        ior: T, ETA, "n", "index below the surface over that above";
    }
    constants {
        /// What has the channels of the answers: 1.
        white: C = C::splat(T::one());
    }
    /// Two [specular lobes](Bsdf::specular): value and density are 0 everywhere. Where the reflection
    /// is total there is one, and with n = 1 light passes straight through.
    ///
    /// # Energy
    /// Reciprocal: R and T are the same both ways along a refracted ray. Conserving and lossless: R + T = 1
    /// to the last digits, from either side, up to the critical angle and grazing.
    ///
    /// # Sampling
    /// The third number chooses: reflection below R. Every draw has the weight 1, for radiance times
    /// (n_o/n_i)² where it is refracted.
    ///
    /// # Sources
    /// A. Fresnel, 1823, as for [`Dielectric`](crate::Dielectric); the law of W. Snell, 1621. Radiance
    /// across an interface: E. Veach, *Robust Monte Carlo Methods for Light Transport Simulation*,
    /// 1997, section 5.2.
    ///
    /// ```
    /// use brdf::{Bsdf, SmoothDielectric, TransportMode};
    /// use glam::DVec3;
    ///
    /// let glass = SmoothDielectric::new(1.5_f64)?;
    /// let lobes = glass.specular(DVec3::Z, TransportMode::Radiance);
    /// assert!((lobes.reflected.weight.x - 0.04).abs() < 1e-15);
    /// assert!((lobes.transmitted.weight.x - 0.96 / 1.5 / 1.5).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("glass", "BTDF", "refraction"))]
    pub struct SmoothDielectric<C = glam::Vec3, T = f32>;
}

impl<T: Real> SmoothDielectric<T::Vec3, T> {
    /// An interface with this index below over that above.
    ///
    /// # Errors
    /// If `ior` is not in 10⁻⁴ … 10⁴.
    pub fn new(ior: T) -> Result<Self, ParameterError> {
        range::ETA.check("ior", ior)?;
        Ok(Self { ior, white: Color::splat(T::one()) })
    }
}

impl<C, T: Real> SmoothDielectric<C, T> {
    /// The same interface with answers in other channels.
    #[must_use]
    pub fn in_channels<D: Color<T>>(&self) -> SmoothDielectric<D, T> {
        SmoothDielectric { ior: self.ior, white: D::splat(T::one()) }
    }
}

/// The direction behind a smooth interface, of light that comes from the viewer; the mirror direction
/// where nothing is transmitted.
#[inline(always)]
fn refracted<T: Real>(viewer: &Viewer<T>, far_over_near: T, transmittance: T) -> T::Vec3 {
    let (zero, wo, inverse) = (T::zero(), viewer.wo, T::one() / far_over_near);
    let sin_squared = wo.x().squared() + wo.y().squared();
    let (cos, _) = refracted_cosine(wo.z(), sin_squared, inverse);
    let through = <T::Vec3 as Vector<T>>::new(
        zero - wo.x() * inverse,
        zero - wo.y() * inverse,
        T::select(viewer.below, cos, -cos),
    );
    Vector::select(transmittance.gt(zero), through, viewer.mirrored())
}

impl<T: Real, C: Color<T>> Bsdf<T> for SmoothDielectric<C, T> {
    type Color = C;

    nothing_but_lobes!(T);

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, [_, _, u]: [T; 3], mode: TransportMode) -> BsdfSample<T, C> {
        let viewer = Viewer::<T>::new(wo);
        let powers = split(self.ior, viewer.wo.z());
        let scale = refraction_scale(viewer.far_over_near(self.ior), mode);
        sample_lobes(&self.specular(wo, mode), powers, scale, u, viewer.exists)
    }

    #[inline(always)]
    fn specular(&self, wo: T::Vec3, mode: TransportMode) -> Lobes<T, C> {
        let viewer = Viewer::<T>::new(wo);
        let [reflectance, transmittance] = split(self.ior, viewer.wo.z());
        let far_over_near = viewer.far_over_near(self.ior);
        let scale = refraction_scale(far_over_near, mode);
        let lobes = Lobes {
            reflected: Lobe { wi: viewer.mirrored(), weight: self.white * reflectance },
            transmitted: Lobe {
                wi: refracted(&viewer, far_over_near, transmittance),
                weight: self.white * (transmittance * scale),
            },
        };
        lobes.only_where(viewer.exists)
    }
}
