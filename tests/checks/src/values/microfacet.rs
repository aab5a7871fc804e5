//! Shadowing, and the models of microfacets.

use std::f64::consts::{LN_2, PI};

use brdf::{
    Beckmann, Blinn1977, Blinn1977Printed, Brdf, Conductor, CookTorrance, CookTorrance1982Printed,
    Dielectric, Distribution, Fresnel, Gaussian, Ggx, Pair, Shadowing, SmithCorrelated,
    SmithSeparable, VCavity, reflect,
};
use glam::DVec3;

use super::reference::each;
use super::{Check, Number, Verdict, plain, vector};

pub(super) fn all<T: Number>() -> [Check; 4] {
    [
        ("shadowing", shadowing::<T>),
        ("visible normals of V-cavities", visible_v_cavities::<T>),
        ("Cook–Torrance", cook_torrance::<T>),
        ("Cook–Torrance with Smith", smith::<T>),
    ]
}

fn g<T: Number, D: Distribution<T>>(
    shadowing: &impl Shadowing<T, D>,
    normals: &D,
    pair: &Pair<T>,
) -> f64 {
    shadowing.g(normals, pair).into()
}

/// G₁(wo, h), for the half vector of the pair.
fn g1<T: Number, D: Distribution<T>>(
    shadowing: &impl Shadowing<T, D>,
    normals: &D,
    pair: &Pair<T>,
) -> f64 {
    shadowing.g1(normals, pair).into()
}

/// The same G as G₁ times the weight of a sample.
fn g_of_samples<T: Number, D: Distribution<T>>(
    shadowing: &impl Shadowing<T, D>,
    normals: &D,
    pair: &Pair<T>,
) -> f64 {
    let unshadowed: f64 = shadowing.unshadowed(normals, pair).into();
    g1(shadowing, normals, pair) * unshadowed
}

/// The columns `schlick_k` and `schlick` belong to Schlick's model of 1994, `implicit` is
/// (N·L)(N·V) without a model; neither is a shadowing of this module.
fn shadowing<T: Number>() -> Verdict {
    each("G_shadowing", |case| {
        let roughness = case.input::<T>("alpha_g");
        let (beckmann, ggx) = (Beckmann::new(roughness)?, Ggx::new(roughness)?);
        let pair = Pair::<T>::new(case.vector::<T>("i"), case.vector::<T>("o"));
        case.same("v_cavity", g(&VCavity, &beckmann, &pair))?;
        case.same("beckmann_correlated", g(&SmithCorrelated, &beckmann, &pair))?;
        case.same("beckmann_separable", g(&SmithSeparable, &beckmann, &pair))?;
        case.same("ggx_correlated", g(&SmithCorrelated, &ggx, &pair))?;
        case.same("ggx_separable", g(&SmithSeparable, &ggx, &pair))?;
        case.same("v_cavity", g_of_samples(&VCavity, &beckmann, &pair))?;
        case.same("beckmann_correlated", g_of_samples(&SmithCorrelated, &beckmann, &pair))?;
        case.same("ggx_separable", g_of_samples(&SmithSeparable, &ggx, &pair))?;
        let exchanged = Pair::<T>::new(pair.wo, pair.wi);
        let smaller = g1(&VCavity, &beckmann, &pair).min(g1(&VCavity, &beckmann, &exchanged));
        case.same("v_cavity", smaller)
    })
}

/// The group draws with a third number; the facet is then the one of the distribution or its twin
/// on the other side of the groove.
fn visible_v_cavities<T: Number>() -> Verdict {
    each("sample_vndf_vcavity", |case| {
        let beckmann = Beckmann::new(case.input::<T>("m"))?;
        let wo = case.direction("o");
        let [u1, u2, u3] = ["u1", "u2", "u3"].map(|key| case.number(key));
        let facet = plain::<T>(beckmann.sample([T::lit(u1), T::lit(u2)]));
        let twin = DVec3::new(-facet.x, -facet.y, facet.z);
        // Density of a normal to be drawn, over the density of its pair of facets.
        let share = |h: DVec3| {
            let seen = vector::<T>(wo);
            let pair = Pair::<T>::new(reflect::<T, _>(seen, vector::<T>(h)), seen);
            let masking: f64 = VCavity.masking(&beckmann, &pair).into();
            0.5 * 4.0 * wo.dot(h).max(0.0) * masking / h.z
        };
        case.same("prob_keep", share(facet))?;
        let drawn = if u3 < share(facet) { facet } else { twin };
        case.same_vector::<f64>("m", drawn)?;
        let density: f64 = beckmann.density(vector::<T>(drawn)).into();
        case.same("pdf_m", 2.0 * share(drawn) * density * drawn.z)?;
        // Two numbers: the same tilt, whatever the second.
        for other in [0.0, 0.3, u2, u3] {
            let u = [u1, other].map(T::lit);
            let h = VCavity.sample_visible(&beckmann, vector::<T>(wo), u);
            case.compare("tilt", plain::<T>(h).z, drawn.z)?;
        }
        Ok(())
    })
}

