//! Rough diffuse surfaces beyond the qualitative model.

use std::f64::consts::{FRAC_PI_2, PI};

use brdf::{Brdf, Eon, Fon, Fujii, OrenNayarFull, from_spherical};
use glam::DVec3;

use super::reference::each;
use super::{Check, Number, Verdict, near, vector};

pub(super) fn all<T: Number>() -> [Check; 3] {
    [
        ("full Oren–Nayar", full::<T>),
        ("FON and EON", by_roughness::<T>),
        ("what is left of the full model's negative values", clipped::<T>),
    ]
}

/// The value of a model of one channel.
fn value<T: Number>(model: &impl Brdf<T, Color = T>, [wi, wo]: [DVec3; 2]) -> f64 {
    model.eval(vector::<T>(wi), vector::<T>(wo)).into()
}

fn full<T: Number>() -> Verdict {
    each("oren_nayar", |case| {
        let pair = ["i", "o"].map(|which| case.direction(which));
        let (albedo, sigma) = (case.input::<T>("rho"), case.input::<T>("sigma"));
        let direct = value(&OrenNayarFull::without_interreflection(albedo, sigma)?, pair);
        case.same("full_direct", direct)?;
        let whole = value(&OrenNayarFull::new(albedo, sigma)?, pair);
        case.same("full", whole)?;
        near("interreflection", whole - direct, case.number_out("full_interreflection"), 1e-15)?;
        case.same("fujii_fit", value(&Fujii::new(albedo, sigma)?, pair))
    })
}

fn by_roughness<T: Number>() -> Verdict {
    each("eon", |case| {
        let pair = ["i", "o"].map(|which| case.direction(which));
        let (albedo, roughness) = (case.input::<T>("rho"), case.input::<T>("r"));
        case.same("fon", value(&Fon::new(albedo, roughness)?, pair))?;
        let eon = Eon::new(albedo, roughness)?;
        case.same("eon", value(&eon, pair))?;
        let light = vector::<T>(pair[0]);
        case.same("albedo_eon", eon.albedo(light))?;
        case.same("E_i", Fon::new(T::one(), roughness)?.albedo(light))
    })
}

/// Light and viewer that graze on opposite sides of a rough, dark surface.
fn clipped<T: Number>() -> Verdict {
    let pair = [from_spherical(1.5, 0.0), from_spherical(1.5, 3.1)];
    let dark = OrenNayarFull::new(T::lit(0.1), T::lit(1.3))?;
    near("clipped", value(&dark, pair), 0.0, 0.0)?;
    // The albedo is that of what is clipped, ring by ring.
    let wo = from_spherical(1.35, 0.0);
    let steps = |count: i32| (0..count).map(move |step| (f64::from(step) + 0.5) / f64::from(count));
    let mut sum = 0.0;
    for theta in steps(200).map(|part| part * FRAC_PI_2) {
        for phi in steps(100).map(|part| part * PI) {
            let f = value(&dark, [from_spherical(theta, phi), wo]);
            sum += f * theta.sin() * theta.cos();
        }
    }
    let want = sum * FRAC_PI_2 / 200.0 * 2.0 * PI / 100.0;
    near("albedo of what is clipped", dark.albedo(vector::<T>(wo)), want, 2e-5)
}
