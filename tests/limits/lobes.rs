use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI, TAU};

use brdf::{
    BlinnPhong, Brdf, ClassicPhong, Lambert, OrenNayar, ParameterError, Phong, SchlickPower,
    from_spherical,
};
use glam::{DVec3, Vec3};

use crate::hemisphere::{Model, albedo, assert_samples_follow_pdf};
use brdf_checks::directions::pairs;

const EXPONENTS: [f64; 8] = [0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 37.5, 100.0];
const ANGLES: [f64; 7] = [0.0, 0.3, 0.8, 1.1, 1.3, 1.45, 1.5];

/// A pair of directions at angles ±θ, so that one mirrors the other, turned apart by δ.
fn near_mirror(theta: f64, delta: f64) -> (DVec3, DVec3) {
    (from_spherical(theta + delta, 0.0), from_spherical(theta, PI))
}

fn phong(n: f64) -> Model {
    Box::new(Phong::new(1.0, n).unwrap())
}
fn classic_phong(n: f64) -> Model {
    Box::new(ClassicPhong::new(1.0, n).unwrap())
}
fn blinn_phong(n: f64) -> Model {
    Box::new(BlinnPhong::new(1.0, n).unwrap())
}
fn unnormalized_blinn_phong(n: f64) -> Model {
    Box::new(BlinnPhong::unnormalized(1.0, n).unwrap())
}
fn schlick_power(n: f64) -> Model {
    Box::new(SchlickPower::new(1.0, n).unwrap())
}
fn unnormalized_schlick_power(n: f64) -> Model {
    Box::new(SchlickPower::unnormalized(1.0, n).unwrap())
}

