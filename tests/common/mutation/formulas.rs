//! Formulas against reference values of 50 digits, against their integrals and their limits, over
//! numbers that err: in short what `tests/values` and `tests/limits` check over `f64`.

use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, LN_2, PI, TAU};

use brdf::fresnel::{
    conductor_polarized, dielectric_polarized, forms, index_from_normal_incidence, normal_incidence,
};
use brdf::{
    Beckmann, Blinn, Blinn1977, Blinn1977Printed, BlinnPhong, Brdf, ClassicPhong, Conductor, Cook,
    CookTorrance, CookTorrance1982Printed, Dielectric, Distribution, Frame, Fresnel, Gaussian, Ggx,
    Hall, Lambert, Mixture, OrenNayar, Pair, Phong, Schlick, SchlickPower, Shadowing, Smith,
    SmithCorrelated, SmithSeparable, VCavity, Vector, WeightedSum, brewster_angle, critical_angle,
    from_spherical, reflect, refract, to_spherical,
};
use glam::DVec3;

use super::suite::{Verdict, fail};
use crate::common::faulty::{Faulty, FaultyVector};
use crate::common::slopes::Facing;
use crate::common::values::{Case, Group};

type Formula = fn() -> Verdict;

/// All of them.
pub(super) const ALL: [(&str, Formula); 34] = [
    ("Fresnel of dielectrics", dielectrics),
    ("Fresnel of conductors", conductors),
    ("Fresnel in a, b, u", abu),
    ("Fresnel in g, c", gc),
    ("reflectance at normal incidence", at_normal_incidence),
    ("Schlick's Fresnel", schlick),
    ("average Fresnel", fresnel_averages),
    ("average Fresnel of Conductor, Hall and Cook", more_fresnel_averages),
    ("Hall and Cook", hall_and_cook),
    ("Snell's law", snell),
    ("special angles", special_angles),
    ("Frame", frames),
    ("density of Beckmann", beckmann),
    ("density of GGX", ggx),
    ("density of Gaussian", gaussian),
    ("density of Blinn", blinn),
    ("anisotropic densities", anisotropic),
    ("Blinn's distributions of 1977", blinn_1977),
    ("mixtures", mixtures),
    ("Smith's Λ", lambda),
    ("densities integrate to 1", densities),
    ("visible facets fill the projected area", furnace),
    ("shadowing", shadowing),
    ("samples of half vectors", half_vectors),
    ("visible normals of GGX", visible_ggx),
    ("visible normals of Beckmann", visible_beckmann),
    ("Cook–Torrance", cook_torrance),
    ("Cook–Torrance with Smith", smith),
    ("Phong and Blinn–Phong", phong_family),
    ("Schlick's power", schlick_power),
    ("Oren–Nayar", oren_nayar),
    ("albedo of Oren–Nayar", oren_nayar_albedo),
    ("diffuse limits", diffuse_limits),
    ("weighted sum", weighted_sum),
];

fn n(value: f64) -> Faulty {
    Faulty(value)
}

fn input(case: &Case<'_>, key: &str) -> Faulty {
    Faulty(case.input(key))
}

fn vector(w: DVec3) -> FaultyVector {
    Vector::new(Faulty(w.x), Faulty(w.y), Faulty(w.z))
}

fn direction(case: &Case<'_>, which: &str) -> FaultyVector {
    vector(case.direction(which))
}

fn same(case: &Case<'_>, key: &str, got: Faulty) -> Verdict {
    Ok(case.compare(key, got.0, case.number(key))?)
}

fn same_list<const N: usize>(case: &Case<'_>, key: &str, got: [Faulty; N]) -> Verdict {
    let want = case.output(key).as_array().expect("a list");
    for (got, want) in got.iter().zip(want) {
        case.compare(key, got.0, want.as_f64().expect("a number"))?;
    }
    Ok(())
}

fn components(w: FaultyVector) -> [Faulty; 3] {
    [w.x(), w.y(), w.z()]
}

