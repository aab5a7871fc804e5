//! Mirror and refracted directions, special angles.

use std::f64::consts::FRAC_PI_2;

use brdf::fresnel::{dielectric_polarized, normal_incidence};
use brdf::{brewster_angle, critical_angle, from_spherical, reflect, refract, to_spherical};
use glam::DVec3;

use super::reference::each;
use super::{Check, Number, Verdict, fail, near, plain, vector};

pub(super) fn all<T: Number>() -> [Check; 2] {
    [("Snell's law", snell::<T>), ("special angles", special_angles::<T>)]
}

fn snell<T: Number>() -> Verdict {
    let normal = vector::<T>(DVec3::Z);
    each("snell_refract", |case| {
        let w = from_spherical(case.input::<T>("theta"), case.input("phi"));
        let mirrored = reflect::<T, _>(w, normal);
        case.same_vector::<T>("reflected", mirrored)?;
        let refraction = refract(w, normal, case.input::<T>("n1"), case.input("n2"));
        let is_total = T::select(refraction.total_internal_reflection, T::one(), T::zero());
        let is_total = is_total.into() == 1.0;
        if case.output("tir").as_bool() != Some(is_total) {
            return fail(format!("total reflection is {is_total}"));
        }
        if is_total {
            let (got, want) = (plain::<T>(refraction.direction), plain::<T>(mirrored));
            let same = got == want;
            return if same { Ok(()) } else { fail(format!("total reflection to {got}")) };
        }
        case.same_vector::<T>("transmitted", refraction.direction)?;
        case.same("theta_t", to_spherical::<T, _>(-refraction.direction).0)
    })
}

fn special_angles<T: Number>() -> Verdict {
    each("special_angles", |case| {
        let (n1, n2) = (case.input::<T>("n1"), case.input::<T>("n2"));
        let brewster = brewster_angle(n1, n2);
        case.same("brewster", brewster)?;
        let critical = case.output("critical").as_f64().unwrap_or(FRAC_PI_2);
        case.compare("critical", critical_angle(n1, n2), critical)?;
        let relative = case.number("n2") / case.number("n1");
        let polarized = dielectric_polarized(T::lit(relative), T::lit(brewster.into().cos()));
        case.same("R_s_at_brewster", polarized.s)?;
        near("R_p at Brewster's angle", polarized.p, 0.0, 1e-31)?;
        case.same("R0", normal_incidence(T::lit(relative), T::zero()))
    })
}