type Lobe = (&'static str, fn(f64) -> Model);
const NORMALIZED: [Lobe; 3] =
    [("Phong", phong), ("Blinn-Phong", blinn_phong), ("Schlick's power", schlick_power)];
const OTHERS: [Lobe; 3] = [
    ("classic Phong", classic_phong),
    ("unnormalised Blinn-Phong", unnormalized_blinn_phong),
    ("unnormalised Schlick's power", unnormalized_schlick_power),
];

fn lobes() -> impl Iterator<Item = Lobe> {
    NORMALIZED.into_iter().chain(OTHERS)
}

#[test]
fn oren_nayar_without_roughness_is_lambert_to_the_bit() {
    let albedo = Vec3::new(0.8, 0.33, 0.0);
    let lambert = Lambert::new(albedo).unwrap();
    let awkward = [Vec3::new(1.0, 0.0, 1e-45), Vec3::new(1.0, 0.0, 1e-20), Vec3::Z, Vec3::NAN];
    let extreme = awkward.into_iter().flat_map(|wi| awkward.map(|wo| (wi, wo)));
    let ordinary = pairs(5000).into_iter().map(|(wi, wo)| (wi.as_vec3(), wo.as_vec3()));
    for rough in [OrenNayar::new(albedo, 0.0), OrenNayar::with_interreflection(albedo, 0.0)]
        .map(Result::unwrap)
    {
        for (wi, wo) in ordinary.clone().chain(extreme.clone()) {
            assert_eq!(rough.eval(wi, wo), lambert.eval(wi, wo), "{wi} {wo}");
            assert_eq!(rough.pdf(wi, wo), lambert.pdf(wi, wo), "{wi} {wo}");
            assert_eq!(rough.albedo(wo), lambert.albedo(wo), "{wo}");
            let u = [wi.x.abs().min(0.99), 0.3];
            assert_eq!(rough.sample(wo, u).weight, lambert.sample(wo, u).weight, "{wo}");
        }
    }
}

/// f grows like 1/cosθ where both directions graze on the same side; the radiance does not.
#[test]
fn oren_nayar_grazing_radiance_stays_finite() {
    let (single, double) =
        (OrenNayar::new(1.0_f32, 0.5).unwrap(), OrenNayar::new(1.0_f64, 0.5).unwrap());
    let (a, b) = (1.0 - 0.5 * 0.25 / (0.25 + 0.33), 0.45 * 0.25 / (0.25 + 0.09));
    for cos in [1e-3, 1e-8, 1e-20, 1e-35] {
        let w = DVec3::new(1.0, 0.0, cos);
        let radiance = double.eval(w, w) * cos;
        assert!((radiance - FRAC_1_PI * (a * cos + b)).abs() < 1e-15, "{cos}: {radiance}");
        let w = w.as_vec3();
        let radiance = f64::from(single.eval(w, w)) * f64::from(w.z);
        assert!((radiance - FRAC_1_PI * (a * cos + b)).abs() < 1e-7, "{cos}: {radiance}");
    }
    let w = Vec3::new(1.0, 0.0, 1e-45);
    let largest = single.eval(w, w);
    assert!(largest.is_finite() && largest > 1e37, "{largest}");
}

/// The albedo only rises towards grazing, so that its largest value is A + B/2; the maximum of
/// that over σ, with its place, for both constants.
#[test]
fn oren_nayar_albedo_maximum() {
    let horizon = DVec3::new(1.0, 0.0, 1e-12);
    let check = |new: fn(f64, f64) -> Result<OrenNayar<f64, f64>, ParameterError>,
                 want: (f64, f64)| {
        let steps = (0..=15_707).map(|step| f64::from(step) * 1e-4);
        let (place, maximum) = steps
            .map(|sigma| (sigma, new(1.0, sigma).unwrap().albedo(horizon)))
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap();
        assert!((place - want.0).abs() < 2e-4, "{place}");
        assert!((maximum - want.1).abs() < 1e-5, "{maximum}");
        assert!(0.95 * maximum < 1.0);
        for sigma in [0.05, want.0, 0.8, FRAC_PI_2] {
            let model = new(1.0, sigma).unwrap();
            let rising: Vec<f64> = (0..=1000)
                .map(|step| model.albedo(from_spherical(f64::from(step) * 1.57e-3, 1.0)))
                .collect();
            assert!(rising.is_sorted(), "{sigma}");
        }
    };
    check(OrenNayar::new, (0.1985, 1.01518));
    check(OrenNayar::with_interreflection, (0.2906, 1.04440));
}

#[test]
fn oren_nayar_albedo_is_the_integral() {
    for sigma in [0.1, 0.3, 0.8, FRAC_PI_2] {
        let model = OrenNayar::with_interreflection(1.0, sigma).unwrap();
        for theta in ANGLES {
            let (got, want) =
                (model.albedo(from_spherical(theta, 0.7)), albedo(&model, theta, 1e-10));
            assert!((got - want).abs() < 2e-10, "σ {sigma} θ {theta}: {got}, {want}");
        }
    }
}

/// Each closed or one-dimensional albedo against the double integral of f. The edge of the lobe at
/// R·V = 0 is a jump for exponent 0 and a steep rim for small ones, which cost the latter digits.
#[test]
fn albedo_is_the_integral() {
    for (name, lobe) in lobes() {
        for n in EXPONENTS {
            let bound = match n {
                n if n < 1.0 => 1e-4,
                n if n < 5.0 => 1e-6,
                _ => 1e-8,
            };
            let model = lobe(n);
            for theta in ANGLES {
                let got = model.albedo(from_spherical(theta, 2.0));
                let want = albedo(&*model, theta, bound);
                let context = format!("{name} n {n} θ {theta}: {got} against {want}");
                assert!((got - want).abs() < bound + 1e-9, "{context}");
            }
        }
    }
}

/// The normalised lobes reflect kₛ of the light at normal incidence and less elsewhere.
#[test]
fn normalized_lobes_conserve_energy() {
    for (name, lobe) in NORMALIZED {
        for n in EXPONENTS.into_iter().chain([1e-8, 1e-4, 1e-3, 0.03, 0.3, 1e3, 1e5, 1e8]) {
            let model = lobe(n);
            let at_normal = model.albedo(DVec3::Z);
            // Schlick's lobe has a step of width n at its rim, where n is small.
            let bound = if n < 0.5 && name.starts_with("Schlick") { 1e-7 } else { 1e-12 };
            assert!((at_normal - 1.0).abs() < bound, "{name} n {n}: {at_normal}");
            for step in 0..=157 {
                let theta = f64::from(step) * 0.01;
                let got = model.albedo(from_spherical(theta, 0.0));
                assert!(got <= 1.0 + bound, "{name} n {n} θ {theta}: {got}");
            }
            if (0.5..=100.0).contains(&n) {
                let integral = albedo(&*model, 0.0, 1e-10);
                assert!((integral - 1.0).abs() < 1e-9, "{name} n {n}: {integral}");
            }
        }
    }
}

/// What the constants in circulation, and none at all, do to the albedo at normal incidence, where
/// all lobes have their maximum.
#[test]
fn other_constants_do_not_conserve() {
    let at_normal = |model: &dyn Brdf<f64, Color = f64>| albedo(model, 0.0, 1e-6);
    let popular = |n: f64| (n + 8.0) / (8.0 * PI) * at_normal(&*unnormalized_blinn_phong(n));
    let of_phong = |n: f64| (n + 2.0) / TAU * at_normal(&*unnormalized_schlick_power(n));
    let cases = [
        ("(n + 8)/(8π)", popular(1.0), 1.024),
        ("(n + 8)/(8π)", popular(10.0), 1.075),
        ("(n + 8)/(8π)", popular(100.0), 1.018),
        ("Schlick's power with Phong's constant", of_phong(10.0), 1.642),
        ("Schlick's power with Phong's constant", of_phong(100.0), 3.285),
        ("classic Phong", at_normal(&*classic_phong(0.0)), TAU),
        ("classic Phong", at_normal(&*classic_phong(1.0)), PI),
        ("unnormalised Blinn-Phong", at_normal(&*unnormalized_blinn_phong(0.0)), PI),
        ("unnormalised Blinn-Phong", at_normal(&*unnormalized_blinn_phong(10.0)), 1.5006),
        ("unnormalised Blinn-Phong", at_normal(&*unnormalized_blinn_phong(18.7)), 1.000),
        ("unnormalised Schlick's power", at_normal(&*unnormalized_schlick_power(0.0)), PI),
        ("unnormalised Schlick's power", at_normal(&*unnormalized_schlick_power(1.0)), 2.0944),
        ("unnormalised Schlick's power", at_normal(&*unnormalized_schlick_power(10.0)), 0.8598),
    ];
    for (name, got, want) in cases {
        assert!((got - want).abs() < 6e-4, "{name}: {got}, {want}");
    }
    for (name, lobe) in OTHERS {
        for n in EXPONENTS {
            let model = lobe(n);
            let at_normal = model.albedo(DVec3::Z);
            for theta in ANGLES {
                let got = model.albedo(from_spherical(theta, 0.0));
                assert!(got <= at_normal * (1.0 + 1e-12), "{name} n {n} θ {theta}: {got}");
            }
        }
    }
}

#[test]
fn modified_phong_loses_what_sinks_below_the_surface() {
    let model = phong(10.0);
    for (degrees, want) in [(0.0_f64, 1.0), (30.0, 0.866), (60.0, 0.505), (89.9, 0.124)] {
        let got = model.albedo(from_spherical(degrees.to_radians(), 0.0));
        assert!((got - want).abs() < 5e-4, "{degrees}°: {got}");
    }
}

/// The lobe of 1975 differs from its reverse by the ratio of the cosines.
#[test]
fn the_lobe_of_1975_is_not_reciprocal() {
    let (wi, wo) = near_mirror(0.9, 0.3);
    let classic = classic_phong(10.0);
    let ratio = classic.eval(wi, wo) / classic.eval(wo, wi);
    assert!((ratio - wo.z / wi.z).abs() < 1e-12 && ratio > 1.5, "{ratio}");
}

#[test]
fn exponent_0_is_constant() {
    for (wi, wo) in pairs(1000) {
        assert!((blinn_phong(0.0).eval(wi, wo) - FRAC_1_PI).abs() < 1e-15);
        let around_mirror = wi.z * wo.z - wi.x * wo.x - wi.y * wo.y;
        if around_mirror.abs() > 1e-9 {
            let want = if around_mirror > 0.0 { FRAC_1_PI } else { 0.0 };
            assert!((phong(0.0).eval(wi, wo) - want).abs() < 1e-15, "{wi} {wo}");
            assert!((schlick_power(0.0).eval(wi, wo) - want).abs() < 1e-15, "{wi} {wo}");
        }
    }
}

/// The limit h → 1 of Schlick's constant is reached without a step, from both sides.
#[test]
fn schlick_constant_around_1() {
    let peak = |h: f64| schlick_power(h).eval(DVec3::Z, DVec3::Z);
    let peak_f32 = |h: f32| SchlickPower::new(1.0_f32, h).unwrap().eval(Vec3::Z, Vec3::Z);
    let slope = (peak(1.0 + 1e-4) - peak(1.0 - 1e-4)) / 2e-4;
    for distance in [1e-3, 1e-6, 1e-9, 1e-12, 1e-15] {
        for h in [1.0 - distance, 1.0 + distance] {
            let want = 3.0 / TAU + slope * (h - 1.0);
            let curvature = 0.1 * distance * distance;
            let bound = curvature + 1e-8 * distance + 3e-16;
            assert!((peak(h) - want).abs() < bound, "{h}: {}, {want}", peak(h));
        }
    }
    // Through the change of formula at h = 1/3 and 3, and far from it.
    for h in [1e-8, 0.01, 0.3333, 0.3334, 0.9999999, 1.0, 1.0000001, 2.9999, 3.0001, 50.0, 1e4, 1e8]
    {
        let single = h as f32;
        let (got, want) = (f64::from(peak_f32(single)), peak(f64::from(single)));
        assert!((got / want - 1.0).abs() < 1e-6, "{h}: {got}, {want}");
    }
    let printed = |h: f64| {
        let g = h - 1.0;
        h * h * h.ln() / g.powi(3) - h / (g * g) - 0.5 / g
    };
    for h in [0.1, 0.3, 0.4, 2.5, 3.5, 20.0, 1e4] {
        let want = 1.0 / (TAU * printed(h));
        assert!((peak(h) / want - 1.0).abs() < 1e-12, "{h}: {}, {want}", peak(h));
    }
}

/// Lobes a hundredth of a degree wide, in single precision: height, width, samples.
#[test]
fn exponent_1e8_in_single_precision() {
    let n = 1e8_f32;
    let (phong, blinn) = (Phong::new(1.0, n).unwrap(), BlinnPhong::new(1.0, n).unwrap());
    let schlick = SchlickPower::new(1.0, n).unwrap();
    let peak = f64::from(n) / TAU;
    for delta in [0.0_f64, 3e-5, 1e-4, 3e-4] {
        let wi = Vec3::new(delta as f32, 0.0, 1.0);
        let tail = |scale: f64| (-f64::from(n) * scale * delta * delta / 2.0).exp();
        let got = f64::from(phong.eval(wi, Vec3::Z));
        assert!((got / (peak * tail(1.0)) - 1.0).abs() < 2e-6, "{delta}: {got}");
        let got = f64::from(blinn.eval(wi, Vec3::Z));
        assert!((got / (peak / 4.0 * tail(0.25)) - 1.0).abs() < 2e-6, "{delta}: {got}");
        let got = f64::from(schlick.eval(wi, Vec3::Z)) / f64::from(schlick.eval(Vec3::Z, Vec3::Z));
        let want = 1.0 / (1.0 + f64::from(n) * delta * delta / 2.0);
        assert!((got / want - 1.0).abs() < 2e-6, "{delta}: {got}");
    }
    let wo = Vec3::new(0.48, -0.36, 0.8);
    let mirror = Vec3::new(-0.48, 0.36, 0.8);
    let (mut tilt, mut half_tilt) = (0.0, 0.0);
    let draws = 20_000_u32;
    for draw in 0..draws {
        let u = [(draw as f32 + 0.5) / draws as f32, (draw as f32 * 0.618_034).fract()];
        let sample = phong.sample(wo, u);
        assert!((sample.weight - sample.wi.z).abs() < 1e-6 && sample.pdf > 0.0);
        tilt += f64::from((sample.wi - mirror).length_squared()) / 2.0;
        let sample = blinn.sample(wo, u);
        assert!((sample.weight - 0.64).abs() < 1e-3 && sample.pdf > 0.0, "{sample:?}");
        half_tilt += f64::from((sample.wi - mirror).length_squared()) / 2.0;
    }
    // 1 − cos of the angle is distributed exponentially with mean 1/n. A half vector that tilts by
    // α turns the sample by 2α in the plane of incidence, and by 2α cosθ across it.
    let (tilt, half_tilt) = (tilt / f64::from(draws), half_tilt / f64::from(draws));
    assert!((tilt * f64::from(n) - 1.0).abs() < 0.02, "{tilt}");
    assert!((half_tilt * f64::from(n) / (2.0 * (1.0 + 0.64)) - 1.0).abs() < 0.02, "{half_tilt}");
}

/// In single precision the powers lose digits in proportion to what their exponents magnify:
/// 1 + n q/(1 − q) with q = 1 − cos of the angle that is raised.
#[test]
fn single_precision_of_powers() {
    for n in [1.0_f32, 10.0, 200.0, 5000.0] {
        let phong = (Phong::new(1.0_f32, n).unwrap(), Phong::new(1.0, f64::from(n)).unwrap());
        let blinn =
            (BlinnPhong::new(1.0_f32, n).unwrap(), BlinnPhong::new(1.0, f64::from(n)).unwrap());
        let n = f64::from(n);
        let (mut of_phong, mut of_blinn, mut of_peak) = (0.0_f64, 0.0_f64, 0.0_f64);
        for (wi, wo) in pairs(20_000) {
            let (wi, wo) = (wi.as_vec3(), wo.as_vec3());
            let (wi64, wo64) = (wi.as_dvec3(), wo.as_dvec3());
            let q = (wi64 - DVec3::new(-wo64.x, -wo64.y, wo64.z)).length_squared() / 2.0;
            let (got, want) = (f64::from(phong.0.eval(wi, wo)), phong.1.eval(wi64, wo64));
            of_peak = of_peak.max((got - want).abs() / ((n + 2.0) / TAU));
            if want > 1e-30 && q < 0.99 {
                of_phong = of_phong.max((got / want - 1.0).abs() / (1.0 + n * q / (1.0 - q)));
            }
            let q = 1.0 - (wi64 + wo64).normalize().z;
            let (got, want) = (f64::from(blinn.0.eval(wi, wo)), blinn.1.eval(wi64, wo64));
            if want > 1e-30 {
                of_blinn = of_blinn.max((got / want - 1.0).abs() / (1.0 + n * q / (1.0 - q)));
            }
        }
        println!(
            "n {n}: Phong {of_phong:.1e}, of the peak {of_peak:.1e}, Blinn-Phong {of_blinn:.1e}"
        );
        assert!(of_phong < 5e-7 && of_blinn < 5e-7 && of_peak < 4e-7);
    }
}

#[test]
fn samples_follow_the_density() {
    let models: Vec<(String, Model)> = lobes()
        .flat_map(|(name, lobe)| [0.0, 1.0, 20.0].map(|n| (format!("{name} {n}"), lobe(n))))
        .chain([("Oren-Nayar".to_owned(), {
            let model: Model = Box::new(OrenNayar::new(0.9, 0.6).unwrap());
            model
        })])
        .collect();
    for (name, model) in &models {
        for (theta, phi) in [(0.0, 0.0), (0.7, 2.0), (1.3, -1.0), (1.55, 0.3)] {
            let wo = from_spherical(theta, phi);
            let failures = assert_samples_follow_pdf(name, &**model, wo, 200_000);
            // Seen from the normal, no part of a lobe of half a sphere around it is lost.
            let whole = theta == 0.0 && !name.contains("Blinn");
            assert!(!whole || failures.abs() < 1e-9, "{name}: {failures}");
        }
    }
}

#[test]
fn parameters_are_checked() {
    let error = OrenNayar::new(0.5_f64, 1.6).unwrap_err();
    assert_eq!((error.parameter(), error.value()), ("sigma", 1.6));
    assert_eq!(OrenNayar::new(1.5_f32, 0.3).unwrap_err().parameter(), "albedo");
    assert!(OrenNayar::new(0.5_f32, std::f32::consts::FRAC_PI_2).is_ok());
    assert!(OrenNayar::new(0.5_f32, f32::NAN).is_err());
    for (specular, exponent, parameter) in [
        (1.1, 5.0, "specular"),
        (-0.1, 5.0, "specular"),
        (0.5, -1.0, "exponent"),
        (0.5, 2e8, "exponent"),
    ] {
        let errors = [
            Phong::new(specular, exponent).unwrap_err(),
            ClassicPhong::new(specular, exponent).unwrap_err(),
            BlinnPhong::new(specular, exponent).unwrap_err(),
            BlinnPhong::unnormalized(specular, exponent).unwrap_err(),
            SchlickPower::new(specular, exponent).unwrap_err(),
            SchlickPower::unnormalized(specular, exponent).unwrap_err(),
        ];
        assert!(errors.iter().all(|error| error.parameter() == parameter), "{errors:?}");
    }
}

/// Erratum of a common shortcut: the exponent 4n belongs to half the angle, and ∠(R, V) is twice
/// ∠(N, H) only where light, viewer and normal lie in one plane.
#[test]
fn half_angle_relation_holds_in_the_plane_of_incidence() {
    let difference = |n: f64, beta: f64| {
        let w = from_spherical(0.5 * beta, 0.0);
        unnormalized_blinn_phong(4.0 * n).eval(w, w) - classic_phong(n).eval(w, w) * w.z
    };
    for (n, place, want) in [(10.0, 0.6266, 0.01425), (1000.0_f64, 0.0632, (-2.0_f64).exp() / 1e3)]
    {
        let betas = (1..2000).map(|step| f64::from(step) * place * 1e-3);
        let (beta, largest) = betas
            .map(|beta| (beta, difference(n, beta)))
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap();
        assert!((largest / want - 1.0).abs() < 3e-3, "n {n}: {largest}");
        assert!((beta / place - 1.0).abs() < 5e-3, "n {n}: {beta}");
    }
    let (wi, wo) = (from_spherical(PI / 3.0, 0.0), from_spherical(PI / 3.0, PI / 1.2));
    let phong = classic_phong(10.0).eval(wi, wo) * wi.z;
    let blinn = unnormalized_blinn_phong(40.0).eval(wi, wo);
    assert!((phong - 0.347).abs() < 1e-3 && (blinn - 0.0257).abs() < 1e-4, "{phong} {blinn}");
}

/// The rational lobe has the power's value and slope at the centre, and half its height at
/// S = h/(h + 1).
#[test]
fn schlick_power_matches_the_power_at_the_centre() {
    for h in [1.0, 3.0, 10.0, 300.0] {
        let lobe = unnormalized_schlick_power(h);
        let at = |s: f64| {
            let w = from_spherical(0.5 * s.acos(), 0.0);
            lobe.eval(w, w)
        };
        assert!((at(h / (h + 1.0)) - 0.5).abs() < 1e-12);
        let step = 1e-6 / h;
        let slope = (at(1.0) - at(1.0 - step)) / step;
        assert!((slope / h - 1.0).abs() < 1e-4, "{h}: {slope}");
    }
}

#[test]
fn oren_nayar_interreflection_brightens_by_a_tenth_at_most() {
    let ratios = (0..=1570).map(|step| {
        let sigma = f64::from(step) * 1e-3;
        let new = OrenNayar::with_interreflection(1.0, sigma).unwrap();
        new.eval(DVec3::Z, DVec3::Z) / OrenNayar::new(1.0, sigma).unwrap().eval(DVec3::Z, DVec3::Z)
    });
    let largest = ratios.fold(0.0, f64::max);
    assert!((largest - 1.0977).abs() < 1e-4, "{largest}");
}

/// Extreme parameters at extreme directions, where no answer may be negative or not finite, and
/// none may panic.
macro_rules! extremes {
    ($test:ident, $float:ident, $vector:ident) => {
        #[test]
        fn $test() {
            let mut models: Vec<Box<dyn Brdf<$float, Color = $float>>> = Vec::new();
            for n in [0.0, 1e-30, 0.5, 1.0, 3.0, 1e4, 1e8] {
                models.push(Box::new(Phong::new(1.0, n).unwrap()));
                models.push(Box::new(ClassicPhong::new(1.0, n).unwrap()));
                models.push(Box::new(BlinnPhong::new(1.0, n).unwrap()));
                models.push(Box::new(BlinnPhong::unnormalized(1.0, n).unwrap()));
                models.push(Box::new(SchlickPower::new(1.0, n).unwrap()));
            }
            for sigma in [0.0, 1e-30, 0.1, 1.5] {
                models.push(Box::new(OrenNayar::new(1.0, sigma).unwrap()));
            }
            let heights = [1e-45, 1e-38, 1e-20, 1e-7, 1e-3, 0.6, 1.0];
            let mut directions = vec![
                $vector::ZERO,
                $vector::NEG_Z,
                $vector::NAN,
                $vector::splat($float::MAX),
                $vector::splat($float::INFINITY),
                $vector::new(0.3, 0.3, 1e-3),
                $vector::new(1.0, 0.0, 0.9),
                $vector::new(1e-20, 0.0, 1.0),
            ];
            for height in heights {
                let side = (1.0 - height * height as $float).sqrt();
                directions.push($vector::new(side, 0.0, height));
                directions.push($vector::new(-side, 0.0, height));
                directions.push($vector::new(0.6 * side, -0.8 * side, height));
            }
            let uniforms = [0.0, 1e-7, 0.25, 0.5, 1.0 - $float::EPSILON / 2.0];
            for (index, model) in models.iter().enumerate() {
                for &wo in &directions {
                    let sound = |what: &str, value: $float| {
                        let fine = value >= 0.0 && value.is_finite();
                        assert!(fine, "model {index}: {what} {value} for {wo}");
                    };
                    sound("albedo", model.albedo(wo));
                    for &wi in &directions {
                        sound("eval", model.eval(wi, wo));
                        sound("pdf", model.pdf(wi, wo));
                    }
                    for u0 in uniforms {
                        for u1 in uniforms {
                            let sample = model.sample(wo, [u0, u1]);
                            sound("weight", sample.weight);
                            sound("density", sample.pdf);
                        }
                    }
                }
            }
        }
    };
}
extremes!(extremes_are_sound_in_f32, f32, Vec3);
extremes!(extremes_are_sound_in_f64, f64, DVec3);

/// The product of two cosines may be below the least number of single precision.
#[test]
fn blinn_phong_samples_at_the_horizon() {
    let model = BlinnPhong::unnormalized(1.0_f32, 20.0).unwrap();
    for exponent in 0..200 {
        let wo = Vec3::new(1.0, 0.0, 10.0_f32.powf(-0.1 * exponent as f32));
        for u in [[0.0, 0.0], [0.5, 0.25], [0.9, 0.5]] {
            let sample = model.sample(wo, u);
            let want = f64::from(model.eval(sample.wi, wo)) * f64::from(sample.wi.z);
            let got = f64::from(sample.weight) * f64::from(sample.pdf);
            assert!((got - want).abs() <= 2e-6 * want, "{wo} {u:?}: {got:e}, not {want:e}");
        }
    }
}

/// The integrals behind the albedos keep the digits of single precision.
#[test]
fn albedo_in_single_precision() {
    let single = |index: usize, n: f32, wo: Vec3| match index {
        0 => Phong::new(1.0, n).unwrap().albedo(wo),
        1 => BlinnPhong::new(1.0, n).unwrap().albedo(wo),
        2 => SchlickPower::new(1.0, n).unwrap().albedo(wo),
        _ => ClassicPhong::new(1.0, n).unwrap().albedo(wo),
    };
    let double = NORMALIZED.into_iter().chain([OTHERS[0]]);
    for (index, (name, lobe)) in double.enumerate() {
        let mut worst = 0.0_f64;
        for n in [0.0_f32, 1.0, 3.0, 30.0, 1e4, 1e8] {
            let model = lobe(f64::from(n));
            for step in 0..=31 {
                let wo = from_spherical(f64::from(step) * 0.05, 1.0).as_vec3();
                let want = model.albedo(wo.as_dvec3().normalize());
                let error = (f64::from(single(index, n, wo)) / want - 1.0).abs();
                worst = worst.max(error);
            }
        }
        println!("{name}: {worst:.1e}");
        assert!(worst < 1e-6, "{name}: {worst}");
    }
}
