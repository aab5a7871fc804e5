//! Fresnel's equations and their stand-ins.

use brdf::fresnel::{
    conductor_polarized, dielectric_polarized, forms, index_from_normal_incidence, normal_incidence,
};
use brdf::{
    Conductor, Constant, Cook, Dielectric, F82, F82Tint, Fresnel, Gulbrandsen, Hall, Lazanyi,
    Schlick,
};

use super::reference::each;
use super::{Check, Number, Verdict, fail, near};
use crate::slopes::composite;
use crate::tables::{number, rows};

pub(super) fn all<T: Number>() -> [Check; 15] {
    [
        ("Fresnel of dielectrics", dielectrics::<T>),
        ("Fresnel of conductors", conductors::<T>),
        ("Fresnel in a, b, u", abu::<T>),
        ("Fresnel in g, c", gc::<T>),
        ("Fresnel of measured indices", measured_indices::<T>),
        ("reflectance at normal incidence", at_normal_incidence::<T>),
        ("Schlick's Fresnel", schlick::<T>),
        ("Lazányi", lazanyi::<T>),
        ("F82", f82::<T>),
        ("Gulbrandsen", gulbrandsen::<T>),
        ("what leaves 0 … 1", held::<T>),
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

fn lazanyi<T: Number>() -> Verdict {
    each("fresnel_lazanyi", |case| {
        let (f0, a) = (case.input::<T>("f0"), case.input("a"));
        let term = Lazanyi::new(f0, a, case.input("alpha"))?;
        case.same("value", term.reflectance(case.input("u")))
    })?;
    let (f0, a, alpha) = (0.9, 1.2, 6.5);
    let term = Lazanyi::new(T::lit(f0), T::lit(a), T::lit(alpha))?;
    let dip = 4.0 * a / ((alpha + 1.0) * (alpha + 2.0) * (alpha + 3.0));
    near("average of Lazányi", term.average(), f0 + (1.0 - f0) / 21.0 - dip, 1e-15)
}

fn f82<T: Number>() -> Verdict {
    each("fresnel_f82", |case| {
        let (f0, f82) = (case.input::<T>("f0"), case.input::<T>("f82"));
        let term = F82::new(f0, f82)?;
        case.same("F", term.reflectance(case.input("u")))?;
        case.same("F_avg", term.average())?;
        // b is what is missing of Schlick's term, over u (1 − u)⁶.
        let u = 0.25_f64;
        let schlick: f64 = Schlick::new(f0)?.reflectance(T::lit(u)).into();
        let missing = schlick - term.reflectance(T::lit(u)).into();
        near("b", T::lit(missing / (u * (1.0 - u).powi(6))), case.number_out("b"), 1e-12)?;
        let at_peak: f64 = Schlick::new(f0)?.reflectance(T::lit(1.0 / 7.0)).into();
        let tint = case.number("f82") / at_peak;
        if tint > 1.0 {
            return Ok(());
        }
        let tinted = F82Tint::new(f0, T::lit(tint))?;
        let cos = case.input("u");
        near("by its tint", tinted.reflectance(cos), term.reflectance(cos).into(), 1e-14)?;
        near("average by its tint", tinted.average(), term.average().into(), 1e-14)
    })
}

fn gulbrandsen<T: Number>() -> Verdict {
    each("fresnel_gulbrandsen", |case| {
        let term = Gulbrandsen::new(case.input::<T>("r"), case.input("g"))?;
        case.same("n", term.eta())?;
        case.same("k", term.k())?;
        case.same("R0", term.reflectance(T::one()))?;
        let conductor = Conductor::new(term.eta(), term.k())?;
        let want = conductor.reflectance(T::lit(0.3)).into();
        near("as a conductor", term.reflectance(T::lit(0.3)), want, 1e-15)?;
        near("its average", term.average(), conductor.average().into(), 1e-15)
    })
}

/// A dip too deep, and an edge too bright: held, and averaged as held.
fn held<T: Number>() -> Verdict {
    let term = Lazanyi::new(T::lit(0.05), T::lit(20.0), T::lit(5.0))?;
    near("held at 0", term.reflectance(T::lit(0.3)), 0.0, 0.0)?;
    let sum = |reflectance: &dyn Fn(f64) -> f64| {
        let at = |step: i32| (f64::from(step) + 0.5) / 1e5;
        (0..100_000).map(|step| 2.0 * at(step) * reflectance(at(step)) / 1e5).sum::<f64>()
    };
    let want = sum(&|cos| term.reflectance(T::lit(cos)).into());
    near("average of what is held at 0", term.average(), want, 2e-4)?;
    let term = F82::new(T::lit(0.9), T::one())?;
    near("held at 1", term.reflectance(T::lit(0.1)), 1.0, 0.0)?;
    let want = sum(&|cos| term.reflectance(T::lit(cos)).into());
    near("average of what is held at 1", term.average(), want, 2e-4)
}
