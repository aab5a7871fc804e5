//! The surfaces of planets and moons.

use std::f64::consts::PI;

use brdf::{Brdf, Lambert, LommelSeeliger, Minnaert, Vector, from_spherical};
use glam::DVec3;

use super::reference::each;
use super::{Check, Number, Verdict, fail, vector};

pub(super) fn all<T: Number>() -> [Check; 3] {
    [
        ("planetary models", planetary::<T>),
        ("the full moon's disc", moon_disc::<T>),
        ("phase functions", phase_functions::<T>),
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
