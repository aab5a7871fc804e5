//! What holds of every model over the whole sphere of directions: the lines of
//! `tests/interfaces.jsonl`.

use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

use brdf::description::{BsdfDescription, forms};
use brdf::parameter::Part;
use brdf::{
    AnyBsdf, Bsdf, BsdfSample, Ggx, Lobe, RoughDielectric, SmithSeparable, TransportMode, TwoSided,
    from_spherical,
};
use glam::{DVec3, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde::Deserialize;
use serde_json::Value;

const LINES: &str = include_str!("../interfaces.jsonl");
const MODES: [TransportMode; 2] = [TransportMode::Radiance, TransportMode::Importance];

/// A model of the file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    name: String,
    bsdf: Value,
    /// The index below over that above, of what refracts.
    #[serde(default = "one")]
    ior: f64,
    /// Whether a beam keeps all its power, from whatever side the model answers for.
    #[serde(default)]
    lossless: bool,
}

fn one() -> f64 {
    1.0
}

impl Line {
    fn description(&self) -> BsdfDescription {
        serde_json::from_str(&self.bsdf.to_string()).expect(&self.name)
    }

    fn model(&self) -> AnyBsdf<f64> {
        self.description().build().expect(&self.name)
    }

    /// Whether the model answers for viewers below the surface.
    fn is_open(&self) -> bool {
        !matches!(self.model(), AnyBsdf::Opaque(_) | AnyBsdf::Mirror(_) | AnyBsdf::Plastic(_))
    }
}

fn lines() -> Vec<Line> {
    LINES.lines().map(|line| serde_json::from_str(line).expect(line)).collect()
}

/// Viewers on both sides, near the normal, at critical angles and grazing.
fn viewers() -> Vec<DVec3> {
    let critical = (1.0_f64 / 1.5).asin();
    let thetas = [0.05, 0.5, critical - 1e-3, critical + 1e-3, 1.1, 1.4, 1.55];
    let sides = thetas.into_iter().flat_map(|theta| [theta, PI - theta]);
    sides.enumerate().map(|(index, theta)| from_spherical(theta, 0.7 * index as f64)).collect()
}

/// Pairs of directions all over the sphere.
fn pairs() -> Vec<(DVec3, DVec3)> {
    let all: Vec<DVec3> = (0..40)
        .map(|index| {
            let index = f64::from(index);
            from_spherical((1.0 - (index + 0.5) / 20.0).acos(), 2.4 * index)
        })
        .collect();
    all.iter().flat_map(|wi| all.iter().map(move |wo| (*wi, *wo))).collect()
}

/// Points of the unit cube.
fn draws(count: u32) -> impl Iterator<Item = [f64; 3]> {
    let mut rng = Pcg64Mcg::seed_from_u64(3);
    (0..count).map(move |_| std::array::from_fn(|_| rng.random()))
}

#[test]
fn every_form_has_a_line() {
    let written: BTreeSet<String> = lines()
        .iter()
        .flat_map(|line| {
            line.bsdf.as_object().expect("an object").keys().cloned().collect::<Vec<_>>()
        })
        .collect();
    for (part, form) in forms() {
        assert!(part != Part::Bsdf || written.contains(form.name()), "{}", form.name());
    }
}

/// The density, the draws that give no direction and the specular draws are all there is.
#[test]
fn events_have_a_sum_of_one() {
    for line in lines() {
        let model = line.model();
        for wo in viewers() {
            if wo.z < 0.0 && !line.is_open() {
                continue;
            }
            let (mut without, mut count) = (0.0, 0.0);
            for u in draws(100_000) {
                let sample = model.sample(wo, u, TransportMode::Radiance);
                without += f64::from(u8::from(sample.pdf == 0.0));
                count += 1.0;
            }
            let mut mass = 0.0;
            over_sphere(wo, |wi, angle| mass += angle * model.pdf(wi, wo, TransportMode::Radiance));
            let sum = mass + without / count;
            let part: f64 = without / count;
            let tolerance = 5e-4 + 4.0 * (part * (1.0 - part) / count).max(0.0).sqrt();
            assert!(
                (sum - 1.0).abs() < tolerance,
                "{} {wo}: {mass} + {}",
                line.name,
                without / count
            );
        }
    }
}

