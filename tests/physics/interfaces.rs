//! What holds of every model over the whole sphere of directions: the lines of
//! `tests/interfaces.jsonl`.

use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

use brdf::description::{BsdfDescription, forms};
use brdf::parameter::Part;
use brdf::{
    AnyBsdf, BelcourBarla, Brdf, Bsdf, BsdfSample, ClassicPhong, Frame, Fresnel, Ggx, Lambert,
    Lobe, Mirror, Opaque, RoughDielectric, SmithSeparable, TransportMode, TwoSided, from_spherical,
};
use brdf_checks::measure::sampling::chi_squared::{compare, least_of};
use glam::{DVec2, DVec3, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;
use serde::Deserialize;
use serde_json::Value;

const LINES: &str = include_str!("../interfaces.jsonl");
const MODES: [TransportMode; 2] = [TransportMode::Radiance, TransportMode::Importance];

/// A model of the file.
#[derive(Clone, Deserialize)]
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
    /// The largest power of the viewers below over that of the beam, to three digits, where a model is known
    /// to exceed it.
    #[serde(default = "one")]
    gain: f64,
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

    /// Whether the model scatters into all directions of both sides.
    fn is_rough(&self) -> bool {
        let rough = matches!(self.model(), AnyBsdf::RoughBeckmann(_) | AnyBsdf::RoughGgx(_));
        rough && self.ior != 1.0 && !self.lossless || self.is_wave()
    }

    /// Whether the model is one of wave optics that scatters around its lobe.
    fn is_wave(&self) -> bool {
        let wave = matches!(self.model(), AnyBsdf::BeckmannKirchhoff(_) | AnyBsdf::He1991(_));
        let pair = from_spherical(0.3, 0.0);
        wave && self.model().eval(pair, pair, TransportMode::Radiance) != DVec3::ZERO
    }

    /// Whether the model answers for viewers below the surface.
    fn is_open(&self) -> bool {
        !matches!(
            self.model(),
            AnyBsdf::Opaque(_)
                | AnyBsdf::Mirror(_)
                | AnyBsdf::Plastic(_)
                | AnyBsdf::BeckmannKirchhoff(_)
                | AnyBsdf::He1991(_)
        )
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

/// Draws are distributed as the density says, on both sides of the surface, at critical angles and grazing:
/// Pearson's χ² in cells that follow the lobes, one more for draws that are specular or give no direction.
/// The expectation of that one is 1 − ∫ pdf dω: with it the probabilities of all events have the sum 1.
#[test]
fn draws_follow_the_density() {
    const COUNT: u32 = 200_000;
    let cases: Vec<(Line, DVec3)> = lines()
        .into_iter()
        .filter(Line::is_rough)
        .flat_map(|line| viewers().into_iter().map(move |wo| (line.clone(), wo)))
        // Sums of many orders take their time.
        .filter(|(line, wo)| !line.is_wave() || (0.1..0.745).contains(&wo.z))
        .collect();
    assert!(cases.len() > 80, "{}", cases.len());
    let least = least_of(cases.len());
    let wrong: Vec<String> = cases
        .into_par_iter()
        .filter_map(|(line, wo)| {
            let (model, chart) = (line.model(), Chart::new(wo));
            let mut drawn = vec![0; Chart::CELLS + 1];
            let open = line.is_open();
            let count = if line.is_wave() { COUNT / 4 } else { COUNT };
            for u in draws(count) {
                let BsdfSample { wi, pdf, .. } = model.sample(wo, u, TransportMode::Radiance);
                drawn[if pdf > 0.0 { chart.cell(wi) } else { Chart::CELLS }] += 1;
            }
            let (mut mass, mut seen) = (vec![0.0; Chart::CELLS], vec![false; Chart::CELLS + 1]);
            chart.visit(|cell, wi, angle| {
                if wi.z > 0.0 || open {
                    mass[cell] += angle * model.pdf(wi, wo, TransportMode::Radiance);
                }
                seen[cell] = true;
            });
            let rest = 1.0 - mass.iter().sum::<f64>();
            mass.push(rest.max(0.0));
            // The integral knows every cell to about 10⁻⁴ of the whole of it, and nothing of those that
            // the horizon leaves a sliver of.
            let error = |all: f64, seen: bool| if seen { 1e-4 * all } else { 0.1 };
            let expected: Vec<(f64, f64)> = mass
                .iter()
                .map(|mass| f64::from(count) * mass)
                .zip(seen)
                .map(|(all, seen)| (all, error(all, seen)))
                .collect();
            let verdict = compare(&drawn, &expected);
            let good = verdict.p_value > least && verdict.terms > 20 && rest > -1e-4;
            (!good).then(|| format!("{} {wo}: rest {rest}, {verdict:?}", line.name))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Directions of both sides by their distance from the mirror direction, or from its mirror image below,
/// crowded there: 1 − cosθ ~ x³.
struct Chart {
    frame: Frame<DVec3>,
}

impl Chart {
    /// Cells along x and around it.
    const PARTS: [usize; 2] = [12, 16];
    const CELLS: usize = 2 * Self::PARTS[0] * Self::PARTS[1];
    /// Steps of the integral along either.
    const STEPS: usize = 480;

    fn new(wo: DVec3) -> Self {
        Self { frame: Frame::from_normal(DVec3::new(-wo.x, -wo.y, wo.z.abs())) }
    }

    fn index(below: bool, place: [f64; 2]) -> usize {
        let [x, around] = [0, 1].map(|axis| {
            let parts = Self::PARTS[axis];
            ((place[axis] * parts as f64) as usize).min(parts - 1)
        });
        (usize::from(below) * Self::PARTS[0] + x) * Self::PARTS[1] + around
    }

    fn cell(&self, w: DVec3) -> usize {
        let local = self.frame.to_local(DVec3::new(w.x, w.y, w.z.abs()));
        // 1 − cosθ without the difference.
        let sin_squared = local.x * local.x + local.y * local.y;
        let near = sin_squared / (1.0 + local.z.max(0.0));
        let versine = if local.z > 0.0 { near } else { 1.0 - local.z };
        Self::index(
            w.z < 0.0,
            [(versine * 0.5).cbrt(), local.y.atan2(local.x).rem_euclid(TAU) / TAU],
        )
    }

    /// Every direction with its cell and the solid angle around it.
    fn visit(&self, mut visit: impl FnMut(usize, DVec3, f64)) {
        let place = |index: usize| (index as f64 + 0.5) / Self::STEPS as f64;
        for i in 0..Self::STEPS {
            let x = place(i);
            let (versine, width) = (2.0 * x.powi(3), 6.0 * x * x / Self::STEPS as f64);
            let sin = (versine * (2.0 - versine)).sqrt();
            for j in 0..Self::STEPS {
                let around = place(j);
                let (s, c) = (TAU * around).sin_cos();
                let w = self.frame.to_world(DVec3::new(sin * c, sin * s, 1.0 - versine));
                if w.z > 0.0 {
                    let angle = width * TAU / Self::STEPS as f64;
                    visit(Self::index(false, [x, around]), w, angle);
                    visit(Self::index(true, [x, around]), DVec3::new(w.x, w.y, -w.z), angle);
                }
            }
        }
    }
}

/// The weight of a draw is f cosθ/pdf, of a lobe its weight over the probability of drawing it.
#[test]
fn weights_are_values_over_densities() {
    for line in lines() {
        let mut worst = 0.0_f64;
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
                    worst = worst.max(off / weight);
                    assert!(off <= 1e-11 * weight, "{} {wo}: {sample:?} {weight}", line.name);
                }
            }
            for (Lobe { weight, .. }, chosen) in lobes.iter().zip(chosen) {
                let off = (weight.x - chosen / count).abs();
                // Four standard errors of 2000 draws by chance.
                let bound = 0.045 * weight.x.max(1.0);
                assert!(off < bound, "{} {wo}: {weight} {chosen}", line.name);
            }
        }
        println!("{}: {worst:.1e}", line.name);
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
        let (model, mut most) = (line.model(), 0.0_f64);
        for wo in viewers() {
            let power = model.power(wo);
            let (mut sums, mut squares, mut count) = ([0.0; 2], 0.0, 0.0);
            for u in draws(if line.is_wave() { 5_000 } else { 40_000 }) {
                let sample = model.sample(wo, u, TransportMode::Importance);
                sums[usize::from(sample.wi.z * wo.z < 0.0)] += sample.weight.x;
                squares += sample.weight.x * sample.weight.x;
                count += 1.0;
            }
            let [returned, passed] = sums.map(|sum| sum / count);
            // Four standard errors where a few grazing draws weigh much.
            let bound = (4.0 * squares.sqrt() / count).max(1e-2);
            let near = |got: f64, want: f64| (got - want).abs() < bound;
            let same = near(power.reflectance.x, returned) && near(power.transmittance.x, passed);
            assert!(same, "{} {wo}: {power:?} {returned} {passed}", line.name);
            let total = power.reflectance.x + power.transmittance.x;
            let answers = wo.z > 0.0 || line.is_open();
            if line.lossless && answers {
                assert!((total - 1.0).abs() <= 1e-13, "{} {wo}: {total}", line.name);
            }
            assert!(total <= line.gain + 1e-13, "{} {wo}: {total}", line.name);
            most = most.max(total);
        }
        println!("{}: {most:.4}", line.name);
        assert!(line.gain == 1.0 || most > line.gain - 5e-3, "{}: {most}", line.name);
    }
}

/// To what its documentation says, by draws that fill the cube evenly.
#[test]
fn the_power_of_rough_glass_is_the_mean_of_many_draws() {
    for (theta, ior, roughness) in [
        (0.0, 1.5, 0.1),
        (1.4, 1.5, 0.5),
        (PI - 0.5, 1.5, 0.3),
        (PI - 1.4, 1.5, 0.1),
        (PI, 1.5, 1.0),
        (0.7, 1.0 / 1.5, 0.3),
    ] {
        let wo: DVec3 = from_spherical(theta, 0.3);
        let ggx = Ggx::new(roughness).expect("a roughness");
        let glass = RoughDielectric::new(ggx, ior).expect("an index");
        const COUNT: u32 = 2_000_000;
        // The additive recurrence of the cube's generalised golden ratio.
        let step = [0.819_172_513_396_164_4, 0.671_043_606_703_789_2, 0.549_700_477_901_970_3];
        let sums = (0..COUNT).into_par_iter().map(|index| {
            let u = step.map(|step| (0.5 + f64::from(index) * step).fract());
            let sample = glass.sample(wo, u, TransportMode::Importance);
            let back = sample.wi.z * wo.z > 0.0;
            DVec2::new(f64::from(u8::from(back)), f64::from(u8::from(!back))) * sample.weight.x
        });
        let mean = sums.reduce(|| DVec2::ZERO, |a, b| a + b) / f64::from(COUNT);
        let power = glass.power(wo);
        let off = DVec2::new(power.reflectance.x, power.transmittance.x) - mean;
        println!("{theta:.2} {ior:.2} {roughness}: {off}");
        assert!(off.abs().max_element() < 2e-4, "{theta} {ior} {roughness}: {power:?} {mean}");
    }
}

/// What is scattered twice is lost however near to 1 the index is, and nothing at 1.
#[test]
fn rough_glass_of_next_to_no_contrast_loses_light() {
    let wo: DVec3 = from_spherical(0.5, 0.3);
    let passed = |ior: f64| {
        let glass = RoughDielectric::new(Ggx::new(0.5_f64).expect("a roughness"), ior);
        glass.expect("an index").power(wo).transmittance.x
    };
    assert_eq!(passed(1.0), 1.0);
    // Half a digit of what the page says, and what the power promises.
    assert!((passed(1.0 + 1e-12) - 0.982).abs() < 7e-4, "{}", passed(1.0 + 1e-12));
}

/// Values of the literature: rounded to four and to three digits.
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
        println!("{ior:.2} {theta} {roughness}: {got:.5}");
        // Half a digit of the table and what the power promises.
        assert!((got - correlated).abs() < 7e-4, "{ior} {theta} {roughness}: {got}");
        if let Some(separable) = separable {
            let got = total(glass.with_shadowing(SmithSeparable).power(wo));
            assert!((got - separable).abs() < 7e-4, "{ior} {theta} {roughness}: {got}");
        }
    }
}

