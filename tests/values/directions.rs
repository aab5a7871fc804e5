use brdf::{brewster_angle, critical_angle, from_spherical, reflect, refract, to_spherical};
use glam::DVec3;
use std::f64::consts::FRAC_PI_2;

use crate::common::values::Group;

#[test]
fn snell_refract() {
    for case in Group::read("snell_refract").cases() {
        let w = from_spherical(case.input("theta"), case.input("phi"));
        case.check_list("reflected", &reflect(w, DVec3::Z).to_array());
        let refraction = refract(w, DVec3::Z, case.input("n1"), case.input("n2"));
        assert_eq!(Some(refraction.total_internal_reflection), case.output("tir").as_bool());
        if refraction.total_internal_reflection {
            assert_eq!(refraction.direction, reflect(w, DVec3::Z));
        } else {
            case.check_list("transmitted", &refraction.direction.to_array());
            case.check("theta_t", to_spherical(-refraction.direction).0);
        }
    }
}

#[test]
fn special_angles() {
    for case in Group::read("special_angles").cases() {
        let (n1, n2) = (case.input("n1"), case.input("n2"));
        case.check("brewster", brewster_angle(n1, n2));
        let critical = case.output("critical").as_f64().unwrap_or(FRAC_PI_2);
        case.check_number("critical", critical_angle(n1, n2), critical);
    }
}