/// Visits directions with the solid angles around them, crowded where the lobes of `wo` are.
fn over_sphere(wo: DVec3, mut visit: impl FnMut(DVec3, f64)) {
    const N: u32 = 480;
    // Around the mirror direction and below it, 1 − cosθ ~ x³.
    let frame = brdf::Frame::from_normal(DVec3::new(-wo.x, -wo.y, wo.z.abs()));
    for i in 0..N {
        let x = (f64::from(i) + 0.5) / f64::from(N);
        let (versine, width) = (2.0 * x.powi(3), 6.0 * x * x / f64::from(N));
        let sin = (versine * (2.0 - versine)).sqrt();
        for j in 0..N {
            let (s, c) = (TAU * (f64::from(j) + 0.5) / f64::from(N)).sin_cos();
            let w = frame.to_world(DVec3::new(sin * c, sin * s, 1.0 - versine));
            if w.z > 0.0 {
                visit(w, width * TAU / f64::from(N));
                visit(DVec3::new(w.x, w.y, -w.z), width * TAU / f64::from(N));
            }
        }
    }
}

/// Draws are distributed as the density says: in every part of the sphere as many as its integral.
#[test]
fn draws_follow_the_density() {
    const COUNT: u32 = 100_000;
    const PARTS: usize = 8;
    for line in lines().into_iter().filter(|line| line.name.contains("glass")) {
        let model = line.model();
        for wo in viewers().into_iter().skip(2).step_by(3) {
            let part = |w: DVec3| {
                let at = |x: f64| ((x * PARTS as f64) as usize).min(PARTS - 1);
                at(w.z * 0.5 + 0.5) * PARTS + at(w.y.atan2(w.x) / TAU + 0.5)
            };
            let mut drawn = [0.0; PARTS * PARTS];
            for u in draws(COUNT) {
                let BsdfSample { wi, pdf, .. } = model.sample(wo, u, TransportMode::Radiance);
                if pdf > 0.0 {
                    drawn[part(wi)] += 1.0;
                }
            }
            let mut expected = [0.0; PARTS * PARTS];
            over_sphere(wo, |wi, angle| {
                let pdf = model.pdf(wi, wo, TransportMode::Radiance);
                expected[part(wi)] += pdf * angle * f64::from(COUNT);
            });
            for (drawn, expected) in drawn.into_iter().zip(expected) {
                let off = (drawn - expected).abs();
                // The parts have edges that the integral knows to its steps.
                let tolerance = 4.0 * expected.sqrt() + 1e-3 * f64::from(COUNT);
                assert!(off < tolerance, "{} {wo}: {drawn} for {expected}", line.name);
            }
        }
    }
}

/// The weight of a draw is f cosθ/pdf, of a lobe its weight over the probability of drawing it.
#[test]
fn weights_are_values_over_densities() {
    for line in lines() {
        let model = line.model();
        for (wo, mode) in viewers().into_iter().flat_map(|wo| MODES.map(|mode| (wo, mode))) {
            let lobes = model.specular(wo, mode);
            let lobes = [lobes.reflected, lobes.transmitted];
            let (mut chosen, mut count) = ([0.0; 2], 0.0);
            for u in draws(2000) {
                let sample = model.sample(wo, u, mode);
                count += 1.0;
                if sample.specular {
                    let which =
                        lobes.iter().position(|lobe| lobe.wi == sample.wi && lobe.weight.x > 0.0);
                    let which = which.unwrap_or_else(|| panic!("{} {wo}: {sample:?}", line.name));
                    chosen[which] += sample.weight.x;
                    assert_eq!(sample.pdf, 0.0, "{} {wo}", line.name);
                } else if sample.pdf > 0.0 {
                    let (value, pdf) = model.eval_pdf(sample.wi, wo, mode);
                    assert_eq!(pdf, sample.pdf, "{} {wo} {}", line.name, sample.wi);
                    let weight = value.x * sample.wi.z.abs() / pdf;
                    let off = (weight - sample.weight.x).abs();
                    assert!(off <= 1e-6 * weight, "{} {wo}: {sample:?} {weight}", line.name);
                }
            }
            for (Lobe { weight, .. }, chosen) in lobes.iter().zip(chosen) {
                let off = (weight.x - chosen / count).abs();
                assert!(off < 0.05 * weight.x.max(1.0), "{} {wo}: {weight} {chosen}", line.name);
            }
        }
    }
}

