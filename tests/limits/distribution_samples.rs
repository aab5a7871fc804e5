//! Samples of facet normals against the density they promise, by χ².

use std::f64::consts::TAU;

use brdf::{Beckmann, Blinn, Distribution, Gaussian, Ggx, Mixture, Smith, from_spherical};
use brdf_checks::measure::sampling::chi_squared::compare;
use brdf_checks::slopes::Facing;
use glam::{DVec2, DVec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

const SAMPLES: u32 = 200_000;
const CELLS: usize = 12;
/// A correct sampler falls below this once in ten thousand tests; there are about a hundred.
const LEAST_P: f64 = 1e-4;

/// The probability of a χ² at least as large as that of `draw` against `density` per steradian.
fn p_value(
    facing: &Facing,
    density: impl Fn(DVec3) -> f64,
    draw: impl Fn([f64; 2]) -> DVec3,
) -> f64 {
    let width = |[from, to]: [f64; 2]| (to - from) / CELLS as f64;
    let (chi_width, psi_width) = (width(facing.chi), width(facing.psi));
    let mut counts = [0_u32; CELLS * CELLS];
    let mut rng = Pcg64Mcg::seed_from_u64(0xfacade);
    for _ in 0..SAMPLES {
        let h = draw([rng.random(), rng.random()]);
        let [chi, psi] = facing.coordinates(h);
        let cell = |angle: f64, from: f64, width: f64| {
            (((angle - from) / width).max(0.0) as usize).min(CELLS - 1)
        };
        let row = cell(chi, facing.chi[0], chi_width);
        counts[row * CELLS + cell(psi, facing.psi[0], psi_width)] += 1;
    }
    let parts = (0..CELLS * CELLS).map(|cell| {
        let chi = facing.chi[0] + chi_width * (cell / CELLS) as f64;
        let psi = facing.psi[0] + psi_width * (cell % CELLS) as f64;
        facing.integral([chi, chi + chi_width], [psi, psi + psi_width], 1, &density)
    });
    let parts: Vec<f64> = parts.collect();
    let total: f64 = parts.iter().sum();
    assert!((total - 1.0).abs() < 1e-4, "the density sums to {total}");
    let expected: Vec<_> = parts.iter().map(|part| (part * f64::from(SAMPLES), 0.0)).collect();
    let verdict = compare(&counts, &expected);
    assert!(verdict.terms > 30, "{} cells say little", verdict.terms);
    verdict.p_value
}

fn check_sample(name: &str, distribution: &dyn Distribution<f64>, scale: [f64; 2]) {
    let p = p_value(
        &Facing::new(DVec3::Z, scale),
        |h| distribution.density(h) * h.z,
        |u| distribution.sample(u),
    );
    assert!(p > LEAST_P, "{name}: p = {p:e}");
}

fn check_visible(name: &str, distribution: &dyn Smith<f64>, scale: [f64; 2]) {
    for wo in [
        DVec3::Z,
        from_spherical(0.02, 1.0),
        from_spherical(0.7, 2.0),
        from_spherical(1.3, -0.5),
        DVec3::new(0.6, -0.8, 1e-3).normalize(),
        DVec3::new(0.0, 1.0, 1e-20),
    ] {
        let p = p_value(
            &Facing::new(wo, scale),
            |h| {
                let facing = wo.dot(h).max(0.0);
                facing * distribution.density(h) / (wo.z + distribution.lambda_cos(wo))
            },
            |u| distribution.sample_visible(wo, u),
        );
        assert!(p > LEAST_P, "{name} from {wo}: p = {p:e}");
    }
}

const SCALES: [[f64; 2]; 5] = [[0.01, 0.01], [0.3, 0.3], [1.5, 1.5], [0.1, 0.6], [2.0, 0.05]];

#[test]
fn beckmann() {
    for scale in SCALES {
        let beckmann = Beckmann::anisotropic(scale[0], scale[1]).unwrap();
        check_sample("Beckmann", &beckmann, scale);
        check_visible("Beckmann", &beckmann, scale);
    }
}

#[test]
fn ggx() {
    for scale in SCALES {
        let ggx = Ggx::anisotropic(scale[0], scale[1]).unwrap();
        check_sample("GGX", &ggx, scale);
        check_visible("GGX", &ggx, scale);
    }
}

#[test]
fn gaussian() {
    for roughness in [1e-3, 0.1, 0.25, 0.35, 0.6, 1.0, 3.0, 1e4] {
        let width = f64::min(roughness, 1.0);
        check_sample("Gaussian", &Gaussian::new(roughness).unwrap(), [width, width]);
    }
}

#[test]
fn blinn() {
    for exponent in [0.0, 0.5, 3.0, 100.0, 1e6] {
        let width = f64::sqrt(2.0 / (exponent + 2.0));
        check_sample("Blinn", &Blinn::new(exponent).unwrap(), [width, width]);
    }
}

#[test]
fn mixture() {
    let components = [
        (0.5, Ggx::anisotropic(0.3, 0.2).unwrap()),
        (0.0, Ggx::new(0.5).unwrap()),
        (1.5, Ggx::new(0.6).unwrap()),
        (1.0, Ggx::anisotropic(0.1, 0.4).unwrap()),
    ];
    let mixture = Mixture::new(components).unwrap();
    check_sample("mixture of GGX", &mixture, [0.3, 0.3]);
    check_visible("mixture of GGX", &mixture, [0.3, 0.3]);
    let components = [(0.4, Beckmann::new(0.2).unwrap()), (0.6, Beckmann::new(0.7).unwrap())];
    let mixture = Mixture::new(components).unwrap();
    check_sample("mixture of Beckmann", &mixture, [0.4, 0.4]);
    check_visible("mixture of Beckmann", &mixture, [0.4, 0.4]);
}

#[test]
fn a_wrong_density_is_noticed() {
    let (drawn, claimed) = (Ggx::new(0.312).unwrap(), Ggx::new(0.3).unwrap());
    let p = p_value(
        &Facing::new(DVec3::Z, [0.3, 0.3]),
        |h| claimed.density(h) * h.z,
        |u| drawn.sample(u),
    );
    assert!(p < LEAST_P, "p = {p:e}");
    // Choosing the parts of a mixture by their weights draws the wrong visible normals.
    let parts = [Ggx::new(0.2).unwrap(), Ggx::new(0.6).unwrap()];
    let mixture = Mixture::new(parts.map(|part| (0.5, part))).unwrap();
    let wo = from_spherical(1.3, 0.3);
    let p = p_value(
        &Facing::new(wo, [0.3, 0.3]),
        |h| wo.dot(h).max(0.0) * mixture.density(h) / (wo.z + mixture.lambda_cos(wo)),
        |[u0, u1]| parts[usize::from(u0 > 0.5)].sample_visible(wo, [2.0 * u0 % 1.0, u1]),
    );
    assert!(p < LEAST_P, "p = {p:e}");
}

/// Single precision draws what double draws: the same slopes for the same numbers, up to the
/// rounding of numbers near 1, where slopes change fast.
#[test]
fn single_precision_follows_double() {
    let mut rng = Pcg64Mcg::seed_from_u64(3);
    let slopes = |h: DVec3| DVec2::new(h.x, h.y) / h.z;
    for _ in 0..20_000 {
        let u: [f32; 2] = [rng.random(), rng.random()];
        let wide = u.map(f64::from);
        let wo = from_spherical(rng.random::<f64>() * 1.57, rng.random::<f64>() * TAU).as_vec3();
        let check = |name: &str, single: glam::Vec3, double: DVec3| {
            let (got, want) = (slopes(single.as_dvec3()), slopes(double));
            let room = (1.0 - wide[0]).min(1.0 - wide[1]);
            let error = (got - want).length() / (1.0 + want.length());
            assert!(error * room < 4e-6, "{name} {u:?} {wo}: {got} for {want}");
        };
        let (single, double) = (Ggx::new(0.5_f32).unwrap(), Ggx::new(0.5_f64).unwrap());
        check("GGX", single.sample(u), double.sample(wide));
        let (visible, exact) =
            (single.sample_visible(wo, u), double.sample_visible(wo.as_dvec3(), wide));
        check("visible GGX", visible, exact);
        let (single, double) = (Beckmann::new(0.5_f32).unwrap(), Beckmann::new(0.5_f64).unwrap());
        check("Beckmann", single.sample(u), double.sample(wide));
        let (visible, exact) =
            (single.sample_visible(wo, u), double.sample_visible(wo.as_dvec3(), wide));
        check("visible Beckmann", visible, exact);
        let (single, double) = (Gaussian::new(0.5_f32).unwrap(), Gaussian::new(0.5_f64).unwrap());
        check("Gaussian", single.sample(u), double.sample(wide));
        let (single, double) = (Blinn::new(30.0_f32).unwrap(), Blinn::new(30.0_f64).unwrap());
        check("Blinn", single.sample(u), double.sample(wide));
    }
}
