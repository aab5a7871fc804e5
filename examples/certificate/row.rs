//! What is measured of one model.

use glam::{DVec3, Vec3};
use rayon::prelude::*;

use crate::cost::{Cost, costs};
use brdf_checks::directions::pairs_to_grazing;
use brdf_checks::measure::derivatives::{Derivatives, LARGEST, of_reflection, questions};
use brdf_checks::measure::energy::{Energy, energy};
use brdf_checks::measure::precision::{Precision, Quantity, precision};
use brdf_checks::measure::reciprocity::{Reciprocity, reciprocity};
use brdf_checks::measure::sampling::{
    ALBEDO_Z, EXCESS, Sampling, Size, WEIGHT_ULPS, measure, viewers,
};
use brdf_checks::models::{self, Entry};

/// Angles of the viewer for the albedo.
pub(crate) const ANGLES: u32 = 48;
/// Pairs of directions for reciprocity and precision.
pub(crate) const PAIRS: usize = 100_000;

/// Pairs of directions for derivatives, and how many of their viewers the albedo is asked for.
pub(crate) const DERIVATIVES: (usize, usize) = (1000, 8);

/// Draws from each of some directions, in each precision, and the integrals that they are held
/// against.
pub(crate) const SIZE: Size =
    Size { pilot: 16_000, draws: 1_000_000, tolerance: 1.5e-7, budget: 600_000 };

pub(crate) struct Pairs {
    single: Vec<(Vec3, Vec3)>,
    double: Vec<(DVec3, DVec3)>,
}

impl Pairs {
    pub(crate) fn new() -> Self {
        let double = pairs_to_grazing(PAIRS);
        let single = double.iter().map(|(wi, wo)| (wi.as_vec3(), wo.as_vec3())).collect();
        Self { single, double }
    }
}

pub(crate) struct Row {
    pub(crate) name: &'static str,
    /// The model without its parts and parameters.
    pub(crate) kind: String,
    pub(crate) energy: Energy,
    pub(crate) reciprocity_f32: Reciprocity,
    pub(crate) reciprocity_f64: Reciprocity,
    pub(crate) precision: Precision,
    pub(crate) derivatives: Derivatives,
    /// From each direction of the viewer.
    pub(crate) sampling: Vec<Sampling>,
    /// What one call of `eval`, `pdf` and `sample` costs.
    pub(crate) costs: [Cost; 3],
    /// Seeded bugs in what the model computes, and how many of them the checks find.
    pub(crate) bugs: usize,
    pub(crate) found: usize,
}

impl Row {
    /// Of the entry at this place of the registry.
    pub(crate) fn measure(
        index: usize,
        single: &Entry<f32>,
        double: &Entry<f64>,
        pairs: &Pairs,
    ) -> Self {
        let row = &models::rows()[index];
        let (pairs_of_directions, albedos) = DERIVATIVES;
        let albedos = if row.has_exact_albedo() { albedos } else { 0 };
        Self {
            name: double.name,
            kind: row.type_name(),
            energy: energy(&*double.model, ANGLES, 1e-6),
            reciprocity_f32: reciprocity(&*single.model, &pairs.single, f64::from(f32::EPSILON)),
            reciprocity_f64: reciprocity(&*double.model, &pairs.double, f64::EPSILON),
            precision: precision(Quantity::Eval, &*single.model, &*double.model, &pairs.single),
            derivatives: of_reflection(&row.brdf, &questions(pairs_of_directions, albedos)),
            sampling: sampling(index, single, double),
            costs: costs(index),
            bugs: 0,
            found: 0,
        }
    }
}

fn sampling(index: usize, single: &Entry<f32>, double: &Entry<f64>) -> Vec<Sampling> {
    let viewers = viewers::all();
    let first = index * viewers.len();
    viewers
        .into_par_iter()
        .enumerate()
        .map(|(viewer, (_, wo))| {
            measure(&*double.model, &*single.model, wo, (first + viewer) as u64, SIZE)
        })
        .collect()
}

impl Row {
    /// The largest |∫ pdf dω + P(no direction) − 1|.
    pub(crate) fn mass_error(&self) -> f64 {
        self.sampling.iter().map(|seen| seen.excess().abs()).fold(0.0, f64::max)
    }

    /// The least probability of a χ² as large, over directions and precisions.
    pub(crate) fn p_value(&self) -> f64 {
        let both = |seen: &Sampling| seen.double.verdict.p_value.min(seen.single.verdict.p_value);
        self.sampling.iter().map(both).fold(1.0, f64::min)
    }

    /// How far weights are from eval · cosθ/pdf, in units in the last place.
    pub(crate) fn weight_ulps(&self) -> f64 {
        let both = |seen: &Sampling| seen.double.weight_ulps.max(seen.single.weight_ulps);
        self.sampling.iter().map(both).fold(0.0, f64::max)
    }

    /// How far mean weights are from the albedo, in standard errors.
    fn albedo_z(&self) -> f64 {
        let both = |seen: &Sampling| seen.double.albedo_z.max(seen.single.albedo_z);
        self.sampling.iter().map(both).fold(0.0, f64::max)
    }

    /// What is wrong with the derivatives.
    fn wrong_derivatives(&self) -> Option<String> {
        let Derivatives { largest, place, faults, .. } = &self.derivatives;
        let wrong = (*largest > LARGEST).then(|| format!("{largest:.1e}: {place}"));
        wrong.or_else(|| faults.first().cloned()).map(|wrong| format!("{}: {wrong}", self.name))
    }

    /// What the model does that it must not, if no right sampler has a p below `least`.
    pub(crate) fn fault(&self, least: f64) -> Option<String> {
        self.wrong_derivatives().or_else(|| self.wrong_samples(least))
    }

    fn wrong_samples(&self, least: f64) -> Option<String> {
        let (p, excess) = (self.p_value(), self.mass_error());
        let (ulps, z) = (self.weight_ulps(), self.albedo_z());
        let right = p > least && excess <= EXCESS && ulps <= WEIGHT_ULPS && z <= ALBEDO_Z;
        (!right).then(|| {
            let Self { name, .. } = self;
            format!(
                "{name}: p {p:.1e}, |∫ pdf + P − 1| {excess:.1e}, weight {ulps:.1} ulp, \
                 mean weight {z:.1} standard errors from the albedo"
            )
        })
    }
}
