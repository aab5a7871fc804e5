//! The surfaces of planets and moons.

use std::f64::consts::PI;

use brdf::{
    Brdf, HFunction, Hapke, Lambert, LommelSeeliger, Minnaert, OrenNayar, OrenNayarFull, Vector,
    from_spherical,
};
use glam::DVec3;

use super::reference::each;
use super::{Check, Number, Verdict, fail, vector};

pub(super) fn all<T: Number>() -> [Check; 6] {
    [
        ("planetary models", planetary::<T>),
        ("the full moon's disc", moon_disc::<T>),
        ("phase functions", phase_functions::<T>),
        ("Hapke", hapke::<T>),
        ("energy of grains that lose none", white_grains::<T>),
        ("discs of the full moon", discs::<T>),
    ]
}

fn planetary<T: Number>() -> Verdict {
    each("planetary", |case| {
        let [wi, wo] = ["i", "o"].map(|which| vector::<T>(case.direction(which)));
        let (rho, w) = (case.input::<T>("rho"), case.input::<T>("w"));
        let minnaert = Minnaert::new(rho, case.input::<T>("k"))?;
        let seeliger = LommelSeeliger::new(w, T::zero())?;
        case.same("lambert", Lambert::new(rho)?.eval(wi, wo).into())?;
        case.same("minnaert", minnaert.eval(wi, wo).into())?;
        case.same("lommel_seeliger", seeliger.eval(wi, wo).into())?;
        // An integral on a line, good to 10⁻⁷.
        let want = case.output("ls_albedo").as_f64().expect("a number");
        near("albedo of Lommel-Seeliger", seeliger.albedo(wo).into(), want, 1e-7)
    })
}

fn near(what: &str, got: f64, want: f64, error: f64) -> Verdict {
    if (got - want).abs() <= error { Ok(()) } else { fail(format!("{what}: {got} for {want}")) }
}

/// Radiance at full phase against that of the middle of the disc: constant for Lommel and Seeliger
/// whatever the phase function, and for Minnaert at k = ½.
fn moon_disc<T: Number>() -> Verdict {
    let normal = vector::<T>(DVec3::Z);
    for theta in [0.3_f64, 0.8, 1.2, 1.5] {
        let limb = vector::<T>(from_spherical(theta, 0.0));
        let disc = |model: &dyn Brdf<T, Color = T>| {
            let [limb, middle] =
                [limb, normal].map(|w| model.eval(w, w).into() * Vector::z(w).into());
            limb / middle
        };
        for xi in [-0.3, 0.0, 0.7] {
            let seeliger = LommelSeeliger::new(T::lit(0.25), T::lit(xi))?;
            near("disc of Lommel-Seeliger", disc(&seeliger), 1.0, 1e-12)?;
        }
        let flat = Minnaert::new(T::lit(0.25), T::lit(0.5))?;
        near("disc of Minnaert, flat", disc(&flat), 1.0, 1e-12)?;
        let lambert = Minnaert::new(T::lit(0.25), T::one())?;
        near("disc of Minnaert, Lambert", disc(&lambert), theta.cos(), 1e-12)?;
    }
    Ok(())
}

/// p = 4π f (N·L + N·V)/w as it is printed.
fn phase_functions<T: Number>() -> Verdict {
    let (wi, wo) = (from_spherical(1.1, 0.4), from_spherical(0.6, 3.3));
    for xi in [-0.9, -0.3, 1e-6, 0.5, 0.95] {
        let model = LommelSeeliger::new(T::one(), T::lit(xi))?;
        let value: f64 = model.eval(vector::<T>(wi), vector::<T>(wo)).into();
        let sum: f64 = 1.0 + 2.0 * xi * wi.dot(wo) + xi * xi;
        let want = (1.0 - xi * xi) / sum.powf(1.5);
        near("phase function", 4.0 * PI * value * (wi.z + wo.z), want, 1e-12 * want)?;
    }
    Ok(())
}

fn hapke<T: Number>() -> Verdict {
    each("hapke", |case| {
        let [wi, wo] = ["i", "o"].map(|which| vector::<T>(case.direction(which)));
        let value = |model: Hapke<T, T>| model.eval(wi, wo).into();
        let grains = Hapke::new(case.input::<T>("w"))?.with_phase(case.input("xi"))?;
        let surging = grains.with_surge(case.input("b0"), case.input("h"))?;
        case.same("f_h93", value(surging))?;
        case.same("f_h81", value(surging.with_h_function(HFunction::Of1981)))?;
        let rough = surging.with_roughness(case.input("theta_bar"))?;
        case.same("f_rough", value(rough))?;
        // What grains scatter once, from grains that scatter next to nothing: the surge and the phase function.
        let dark = |b0: f64| -> Result<f64, Box<dyn std::error::Error>> {
            let dark = Hapke::new(T::lit(1e-12))?.with_phase(case.input("xi"))?;
            let dark = dark.with_surge(T::lit(b0), case.input("h"))?;
            Ok(value(dark) * 4e12 * PI * (case.direction("i").z + case.direction("o").z))
        };
        let phase = dark(0.0)?;
        case.same("p", phase)?;
        case.compare("B", dark(case.number("b0"))? / phase - 1.0, case.number_out("B"))
    })
}

fn discs<T: Number>() -> Verdict {
    each("moon_disc", |case| {
        let limb = vector::<T>(from_spherical(case.number("theta"), 0.0));
        let normal = vector::<T>(DVec3::Z);
        let disc = |model: &dyn Brdf<T, Color = T>| {
            let [limb, middle] =
                [limb, normal].map(|w| model.eval(w, w).into() * Vector::z(w).into());
            limb / middle
        };
        let (one, sigma, w) = (T::one(), case.input("sigma"), case.input::<T>("w"));
        case.same("lambert", disc(&Lambert::new(one)?))?;
        case.same("lommel_seeliger", disc(&LommelSeeliger::new(w, T::zero())?))?;
        case.same("oren_nayar_qualitative", disc(&OrenNayar::new(one, sigma)?))?;
        case.same("oren_nayar_full", disc(&OrenNayarFull::new(one, sigma)?))?;
        let grains = Hapke::new(w)?.with_phase(T::lit(-0.3))?.with_surge(one, T::lit(0.05))?;
        case.same("hapke", disc(&grains.with_roughness(case.input("theta_bar"))?))
    })
}

/// With w = 1, where H of 1981 makes too much of the light at normal incidence.
fn white_grains<T: Number>() -> Verdict {
    let white = Hapke::new(T::one())?;
    let at = |model: Hapke<T, T>, theta| model.albedo(vector::<T>(from_spherical(theta, 0.2)));
    near("1993 at the normal", at(white, 0.0).into(), 0.9855645, 1e-6)?;
    near("1993 at 60°", at(white, PI / 3.0).into(), 0.9869897, 1e-6)?;
    let of_1981 = white.with_h_function(HFunction::Of1981);
    near("1981 at the normal", at(of_1981, 0.0).into(), 1.0397208, 1e-6)?;
    near("1981 at 60°", at(of_1981, PI / 3.0).into(), 1.0, 1e-6)?;
    let surging = white.with_phase(T::lit(-0.3))?.with_surge(T::one(), T::lit(0.05))?;
    near("1993 with a surge", at(surging, 0.0).into(), 1.1202266, 1e-6)
}
