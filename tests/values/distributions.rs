//! Distributions of facet normals.

use brdf::{
    Beckmann, Blinn, Blinn1977, Distribution, Gaussian, Ggx, Mixture, Smith, from_spherical,
    to_spherical,
};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_4, PI, TAU};

use crate::common::values::Group;

#[test]
fn d_beckmann() {
    for case in Group::read("D_beckmann").cases() {
        let beckmann = Beckmann::new(case.input("m")).unwrap();
        let density = beckmann.density(from_spherical(case.input("alpha"), 0.3));
        case.check("D", density);
        case.check("D_lecture", FRAC_PI_4 * density);
        case.check("D_cook_torrance", PI * density);
    }
}

#[test]
fn d_ggx() {
    for case in Group::read("D_ggx").cases() {
        let ggx = Ggx::new(case.input("alpha_g")).unwrap();
        case.check("value", ggx.density(case.direction("m")));
    }
}

#[test]
fn d_anisotropic() {
    for case in Group::read("D_anisotropic").cases() {
        let (along_x, along_y) = (case.input("ax"), case.input("ay"));
        let h = case.direction("m");
        let beckmann = Beckmann::anisotropic(along_x, along_y).unwrap().density(h);
        let ggx = Ggx::anisotropic(along_x, along_y).unwrap().density(h);
        case.check("beckmann", beckmann);
        case.check("ggx", ggx);
        case.check("P22_beckmann", beckmann * h.z.powi(4));
        case.check("P22_ggx", ggx * h.z.powi(4));
    }
}

#[test]
fn lambda_smith() {
    for case in Group::read("lambda_smith").cases() {
        let (roughness, w) = (case.input("alpha_g"), from_spherical(case.input("theta"), 0.7));
        let beckmann = Beckmann::new(roughness).unwrap().lambda_cos(w) / w.z;
        let ggx = Ggx::new(roughness).unwrap().lambda_cos(w) / w.z;
        case.check("beckmann", beckmann);
        // Exact, and not Walter's rational fit, which is cut off to zero for small angles.
        let rational = case.output("beckmann_rational").as_f64().unwrap();
        assert!((beckmann - rational).abs() > 1e-12 * beckmann);
        case.check("ggx", ggx);
        case.check("G1_beckmann", 1.0 / (1.0 + beckmann));
        case.check("G1_ggx", 1.0 / (1.0 + ggx));
    }
}

/// G₁ (wo·h) D / (N·wo): the density of the normals visible from `wo`.
fn visible_density(distribution: &impl Smith<f64>, wo: DVec3, h: DVec3) -> f64 {
    wo.dot(h).max(0.0) * distribution.density(h) / (wo.z + distribution.lambda_cos(wo))
}

#[test]
fn sample_vndf_ggx_caps() {
    for case in Group::read("sample_vndf_ggx_caps").cases() {
        let ggx = Ggx::anisotropic(case.input("ax"), case.input("ay")).unwrap();
        let wo = case.direction("o");
        let h = ggx.sample_visible(wo, [case.input("u1"), case.input("u2")]);
        case.check_list("m", &h.to_array());
        case.check("pdf_m", visible_density(&ggx, wo, h));
    }
}

#[test]
fn sample_vndf_beckmann() {
    for case in Group::read("sample_vndf_beckmann").cases() {
        let beckmann = Beckmann::anisotropic(case.input("ax"), case.input("ay")).unwrap();
        let wo = case.direction("o");
        let h = beckmann.sample_visible(wo, [case.input("u1"), case.input("u2")]);
        case.check_list("m", &h.to_array());
        case.check("pdf_m", visible_density(&beckmann, wo, h));
    }
}

#[test]
fn d_gaussian() {
    for case in Group::read("D_gaussian").cases() {
        let gaussian = Gaussian::new(case.input("m")).unwrap();
        case.check("c", gaussian.density(DVec3::Z));
        case.check("D", gaussian.density(from_spherical(case.input("alpha"), 0.3)));
    }
}

#[test]
fn d_blinn_phong() {
    for case in Group::read("D_blinn_phong").cases() {
        let blinn = Blinn::new(case.input("n")).unwrap();
        case.check("value", blinn.density(case.direction("m")));
    }
}

#[test]
fn d_blinn_1977() {
    for case in Group::read("D_blinn_1977").cases() {
        let blinn = Blinn1977::new(case.input("beta")).unwrap();
        let alpha = case.input("alpha");
        case.check("c1", blinn.c1());
        case.check("c2", blinn.c2());
        case.check("c3", blinn.c3());
        case.check("D1", blinn.d1(alpha));
        case.check("D2", blinn.d2(alpha));
        case.check("D3", blinn.d3(alpha));
    }
}

#[test]
fn d_mixture() {
    for case in Group::read("D_mixture").cases() {
        let (weights, roughness) = (case.inputs("w"), case.inputs("m"));
        let component = |i: usize| (weights[i], Beckmann::new(roughness[i]).unwrap());
        let (h, w) =
            (from_spherical(case.input("alpha"), 0.3), from_spherical(case.input("theta"), 0.7));
        let check = |mixture: &dyn Smith<f64>| {
            case.check("D", mixture.density(h));
            case.check("Lambda", mixture.lambda_cos(w) / w.z);
        };
        match weights.len() {
            2 => check(&Mixture::new([0, 1].map(component)).unwrap()),
            3 => check(&Mixture::new([0, 1, 2].map(component)).unwrap()),
            other => panic!("a mixture of {other}"),
        }
    }
}

#[test]
fn sample_half_vector() {
    for case in Group::read("sample_half_vector").cases() {
        let u = [case.input("u1"), case.input("u2")];
        let check = |name: &str, distribution: &dyn Distribution<f64>| {
            let h = distribution.sample(u);
            let (theta, phi) = to_spherical(h);
            case.check(name, theta);
            if theta > 0.0 {
                case.check("phi", phi.rem_euclid(TAU));
            }
            case.check(&format!("pdf_{name}"), distribution.density(h) * h.z);
        };
        let roughness = case.input("alpha_g");
        check("beckmann", &Beckmann::new(roughness).unwrap());
        check("ggx", &Ggx::new(roughness).unwrap());
        check("blinn_phong", &Blinn::new(case.input("n")).unwrap());
    }
}
