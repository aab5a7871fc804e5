use super::side::{Viewer, nothing_but_lobes};
use crate::bsdf::{Bsdf, BsdfSample, Lobe, Lobes, Power, TransportMode};
use crate::parameter::model;
use crate::real::{Color, Real};

model! {
    /// An ideal retro-reflector: light goes back to where it comes from, as from the corners of three mirrors in
    /// the reflectors of bicycles.
    ///
    /// # Formula
    /// ```text
    /// wi = wo   weight ρ
    /// ```
    parameters {
        reflectance: C, UNIT, "ρ", "fraction of the light that is sent back";
    }
    ///
    /// One [specular lobe](Bsdf::specular) above the surface: value and density are 0 everywhere, and below
    /// the surface there is nothing. ρ is the same at all angles: real corners lose the light of rays that miss
    /// one of the mirrors.
    ///
    /// # Energy
    /// Reciprocal. Conserving: it reflects ρ.
    ///
    /// # Sampling
    /// Every draw is the lobe, with the weight ρ.
    ///
    /// # Sources
    /// Three reflections at planes that are perpendicular to each other turn each component of a direction
    /// round. It has no form in descriptions.
    ///
    /// ```
    /// use brdf::{Bsdf, RetroReflector, TransportMode};
    /// use glam::DVec3;
    ///
    /// let sign = RetroReflector::new(DVec3::splat(0.7))?;
    /// let wo = DVec3::new(0.6, 0.0, 0.8);
    /// let lobe = sign.specular(wo, TransportMode::Radiance).reflected;
    /// assert_eq!((lobe.wi, lobe.weight.x), (wo, 0.7));
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    #[doc(alias("corner cube"))]
    pub struct RetroReflector<C = glam::Vec3>;

    /// A retro-reflector of the given reflectance.
    pub fn new;
}

impl<T: Real, C: Color<T>> Bsdf<T> for RetroReflector<C> {
    type Color = C;

    nothing_but_lobes!(T);

    #[inline(always)]
    fn sample(&self, wo: T::Vec3, _: [T; 3], mode: TransportMode) -> BsdfSample<T, C> {
        Viewer::above(wo).sample(&self.specular(wo, mode))
    }

    #[inline(always)]
    fn specular(&self, wo: T::Vec3, _: TransportMode) -> Lobes<T, C> {
        let Viewer { wo, exists, .. } = Viewer::<T>::above(wo);
        Lobes::reflected(wo, Lobe { wi: wo, weight: self.reflectance }, exists)
    }
}

#[cfg(test)]
mod tests {
    use core::array;

    use glam::{DVec3, Vec3};

    use super::*;
    use crate::direction::from_spherical;
    use crate::interface::Mirror;
    use crate::{Constant, Lanes, Vector3};

    const MODES: [TransportMode; 2] = [TransportMode::Radiance, TransportMode::Importance];

    fn sign() -> RetroReflector<DVec3> {
        RetroReflector::new(DVec3::new(0.9, 0.5, 0.1)).expect("a reflectance")
    }

    /// Three mirrors that are perpendicular to each other, in any of their six orders.
    #[test]
    fn the_lobe_is_that_of_a_corner_of_three_mirrors() {
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
        // The corner opens towards the normal.
        let turn = glam::DQuat::from_rotation_arc(DVec3::ONE.normalize(), DVec3::Z);
        for theta in [0.0, 0.3, 0.9, 1.5] {
            let wo: DVec3 = from_spherical(theta, 0.4);
            let lobe = sign().specular(wo, TransportMode::Radiance).reflected;
            for order in orders {
                let onwards = order.iter().fold(-wo, |direction, &axis| {
                    let mirror = turn * axes[axis];
                    direction - mirror * (2.0 * direction.dot(mirror))
                });
                // Three reflections of a unit vector, each rounded.
                assert!((lobe.wi - onwards).length() < 1e-15, "{theta} {order:?}");
            }
        }
    }

    #[test]
    fn every_draw_is_the_lobe_and_carries_the_power() {
        for mode in MODES {
            for (theta, u) in [(0.0, 0.1), (0.7, 0.5), (1.57, 0.99)] {
                let wo: DVec3 = from_spherical(theta, 2.0);
                let sample = sign().sample(wo, [u; 3], mode);
                assert_eq!((sample.wi, sample.pdf, sample.specular), (wo, 0.0, true));
                assert_eq!(sample.weight, DVec3::new(0.9, 0.5, 0.1));
                assert_eq!(sign().power(wo).reflectance, sample.weight);
                assert_eq!(sign().power(wo).transmittance, DVec3::ZERO);
                assert_eq!(sign().eval(wo, wo, mode), DVec3::ZERO);
                let pdf: f64 = sign().pdf(wo, wo, mode);
                assert_eq!(pdf, 0.0);
            }
        }
        // At the normal it is a mirror.
        let mirror = Mirror::new(Constant::new(DVec3::new(0.9, 0.5, 0.1)).expect("a reflectance"));
        let of_mirror = mirror.specular(DVec3::Z, MODES[0]).reflected;
        assert_eq!(sign().specular(DVec3::Z, MODES[0]).reflected, of_mirror);
    }

    #[test]
    fn there_is_nothing_below_and_of_no_direction() {
        let nowhere = [-DVec3::Z, DVec3::X, DVec3::ZERO, DVec3::NAN, DVec3::splat(f64::MAX)];
        for wo in nowhere {
            let lobe = sign().specular(wo, TransportMode::Radiance).reflected;
            assert!(lobe.wi.is_finite() && lobe.weight == DVec3::ZERO, "{wo}");
            let sample = sign().sample(wo, [0.5; 3], TransportMode::Radiance);
            assert!(!sample.specular && sample.weight == DVec3::ZERO, "{wo}");
            assert_eq!(sign().power(wo).reflectance, DVec3::ZERO, "{wo}");
        }
    }

    #[test]
    fn lanes_have_the_lobes_of_single_calls() {
        let wo: [Vec3; 4] = array::from_fn(|lane| from_spherical(lane as f32 * 0.6, 1.0));
        let lane = |of: fn(Vec3) -> f32| Lanes(wo.map(of));
        let wide = Vector3 { x: lane(|w| w.x), y: lane(|w| w.y), z: lane(|w| w.z) };
        let sign = RetroReflector::new(Lanes([0.7_f32; 4])).expect("a reflectance");
        let lobe = sign.specular(wide, TransportMode::Radiance).reflected;
        let single = RetroReflector::new(0.7_f32).expect("a reflectance");
        for (lane, wo) in wo.into_iter().enumerate() {
            let one: Lobe<f32, f32> = single.specular(wo, TransportMode::Radiance).reflected;
            let wi = Vec3::new(lobe.wi.x.0[lane], lobe.wi.y.0[lane], lobe.wi.z.0[lane]);
            assert_eq!((wi, lobe.weight.0[lane]), (one.wi, one.weight));
        }
    }

    #[test]
    fn a_reflectance_above_1_is_refused() {
        let error = RetroReflector::new(1.5_f64).expect_err("more than there is");
        assert!(error.to_string().contains("reflectance"), "{error}");
    }
}
