//! Distributions of facet normals.

use brdf::{Beckmann, Distribution, Ggx, Smith, from_spherical};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_4, PI};

use crate::common::values::{Case, Group};

fn normal(case: &Case) -> DVec3 {
    case.direction("m")
}

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
        case.check("value", ggx.density(normal(&case)));
    }
}

#[test]
fn d_anisotropic() {
    for case in Group::read("D_anisotropic").cases() {
        let (along_x, along_y) = (case.input("ax"), case.input("ay"));
        let h = normal(&case);
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
