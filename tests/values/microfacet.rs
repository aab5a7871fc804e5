use std::f64::consts::{LN_2, PI};

use brdf::{
    Beckmann, Blinn1977, Blinn1977Printed, Brdf, Conductor, CookTorrance, CookTorrance1982Printed,
    Dielectric, Distribution, Fresnel, Gaussian, Ggx, Pair, Shadowing, SmithCorrelated,
    SmithSeparable, VCavity, reflect,
};
use glam::DVec3;

use crate::common::values::Group;

fn g<D: Distribution<f64>>(
    shadowing: &impl Shadowing<f64, D>,
    distribution: &D,
    pair: &Pair<f64>,
) -> f64 {
    4.0 * pair.cos_i * pair.cos_o * shadowing.visibility(distribution, pair)
}

/// G₁(wo, h), for the half vector of the pair.
fn g1<D: Distribution<f64>>(
    shadowing: &impl Shadowing<f64, D>,
    distribution: &D,
    pair: &Pair<f64>,
) -> f64 {
    4.0 * pair.cos_o * shadowing.masking(distribution, pair)
}

/// The columns `schlick_k` and `schlick` belong to Schlick's model of 1994, `implicit` is
/// (N·L)(N·V) without a model; neither is a shadowing of this module.
#[test]
fn shadowing() {
    for case in Group::read("G_shadowing").cases() {
        let roughness = case.input("alpha_g");
        let beckmann = Beckmann::new(roughness).unwrap();
        let ggx = Ggx::new(roughness).unwrap();
        let pair = Pair::new(case.direction("i"), case.direction("o"));
        case.check("v_cavity", g(&VCavity, &beckmann, &pair));
        case.check("beckmann_correlated", g(&SmithCorrelated, &beckmann, &pair));
        case.check("beckmann_separable", g(&SmithSeparable, &beckmann, &pair));
        case.check("ggx_correlated", g(&SmithCorrelated, &ggx, &pair));
        case.check("ggx_separable", g(&SmithSeparable, &ggx, &pair));

        // The weight of a sample is the same G over G₁.
        let exchanged = Pair::new(pair.wo, pair.wi);
        let smaller = g1(&VCavity, &beckmann, &pair).min(g1(&VCavity, &beckmann, &exchanged));
        case.check("v_cavity", smaller);
        let product = VCavity.unshadowed(&beckmann, &pair) * g1(&VCavity, &beckmann, &pair);
        case.check("v_cavity", product);
        let product =
            SmithCorrelated.unshadowed(&beckmann, &pair) * g1(&SmithCorrelated, &beckmann, &pair);
        case.check("beckmann_correlated", product);
        let product = SmithSeparable.unshadowed(&ggx, &pair) * g1(&SmithSeparable, &ggx, &pair);
        case.check("ggx_separable", product);
    }
}

/// The group draws with a third number; the facet is then the one of the distribution or its twin
/// on the other side of the groove.
#[test]
fn visible_normals_of_v_cavities() {
    for case in Group::read("sample_vndf_vcavity").cases() {
        let beckmann = Beckmann::new(case.input("m")).unwrap();
        let wo = case.direction("o");
        let [u1, u2, u3] = ["u1", "u2", "u3"].map(|key| case.input(key));
        let facet = beckmann.sample([u1, u2]);
        let twin = DVec3::new(-facet.x, -facet.y, facet.z);
        // Density of a normal to be drawn, over the density of its pair of facets.
        let share = |h: DVec3| {
            let pair = Pair::new(reflect(wo, h), wo);
            let density = 4.0 * wo.dot(h).max(0.0) * VCavity.masking(&beckmann, &pair);
            0.5 * density / h.z
        };
        case.check("prob_keep", share(facet));
        let drawn = if u3 < share(facet) { facet } else { twin };
        case.check_list("m", &drawn.to_array());
        case.check("pdf_m", 2.0 * share(drawn) * beckmann.density(drawn) * drawn.z);

        // Two numbers: the same tilt, whatever the second.
        for other in [0.0, 0.3, u2, u3] {
            let h = VCavity.sample_visible(&beckmann, wo, [u1, other]);
            case.check_number("tilt", h.z, drawn.z);
        }
    }
}

#[test]
fn cook_torrance() {
    for case in Group::read("brdf_cook_torrance").cases() {
        let (wi, wo) = (case.direction("i"), case.direction("o"));
        let m = case.input("m");
        let (beckmann, gaussian) = (Beckmann::new(m).unwrap(), Gaussian::new(m).unwrap());
        let glass = Dielectric::new(case.input("n")).unwrap();
        case.check("f", CookTorrance::new(beckmann, glass).eval(wi, wo));
        let printed = CookTorrance1982Printed::new(beckmann, glass).eval(wi, wo);
        case.check("f_cook_torrance_1982_printed", printed);
        let gauss = CookTorrance::new(gaussian, glass).eval(wi, wo);
        case.check("f_torrance_sparrow_gauss", gauss);
        let per_degree = PI / 180.0 / m;
        let gauss = CookTorrance::torrance_sparrow_1967(per_degree, glass).unwrap();
        case.check("f_torrance_sparrow_gauss", gauss.eval(wi, wo));
        // The group's D2 = exp(−(α/m)²) is ½ at m √ln2.
        let half_width = Blinn1977::new(m * LN_2.sqrt()).unwrap();
        let blinn = Blinn1977Printed::d2(half_width, glass).unwrap();
        case.check("blinn1977_s", blinn.specular(wi, wo));

        // F/π · D G/((N·L)(N·V)) with D = exp(−tan²α/m²)/(4 m² cos⁴α).
        let pair = Pair::<f64>::new(wi, wo);
        let tan_squared = (pair.h.x.powi(2) + pair.h.y.powi(2)) / pair.cos_h.powi(2);
        let density = (-tan_squared / m.powi(2)).exp() / (4.0 * m.powi(2) * pair.cos_h.powi(4));
        let gamma = 2.0 * pair.cos_h / pair.cos_d;
        let g = (gamma * pair.cos_i).min(gamma * pair.cos_o).min(1.0);
        let fresnel = Fresnel::<f64>::reflectance(&glass, pair.cos_d);
        case.check("f_lecture_beckmann", fresnel / PI * density * g / (pair.cos_i * pair.cos_o));
    }
}

#[test]
fn smith() {
    for case in Group::read("brdf_microfacet_smith").cases() {
        let (wi, wo) = (case.direction("i"), case.direction("o"));
        let (along_x, along_y) = (case.input("ax"), case.input("ay"));
        let beckmann = Beckmann::anisotropic(along_x, along_y).unwrap();
        let ggx = Ggx::anisotropic(along_x, along_y).unwrap();
        let metal = Conductor::new(case.input("n"), case.input("k")).unwrap();
        case.check("F", Fresnel::<f64>::reflectance(&metal, Pair::new(wi, wo).cos_d));
        let beckmann = CookTorrance::new(beckmann, metal);
        let ggx = CookTorrance::new(ggx, metal);
        let correlated = beckmann.with_shadowing(SmithCorrelated);
        case.check("beckmann_correlated", correlated.eval(wi, wo));
        let separable = beckmann.with_shadowing(SmithSeparable);
        case.check("beckmann_separable", separable.eval(wi, wo));
        let correlated = ggx.with_shadowing(SmithCorrelated);
        case.check("ggx_correlated", correlated.eval(wi, wo));
        let separable = ggx.with_shadowing(SmithSeparable);
        case.check("ggx_separable", separable.eval(wi, wo));
    }
}
