//! Integrals over the hemisphere and statistics of samples, to hold models against.

use std::f64::consts::{FRAC_PI_2, TAU};

use brdf::quadrature::integrate;
use brdf::{Brdf, from_spherical};
use brdf_checks::measure::hemisphere::{cells, integrate as cubature};
use brdf_checks::measure::sampling::chi_squared::compare;
use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

pub(crate) type Model = Box<dyn Brdf<f64, Color = f64>>;

/// The integral over a piece of the sphere, θ and φ in the given ranges.
fn patch(theta: [f64; 2], phi: [f64; 2], formula: impl Fn(DVec3) -> f64) -> f64 {
    integrate(theta[0], theta[1], |theta: f64| {
        let ring = integrate(phi[0], phi[1], |phi| formula(from_spherical(theta, phi)));
        ring * theta.sin()
    })
}

/// ∫ f cosθᵢ dωᵢ for a viewer at azimuth 0, with an error below `tolerance`.
pub(crate) fn albedo(model: &dyn Brdf<f64, Color = f64>, theta_o: f64, tolerance: f64) -> f64 {
    let wo = from_spherical(theta_o, 0.0);
    let light = |wi: DVec3| DVec3::splat(model.eval(wi, wo) * wi.z);
    let integral = cubature(wo, &cells(model, wo), light, |_, error| error <= tolerance);
    assert!(integral.error <= tolerance, "{theta_o}: {integral:?}");
    integral.value.x
}

const RINGS: usize = 12;
const SECTORS: usize = 16;

/// Draws `count` directions and holds their histogram, failures included, against the integral
/// of the density. Asserts that a worse agreement has more than one chance in 10⁴, and that the
/// weight is f cosθᵢ/pdf. Gives back the probability of failure.
pub(crate) fn assert_samples_follow_pdf(
    name: &str,
    model: &dyn Brdf<f64, Color = f64>,
    wo: DVec3,
    count: u32,
) -> f64 {
    let mut rng = Pcg64Mcg::seed_from_u64(20_240_229);
    let mut histogram = vec![0_u32; RINGS * SECTORS + 1];
    for draw in 0..count {
        let sample = model.sample(wo, [rng.random(), rng.random()]);
        if sample.pdf == 0.0 {
            assert_eq!(sample.weight, 0.0, "{name}: a failed draw has a weight");
            histogram[RINGS * SECTORS] += 1;
            continue;
        }
        if draw < 1000 {
            let pdf = model.pdf(sample.wi, wo);
            let value = model.eval(sample.wi, wo) * sample.wi.z;
            let context = format!("{name} at {wo}: {sample:?}, pdf {pdf}, f cos {value}");
            assert!((sample.pdf - pdf).abs() <= 1e-9 * pdf, "{context}");
            assert!((sample.weight * pdf - value).abs() <= 1e-8 * value + 1e-12, "{context}");
        }
        let theta = sample.wi.z.acos() / FRAC_PI_2;
        let phi = sample.wi.y.atan2(sample.wi.x) / TAU + 0.5;
        let ring = ((theta * RINGS as f64) as usize).min(RINGS - 1);
        let sector = ((phi * SECTORS as f64) as usize).min(SECTORS - 1);
        histogram[ring * SECTORS + sector] += 1;
    }
    let mut expected = Vec::with_capacity(histogram.len());
    for ring in 0..RINGS {
        let theta = [ring, ring + 1].map(|edge| edge as f64 / RINGS as f64 * FRAC_PI_2);
        for sector in 0..SECTORS {
            let phi = [sector, sector + 1].map(|edge| (edge as f64 / SECTORS as f64 - 0.5) * TAU);
            expected.push(patch(theta, phi, |wi| model.pdf(wi, wo)) * f64::from(count));
        }
    }
    let failures = f64::from(count) - expected.iter().sum::<f64>();
    assert!(failures > -1e-5 * f64::from(count), "{name} at {wo}: the density exceeds 1");
    expected.push(failures.max(0.0));
    let expected: Vec<(f64, f64)> = expected.into_iter().map(|want| (want, 0.0)).collect();
    let verdict = compare(&histogram, &expected);
    assert!(verdict.p_value > 1e-4, "{name} at {wo}: {verdict:?}");
    failures / f64::from(count)
}
