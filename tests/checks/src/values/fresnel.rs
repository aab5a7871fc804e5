//! Fresnel's equations and their stand-ins.

use brdf::fresnel::{
    conductor_polarized, dielectric_polarized, forms, index_from_normal_incidence, normal_incidence,
};
use brdf::{Conductor, Constant, Cook, Dielectric, Fresnel, Hall, Schlick};

use super::reference::each;
use super::{Check, Number, Verdict, fail, near};
use crate::slopes::composite;
use crate::tables::{number, rows};

pub(super) fn all<T: Number>() -> [Check; 11] {
    [
        ("Fresnel of dielectrics", dielectrics::<T>),
        ("Fresnel of conductors", conductors::<T>),
        ("Fresnel in a, b, u", abu::<T>),
        ("Fresnel in g, c", gc::<T>),
        ("Fresnel of measured indices", measured_indices::<T>),
        ("reflectance at normal incidence", at_normal_incidence::<T>),
        ("Schlick's Fresnel", schlick::<T>),
        ("average Fresnel", averages::<T>),
        ("average Fresnel of Conductor, Hall and Cook", more_averages::<T>),
        ("Hall and Cook", hall_and_cook::<T>),
        ("a constant is its own average", constant::<T>),
    ]
}

fn dielectrics<T: Number>() -> Verdict {
    each("fresnel_dielectric", |case| {
        let ior = case.number("eta_t") / case.number("eta_i");
        let cos = case.number("theta").cos();
        let polarized = dielectric_polarized(T::lit(ior), T::lit(cos));
        case.same("R_s", polarized.s)?;
        case.same("R_p", polarized.p)?;
        case.same("R", polarized.unpolarized())?;
        case.same("R", Dielectric::new(T::lit(ior))?.reflectance(T::lit(cos)))?;
        // The same interface with the normal on the other side.
        case.same("R", Dielectric::new(T::lit(1.0 / ior))?.reflectance(T::lit(-cos)))
    })
}

fn conductors<T: Number>() -> Verdict {
    each("fresnel_conductor", |case| {
        let (eta, k) = (case.input::<T>("n"), case.input::<T>("k"));
        let cos = T::lit(case.number("theta").cos());
        let polarized = conductor_polarized(eta, k, cos);
        case.same("R_s", polarized.s)?;
        case.same("R_p", polarized.p)?;
        case.same("R", polarized.unpolarized())?;
        case.same("R", Conductor::new(eta, k)?.reflectance(cos))?;
        let (a, b) = forms::ab(eta, k, cos);
        case.same("a", a)?;
        case.same("b", b)
    })
}

fn abu<T: Number>() -> Verdict {
    each("fresnel_abu", |case| {
        let (eta, k, u) = (case.input::<T>("n"), case.input::<T>("k"), case.input::<T>("u"));
        let (a, b) = forms::ab(eta, k, u);
        case.same("a", a)?;
        case.same("b", b)?;
        case.same("R", forms::abu(eta, k, u))?;
        case.same("R", Conductor::new(eta, k)?.reflectance(u))
    })
}

fn gc<T: Number>() -> Verdict {
    each("fresnel_gc", |case| {
        let (ior, c) = (case.input::<T>("n"), case.input::<T>("c"));
        case.same("value", forms::gc(ior, c))?;
        case.same("value", Dielectric::new(ior)?.reflectance(c))
    })
}

