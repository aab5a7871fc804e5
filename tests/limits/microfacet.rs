//! What the microfacet models promise: energy, reciprocity, agreement of density and samples.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use brdf::quadrature::integrate;
use brdf::{
    Beckmann, Blinn1977, Blinn1977Printed, Brdf, Constant, CookTorrance, CookTorrance1982Printed,
    Gaussian, Ggx, Mixture, SmithCorrelated, SmithSeparable, VCavity, from_spherical, reflect,
};
use glam::{DVec3, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::hemisphere::{Model, assert_samples_follow_pdf};
use brdf_checks::directions::pairs;

fn white() -> Constant<f64> {
    Constant::new(1.0).unwrap()
}

fn viewer(degrees: f64) -> DVec3 {
    from_spherical(degrees.to_radians(), 0.0)
}

/// ∫ over facets h whose mirror direction may lie anywhere, `formula(h, wi)` times dω of `wi`,
/// for a surface that looks the same on both sides of the plane of `wo` = (sinθ, 0, cosθ).
/// Facets are counted in β with tanα = `roughness` tanβ, which spreads every lobe evenly.
fn over_mirrored(
    wo: DVec3,
    roughness: f64,
    panels: u16,
    formula: impl Fn(DVec3, DVec3) -> f64,
) -> f64 {
    let panels = |from: f64, to: f64, formula: &dyn Fn(f64) -> f64| -> f64 {
        let width = (to - from) / f64::from(panels);
        (0..panels)
            .map(|panel| from + width * f64::from(panel))
            .map(|start| integrate(start, start + width, formula))
            .sum()
    };
    2.0 * panels(0.0, FRAC_PI_2, &|beta| {
        let tan = roughness * beta.tan();
        let cos = 1.0 / (1.0 + tan * tan).sqrt();
        // sinα dα = cos³α tanα d(tanα).
        let jacobian = cos.powi(3) * tan * roughness / beta.cos().powi(2);
        jacobian
            * panels(0.0, PI, &|phi| {
                let h = DVec3::new(tan * cos * phi.cos(), tan * cos * phi.sin(), cos);
                let cos_d = wo.dot(h);
                if cos_d > 0.0 { 4.0 * cos_d * formula(h, reflect(wo, h)) } else { 0.0 }
            })
    })
}

fn exact_albedo(
    model: &impl Brdf<f64, Color = f64>,
    wo: DVec3,
    roughness: f64,
    panels: u16,
) -> f64 {
    over_mirrored(wo, roughness, panels, |_, wi| model.eval(wi, wo) * wi.z.max(0.0))
}

/// Every shadowing with every distribution that has one, for one roughness.
fn models(roughness: f64) -> Vec<(String, Model)> {
    let beckmann = CookTorrance::from_parts(Beckmann::new(roughness).unwrap(), white(), VCavity);
    let ggx = CookTorrance::from_parts(Ggx::new(roughness).unwrap(), white(), VCavity);
    let gaussian = CookTorrance::new(Gaussian::new(roughness).unwrap(), white());
    let models: Vec<(&str, Model)> = vec![
        ("Beckmann, V-cavity", Box::new(beckmann)),
        ("Gaussian, V-cavity", Box::new(gaussian)),
        ("GGX, V-cavity", Box::new(ggx)),
        ("Beckmann, Smith correlated", Box::new(beckmann.with_shadowing(SmithCorrelated))),
        ("GGX, Smith correlated", Box::new(ggx.with_shadowing(SmithCorrelated))),
        ("Beckmann, Smith separable", Box::new(beckmann.with_shadowing(SmithSeparable))),
        ("GGX, Smith separable", Box::new(ggx.with_shadowing(SmithSeparable))),
    ];
    models.into_iter().map(|(name, model)| (format!("{name} {roughness}"), model)).collect()
}

/// The default albedo, the mean weight of a lattice of samples, against the fine quadrature over facets.
#[test]
fn the_albedo_of_samples_is_that_of_the_integral() {
    let mut worst = (0.0, String::new());
    for roughness in (1..=20).map(|step| 0.05 * f64::from(step)) {
        for (name, model) in models(roughness) {
            for degrees in [0.0, 30.0, 60.0, 75.0, 80.0, 85.0, 88.0, 89.0, 89.5, 89.9] {
                let wo = viewer(degrees);
                let error = (model.albedo(wo) - exact_albedo(&model, wo, roughness, 6)).abs();
                if error > worst.0 {
                    worst = (error, format!("{name} at {degrees}°"));
                }
            }
        }
    }
    assert!(worst.0 < 6e-4, "{worst:?}");
}

/// Figures for F = 1 at 0°, 60°, 80° and 89.9°.
#[test]
fn albedo_has_the_published_values() {
    let close = |model: &dyn Brdf<f64, Color = f64>, roughness: f64, want: [f64; 4]| {
        for (degrees, want) in [0.0, 60.0, 80.0, 89.9].into_iter().zip(want) {
            let got = exact_albedo(&model, viewer(degrees), roughness, 8);
            assert!((got - want).abs() < 6e-4, "{roughness} {degrees}°: {got}, not {want}");
        }
    };
    let beckmann =
        |roughness| CookTorrance::from_parts(Beckmann::new(roughness).unwrap(), white(), VCavity);
    let ggx = |roughness| CookTorrance::from_parts(Ggx::new(roughness).unwrap(), white(), VCavity);
    let gaussian = CookTorrance::new(Gaussian::new(0.8).unwrap(), white());
    close(&beckmann(0.1), 0.1, [1.000, 0.999, 0.942, 0.998]);
    close(&beckmann(0.3), 0.3, [0.996, 0.925, 0.945, 0.999]);
    close(&beckmann(0.8), 0.8, [0.605, 0.839, 0.949, 0.9995]);
    close(&gaussian, 0.8, [0.642, 0.814, 0.939, 0.999]);
    let smith = beckmann(0.3).with_shadowing(SmithCorrelated);
    close(&smith, 0.3, [0.9997, 0.923, 0.916, 0.999]);
    let smith = ggx(0.3).with_shadowing(SmithCorrelated);
    close(&smith, 0.3, [0.877, 0.822, 0.848, 0.996]);
    let smith = ggx(1.0).with_shadowing(SmithCorrelated);
    close(&smith, 1.0, [0.30685, 0.451, 0.668, 0.989]);
    let normal = exact_albedo(&smith, DVec3::Z, 1.0, 6);
    assert!((normal - (1.0 - 2.0_f64.ln())).abs() < 1e-9, "1 − ln 2: {normal}");
    let smith = ggx(1.0).with_shadowing(SmithSeparable);
    close(&smith, 1.0, [0.307, 0.409, 0.523, 0.613]);
}

#[test]
fn the_constants_of_1982_are_four_times_too_bright() {
    let printed = CookTorrance1982Printed::new(Beckmann::new(0.1).unwrap(), white());
    let albedo = exact_albedo(&printed, DVec3::Z, 0.1, 6);
    assert!((albedo - 4.0).abs() < 1e-9, "{albedo}");
    assert!((printed.albedo(DVec3::Z) - 4.0).abs() < 1e-9);
    let modern = CookTorrance::from_parts(Beckmann::new(0.1).unwrap(), white(), VCavity);
    for (wi, wo) in pairs(1000) {
        assert_eq!(printed.eval(wi, wo), 4.0 * modern.eval(wi, wo));
        assert_eq!(printed.pdf(wi, wo), modern.pdf(wi, wo));
    }
}

/// The albedo at normal incidence of D₂ as Blinn printed it, with F = 1.
#[test]
fn the_constant_of_1977_is_too_dark_or_too_bright() {
    for (half_width, want) in [(0.1, 0.1796), (1.0, 4.0776)] {
        let distribution = Blinn1977::new(half_width).unwrap();
        let printed = Blinn1977Printed::d2(distribution, white()).unwrap();
        let albedo = exact_albedo(&printed, DVec3::Z, 1.2 * half_width, 8);
        assert!((albedo - want).abs() < 5e-4, "{half_width}: {albedo}");
        let (wi, wo) = (viewer(50.0), from_spherical(0.7, 2.0));
        assert_eq!(printed.eval(wi, wo), printed.eval(wo, wi));
        assert!((printed.specular(wi, wo) / printed.eval(wi, wo) - wi.z).abs() < 1e-15);
    }
}

/// Angles that are not those of facets above the surface, and not to be confused with what they are
/// a turn away from.
#[test]
fn the_distributions_of_1977_end_at_the_horizon() {
    for half_width in [0.1, 1.0, 1.57] {
        let blinn = Blinn1977::new(half_width).unwrap();
        assert!(blinn.d1(1.5) > 0.0 && blinn.d3(1.5) > 0.0);
        for alpha in [1.571, 2.0, PI, 4.8, 5.0, 6.0, TAU, 12.0, 1e5] {
            let densities = [blinn.d1(alpha), blinn.d2(alpha), blinn.d3(alpha)];
            assert_eq!(densities, [0.0; 3], "half-width {half_width} at {alpha}");
        }
    }
}

#[test]
fn a_sample_agrees_with_eval_and_pdf() {
    let mut rng = Pcg64Mcg::seed_from_u64(2);
    let mut worst = 0.0_f64;
    for roughness in [1e-6, 1e-3, 0.1, 0.5, 1.0, 10.0] {
        for (name, model) in models(roughness) {
            for _ in 0..5000 {
                let cos = if rng.random() {
                    rng.random()
                } else {
                    10.0_f64.powf(-20.0 * rng.random::<f64>())
                };
                let wo = from_spherical(cos.acos(), TAU * rng.random::<f64>());
                let sample = model.sample(wo, [rng.random(), rng.random()]);
                if sample.pdf == 0.0 {
                    continue;
                }
                assert_eq!(sample.pdf, model.pdf(sample.wi, wo), "{name} {wo}");
                assert!(sample.weight <= 1.0);
                let value = model.eval(sample.wi, wo);
                if !(1e-290..1e290).contains(&value) {
                    continue;
                }
                let ulps =
                    (sample.weight * sample.pdf / (value * sample.wi.z) - 1.0).abs() / f64::EPSILON;
                assert!(ulps <= 8.0, "{name} {wo}: {ulps} ulp");
                worst = worst.max(ulps);
            }
        }
    }
    println!("{worst} ulp");
}

/// A smooth surface is a mirror with the reflectance F.
#[test]
fn without_roughness_a_mirror_remains() {
    for roughness in [1e-8, 1e-6, 1e-4] {
        for (name, model) in models(roughness) {
            for degrees in [0.0, 30.0, 60.0, 80.0] {
                let wo = viewer(degrees);
                // GGX has tails ~ (roughness/tanα)²: 10⁻³ is 10 standard deviations of the others.
                let albedo = model.albedo(wo);
                assert!((albedo - 1.0).abs() < 5e-4, "{name} at {degrees}°: {albedo}");
                let sample = model.sample(wo, [0.5, 0.3]);
                let mirror = DVec3::new(-wo.x, -wo.y, wo.z);
                let off = (sample.wi - mirror).length();
                assert!(off < 4.0 * roughness + 1e-15, "{name} at {degrees}°: off by {off}");
            }
        }
    }
}

#[test]
fn samples_follow_the_density() {
    let beckmann = CookTorrance::from_parts(Beckmann::new(0.3).unwrap(), white(), VCavity);
    let ggx = CookTorrance::from_parts(Ggx::new(0.5).unwrap(), white(), VCavity);
    let gaussian = CookTorrance::new(Gaussian::new(0.4).unwrap(), white());
    let grained_beckmann =
        CookTorrance::from_parts(Beckmann::anisotropic(0.2, 0.7).unwrap(), white(), VCavity);
    let grained_ggx =
        CookTorrance::from_parts(Ggx::anisotropic(0.6, 0.2).unwrap(), white(), VCavity);
    let grained = |x, y| Beckmann::anisotropic(x, y).unwrap();
    let mixture = Mixture::new([(0.3, grained(0.15, 0.6)), (0.7, grained(0.5, 0.3))]).unwrap();
    let mixture = CookTorrance::from_parts(mixture, white(), VCavity);
    for (theta, phi) in [(0.0, 0.0), (0.7, 0.5), (1.2, 2.0), (1.5, -1.0)] {
        let wo = from_spherical(theta, phi);
        let check = |name: &str, model: &dyn Brdf<f64, Color = f64>| {
            assert_samples_follow_pdf(name, model, wo, 200_000);
        };
        check("Beckmann, V-cavity", &beckmann);
        check("GGX, V-cavity", &ggx);
        check("Gaussian, V-cavity", &gaussian);
        check("Beckmann with grain, V-cavity", &grained_beckmann);
        check("mixture with grain, V-cavity", &mixture);
        check("GGX with grain, V-cavity", &grained_ggx);
        check("Beckmann, Smith", &beckmann.with_shadowing(SmithCorrelated));
        check("GGX with grain, Smith", &grained_ggx.with_shadowing(SmithSeparable));
    }
}

/// Cosines down to 1e-20, equal and opposite directions, all roughness that is accepted.
macro_rules! sound {
    ($test:ident, $float:ident, $vector:ident) => {
        #[test]
        fn $test() {
            let cosines: [$float; 7] = [1e-20, 1e-12, 1e-7, 1e-3, 0.3, 0.9, 1.0];
            let azimuths: [$float; 5] = [0.0, 1e-7, 1.0, 3.1415925, std::$float::consts::PI];
            let direction = |cos: $float, phi: $float| {
                let sin = ((1.0 - cos) * (1.0 + cos)).max(0.0).sqrt();
                $vector::new(sin * phi.cos(), sin * phi.sin(), cos)
            };
            let fine = |value: $float| value.is_finite() && value >= 0.0;
            for roughness in [1e-8, 1e-4, 0.03, 1.0, 30.0, 1e4] {
                let white: Constant<$float> = Constant::new(1.0).unwrap();
                let beckmann =
                    CookTorrance::from_parts(Beckmann::new(roughness).unwrap(), white, VCavity);
                let ggx = CookTorrance::from_parts(Ggx::new(roughness).unwrap(), white, VCavity);
                let gaussian = CookTorrance::new(Gaussian::new(roughness).unwrap(), white);
                let models: [Box<dyn Brdf<$float, Color = $float>>; 7] = [
                    Box::new(beckmann),
                    Box::new(ggx),
                    Box::new(gaussian),
                    Box::new(beckmann.with_shadowing(SmithCorrelated)),
                    Box::new(ggx.with_shadowing(SmithCorrelated)),
                    Box::new(beckmann.with_shadowing(SmithSeparable)),
                    Box::new(ggx.with_shadowing(SmithSeparable)),
                ];
                for (index, model) in models.iter().enumerate() {
                    for cos_o in cosines {
                        for phi in azimuths {
                            let wo = direction(cos_o, phi);
                            for cos_i in cosines {
                                let wi = direction(cos_i, 0.0);
                                for wi in [wi, wo, $vector::new(-wo.x, -wo.y, wo.z)] {
                                    let (f, pdf) = (model.eval(wi, wo), model.pdf(wi, wo));
                                    let context = (index, roughness, wi, wo);
                                    assert!(fine(f) && fine(pdf), "{f} {pdf} {context:?}");
                                }
                            }
                            for u0 in [0.0, 1e-7, 0.5, 1.0 - $float::EPSILON / 2.0] {
                                for u1 in [0.0, 0.25, 0.5, 0.7, 1.0 - $float::EPSILON / 2.0] {
                                    let sample = model.sample(wo, [u0, u1]);
                                    let context = (index, roughness, wo, u0, u1, sample);
                                    assert!(fine(sample.weight), "{context:?}");
                                    assert!(sample.weight <= 1.0, "{context:?}");
                                    assert!(fine(sample.pdf), "{context:?}");
                                    assert!(sample.wi.is_finite(), "{context:?}");
                                }
                            }
                        }
                    }
                }
            }
        }
    };
}
sound!(every_answer_is_finite_in_f64, f64, DVec3);
sound!(every_answer_is_finite_in_f32, f32, Vec3);

/// Types are inferred from the colour.
#[test]
fn a_color_of_glam_decides_the_number() -> Result<(), brdf::ParameterError> {
    let gold =
        CookTorrance::from_parts(Beckmann::new(0.3)?, Constant::new(Vec3::splat(0.5))?, VCavity);
    let f = gold.eval(Vec3::Z, Vec3::Z);
    let precise =
        CookTorrance::from_parts(Beckmann::new(0.3)?, Constant::new(DVec3::splat(0.5))?, VCavity);
    assert!((f.as_dvec3() - precise.eval(DVec3::Z, DVec3::Z)).length() < 1e-6);
    let scene: Vec<Box<dyn Brdf<Color = Vec3>>> = vec![Box::new(gold)];
    assert_eq!(scene[0].eval(Vec3::Z, Vec3::Z), f);
    Ok(())
}