/// Importance is the transpose of radiance to the last bit, and light that crosses is scaled by the
/// indices of both sides.
#[test]
fn radiance_and_importance_are_adjoint() {
    let mut crossing = 0;
    for line in lines() {
        let model = line.model();
        for (wi, wo) in pairs() {
            let radiance = model.eval(wi, wo, TransportMode::Radiance);
            let importance = model.eval(wi, wo, TransportMode::Importance);
            assert_eq!(importance, model.eval(wo, wi, TransportMode::Radiance), "{}", line.name);
            // f(wi, wo)/n_o² = f(wo, wi)/n_i².
            let squared = |w: DVec3| if w.z < 0.0 { line.ior * line.ior } else { 1.0 };
            let [there, back] = [radiance.x / squared(wo), importance.x / squared(wi)];
            assert!((there - back).abs() <= 4e-16 * there, "{}: {there} {back}", line.name);
            crossing += u32::from(wi.z * wo.z < 0.0 && there > 0.0);
        }
    }
    assert!(crossing > 1000, "{crossing}");
}

/// The lobe back through a refracted one leads to where it came from, with the transposed weight.
#[test]
fn specular_lobes_are_adjoint() {
    let mut seen = 0;
    for line in lines() {
        let model = line.model();
        for wo in viewers() {
            let there = model.specular(wo, TransportMode::Radiance);
            for (lobe, transmitted) in [(there.reflected, false), (there.transmitted, true)] {
                if lobe.weight.x == 0.0 {
                    continue;
                }
                let back = model.specular(lobe.wi, TransportMode::Radiance);
                let back = if transmitted { back.transmitted } else { back.reflected };
                assert!(back.wi.abs_diff_eq(wo, 1e-12), "{} {wo}: {}", line.name, back.wi);
                let squared = |w: DVec3| if w.z < 0.0 { line.ior * line.ior } else { 1.0 };
                // What the beams have of power: radiance over n² is the same all along a beam.
                let indices = squared(lobe.wi) / squared(wo);
                let [there, back] = [lobe.weight.x * indices, back.weight.x / indices];
                assert!((there / back - 1.0).abs() < 1e-10, "{} {wo}: {there} {back}", line.name);
                seen += 1;
            }
        }
    }
    assert!(seen > 100, "{seen}");
}

#[test]
fn powers_are_means_of_weights_and_no_more_than_all() {
    for line in lines() {
        let model = line.model();
        for wo in viewers() {
            let power = model.power(wo);
            let (mut sums, mut count) = ([0.0; 2], 0.0);
            for u in draws(40_000) {
                let sample = model.sample(wo, u, TransportMode::Importance);
                sums[usize::from(sample.wi.z * wo.z < 0.0)] += sample.weight.x;
                count += 1.0;
            }
            let [returned, passed] = sums.map(|sum| sum / count);
            let near = |got: f64, want: f64| (got - want).abs() < 1e-2;
            let same = near(power.reflectance.x, returned) && near(power.transmittance.x, passed);
            assert!(same, "{} {wo}: {power:?} {returned} {passed}", line.name);
            let total = power.reflectance.x + power.transmittance.x;
            let answers = wo.z > 0.0 || line.is_open();
            if line.lossless && answers {
                assert!((total - 1.0).abs() <= 1e-13, "{} {wo}: {total}", line.name);
            }
            assert!(total <= 1.0 + 1e-13, "{} {wo}: {total}", line.name);
        }
    }
}

