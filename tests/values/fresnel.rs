use std::path::Path;

use brdf::fresnel::{
    conductor_polarized, dielectric_polarized, forms, index_from_normal_incidence, normal_incidence,
};
use brdf::{Conductor, Constant, Dielectric, Fresnel, Hall, Schlick, brewster_angle};

use crate::common::values::Group;

#[test]
fn fresnel_dielectric() {
    for case in Group::read("fresnel_dielectric").cases() {
        let ior = case.input("eta_t") / case.input("eta_i");
        let cos = case.input("theta").cos();
        let polarized = dielectric_polarized(ior, cos);
        case.check("R_s", polarized.s);
        case.check("R_p", polarized.p);
        case.check("R", polarized.unpolarized());
        case.check("R", Dielectric::new(ior).unwrap().reflectance(cos));
        // The same interface with the normal on the other side.
        case.check("R", Dielectric::new(1.0 / ior).unwrap().reflectance(-cos));
    }
}

#[test]
fn fresnel_conductor() {
    for case in Group::read("fresnel_conductor").cases() {
        let (eta, k, cos) = (case.input("n"), case.input("k"), case.input("theta").cos());
        let polarized = conductor_polarized(eta, k, cos);
        case.check("R_s", polarized.s);
        case.check("R_p", polarized.p);
        case.check("R", polarized.unpolarized());
        case.check("R", Conductor::new(eta, k).unwrap().reflectance(cos));
        let (a, b) = forms::ab(eta, k, cos);
        case.check("a", a);
        case.check("b", b);
    }
}

#[test]
fn fresnel_abu() {
    for case in Group::read("fresnel_abu").cases() {
        let (eta, k, u) = (case.input("n"), case.input("k"), case.input("u"));
        let (a, b) = forms::ab(eta, k, u);
        case.check("a", a);
        case.check("b", b);
        case.check("R", forms::abu(eta, k, u));
        case.check("R", Conductor::new(eta, k).unwrap().reflectance(u));
    }
}

#[test]
fn fresnel_gc() {
    for case in Group::read("fresnel_gc").cases() {
        let (ior, c) = (case.input("n"), case.input("c"));
        case.check("value", forms::gc(ior, c));
        case.check("value", Dielectric::new(ior).unwrap().reflectance(c));
    }
}

#[test]
fn r0_n() {
    for case in Group::read("r0_n").cases() {
        let (eta, k) = (case.input("n"), case.input("k"));
        let r0 = normal_incidence(eta, k);
        case.check("R0", r0);
        case.check("n_effective_dielectric", index_from_normal_incidence(r0).unwrap());
    }
}

#[test]
fn reflectances_at_special_angles() {
    for case in Group::read("special_angles").cases() {
        let (n1, n2) = (case.input("n1"), case.input("n2"));
        let polarized = dielectric_polarized(n2 / n1, brewster_angle(n1, n2).cos());
        case.check("R_s_at_brewster", polarized.s);
        assert!(polarized.p < 1e-31, "{n1} {n2}: {}", polarized.p);
        case.check("R0", normal_incidence(n2 / n1, 0.0));
    }
}

#[test]
fn fresnel_schlick() {
    for case in Group::read("fresnel_schlick").cases() {
        let schlick = Schlick::new(case.input("f0")).unwrap();
        case.check("F", schlick.reflectance(case.input("u")));
        case.check("F_avg", schlick.average());
    }
}

#[test]
fn fresnel_dielectric_average() {
    for case in Group::read("fresnel_dielectric_average").cases() {
        case.check("value", Dielectric::new(case.input("n")).unwrap().average());
    }
}

/// A reference curve that has one value at normal incidence and another at all other angles.
struct Reference {
    normal: f64,
    elsewhere: f64,
}

impl Fresnel<f64> for Reference {
    type Color = f64;

    fn reflectance(&self, cos_theta: f64) -> f64 {
        if cos_theta == 1.0 { self.normal } else { self.elsewhere }
    }
}

#[test]
fn fresnel_cook_hall() {
    for case in Group::read("fresnel_cook_hall").cases() {
        let reference = Reference { normal: case.input("f0_ref"), elsewhere: case.input("f_ref") };
        let hall = Hall::with_reference(case.input("f0"), reference).unwrap();
        case.check("value", hall.reflectance(0.5));
    }
}

/// Thirteen materials at three wavelengths and ten angles, computed with complex numbers.
///
/// The table has 12 digits of the reflectances and 9 of the indices, so the last digit of an index
/// decides how well a reflectance can agree.
#[test]
fn fresnel_of_measured_indices() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/fresnel_reference.csv");
    let text = std::fs::read_to_string(path).expect("the table is in the repository");
    let half_digit =
        |x: f64| if x == 0.0 { 0.0 } else { 0.5 * 10_f64.powf(x.log10().floor() - 8.0) };
    let mut rows = 0;
    for line in text.lines().filter(|line| !line.starts_with("key")) {
        let numbers: Vec<f64> =
            line.split(',').skip(2).map(|field| field.parse().expect("a number")).collect();
        let [eta, k, degrees, r_s, r_p, r] = numbers[..] else { panic!("{line}") };
        let cos = degrees.to_radians().cos();
        let reflectances = |eta: f64, k: f64| {
            let polarized = conductor_polarized(eta, k, cos);
            [polarized.s, polarized.p, Conductor::new(eta, k).unwrap().reflectance(cos)]
        };
        let got = reflectances(eta, k);
        let other_eta = reflectances(eta + half_digit(eta), k);
        let other_k = reflectances(eta, k + half_digit(k));
        for (i, want) in [r_s, r_p, r].into_iter().enumerate() {
            let allowed = 1e-12 + (other_eta[i] - got[i]).abs() + (other_k[i] - got[i]).abs();
            assert!(allowed < 5e-9, "{line}: {allowed}");
            assert!((got[i] - want).abs() <= allowed, "{line}: got {}, want {want}", got[i]);
        }
        rows += 1;
    }
    assert_eq!(rows, 390);
}

#[test]
fn a_constant_is_its_own_average() {
    let constant = Constant::new(0.3_f64).unwrap();
    assert_eq!((constant.reflectance(0.2), constant.average()), (0.3, 0.3));
}
