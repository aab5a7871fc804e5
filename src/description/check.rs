//! What the range of a single number cannot tell.

use core::marker::PhantomData;

use glam::DVec3;

use super::bsdf::bsdf;
use super::build::Build;
use super::channels::Channels;
use super::error::{DescriptionError, Problem};
use super::fresnel::fresnel;
use super::path::Path;
use super::value::{Described, Numbers, Value};
use crate::error::range;
use crate::parameter::Part;
use crate::real::Color;

/// Checks a form whose numbers are in their ranges, and whose parts are checked.
pub(super) fn check(described: &Described, path: &Path<'_>) -> Result<(), DescriptionError> {
    match described.form.name() {
        "sum" => total(described, "total weight", path),
        "mixture" => total(described, "sum of weights", path),
        "stack" => built(described, path, fresnel::<f64, DVec3>).map(drop),
        "belcour_barla" => same_in_all_channels(described, &path.key("substrate")),
        "rough_dielectric" if !is_facets(described) => {
            Err(path.key("distribution").error(Problem::NotRefracting))
        }
        // The material, and what its index comes to relative to that outside.
        "metal" => built(described, path, fresnel::<f64, DVec3>).map(drop),
        "dielectric" if described.form.part() == Part::Fresnel => {
            built(described, path, fresnel::<f64, DVec3>).map(drop)
        }
        "dielectric" | "thin_dielectric" | "rough_dielectric" | "plastic" => {
            built(described, path, bsdf::<f64, DVec3>).map(drop)
        }
        "cook_torrance" if described.word("shadowing") != "v_cavity" => {
            match described.get("distribution") {
                Some((_, distribution)) if has_smith(distribution) => Ok(()),
                _ => Err(path.key("shadowing").error(Problem::NoSmith)),
            }
        }
        _ => Ok(()),
    }
}

/// Whether the distribution is one of a rough dielectric.
fn is_facets(described: &Described) -> bool {
    match described.get("distribution") {
        Some((_, Value::Form(distribution))) => {
            matches!(distribution.form.name(), "beckmann" | "ggx")
        }
        _ => false,
    }
}

/// What is described, built in red, green and blue.
fn built<V>(
    described: &Described,
    path: &Path<'_>,
    build: impl Fn(&Build<'_, f64, DVec3>) -> Result<V, DescriptionError>,
) -> Result<V, DescriptionError> {
    let (path, channels, color) = (*path, Channels::Rgb, PhantomData);
    build(&Build { described, path, number: &|_, value| value, channels, color })
}

/// Whether the index of a substrate is the same in all channels.
fn same_in_all_channels(film: &Described, path: &Path<'_>) -> Result<(), DescriptionError> {
    let same = match film.get("substrate") {
        Some((_, Value::Term(index))) if index.get("eta").is_some() => {
            ["eta", "k"].into_iter().all(|key| {
                let [red, green, blue] = index.channels(key);
                red == green && green == blue
            })
        }
        Some((_, Value::Term(_))) => false,
        _ => true,
    };
    if same { Ok(()) } else { Err(path.error(Problem::Dispersion)) }
}

/// Whether the weights of a list, averaged over their channels, have a sum to divide by. It is
/// formed as the sums and mixtures of the crate form it.
fn total(list: &Described, name: &'static str, path: &Path<'_>) -> Result<(), DescriptionError> {
    let is_color = name == "total weight";
    let mean = |term: &Value| match term {
        Value::Term(term) => match term.get("weight") {
            Some((_, Value::Numbers(Numbers::One(weight)))) if is_color => {
                Color::<f64>::mean(DVec3::splat(*weight))
            }
            Some((_, Value::Numbers(Numbers::One(weight)))) => *weight,
            Some((_, Value::Numbers(Numbers::Three(weight)))) => {
                Color::<f64>::mean(DVec3::from(*weight))
            }
            _ => 0.0,
        },
        _ => 0.0,
    };
    let total = list.values.iter().fold(0.0, |sum, term| sum + mean(term));
    let checked = range::TOTAL_WEIGHT.check::<f64, _>(name, total);
    checked.map_err(|error| path.error(Problem::Parameter(error)))
}

/// Whether a value is a distribution for which Smith's shadowing is known, as
/// [`has_smith`](crate::AnyDistribution::has_smith) says of what is built.
pub(super) fn has_smith(value: &Value) -> bool {
    match value {
        Value::Form(distribution) => match distribution.form.name() {
            "beckmann" | "ggx" => true,
            "mixture" => distribution.values.iter().all(has_smith),
            _ => false,
        },
        Value::Term(term) => term.get("distribution").is_some_and(|(_, part)| has_smith(part)),
        _ => false,
    }
}
