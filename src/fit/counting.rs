//! What counts of the measurements, once they are checked.

use glam::DVec3;

use super::error::{FitError, Unfit};
use crate::direction::check_direction;
use crate::error::Range;

/// A measured value; further off it is a mistake and no light.
const VALUE: Range = Range { lower: -1e100, upper: 1e100 };

/// A weight.
const WEIGHT: Range = Range { lower: 0.0, upper: 1e100 };

/// How far a cosine may lie above 1: what a few roundings make of a dot product in `f32`.
const ROUNDING: f64 = 1e-6;

/// The cosine of an angle of incidence.
const COSINE: Range = Range { lower: 0.0, upper: 1.0 };

/// What counts of the measurements.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct Counting<P> {
    /// Those that have a weight, in parts of the largest one.
    pub(super) points: Vec<P>,
    /// How many channels have one.
    pub(super) count: usize,
    /// The largest weight.
    pub(super) unit: f64,
}

/// The measurements with a weight, each checked.
pub(super) fn counting<P: Copy>(
    points: &[P],
    weight: impl Fn(&mut P) -> &mut DVec3,
    check: impl Fn(&P) -> Result<(), Unfit>,
) -> Result<Counting<P>, FitError> {
    let (mut count, mut unit, mut kept) = (0, 0.0_f64, Vec::with_capacity(points.len()));
    for (index, point) in points.iter().enumerate() {
        let mut point = *point;
        let unfit = |problem| FitError::Measured { index, problem };
        let weight = *weight(&mut point);
        each_channel("weight", WEIGHT, weight, DVec3::ONE).map_err(unfit)?;
        if weight == DVec3::ZERO {
            continue;
        }
        check(&point).map_err(unfit)?;
        count += weight.to_array().iter().filter(|weight| **weight > 0.0).count();
        unit = unit.max(weight.max_element());
        kept.push(point);
    }
    for point in &mut kept {
        *weight(point) /= unit;
    }
    Ok(Counting { points: kept, count, unit })
}

/// Checks the channels that count.
fn each_channel(
    parameter: &'static str,
    range: Range,
    value: DVec3,
    weight: DVec3,
) -> Result<(), Unfit> {
    for (channel, (value, weight)) in
        value.to_array().into_iter().zip(weight.to_array()).enumerate()
    {
        if weight > 0.0 {
            range.check(parameter, value).map_err(|error| Unfit::Number(error.at(channel)))?;
        }
    }
    Ok(())
}

/// Checks the channels of a measured value that count.
pub(super) fn value(parameter: &'static str, value: DVec3, weight: DVec3) -> Result<(), Unfit> {
    each_channel(parameter, VALUE, value, weight)
}

/// Checks the cosine of an angle of incidence.
pub(super) fn cosine(cos: f64) -> Result<(), Unfit> {
    // What exceeds 1 by the rounding of a dot product counts as 1.
    if (1.0..=1.0 + ROUNDING).contains(&cos) {
        return Ok(());
    }
    COSINE.check("cos", cos).map_err(Unfit::Number)
}

/// Checks a direction that must lie above the surface.
pub(super) fn above(direction: &'static str, w: DVec3) -> Result<(), Unfit> {
    check_direction(w).map_err(|error| Unfit::NoDirection { direction, error })?;
    if w.z > 0.0 { Ok(()) } else { Err(Unfit::Below { direction }) }
}

/// The sum of the squares of weighted values.
pub(super) fn size(values: impl Iterator<Item = (DVec3, DVec3)>) -> f64 {
    let squares = values.map(|(value, weight)| {
        let both = value.to_array().into_iter().zip(weight.to_array());
        both.map(|(value, weight)| if weight > 0.0 { (value * weight).powi(2) } else { 0.0 })
            .sum::<f64>()
    });
    squares.sum()
}