fn near(what: &str, got: Faulty, want: f64, tolerance: f64) -> Verdict {
    let off = (got.0 - want).abs();
    if off <= tolerance { Ok(()) } else { fail(format!("{what}: {} for {want}", got.0)) }
}

fn each(group: &str, check: impl Fn(&Case<'_>) -> Verdict) -> Verdict {
    Group::read(group).cases().try_for_each(|case| check(&case))
}

fn dielectrics() -> Verdict {
    each("fresnel_dielectric", |case| {
        let ior = n(case.input("eta_t") / case.input("eta_i"));
        let cos = n(case.input("theta").cos());
        let polarized = dielectric_polarized(ior, cos);
        same(case, "R_s", polarized.s)?;
        same(case, "R_p", polarized.p)?;
        same(case, "R", polarized.unpolarized())?;
        same(case, "R", Dielectric::new(ior)?.reflectance(cos))?;
        let other_side = Dielectric::new(n(1.0 / ior.0))?;
        same(case, "R", other_side.reflectance(n(-cos.0)))
    })
}

fn conductors() -> Verdict {
    each("fresnel_conductor", |case| {
        let (eta, k) = (input(case, "n"), input(case, "k"));
        let cos = n(case.input("theta").cos());
        let polarized = conductor_polarized(eta, k, cos);
        same(case, "R_s", polarized.s)?;
        same(case, "R_p", polarized.p)?;
        same(case, "R", polarized.unpolarized())?;
        same(case, "R", Conductor::new(eta, k)?.reflectance(cos))?;
        let (a, b) = forms::ab(eta, k, cos);
        same(case, "a", a)?;
        same(case, "b", b)
    })
}

fn abu() -> Verdict {
    each("fresnel_abu", |case| {
        let (eta, k, u) = (input(case, "n"), input(case, "k"), input(case, "u"));
        same(case, "R", forms::abu(eta, k, u))?;
        same(case, "R", Conductor::new(eta, k)?.reflectance(u))
    })
}

fn gc() -> Verdict {
    each("fresnel_gc", |case| same(case, "value", forms::gc(input(case, "n"), input(case, "c"))))
}

fn at_normal_incidence() -> Verdict {
    each("r0_n", |case| {
        let r0 = normal_incidence(input(case, "n"), input(case, "k"));
        same(case, "R0", r0)?;
        same(case, "n_effective_dielectric", index_from_normal_incidence(r0)?)
    })
}

fn schlick() -> Verdict {
    each("fresnel_schlick", |case| {
        let schlick = Schlick::new(input(case, "f0"))?;
        same(case, "F", schlick.reflectance(input(case, "u")))?;
        same(case, "F_avg", schlick.average())
    })
}

fn fresnel_averages() -> Verdict {
    each("fresnel_dielectric_average", |case| {
        same(case, "value", Dielectric::new(input(case, "n"))?.average())
    })
}

/// Against the mean of the reflectances themselves.
fn more_fresnel_averages() -> Verdict {
    fn check(what: &str, fresnel: &dyn Fresnel<Faulty, Color = Faulty>) -> Verdict {
        let mean = crate::common::slopes::composite([0.0, 1.0], 8, |root| {
            4.0 * root.powi(3) * fresnel.reflectance(n(root * root)).0
        });
        near(what, fresnel.average(), mean, 1e-7)
    }
    for (eta, k) in [(0.14, 3.697), (1.5, 0.0), (2.0, 1.0)] {
        check("Conductor", &Conductor::new(n(eta), n(k))?)?;
    }
    // Total reflection beyond a critical angle makes a kink.
    let dense = Dielectric::new(n(0.6))?.average();
    near("Conductor, k = 0", Conductor::new(n(0.6), n(0.0))?.average(), dense.0, 3e-7)?;
    check("Hall", &Hall::new(n(0.6), n(1.5))?)?;
    check("Cook", &Cook::new(n(0.6), n(0.7), n(1.5))?)
}

/// A reference curve that has one value at normal incidence and another at all other angles.
struct Reference {
    normal: Faulty,
    elsewhere: Faulty,
}

impl Fresnel<Faulty> for Reference {
    type Color = Faulty;

    fn reflectance(&self, cos_theta: Faulty) -> Faulty {
        if cos_theta.0 == 1.0 { self.normal } else { self.elsewhere }
    }
}

fn hall_and_cook() -> Verdict {
    each("fresnel_cook_hall", |case| {
        let reference =
            || Reference { normal: input(case, "f0_ref"), elsewhere: input(case, "f_ref") };
        let f0 = input(case, "f0");
        same(case, "value", Hall::with_reference(f0, reference())?.reflectance(n(0.5)))?;
        let cook = Cook::with_reference(f0, n(0.5), reference())?.reflectance(n(0.5));
        same(case, "value", n(2.0 * cook.0))
    })
}

fn snell() -> Verdict {
    let normal = vector(DVec3::Z);
    each("snell_refract", |case| {
        let w = from_spherical(input(case, "theta"), input(case, "phi"));
        same_list(case, "reflected", components(reflect(w, normal)))?;
        let refraction = refract(w, normal, input(case, "n1"), input(case, "n2"));
        if case.output("tir").as_bool() == Some(true) {
            return same_list(case, "reflected", components(refraction.direction));
        }
        same_list(case, "transmitted", components(refraction.direction))?;
        same(case, "theta_t", to_spherical::<Faulty, _>(-refraction.direction).0)
    })
}

fn special_angles() -> Verdict {
    each("special_angles", |case| {
        let (n1, n2) = (input(case, "n1"), input(case, "n2"));
        same(case, "brewster", brewster_angle(n1, n2))?;
        let critical = case.output("critical").as_f64().unwrap_or(FRAC_PI_2);
        case.compare("critical", critical_angle(n1, n2).0, critical)?;
        let polarized = dielectric_polarized(n(n2.0 / n1.0), n(brewster_angle(n1, n2).0.cos()));
        same(case, "R_s_at_brewster", polarized.s)?;
        near("R_p at Brewster's angle", polarized.p, 0.0, 1e-31)
    })
}

/// Orthonormal, right-handed, with the normal along z and the tangent where it was asked for.
fn frames() -> Verdict {
    for normal in [DVec3::Z, -DVec3::Z, DVec3::new(0.3, -1.2, 0.4), DVec3::new(-2.0, 0.1, -0.7)] {
        let tangent = DVec3::new(0.2, 1.0, 0.5);
        let around = Frame::from_normal(vector(normal));
        let along = Frame::from_normal_and_tangent(vector(normal), vector(tangent));
        let toward = tangent - normal * tangent.dot(normal) / normal.length_squared();
        for (frame, tangent) in [(around, None), (along, Some(toward.normalize()))] {
            let [x, y, z] = [frame.tangent(), frame.bitangent(), frame.normal()]
                .map(|w| DVec3::from_array(components(w).map(|component| component.0)));
            let off = (x.cross(y) - z).length()
                + (z - normal.normalize()).length()
                + (x.length() - 1.0).abs()
                + (y.length() - 1.0).abs()
                + x.dot(z).abs()
                + tangent.map_or(0.0, |tangent| (x - tangent).length());
            near("axes", n(off), 0.0, 1e-14)?;
            let there = frame.to_local(frame.to_world(vector(DVec3::new(0.1, 0.2, 0.3))));
            for (got, want) in components(there).into_iter().zip([0.1, 0.2, 0.3]) {
                near("there and back", got, want, 1e-15)?;
            }
        }
    }
    Ok(())
}

fn beckmann() -> Verdict {
    each("D_beckmann", |case| {
        let h = from_spherical(input(case, "alpha"), n(0.3));
        same(case, "D", Beckmann::new(input(case, "m"))?.density(h))
    })
}

fn ggx() -> Verdict {
    each("D_ggx", |case| {
        same(case, "value", Ggx::new(input(case, "alpha_g"))?.density(direction(case, "m")))
    })
}

fn gaussian() -> Verdict {
    each("D_gaussian", |case| {
        let gaussian = Gaussian::new(input(case, "m"))?;
        same(case, "c", gaussian.density(vector(DVec3::Z)))?;
        same(case, "D", gaussian.density(from_spherical(input(case, "alpha"), n(0.3))))
    })
}

fn blinn() -> Verdict {
    each("D_blinn_phong", |case| {
        same(case, "value", Blinn::new(input(case, "n"))?.density(direction(case, "m")))
    })?;
    for roughness in [0.01, 0.3, 1.0] {
        let peak = Blinn::from_roughness(n(roughness))?.density(vector(DVec3::Z));
        let want = FRAC_1_PI / (roughness * roughness);
        near("peak of Blinn", peak, want, 1e-12 * want)?;
    }
    Ok(())
}

fn anisotropic() -> Verdict {
    each("D_anisotropic", |case| {
        let (along_x, along_y) = (input(case, "ax"), input(case, "ay"));
        let h = direction(case, "m");
        same(case, "beckmann", Beckmann::anisotropic(along_x, along_y)?.density(h))?;
        same(case, "ggx", Ggx::anisotropic(along_x, along_y)?.density(h))
    })
}

fn blinn_1977() -> Verdict {
    each("D_blinn_1977", |case| {
        let blinn = Blinn1977::new(input(case, "beta"))?;
        let alpha = input(case, "alpha");
        same(case, "c1", blinn.c1())?;
        same(case, "c2", blinn.c2())?;
        same(case, "c3", blinn.c3())?;
        same(case, "D1", blinn.d1(alpha))?;
        same(case, "D2", blinn.d2(alpha))?;
        same(case, "D3", blinn.d3(alpha))
    })
}

fn mixtures() -> Verdict {
    each("D_mixture", |case| {
        let (weights, roughness) = (case.inputs("w"), case.inputs("m"));
        let h = from_spherical(input(case, "alpha"), n(0.3));
        let w = from_spherical(input(case, "theta"), n(0.7));
        let check = |mixture: &dyn Smith<Faulty>| {
            same(case, "D", mixture.density(h))?;
            same(case, "Lambda", n(mixture.lambda_cos(w).0 / w.z().0))
        };
        let component = |i: usize| {
            (n(weights[i]), Beckmann::new(n(roughness[i])).expect("the case is in range"))
        };
        match weights.len() {
            2 => check(&Mixture::new([0, 1].map(component))?),
            3 => check(&Mixture::new([0, 1, 2].map(component))?),
            other => fail(format!("a mixture of {other}")),
        }
    })
}

fn lambda() -> Verdict {
    each("lambda_smith", |case| {
        let (roughness, w) = (input(case, "alpha_g"), from_spherical(input(case, "theta"), n(0.7)));
        same(case, "beckmann", n(Beckmann::new(roughness)?.lambda_cos(w).0 / w.z().0))?;
        same(case, "ggx", n(Ggx::new(roughness)?.lambda_cos(w).0 / w.z().0))
    })
}

fn densities() -> Verdict {
    fn check(what: &str, scale: f64, distribution: &dyn Distribution<Faulty>) -> Verdict {
        let facing = Facing::new(DVec3::Z, [scale, scale]);
        let whole =
            facing.integral(facing.chi, facing.psi, 4, |h| distribution.density(vector(h)).0 * h.z);
        near(what, n(whole), 1.0, 1e-8)
    }
    for roughness in [0.05, 0.4, 1.5] {
        check("Beckmann", roughness, &Beckmann::new(n(roughness))?)?;
        check("GGX", roughness, &Ggx::new(n(roughness))?)?;
        check("Gaussian", roughness, &Gaussian::new(n(roughness))?)?;
    }
    for exponent in [0.0, 3.0, 400.0_f64] {
        check("Blinn", (2.0 / (exponent + 2.0)).sqrt(), &Blinn::new(n(exponent))?)?;
    }
    Ok(())
}

/// ∫ (w·h)₊ D dω = N·w (1 + Λ).
fn furnace() -> Verdict {
    fn check(what: &str, scale: [f64; 2], distribution: &dyn Smith<Faulty>) -> Verdict {
        for theta in [0.3, 1.0, 1.5] {
            let wo = from_spherical(theta, 0.8);
            let facing = Facing::new(wo, scale);
            let visible = facing.integral(facing.chi, facing.psi, 3, |h| {
                distribution.density(vector(h)).0 * wo.dot(h).max(0.0)
            });
            let claimed = wo.z + distribution.lambda_cos(vector(wo)).0;
            near(what, n(claimed / visible), 1.0, 1e-8)?;
        }
        Ok(())
    }
    check("Beckmann", [0.2, 0.5], &Beckmann::anisotropic(n(0.2), n(0.5))?)?;
    check("GGX", [0.2, 0.5], &Ggx::anisotropic(n(0.2), n(0.5))?)
}

fn g<D: Distribution<Faulty>>(
    shadowing: &impl Shadowing<Faulty, D>,
    distribution: &D,
    pair: &Pair<Faulty>,
) -> Faulty {
    let cosines = 4.0 * pair.cos_i.0 * pair.cos_o.0;
    n(cosines * shadowing.visibility(distribution, pair).0)
}

/// G₁(wo, h) times G/G₁(wo, h).
fn g_of_samples<D: Distribution<Faulty>>(
    shadowing: &impl Shadowing<Faulty, D>,
    distribution: &D,
    pair: &Pair<Faulty>,
) -> Faulty {
    let g1 = 4.0 * pair.cos_o.0 * shadowing.masking(distribution, pair).0;
    n(g1 * shadowing.unshadowed(distribution, pair).0)
}

fn shadowing() -> Verdict {
    each("G_shadowing", |case| {
        let roughness = input(case, "alpha_g");
        let (beckmann, ggx) = (Beckmann::new(roughness)?, Ggx::new(roughness)?);
        let pair = Pair::new(direction(case, "i"), direction(case, "o"));
        same(case, "v_cavity", g(&VCavity, &beckmann, &pair))?;
        same(case, "beckmann_correlated", g(&SmithCorrelated, &beckmann, &pair))?;
        same(case, "beckmann_separable", g(&SmithSeparable, &beckmann, &pair))?;
        same(case, "ggx_correlated", g(&SmithCorrelated, &ggx, &pair))?;
        same(case, "ggx_separable", g(&SmithSeparable, &ggx, &pair))?;
        same(case, "v_cavity", g_of_samples(&VCavity, &beckmann, &pair))?;
        same(case, "beckmann_correlated", g_of_samples(&SmithCorrelated, &beckmann, &pair))?;
        same(case, "ggx_separable", g_of_samples(&SmithSeparable, &ggx, &pair))
    })
}

fn half_vectors() -> Verdict {
    each("sample_half_vector", |case| {
        let u = [input(case, "u1"), input(case, "u2")];
        let check = |name: &str, distribution: &dyn Distribution<Faulty>| {
            let h = distribution.sample(u);
            let (theta, phi) = to_spherical::<Faulty, _>(h);
            same(case, name, theta)?;
            if theta.0 > 0.0 {
                same(case, "phi", n(phi.0.rem_euclid(TAU)))?;
            }
            same(case, &format!("pdf_{name}"), n(distribution.density(h).0 * h.z().0))
        };
        let roughness = input(case, "alpha_g");
        check("beckmann", &Beckmann::new(roughness)?)?;
        check("ggx", &Ggx::new(roughness)?)?;
        check("blinn_phong", &Blinn::new(input(case, "n"))?)
    })
}

fn visible(case: &Case<'_>, distribution: &dyn Smith<Faulty>) -> Verdict {
    let wo = case.direction("o");
    let h = distribution.sample_visible(vector(wo), [input(case, "u1"), input(case, "u2")]);
    same_list(case, "m", components(h))?;
    let facing = wo.dot(DVec3::from_array(components(h).map(|component| component.0)));
    let seen = wo.z + distribution.lambda_cos(vector(wo)).0;
    same(case, "pdf_m", n(facing.max(0.0) * distribution.density(h).0 / seen))
}

fn visible_ggx() -> Verdict {
    each("sample_vndf_ggx_caps", |case| {
        visible(case, &Ggx::anisotropic(input(case, "ax"), input(case, "ay"))?)
    })
}

fn visible_beckmann() -> Verdict {
    each("sample_vndf_beckmann", |case| {
        visible(case, &Beckmann::anisotropic(input(case, "ax"), input(case, "ay"))?)
    })
}

fn cook_torrance() -> Verdict {
    each("brdf_cook_torrance", |case| {
        let (wi, wo) = (direction(case, "i"), direction(case, "o"));
        let m = input(case, "m");
        let (beckmann, gaussian) = (Beckmann::new(m)?, Gaussian::new(m)?);
        let glass = Dielectric::new(input(case, "n"))?;
        same(case, "f", CookTorrance::new(beckmann, glass).eval(wi, wo))?;
        let printed = CookTorrance1982Printed::new(beckmann, glass).eval(wi, wo);
        same(case, "f_cook_torrance_1982_printed", printed)?;
        let gauss = CookTorrance::new(gaussian, glass).eval(wi, wo);
        same(case, "f_torrance_sparrow_gauss", gauss)?;
        let gauss = CookTorrance::torrance_sparrow_1967(n(PI / 180.0 / m.0), glass)?;
        same(case, "f_torrance_sparrow_gauss", gauss.eval(wi, wo))?;
        let half_width = Blinn1977::new(n(m.0 * LN_2.sqrt()))?;
        let blinn = Blinn1977Printed::d2(half_width, glass)?;
        same(case, "blinn1977_s", blinn.specular(wi, wo))
    })
}

fn smith() -> Verdict {
    each("brdf_microfacet_smith", |case| {
        let (wi, wo) = (direction(case, "i"), direction(case, "o"));
        let (along_x, along_y) = (input(case, "ax"), input(case, "ay"));
        let metal = Conductor::new(input(case, "n"), input(case, "k"))?;
        let beckmann = CookTorrance::new(Beckmann::anisotropic(along_x, along_y)?, metal);
        let ggx = CookTorrance::new(Ggx::anisotropic(along_x, along_y)?, metal);
        let value = beckmann.with_shadowing(SmithCorrelated).eval(wi, wo);
        same(case, "beckmann_correlated", value)?;
        let value = beckmann.with_shadowing(SmithSeparable).eval(wi, wo);
        same(case, "beckmann_separable", value)?;
        same(case, "ggx_correlated", ggx.with_shadowing(SmithCorrelated).eval(wi, wo))?;
        same(case, "ggx_separable", ggx.with_shadowing(SmithSeparable).eval(wi, wo))
    })
}

fn phong_family() -> Verdict {
    each("phong_family", |case| {
        let (wi, wo) = (direction(case, "i"), direction(case, "o"));
        let (white, exponent) = (n(1.0), input(case, "n"));
        let classic = ClassicPhong::new(white, exponent)?.eval(wi, wo);
        same(case, "phong_1975_over_cos", classic)?;
        same(case, "phong_modified", Phong::new(white, exponent)?.eval(wi, wo))?;
        same(case, "blinn_phong_normalised", BlinnPhong::new(white, exponent)?.eval(wi, wo))?;
        same(case, "n_dot_h", BlinnPhong::unnormalized(white, n(1.0))?.eval(wi, wo))?;
        same(case, "schlick_power", SchlickPower::unnormalized(white, exponent)?.eval(wi, wo))
    })
}

fn schlick_power() -> Verdict {
    each("schlick_power", |case| {
        let (white, exponent) = (n(1.0), input(case, "h"));
        let w = vector(from_spherical(0.5 * case.input("s").acos(), 0.0));
        same(case, "value", SchlickPower::unnormalized(white, exponent)?.eval(w, w))?;
        let normal = vector(DVec3::Z);
        same(case, "norm", SchlickPower::new(white, exponent)?.eval(normal, normal))
    })
}

fn oren_nayar() -> Verdict {
    each("oren_nayar", |case| {
        let (wi, wo) = (direction(case, "i"), direction(case, "o"));
        let (rho, sigma) = (input(case, "rho"), input(case, "sigma"));
        same(case, "qualitative_033", OrenNayar::new(rho, sigma)?.eval(wi, wo))?;
        let interreflecting = OrenNayar::with_interreflection(rho, sigma)?;
        same(case, "qualitative_057", interreflecting.eval(wi, wo))
    })
}

fn oren_nayar_albedo() -> Verdict {
    each("oren_nayar_qualitative_albedo", |case| {
        let white = OrenNayar::new(n(1.0), input(case, "sigma"))?;
        same(case, "value", white.albedo(vector(from_spherical(case.input("theta"), 0.3))))
    })
}

/// Lambert's surface, and those that it is a limit of.
fn diffuse_limits() -> Verdict {
    let (wi, wo) = (vector(from_spherical(0.4, 1.0)), vector(from_spherical(1.3, 2.0)));
    type Gray = Box<dyn Brdf<Faulty, Color = Faulty>>;
    let models: [(&str, Gray); 4] = [
        ("Lambert", Box::new(Lambert::new(n(0.5))?)),
        ("Oren–Nayar, σ = 0", Box::new(OrenNayar::new(n(0.5), n(0.0))?)),
        ("Phong, n = 0", Box::new(Phong::new(n(0.5), n(0.0))?)),
        ("Blinn–Phong, n = 0", Box::new(BlinnPhong::new(n(0.5), n(0.0))?)),
    ];
    for (what, model) in models {
        near(what, model.eval(wi, wo), 0.5 * FRAC_1_PI, 1e-15)?;
    }
    Ok(())
}

/// Weights that do not add up to 1: the probabilities still do, and each is met by as many numbers.
fn weighted_sum() -> Verdict {
    let lobe = |exponent| Phong::new(vector(DVec3::ONE), n(exponent));
    let terms = [(0.3, 4.0), (0.9, 40.0)];
    let sum = WeightedSum::new([
        (vector(DVec3::splat(terms[0].0)), lobe(terms[0].1)?),
        (vector(DVec3::splat(terms[1].0)), lobe(terms[1].1)?),
    ])?;
    let (wi, wo) = (from_spherical(0.5, 0.2), from_spherical(0.4, 3.2));
    let cos = reflect(wi, DVec3::Z).dot(wo);
    let (mut value, mut pdf) = (0.0, 0.0);
    for (weight, exponent) in terms {
        value += weight * (exponent + 2.0) / TAU * cos.powf(exponent);
        pdf += weight / 1.2 * (exponent + 1.0) / TAU * cos.powf(exponent);
    }
    near("f", sum.eval(vector(wi), vector(wo)).x(), value, 1e-14 * value)?;
    near("density", sum.pdf(vector(wi), vector(wo)), pdf, 1e-14 * pdf)?;
    // The first term takes the first quarter of the numbers, and all of each lobe is drawn.
    for (u, versine) in [(0.125, 1.0 - 0.5_f64.powf(0.2)), (0.625, 1.0 - 0.5_f64.powf(1.0 / 41.0))]
    {
        let normal = vector(DVec3::Z);
        let drawn = sum.sample(normal, [n(u), n(0.1)]).wi;
        near("sample", drawn.z(), 1.0 - versine, 1e-14)?;
    }
    Ok(())
}
