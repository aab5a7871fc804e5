//! What is measured of one model.

use glam::{DVec3, Vec3};

use crate::common::directions::pairs_to_grazing;
use crate::common::measure::energy::{Energy, energy};
use crate::common::measure::precision::{Precision, Quantity, precision};
use crate::common::measure::reciprocity::{Reciprocity, reciprocity};
use crate::common::models::Entry;

/// Angles of the viewer for the albedo.
pub(crate) const ANGLES: u32 = 48;
/// Pairs of directions for reciprocity and precision.
pub(crate) const PAIRS: usize = 100_000;

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
    /// Seeded bugs in what the model computes, and how many of them the checks find.
    pub(crate) bugs: usize,
    pub(crate) found: usize,
}

impl Row {
    pub(crate) fn measure(single: &Entry<f32>, double: &Entry<f64>, pairs: &Pairs) -> Self {
        let path = double.type_name.split('<').next().unwrap_or_default();
        Self {
            name: double.name,
            kind: path.rsplit(':').next().unwrap_or_default().to_owned(),
            energy: energy(&*double.model, ANGLES, 1e-6),
            reciprocity_f32: reciprocity(&*single.model, &pairs.single, f64::from(f32::EPSILON)),
            reciprocity_f64: reciprocity(&*double.model, &pairs.double, f64::EPSILON),
            precision: precision(Quantity::Eval, &*single.model, &*double.model, &pairs.single),
            bugs: 0,
            found: 0,
        }
    }
}
