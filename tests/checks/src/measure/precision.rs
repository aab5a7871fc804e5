//! What single precision keeps of double precision.

use brdf::Brdf;
use glam::{DVec3, Vec3};

use super::Model64;

/// A model in single precision.
pub type Model32 = dyn Brdf<f32, Color = Vec3>;

/// The difference of `f32` from `f64` on the same inputs.
#[derive(Clone, Copy, Debug)]
pub struct Precision {
    /// Relative to the value, over all values above [`SMALLEST`].
    pub median: f64,
    pub maximum: f64,
    /// The largest quotient of the difference by [`bound`].
    pub ratio: f64,
    /// Where that is.
    pub worst: (Vec3, Vec3),
}

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    Eval,
    Pdf,
}

impl Quantity {
    fn single(self, model: &Model32, wi: Vec3, wo: Vec3) -> DVec3 {
        match self {
            Self::Eval => model.eval(wi, wo).as_dvec3(),
            Self::Pdf => DVec3::splat(f64::from(model.pdf(wi, wo))),
        }
    }

    fn double(self, model: &Model64, wi: DVec3, wo: DVec3) -> DVec3 {
        match self {
            Self::Eval => model.eval(wi, wo),
            Self::Pdf => DVec3::splat(model.pdf(wi, wo)),
        }
    }
}

/// Below, factors of a value are numbers that `f32` holds with fewer digits, or not at all.
pub const SMALLEST: f64 = 1e-30;

/// How much of its value an error may be, beside what rounding of its arguments does.
pub const RELATIVE: f64 = 2e-6;

/// How often a number is rounded on its way into a lobe. A component of a direction: in wi + wo or
/// wi − wo, when the sum is divided by its length, when it is divided by the roughness. The
/// argument of an exponential or a power: in a square, in a sum of two, in a quotient or product.
const ROUNDINGS: f64 = 3.0;

/// Mixed forward and backward stability: how much `f32` may be off, with half a unit in the last
/// place for each rounding. The sum of
///
/// - 2·10⁻⁶ of the value;
/// - the change of the value while each component of both directions in turn moves by its
///   roundings. The directions came with one such error already, and no arrangement of a formula
///   undoes what a narrow lobe or a steep flank makes of it;
/// - the change while the argument of an exponential moves by its roundings, which counts by how
///   many powers of e the value lies below the `peak` of the model: the roughness or the exponent
///   came with such an error too;
/// - the least normal number of `f32`, below which there are no digits, also as the factor of a
///   visibility of up to 1/(4 cosθᵢ cosθₒ).
fn bound(value: DVec3, peak: f64, at: impl Fn(DVec3, DVec3) -> DVec3, wi: Vec3, wo: Vec3) -> DVec3 {
    let tiny = f64::from(f32::MIN_POSITIVE);
    let depth = (peak / value.max_element().max(tiny)).ln();
    let unit = 0.5 * f64::from(f32::EPSILON);
    let visibility = (0.25 / (f64::from(wi.z) * f64::from(wo.z))).max(1.0);
    let mut bound = value * (RELATIVE + ROUNDINGS * unit * depth) + DVec3::splat(tiny * visibility);
    for component in 0..6 {
        let mut largest = DVec3::ZERO;
        for side in [-0.5 * ROUNDINGS, 0.5 * ROUNDINGS] {
            let (mut moved_i, mut moved_o) = (wi.as_dvec3(), wo.as_dvec3());
            let moved = if component < 3 { &mut moved_i } else { &mut moved_o };
            let x = if component < 3 { wi[component] } else { wo[component - 3] };
            moved[component % 3] += side * (f64::from(x.abs().next_up()) - f64::from(x.abs()));
            largest = largest.max((at(moved_i, moved_o) - value).abs());
        }
        bound += largest;
    }
    bound
}

/// Compares at the given pairs of directions.
pub fn precision(
    quantity: Quantity,
    single: &Model32,
    double: &Model64,
    pairs: &[(Vec3, Vec3)],
) -> Precision {
    let at = |wi: DVec3, wo: DVec3| quantity.double(double, wi, wo);
    let (mut ratio, mut worst) = (0.0, (Vec3::ZERO, Vec3::ZERO));
    let mut relative = Vec::new();
    let peak = pairs
        .iter()
        .map(|(wi, wo)| at(wi.as_dvec3(), wo.as_dvec3()).max_element())
        .fold(0.0, f64::max);
    for &(wi, wo) in pairs {
        let want = at(wi.as_dvec3(), wo.as_dvec3());
        let error = (quantity.single(single, wi, wo) - want).abs();
        let largest = want.max_element();
        if largest > SMALLEST {
            relative.push(error.max_element() / largest);
        }
        // The bound takes twelve evaluations; most errors need none of them.
        if error.cmple(want * (RELATIVE * ratio)).all() {
            continue;
        }
        let quotient = (error / bound(want, peak, at, wi, wo)).max_element();
        if quotient > ratio {
            (ratio, worst) = (quotient, (wi, wo));
        }
    }
    relative.sort_by(f64::total_cmp);
    let median = relative.get(relative.len() / 2).copied().unwrap_or(0.0);
    let maximum = relative.last().copied().unwrap_or(0.0);
    Precision { median, maximum, ratio, worst }
}