/// Values of the literature, and of `tests/data/values.json`'s reference.
#[test]
fn rough_glass_keeps_what_is_known() {
    for (ior, theta, roughness, correlated, separable) in [
        (1.5, 0.0, 0.1, 0.9988, None),
        (1.5, 0.0, 0.5, 0.9681, None),
        (1.5, 0.0, 1.0, 0.8933, None),
        (1.5, 1.4, 0.1, 0.942, Some(0.940)),
        (1.5, 1.4, 0.5, 0.679, Some(0.750)),
        (1.5, 1.4, 1.0, 0.243, Some(0.456)),
        (1.0 / 1.5, 0.0, 0.5, 0.754, None),
        (1.0 / 1.5, 0.0, 1.0, 0.417, None),
    ] {
        let wo: DVec3 = from_spherical(theta, 0.3);
        let ggx = Ggx::new(roughness).expect("a roughness");
        let glass = RoughDielectric::new(ggx, ior).expect("an index");
        let total = |power: brdf::Power<DVec3>| power.reflectance.x + power.transmittance.x;
        let got = total(glass.power(wo));
        assert!((got - correlated).abs() < 7e-4, "{ior} {theta} {roughness}: {got}");
        if let Some(separable) = separable {
            let got = total(glass.with_shadowing(SmithSeparable).power(wo));
            assert!((got - separable).abs() < 7e-4, "{ior} {theta} {roughness}: {got}");
        }
    }
}

#[test]
fn a_model_on_two_sides_is_its_mirror_image_below() {
    for line in lines() {
        let model = line.model();
        let both = TwoSided::new(&model);
        let over = |w: DVec3| DVec3::new(w.x, w.y, -w.z);
        for (wi, wo) in pairs() {
            for mode in MODES {
                let up = |w: DVec3| if wo.z < 0.0 { over(w) } else { w };
                assert_eq!(both.eval(wi, wo, mode), model.eval(up(wi), up(wo), mode));
                assert_eq!(both.pdf(wi, wo, mode), model.pdf(up(wi), up(wo), mode));
                let [mine, theirs] = [
                    both.sample(wo, [0.3, 0.6, 0.02], mode),
                    model.sample(up(wo), [0.3, 0.6, 0.02], mode),
                ];
                assert_eq!((mine.wi, mine.weight), (up(theirs.wi), theirs.weight), "{}", line.name);
            }
        }
    }
}

/// Zero vectors, NaN, infinities, directions in the surface, and every uniform number.
#[test]
fn every_answer_is_sound() {
    let numbers =
        [0.0, 1.0, -1.0, 0.6, -0.8, 1e-30, -1e-20, 1e30, f32::MAX, f32::INFINITY, f32::NAN];
    let mut directions = Vec::new();
    for x in numbers {
        for z in numbers {
            directions.push(Vec3::new(x, 0.0, z));
            directions.push(Vec3::new(x, 0.6, z));
        }
    }
    for index in 0..40 {
        let grazing = 10_f32.powi(-index);
        directions.extend([Vec3::new(1.0, 0.0, grazing), Vec3::new(-1.0, 0.0, -grazing)]);
        directions.push(from_spherical(index as f32 * 0.08, 0.4));
    }
    let uniforms = [
        [0.0; 3],
        [1.0; 3],
        [0.3, 0.7, 1.0 - f32::EPSILON / 2.0],
        [0.3, 0.7, 0.0],
        [f32::NAN, 2.0, -1.0],
        [0.999_999_94; 3],
    ];
    let sound = |x: f32| x.is_finite() && x >= 0.0;
    for line in lines() {
        let model = line.description().build::<f32>().expect("a model");
        for (index, wo) in directions.iter().enumerate() {
            for (step, u) in uniforms.iter().enumerate() {
                let wi = directions[(7 * index + 53 * step) % directions.len()];
                for mode in MODES {
                    let (value, pdf) = model.eval_pdf(wi, *wo, mode);
                    let sample = model.sample(*wo, *u, mode);
                    let lobes = model.specular(*wo, mode);
                    let all = [
                        value.x,
                        pdf,
                        sample.weight.x,
                        sample.pdf,
                        lobes.reflected.weight.x,
                        lobes.transmitted.weight.x,
                    ];
                    let finite = sample.wi.is_finite();
                    assert!(
                        finite && all.iter().all(|x| sound(*x)),
                        "{} {wi} {wo} {u:?}",
                        line.name
                    );
                }
            }
        }
    }
}