fn cook_torrance<T: Number>() -> Verdict {
    each("brdf_cook_torrance", |case| {
        let (wi, wo) = (case.vector::<T>("i"), case.vector::<T>("o"));
        let m = case.number("m");
        let (beckmann, gaussian) = (Beckmann::new(T::lit(m))?, Gaussian::new(T::lit(m))?);
        let glass = Dielectric::new(case.input::<T>("n"))?;
        case.same("f", CookTorrance::from_parts(beckmann, glass, VCavity).eval(wi, wo))?;
        let printed = CookTorrance1982Printed::new(beckmann, glass).eval(wi, wo);
        case.same("f_cook_torrance_1982_printed", printed)?;
        let gauss = CookTorrance::from_parts(gaussian, glass, VCavity).eval(wi, wo);
        case.same("f_torrance_sparrow_gauss", gauss)?;
        let gauss = CookTorrance::torrance_sparrow_1967(T::lit(PI / 180.0 / m), glass)?;
        case.same("f_torrance_sparrow_gauss", gauss.eval(wi, wo))?;
        // The group's D2 = exp(−(α/m)²) is ½ at m √ln2.
        let half_width = Blinn1977::new(T::lit(m * LN_2.sqrt()))?;
        let blinn = Blinn1977Printed::d2(half_width, glass)?;
        case.same("blinn1977_s", blinn.specular(wi, wo))?;

        // F/π · D G/((N·L)(N·V)) with D = exp(−tan²α/m²)/(4 m² cos⁴α).
        let pair = Pair::<f64>::new(case.direction("i"), case.direction("o"));
        let tan_squared = (pair.h.x.powi(2) + pair.h.y.powi(2)) / pair.cos_h.powi(2);
        let density = (-tan_squared / m.powi(2)).exp() / (4.0 * m.powi(2) * pair.cos_h.powi(4));
        let gamma = 2.0 * pair.cos_h / pair.cos_d;
        let g = (gamma * pair.cos_i).min(gamma * pair.cos_o).min(1.0);
        let fresnel: f64 = Fresnel::<T>::reflectance(&glass, T::lit(pair.cos_d)).into();
        case.same("f_lecture_beckmann", fresnel / PI * density * g / (pair.cos_i * pair.cos_o))
    })
}

fn smith<T: Number>() -> Verdict {
    each("brdf_microfacet_smith", |case| {
        let (wi, wo) = (case.vector::<T>("i"), case.vector::<T>("o"));
        let (along_x, along_y) = (case.input::<T>("ax"), case.input::<T>("ay"));
        let metal = Conductor::new(case.input::<T>("n"), case.input("k"))?;
        case.same("F", Fresnel::<T>::reflectance(&metal, Pair::<T>::new(wi, wo).cos_d))?;
        let beckmann = CookTorrance::new(Beckmann::anisotropic(along_x, along_y)?, metal);
        let ggx = CookTorrance::new(Ggx::anisotropic(along_x, along_y)?, metal);
        let value = beckmann.with_shadowing(SmithCorrelated).eval(wi, wo);
        case.same("beckmann_correlated", value)?;
        let value = beckmann.with_shadowing(SmithSeparable).eval(wi, wo);
        case.same("beckmann_separable", value)?;
        case.same("ggx_correlated", ggx.with_shadowing(SmithCorrelated).eval(wi, wo))?;
        case.same("ggx_separable", ggx.with_shadowing(SmithSeparable).eval(wi, wo))
    })
}
