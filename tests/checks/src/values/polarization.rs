//! Amplitudes, Jones and Mueller matrices, plates and films.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use brdf::colorimetry::xyz_to_linear_srgb;
use brdf::polarization::{
    Amplitudes, Complex, Interface, Jones, Layer, Layers, Mueller, Plates, Stokes,
};
use brdf::{Beckmann, BelcourBarla, Brdf, Constant, CookTorrance, Fresnel, from_spherical};
use glam::DVec3;

use super::reference::{Case, each};
use super::{Check, Number, Verdict, near, plain, vector};

pub(super) fn all<T: Number>() -> [Check; 10] {
    [
        ("amplitudes of dielectrics", dielectrics::<T>),
        ("amplitudes of conductors", conductors::<T>),
        ("amplitudes between absorbing media", absorbing::<T>),
        ("Mueller matrices of a boundary", boundaries::<T>),
        ("Mueller matrices of Jones matrices", of_jones::<T>),
        ("two reflections", two_reflections::<T>),
        ("coloured conductors in polarised light", tint::<T>),
        ("pile of plates", plates::<T>),
        ("thin film", film::<T>),
        ("thin film over the spectrum", belcour_barla::<T>),
    ]
}

fn complex<T: Number>(case: &Case<'_>, [re, im]: [&str; 2]) -> Complex<T> {
    Complex::new(case.input(re), case.input(im))
}

fn real<T: Number>(case: &Case<'_>, key: &str) -> Complex<T> {
    Complex::real(case.input(key))
}

fn cos<T: Number>(case: &Case<'_>, theta: &str) -> T {
    T::lit(case.number(theta).cos())
}

/// Holds a complex number against an output.
fn same<T: Number>(case: &Case<'_>, key: &str, got: Complex<T>) -> Verdict {
    let want = |part: &str| case.output(key)[part].as_f64().expect("a part");
    case.compare(key, got.re, want("re"))?;
    case.compare(key, got.im, want("im"))
}

/// Holds a Mueller matrix against an output.
fn same_matrix<T: Number>(case: &Case<'_>, got: &Mueller<T>) -> Verdict {
    for (row, got) in got.rows.into_iter().enumerate() {
        for (column, got) in got.into_iter().enumerate() {
            let want = case.output("m")[row][column].as_f64().expect("an element");
            case.compare(&format!("m[{row}][{column}]"), got, want)?;
        }
    }
    Ok(())
}

/// An angle up to whole turns.
fn same_angle<T: Number>(case: &Case<'_>, key: &str, got: T) -> Verdict {
    let (got, want) = (got.into(), case.output(key).as_f64().expect("an angle"));
    let turns = ((got - want) / TAU).round();
    case.compare(key, got - turns * TAU, want)
}

fn dielectrics<T: Number>() -> Verdict {
    each("fresnel_dielectric", |case| {
        let interface = Interface::new(real(case, "eta_i"), real(case, "eta_t"))?;
        let cos = cos::<T>(case, "theta");
        // Without a film between them, and with one of no thickness.
        let none = Layers::new(real(case, "eta_i"), &[], real(case, "eta_t"), T::lit(550.0))?;
        let thin = Layer { index: Complex::real(T::lit(1.3)), thickness: T::zero() };
        let thin = Layers::new(real(case, "eta_i"), &[thin], real(case, "eta_t"), T::lit(550.0))?;
        for found in [interface.amplitudes(cos), none.amplitudes(cos), thin.amplitudes(cos)] {
            let Amplitudes { r, t, transmittance } = found;
            same(case, "r_s", r.s)?;
            same(case, "r_p", r.p)?;
            same(case, "t_s", t.s)?;
            same(case, "t_p", t.p)?;
            case.same("R_s", found.reflectance().s)?;
            case.same("R_p", found.reflectance().p)?;
            case.same("T_s", transmittance.s)?;
            case.same("T_p", transmittance.p)?;
        }
        Ok(())
    })
}

fn conductors<T: Number>() -> Verdict {
    each("fresnel_conductor", |case| {
        let interface = Interface::new(Complex::real(T::one()), complex::<T>(case, ["n", "k"]))?;
        let found = interface.amplitudes(cos(case, "theta"));
        same(case, "r_s", found.r.s)?;
        same(case, "r_p", found.r.p)?;
        case.same("R", found.reflectance().unpolarized())?;
        same_angle(case, "phase_s", found.r.s.arg())?;
        same_angle(case, "phase_p", found.r.p.arg())
    })
}

fn absorbing<T: Number>() -> Verdict {
    each("fresnel_complex_complex", |case| {
        let (from, to) = (complex(case, ["n1", "k1"]), complex(case, ["n2", "k2"]));
        let found = Interface::<T>::new(to, from)?.reversed().amplitudes(cos(case, "theta"));
        same(case, "r_s", found.r.s)?;
        same(case, "r_p", found.r.p)?;
        case.same("R_s", found.reflectance().s)?;
        case.same("R_p", found.reflectance().p)
    })
}

fn boundaries<T: Number>() -> Verdict {
    each("mueller_reflection", |case| {
        let to = complex::<T>(case, ["n2", "k2"]);
        let found = Interface::new(real(case, "n1"), to)?.amplitudes(cos(case, "theta"));
        let matrix = found.mueller_reflection();
        same_matrix(case, &matrix)?;
        let light = matrix * Stokes::unpolarized(T::one());
        case.same("dop_from_unpolarised", light.degree_of_polarization())?;
        same_angle(case, "retardance", (found.r.s * found.r.p.conj()).arg())
    })?;
    each("mueller_transmission", |case| {
        let interface = Interface::<T>::new(real(case, "n1"), real(case, "n2"))?;
        let matrix = interface.amplitudes(cos(case, "theta")).mueller_transmission();
        same_matrix(case, &matrix)?;
        let light = matrix * Stokes::unpolarized(T::one());
        case.same("dop_from_unpolarised", light.degree_of_polarization())
    })
}

