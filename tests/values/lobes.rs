use std::f64::consts::{FRAC_1_PI, PI};

use brdf::{BlinnPhong, Brdf, ClassicPhong, OrenNayar, Phong, SchlickPower, from_spherical};
use glam::DVec3;

use crate::common::values::{Case, Group};

/// The value of a model of one channel.
fn value(model: &impl Brdf<f64, Color = f64>, wi: DVec3, wo: DVec3) -> f64 {
    model.eval(wi, wo)
}

#[test]
fn phong_family() {
    for case in Group::read("phong_family").cases() {
        let (wi, wo, n) = (case.direction("i"), case.direction("o"), case.input("n"));
        let phong = |n| ClassicPhong::new(1.0, n).unwrap();
        let blinn = |n| BlinnPhong::unnormalized(1.0, n).unwrap();
        // Exponent 1 is the cosine itself.
        case.check("r_dot_v", value(&phong(1.0), wi, wo) * wi.z);
        case.check("n_dot_h", value(&blinn(1.0), wi, wo));
        case.check("phong_1975_over_cos", value(&phong(n), wi, wo));
        case.check("phong_modified", value(&Phong::new(1.0, n).unwrap(), wi, wo));
        case.check("blinn_phong_normalised", value(&BlinnPhong::new(1.0, n).unwrap(), wi, wo));
        case.check("blinn_phong_8pi", value(&blinn(n), wi, wo) * (n + 8.0) / (8.0 * PI));
        let schlick = SchlickPower::unnormalized(1.0, n).unwrap();
        case.check("schlick_power", value(&schlick, wi, wo));
    }
}

/// Light and viewer in one plane with the normal, the viewer off the mirror direction by β.
fn in_plane(beta: f64) -> (DVec3, DVec3) {
    (from_spherical(0.5 * beta, 0.0), from_spherical(0.5 * beta, 0.0))
}

#[test]
fn phong_half_angle_relation() {
    for case in Group::read("phong_half_angle_relation").cases() {
        let h = case.input("h");
        let (wi, wo) = in_plane(case.input("beta"));
        let phong = ClassicPhong::new(1.0, h).unwrap();
        let blinn = BlinnPhong::unnormalized(1.0, 4.0 * h).unwrap();
        case.check("lhs", value(&phong, wi, wo) * wi.z);
        case.check("rhs", value(&blinn, wi, wo));
    }
}

#[test]
fn schlick_power() {
    for case in Group::read("schlick_power").cases() {
        let h = case.input("h");
        let (wi, wo) = in_plane(case.input("s").acos());
        case.check("value", value(&SchlickPower::unnormalized(1.0, h).unwrap(), wi, wo));
        let peak = value(&SchlickPower::new(1.0, h).unwrap(), DVec3::Z, DVec3::Z);
        case.check("norm", peak);
    }
}

fn oren_nayar_pair(case: &Case<'_>, rho: f64) -> [OrenNayar<f64, f64>; 2] {
    let sigma = case.input("sigma");
    [OrenNayar::new(rho, sigma).unwrap(), OrenNayar::with_interreflection(rho, sigma).unwrap()]
}

#[test]
fn oren_nayar() {
    for case in Group::read("oren_nayar").cases() {
        let (wi, wo) = (case.direction("i"), case.direction("o"));
        let [direct, with_interreflection] = oren_nayar_pair(&case, case.input("rho"));
        case.check("qualitative_033", value(&direct, wi, wo));
        case.check("qualitative_057", value(&with_interreflection, wi, wo));

        let [white, _] = oren_nayar_pair(&case, 1.0);
        let a = value(&white, DVec3::Z, DVec3::Z) / FRAC_1_PI;
        case.check("A", a);
        // Back to the light from 45°, sinα tanβ = 1/√2.
        let w = DVec3::new(0.5_f64.sqrt(), 0.0, 0.5_f64.sqrt());
        case.check("B", (value(&white, w, w) / FRAC_1_PI - a) * 2.0_f64.sqrt());
    }
}

#[test]
fn oren_nayar_qualitative_albedo() {
    for case in Group::read("oren_nayar_qualitative_albedo").cases() {
        let [white, _] = oren_nayar_pair(&case, 1.0);
        case.check("value", white.albedo(from_spherical(case.input("theta"), 0.3)));
    }
}