/// What a beam loses to a model that is not reciprocal is no albedo. The powers are sums over 600 × 600
/// directions.
#[test]
fn a_beam_meets_a_model_that_is_not_reciprocal_the_other_way() {
    let phong = ClassicPhong::new(DVec3::ONE, 5.0).expect("a lobe");
    let opaque = Opaque::new(phong);
    for theta in [0.2, 0.5, 0.9, 1.2] {
        let wo: DVec3 = from_spherical(theta, 0.0);
        for u in draws(1000) {
            let BsdfSample { wi, weight, pdf, .. } =
                opaque.sample(wo, u, TransportMode::Importance);
            if pdf > 0.0 {
                let value = opaque.eval(wi, wo, TransportMode::Importance);
                assert!(
                    (value * wi.z / pdf - weight).length() <= 1e-14 * weight.length(),
                    "{wo} {wi}"
                );
            }
        }
        const N: u32 = 600;
        let mut power = 0.0;
        for i in 0..N {
            // z² is even, so that cosθ dω is.
            let z = ((f64::from(i) + 0.5) / f64::from(N)).sqrt();
            let radius = (1.0 - z * z).sqrt();
            for j in 0..N {
                let (sin, cos) = (TAU * (f64::from(j) + 0.5) / f64::from(N)).sin_cos();
                let wi = DVec3::new(radius * cos, radius * sin, z);
                power += PI / f64::from(N * N) * opaque.eval(wi, wo, TransportMode::Importance).x;
            }
        }
        let got = opaque.power(wo).reflectance.x;
        println!("{theta}: {got:.6} {power:.6} {:.6}", phong.albedo(wo).x);
        assert!((got - power).abs() < 2e-3 * power, "{theta}: {got} is not {power}");
        assert!((phong.albedo(wo).x - power).abs() > 0.03 * power, "{theta}");
    }
}

/// The colours of films leave those that light can have.
#[test]
fn a_mirror_of_a_film_takes_no_light_away() {
    let soap: BelcourBarla<DVec3, f64> =
        BelcourBarla::new(1.33, 300.0, [1.0, 0.0], 1.0).expect("a film");
    let wo: DVec3 = from_spherical(PI / 3.0, 0.0);
    assert!(soap.reflectance(0.5).x < -0.01);
    let mirror = Mirror::new(soap);
    let lobe = mirror.specular(wo, TransportMode::Radiance).reflected;
    assert_eq!(lobe.weight.x, 0.0);
    assert!(lobe.weight.z > 0.1);
    assert_eq!(mirror.power(wo).reflectance, lobe.weight);
}

#[test]
fn no_direction_has_no_lobe() {
    let paper = Opaque::new(Lambert::new(DVec3::ONE).expect("an albedo"));
    let lobes = paper.specular(DVec3::NAN, TransportMode::Radiance);
    assert_eq!(lobes.reflected.weight, DVec3::ZERO);
    assert!(lobes.reflected.wi.is_finite() && lobes.transmitted.wi.is_finite());
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
