//! What holds for every model of the registry, checked on models over numbers that err.

use std::cell::Cell;
use std::f64::consts::PI;
use std::sync::LazyLock;

use brdf::quadrature::mean_over_square;
use brdf::{Brdf, from_spherical};
use glam::DVec3;

use super::suite::Subject;
use crate::directions::pairs_to_grazing;
use crate::measure;
use crate::measure::hemisphere::{cells, integrate};
use crate::values::{Verdict, fail};

/// Viewers: near the normal, oblique off the axes, grazing.
fn viewers() -> [DVec3; 4] {
    [(0.02, 0.5), (0.6, 2.3), (1.1, -2.0), (1.5, 0.9)]
        .map(|(theta, phi)| from_spherical(theta, phi))
}

/// A lattice of places in the unit square, off its edges.
fn places(count: u32) -> impl Iterator<Item = [f64; 2]> {
    (0..count).map(move |index| {
        let along = (f64::from(index) + 0.5) / f64::from(count);
        [along, (f64::from(index) * 0.618_033_988_749_894_9 + 0.25).fract()]
    })
}

/// Whether every component is at most that large; one that is not a number is not.
fn within(difference: DVec3, bound: f64) -> bool {
    difference.to_array().into_iter().all(|component| component.abs() <= bound)
}

/// f(wi, wo) = f(wo, wi) to the last bit, or not at all.
pub(super) fn reciprocity(subject: &Subject) -> Verdict {
    static PAIRS: LazyLock<Vec<(DVec3, DVec3)>> = LazyLock::new(|| pairs_to_grazing(1000));
    let found = measure::reciprocity::reciprocity(&*subject.model, &PAIRS, f64::EPSILON);
    let holds = if subject.promises.reciprocal { found.ulp == 0.0 } else { found.relative > 0.5 };
    if holds { Ok(()) } else { fail(format!("{found:?}")) }
}

/// A sample tells what `eval` and `pdf` say of its direction.
pub(super) fn samples_agree(subject: &Subject) -> Verdict {
    for wo in viewers() {
        for u in places(60) {
            let sample = subject.model.sample(wo, u);
            if sample.pdf == 0.0 {
                continue;
            }
            let pdf = subject.model.pdf(sample.wi, wo);
            let radiance = subject.model.eval(sample.wi, wo) * sample.wi.z;
            let bound = 1e-8 * radiance.max_element() + 1e-12;
            let close = (sample.pdf - pdf).abs() <= 1e-9 * pdf
                && within(sample.weight * pdf - radiance, bound);
            if !close {
                return fail(format!("{sample:?}, but pdf {pdf} and f cosθ {radiance} at {wo}"));
            }
        }
    }
    Ok(())
}

/// The solid angle that belongs to a small area of u around a sample, per that area.
fn spread(model: &dyn Brdf<f64, Color = DVec3>, wo: DVec3, u: [f64; 2]) -> Option<(DVec3, f64)> {
    const STEP: f64 = 1e-5;
    let at = |u| Some(model.sample(wo, u)).filter(|sample| sample.pdf > 0.0).map(|s| s.wi);
    let first = at([u[0] + STEP, u[1]])? - at([u[0] - STEP, u[1]])?;
    let second = at([u[0], u[1] + STEP])? - at([u[0], u[1] - STEP])?;
    Some((at(u)?, first.cross(second).length() / (4.0 * STEP * STEP)))
}

/// The density is the inverse of the solid angle over which a sampler spreads its numbers. Where
/// several numbers lead to one direction, their densities add up, so that it is at least that.
pub(super) fn density_is_the_jacobian(subject: &Subject) -> Verdict {
    for wo in viewers() {
        let (mut off, mut seen, mut worst) = (0, 0, 0.0_f64);
        for u in
            places(100).filter(|u| (0.03..0.97).contains(&u[0]) && (0.03..0.97).contains(&u[1]))
        {
            let Some((wi, area)) = spread(&*subject.model, wo, u) else { continue };
            let product = subject.model.pdf(wi, wo) * area;
            let close = if subject.promises.one_to_one {
                (product - 1.0).abs() < 1e-4
            } else {
                product > 1.0 - 1e-4
            };
            seen += 1;
            if !close {
                off += 1;
                worst = if product.is_nan() { product } else { worst.max((product - 1.0).abs()) };
            }
        }
        // A step may cross one of the few edges where a piecewise sampler has a kink.
        if seen < 10 || off > 3 {
            return fail(format!("{off} of {seen} densities are off, by up to {worst} at {wo}"));
        }
    }
    Ok(())
}

