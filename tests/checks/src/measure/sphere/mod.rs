//! What can be measured of a model over the whole sphere.

mod chart;

use brdf::{Lobe, Real, TransportMode, Vector};
use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::sampling::chi_squared::{Verdict, compare};
use super::sampling::draws::{epsilon, single_below};
use crate::interfaces::{Entry, MODES, Model, pairs, viewers};
use chart::Chart;

fn narrow<T: Real>(w: DVec3) -> T::Vec3 {
    Vector::new(T::lit(w.x), T::lit(w.y), T::lit(w.z))
}

fn wide<T: Real + Into<f64>>(w: T::Vec3) -> DVec3 {
    DVec3::new(w.x().into(), w.y().into(), w.z().into())
}

/// The difference of two colours in units in the last place of the larger channel.
fn ulps(a: DVec3, b: DVec3, epsilon: f64) -> f64 {
    let of = |(a, b): (f64, f64)| {
        let unit = a.abs().max(b.abs()).log2().floor().exp2() * epsilon;
        if a == b { 0.0 } else { (a - b).abs() / unit }
    };
    a.to_array().into_iter().zip(b.to_array()).map(of).fold(0.0, f64::max)
}

/// Draws of a model from one direction, counted.
#[derive(Debug)]
pub struct Sampling {
    pub double: Verdict,
    pub single: Verdict,
    /// 1 − ∫ pdf dω: the probability of lobes and of no direction.
    pub rest: f64,
}

/// Pearson's χ² of draws in cells that follow the lobes, one more for draws that are specular or give no
/// direction. The expectation of that one is 1 − ∫ pdf dω: with it the probabilities of all events have
/// the sum 1.
pub fn sampling(double: &Model<f64>, single: &Model<f32>, wo: DVec3, count: u32) -> Sampling {
    let wo = wo.as_vec3();
    let (mode, wide_wo) = (TransportMode::Radiance, wo.as_dvec3());
    let chart = Chart::new(wide_wo);
    let (mut mass, mut seen) = (vec![0.0; Chart::CELLS], vec![false; Chart::CELLS + 1]);
    chart.visit(|cell, wi, angle| {
        mass[cell] += angle * double.pdf(wi, wide_wo, mode);
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
    let counted = |draw: &dyn Fn([f64; 3]) -> Option<DVec3>| {
        let mut rng = Pcg64Mcg::seed_from_u64(3);
        let mut drawn = vec![0; Chart::CELLS + 1];
        for _ in 0..count {
            let wi = draw(std::array::from_fn(|_| rng.random()));
            drawn[wi.map_or(Chart::CELLS, |wi| chart.cell(wi))] += 1;
        }
        compare(&drawn, &expected)
    };
    Sampling {
        double: counted(&|u| {
            let sample = double.sample(wide_wo, u, mode);
            (sample.pdf > 0.0).then_some(sample.wi)
        }),
        single: counted(&|u| {
            let sample = single.sample(wo, u.map(single_below), mode);
            (sample.pdf > 0.0).then_some(sample.wi.as_dvec3())
        }),
        rest,
    }
}

/// How far a model is from what it promises, in units in the last place of its number.
#[derive(Clone, Copy, Debug, Default)]
pub struct Adjointness {
    /// f(wi, wo)/n_o² against f(wo, wi)/n_i².
    pub reciprocity: f64,
    /// Importance against radiance with the directions exchanged.
    pub modes: f64,
    /// The power along a lobe against that of the lobe back.
    pub lobes: f64,
    /// The weight of a draw against f |cosθ|/pdf.
    pub weights: f64,
}

/// Exchanges light and viewer of pairs all over the sphere, follows the lobes of some viewers back, and
/// compares weights of draws with values and densities.
pub fn adjointness<T: Real<Mask = bool> + Into<f64>>(entry: &Entry<T>) -> Adjointness {
    let (row, model, epsilon) = (entry.row, &*entry.model, epsilon::<T>());
    let mut found = Adjointness::default();
    for (wi, wo) in pairs() {
        let eval =
            |a: DVec3, b: DVec3, mode| wide::<T>(model.eval(narrow::<T>(a), narrow::<T>(b), mode));
        let there = eval(wi, wo, TransportMode::Radiance);
        let back = eval(wo, wi, TransportMode::Radiance);
        let [a, b] = [there / row.index_squared(wo), back / row.index_squared(wi)];
        found.reciprocity = found.reciprocity.max(ulps(a, b, epsilon));
        let importance = eval(wi, wo, TransportMode::Importance);
        found.modes = found.modes.max(ulps(importance, back, epsilon));
    }
    let mut rng = Pcg64Mcg::seed_from_u64(5);
    for (wo, mode) in viewers().into_iter().flat_map(|wo| MODES.map(|mode| (wo, mode))) {
        let wo = narrow::<T>(wo);
        let there = model.specular(wo, mode);
        for (lobe, transmitted) in [(there.reflected, false), (there.transmitted, true)] {
            let weight = wide::<T>(lobe.weight);
            if weight == DVec3::ZERO {
                continue;
            }
            let back = model.specular(lobe.wi, mode);
            let Lobe { weight: back, .. } =
                if transmitted { back.transmitted } else { back.reflected };
            let indices = match mode {
                TransportMode::Radiance => {
                    row.index_squared(wide::<T>(lobe.wi)) / row.index_squared(wide::<T>(wo))
                }
                TransportMode::Importance => 1.0,
            };
            found.lobes =
                found.lobes.max(ulps(weight * indices, wide::<T>(back) / indices, epsilon));
        }
        for _ in 0..2000 {
            let u: [f64; 3] = std::array::from_fn(|_| rng.random());
            let sample = model.sample(wo, u.map(T::lit), mode);
            let pdf: f64 = sample.pdf.into();
            if pdf > 0.0 {
                let value = wide::<T>(model.eval(sample.wi, wo, mode));
                let cos: f64 = sample.wi.z().into();
                let [a, b] = [wide::<T>(sample.weight) * pdf, value * cos.abs()];
                found.weights = found.weights.max(ulps(a, b, epsilon));
            }
        }
    }
    found
}

/// R + T of beams from both sides.
#[derive(Clone, Copy, Debug)]
pub struct Powers {
    pub least: f64,
    pub largest: f64,
}

/// Of the brightest channel, from the sides that the model answers for.
pub fn powers(entry: &Entry<f64>) -> Powers {
    let sides = viewers().into_iter().filter(|wo| wo.z > 0.0 || entry.row.is_open());
    let totals = sides.map(|wo| {
        let power = entry.model.power(wo);
        (power.reflectance + power.transmittance).max_element()
    });
    totals.fold(Powers { least: f64::INFINITY, largest: 0.0 }, |found, total| Powers {
        least: found.least.min(total),
        largest: found.largest.max(total),
    })
}

/// Relative errors of values in single precision: the median and the largest, `None` of a model without
/// values.
pub fn precision(double: &Entry<f64>, single: &Entry<f32>) -> Option<[f64; 2]> {
    let mut errors = Vec::new();
    for (wi, wo) in pairs() {
        let (wi, wo) = (wi.as_vec3(), wo.as_vec3());
        for mode in MODES {
            let want = double.model.eval(wi.as_dvec3(), wo.as_dvec3(), mode);
            let got = single.model.eval(wi, wo, mode).as_dvec3();
            let largest = want.max_element();
            if largest > super::precision::SMALLEST {
                errors.push((got - want).abs().max_element() / largest);
            }
        }
    }
    errors.sort_by(f64::total_cmp);
    Some([*errors.get(errors.len() / 2)?, *errors.last()?])
}