fn of_jones<T: Number>() -> Verdict {
    each("mueller_from_jones", |case| {
        let (re, im) = (case.inputs::<T>("re"), case.inputs::<T>("im"));
        let at = |place: usize| Complex::new(re[place], im[place]);
        let jones = Jones { rows: [[at(0), at(1)], [at(2), at(3)]] };
        same_matrix(case, &jones.mueller())
    })?;
    each("mueller_rotation", |case| {
        same_matrix(case, &Mueller::<T>::rotation(case.input("chi")))?;
        same_matrix(case, &Jones::<T>::rotation(case.input("chi")).mueller())
    })
}

fn two_reflections<T: Number>() -> Verdict {
    each("stokes_two_reflections", |case| {
        let air = Complex::real(T::one());
        let mirror = |index, theta| -> Result<_, Box<dyn std::error::Error>> {
            Ok(Interface::new(air, complex(case, index))?.amplitudes(cos(case, theta)))
        };
        let (first, second) = (mirror(["n1", "k1"], "theta1")?, mirror(["n2", "k2"], "theta2")?);
        let chi = case.input::<T>("chi");
        let step_by_step = second.mueller_reflection()
            * (Mueller::rotation(chi)
                * (first.mueller_reflection() * Stokes::unpolarized(T::one())));
        let chain = second.reflection() * Jones::rotation(chi) * first.reflection();
        for light in [step_by_step, chain.mueller() * Stokes::unpolarized(T::one())] {
            for (place, got) in light.to_array().into_iter().enumerate() {
                let want = case.output("stokes")[place].as_f64().expect("a parameter");
                case.compare("stokes", got, want)?;
            }
            case.same("dop", light.degree_of_polarization())?;
        }
        Ok(())
    })
}

fn tint<T: Number>() -> Verdict {
    each("conductor_polarised_tint", |case| {
        let metal = Interface::new(Complex::real(T::one()), complex::<T>(case, ["n", "k"]))?;
        let found = metal.amplitudes(cos(case, "theta"));
        let pol = case.input::<T>("pol");
        let light = found.mueller_reflection() * Stokes::linear(T::one(), pol);
        case.same("R", light.i)?;
        // An ideal mirror turns the azimuth to −pol; the analyser stands across that.
        let analyser = Jones::polarizer(T::lit(FRAC_PI_2) - pol);
        let field = [Complex::real(pol.cos()), Complex::real(pol.sin())];
        let crossed = analyser.apply(found.reflection().apply(field));
        case.same("crossed", Stokes::of_field(crossed).i)
    })
}

fn plates<T: Number>() -> Verdict {
    each("pile_of_plates", |case| {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count")]
        let count = case.number("plates") as u32;
        let pile = Plates::<T>::new(case.input("n"), count, case.input("k_d"))?;
        let found = pile.at(cos(case, "theta"));
        case.same("R_s", found.reflectance.s)?;
        case.same("R_p", found.reflectance.p)?;
        case.same("T_s", found.transmittance.s)?;
        case.same("T_p", found.transmittance.p)?;
        let light = found.mueller_transmission() * Stokes::unpolarized(T::one());
        case.same("dop_transmitted", light.degree_of_polarization())
    })
}

fn film<T: Number>() -> Verdict {
    each("thin_film_airy", |case| {
        let whole = case.number("d_nm");
        let half = Layer { index: real::<T>(case, "n2"), thickness: T::lit(whole * 0.5) };
        let film = Layer { thickness: T::lit(whole), ..half };
        let cos = cos(case, "theta");
        // A film, and the same in two halves.
        for layers in [&[film][..], &[half, half]] {
            let substrate = complex(case, ["n3", "k3"]);
            let stack = Layers::new(real(case, "n1"), layers, substrate, case.input("lam_nm"))?;
            let found = stack.amplitudes(cos).reflectance();
            case.same("R_s", found.s)?;
            case.same("R_p", found.p)?;
            case.same("R", found.unpolarized())?;
            case.same("R", stack.reflectance(cos))?;
        }
        Ok(())
    })
}

fn belcour_barla<T: Number>() -> Verdict {
    each("thin_film_belcour_barla", |case| {
        let substrate = [case.input::<T>("n3"), case.input("k3")];
        let (film, outside) = (case.input("n2"), case.input("n1"));
        let film: BelcourBarla<T::Vec3, T> =
            BelcourBarla::new(film, case.input("d_nm"), substrate, outside)?;
        let found = film.xyz(cos(case, "theta"));
        for (place, got) in found.into_iter().enumerate() {
            let want = case.output("xyz")[place].as_f64().expect("a number");
            case.compare("xyz", got, want)?;
        }
        let found = DVec3::from_array(found.map(Into::into));
        let want = xyz_to_linear_srgb(found) / xyz_to_linear_srgb(DVec3::ONE);
        let seen = plain::<T>(film.reflectance(cos(case, "theta")));
        near("colour", (seen - want).abs().max_element(), 0.0, 1e-14)?;
        // On facets what is below 0 counts as 0.
        let theta = case.number("theta");
        let [wi, wo] = [0.0, PI].map(|phi| vector::<T>(from_spherical(theta, phi)));
        let facets = Beckmann::new(T::lit(0.3))?;
        let white: f64 = CookTorrance::new(facets, Constant::new(T::one())?).eval(wi, wo).into();
        let found = plain::<T>(CookTorrance::new(facets, film).eval(wi, wo));
        near("facets", (found - seen.max(DVec3::ZERO) * white).abs().max_element(), 0.0, 1e-12)
    })
}