/// Moments of the samples are those of the density.
pub(super) fn moments_of_samples(subject: &Subject) -> Verdict {
    if subject.promises.one_to_one {
        return Ok(());
    }
    let moments = |w: DVec3| [DVec3::ONE, w, w * w, DVec3::new(w.x * w.y, w.y * w.z, w.x * w.z)];
    let wo = from_spherical(0.5, 0.4);
    let cells = cells(&*subject.model, wo);
    let lost = Cell::new(false);
    for row in 0..4 {
        let samples: DVec3 = mean_over_square(|u| {
            let sample = subject.model.sample(wo, u);
            lost.set(lost.get() || sample.pdf == 0.0);
            if sample.pdf > 0.0 { moments(sample.wi)[row] } else { DVec3::ZERO }
        });
        // What the lattice promises where samples end along a line of the square.
        let bound = if lost.get() { 2e-3 } else { 1e-3 };
        let formula = |wi| moments(wi)[row] * subject.model.pdf(wi, wo);
        let density = integrate(wo, &cells, formula, |_, error| error <= 1e-4).value;
        if !within(samples - density, bound) {
            return fail(format!("moments {row} of samples {samples}, of the density {density}"));
        }
    }
    Ok(())
}

/// The albedo is the integral of f, no larger than 1, or as large as the registry says where it
/// says.
pub(super) fn energy(subject: &Subject) -> Verdict {
    let integral = |wo| {
        let cells = cells(&*subject.model, wo);
        let formula = |wi: DVec3| subject.model.eval(wi, wo) * wi.z;
        integrate(wo, &cells, formula, |value, error| error <= 1e-4 * value.max_element())
    };
    for wo in &viewers()[1..] {
        let (albedo, integral) = (subject.model.albedo(*wo), integral(*wo));
        // The lattice behind the default is within 5·10⁻⁴ of that of F = 1.
        let scale = subject.promises.gain.map_or(1.0, |gain| gain.albedo.max(1.0));
        if !within(albedo - integral.value, 1e-3 * scale) {
            return fail(format!("albedo {albedo}, but {integral:?} at {wo}"));
        }
        if subject.promises.gain.is_none() && !within(integral.value, 1.0 + 1e-12 + integral.error)
        {
            return fail(format!("reflects {integral:?} at {wo}"));
        }
    }
    if let Some(gain) = subject.promises.gain {
        // Close to 90° the albedo has still about cosθ to go.
        let theta = gain.degrees.min(89.99).to_radians();
        let found = integral(from_spherical(theta, PI)).value.max_element();
        if !within(DVec3::splat(found / gain.albedo - 1.0), 1e-3) {
            return fail(format!("reflects {found} where {gain:?}"));
        }
    }
    Ok(())
}

/// Every answer is finite and not negative, whatever goes in; nothing is reflected below the
/// surface or towards what is no direction.
pub(super) fn robustness(subject: &Subject) -> Verdict {
    let mut directions = vec![DVec3::Z, -DVec3::Z, DVec3::X, DVec3::ZERO, DVec3::NAN];
    directions.push(DVec3::splat(f64::MAX));
    directions.push(DVec3::splat(f64::INFINITY));
    directions.push(DVec3::new(0.0, 0.3, 0.9));
    for cos in [1e-320, 1e-160, 1e-20, 1e-7, 1e-3, 0.5, 1.0 - 1e-9] {
        for phi in [0.3, 0.3 + PI] {
            let sin = ((1.0_f64 - cos) * (1.0 + cos)).sqrt();
            directions.push(DVec3::new(sin * phi.cos(), sin * phi.sin(), cos));
        }
    }
    let real = |w: DVec3| w.z > 0.0 && (w.length_squared() - 1.0).abs() <= 0.01;
    let sane = |value: f64| value.is_finite() && value >= 0.0;
    let sane_color = |color: DVec3| color.to_array().into_iter().all(sane);
    for wo in [-DVec3::Z, DVec3::NAN] {
        let albedo = subject.model.albedo(wo);
        if albedo != DVec3::ZERO {
            return fail(format!("albedo {albedo} at {wo}"));
        }
    }
    for &wo in &directions {
        for &wi in &directions {
            let (value, pdf) = (subject.model.eval(wi, wo), subject.model.pdf(wi, wo));
            let hidden = !real(wi) || !real(wo);
            if !sane_color(value) || !sane(pdf) || hidden && (value, pdf) != (DVec3::ZERO, 0.0) {
                return fail(format!("f {value}, pdf {pdf} at {wi} {wo}"));
            }
        }
        for u in [0.0, 1e-300, 1e-9, 0.3, 0.5, 0.75, 1.0 - 1e-9, 1.0 - f64::EPSILON / 2.0] {
            for v in [0.0, 0.25, 0.6, 1.0 - f64::EPSILON / 2.0] {
                let sample = subject.model.sample(wo, [u, v]);
                let lost = sample.pdf == 0.0 || real(sample.wi);
                let hidden = !real(wo) && (sample.weight, sample.pdf) != (DVec3::ZERO, 0.0);
                if !sane_color(sample.weight) || !sane(sample.pdf) || !lost || hidden {
                    return fail(format!("{sample:?} for {u} {v} at {wo}"));
                }
            }
        }
    }
    Ok(())
}

/// Answers of a model from everywhere, to see what it is made of.
pub(super) fn probe(model: &dyn Brdf<f64, Color = DVec3>) {
    for wo in viewers() {
        for u in places(16) {
            let sample = model.sample(wo, u);
            model.eval(sample.wi, wo);
            model.pdf(sample.wi, wo);
        }
    }
    model.albedo(viewers()[1]);
}