/// Thirteen materials at three wavelengths and ten angles, computed with complex numbers.
///
/// The table has 12 digits of the reflectances and 9 of the indices, so the last digit of an index
/// decides how well a reflectance can agree.
fn measured_indices<T: Number>() -> Verdict {
    let half_digit =
        |x: f64| if x == 0.0 { 0.0 } else { 0.5 * 10_f64.powf(x.log10().floor() - 8.0) };
    let table = rows("tests/data/fresnel_reference.csv");
    assert_eq!(table.len(), 390);
    for row in &table {
        let of = |column: &str| number(row, column);
        let (eta, k, cos) = (of("n"), of("k"), T::lit(of("theta_deg").to_radians().cos()));
        let reflectances = |eta: f64, k: f64| -> Result<[f64; 3], Box<dyn std::error::Error>> {
            let (eta, k) = (T::lit(eta), T::lit(k));
            let polarized = conductor_polarized(eta, k, cos);
            let unpolarized = Conductor::new(eta, k)?.reflectance(cos);
            Ok([polarized.s, polarized.p, unpolarized].map(Into::into))
        };
        let got = reflectances(eta, k)?;
        let other_eta = reflectances(eta + half_digit(eta), k)?;
        let other_k = reflectances(eta, k + half_digit(k))?;
        for (i, want) in ["Rs", "Rp", "R"].map(of).into_iter().enumerate() {
            let allowed = 1e-12 + (other_eta[i] - got[i]).abs() + (other_k[i] - got[i]).abs();
            if allowed >= 5e-9 {
                return fail(format!("{row:?}: {allowed}"));
            }
            near(&format!("{row:?}"), got[i], want, allowed)?;
        }
    }
    Ok(())
}

fn at_normal_incidence<T: Number>() -> Verdict {
    each("r0_n", |case| {
        let r0 = normal_incidence(case.input::<T>("n"), case.input("k"));
        case.same("R0", r0)?;
        case.same("n_effective_dielectric", index_from_normal_incidence(r0)?)
    })
}

fn schlick<T: Number>() -> Verdict {
    each("fresnel_schlick", |case| {
        let schlick = Schlick::new(case.input::<T>("f0"))?;
        case.same("F", schlick.reflectance(case.input("u")))?;
        case.same("F_avg", schlick.average())
    })
}

fn averages<T: Number>() -> Verdict {
    each("fresnel_dielectric_average", |case| {
        case.same("value", Dielectric::new(case.input::<T>("n"))?.average())
    })
}

/// Against the mean of the reflectances themselves.
fn more_averages<T: Number>() -> Verdict {
    fn check<T: Number>(what: &str, fresnel: &dyn Fresnel<T, Color = T>) -> Verdict {
        let mean = composite([0.0, 1.0], 8, |root| {
            4.0 * root.powi(3) * fresnel.reflectance(T::lit(root * root)).into()
        });
        near(what, fresnel.average(), mean, 1e-7)
    }
    let n = T::lit;
    for (eta, k) in [(0.14, 3.697), (1.5, 0.0), (2.0, 1.0)] {
        check("Conductor", &Conductor::new(n(eta), n(k))?)?;
    }
    // Total reflection beyond a critical angle makes a kink.
    let dense = Dielectric::new(n(0.6))?.average();
    near("Conductor, k = 0", Conductor::new(n(0.6), n(0.0))?.average(), dense.into(), 3e-7)?;
    check("Hall", &Hall::new(n(0.6), n(1.5))?)?;
    check("Cook", &Cook::new(n(0.6), n(0.7), n(1.5))?)
}

/// A reference curve that has one value at normal incidence and another at all other angles.
struct Reference<T> {
    normal: T,
    elsewhere: T,
}

impl<T: Number> Fresnel<T> for Reference<T> {
    type Color = T;

    fn reflectance(&self, cos_theta: T) -> T {
        if cos_theta.into() == 1.0 { self.normal } else { self.elsewhere }
    }
}

fn hall_and_cook<T: Number>() -> Verdict {
    each("fresnel_cook_hall", |case| {
        let reference =
            || Reference::<T> { normal: case.input("f0_ref"), elsewhere: case.input("f_ref") };
        let (f0, half) = (case.input::<T>("f0"), T::lit(0.5));
        case.same("value", Hall::with_reference(f0, reference())?.reflectance(half))?;
        let cook = Cook::with_reference(f0, half, reference())?.reflectance(half);
        case.same("value", 2.0 * cook.into())
    })
}

fn constant<T: Number>() -> Verdict {
    let constant = Constant::new(T::lit(0.3))?;
    near("reflectance", constant.reflectance(T::lit(0.2)), 0.3, 0.0)?;
    near("average", Fresnel::<T>::average(&constant), 0.3, 0.0)
}
