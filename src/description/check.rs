//! What the range of a single number cannot tell.

use alloc::format;
use core::marker::PhantomData;

use glam::DVec3;

use super::bsdf::bsdf;
use super::build::Build;
use super::channels::Channels;
use super::error::{DescriptionError, Problem};
use super::fresnel::fresnel;
use super::path::Path;
use super::place::beginning;
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
        "rough_dielectric" if !is_facets(described) => Err(not_refracting(described, path)),
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
                Some((_, distribution)) => match without_smith(distribution) {
                    None => Ok(()),
                    Some(name) => Err(path.key("shadowing").error(Problem::NoSmith(name))),
                },
                None => Ok(()),
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

/// What is said of a rough dielectric whose distribution is none of its own.
pub(super) fn not_refracting(described: &Described, path: &Path<'_>) -> DescriptionError {
    let name = match described.get("distribution") {
        Some((_, Value::Form(distribution))) => distribution.form.name(),
        _ => "",
    };
    path.key("distribution").error(Problem::NotRefracting(name))
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
    let differs = match film.get("substrate") {
        Some((_, Value::Term(index))) if index.get("eta").is_some() => {
            let numbers = ["eta", "k"].into_iter().map(|key| (key, index.channels(key)));
            let mut differ =
                numbers.filter(|(_, [red, green, blue])| red != green || green != blue);
            differ.next().map(|(key, numbers)| format!("{key} {numbers:?}"))
        }
        Some((_, Value::Term(index))) if index.get("material").is_some() => {
            Some(format!("the material {:?}", beginning(index.text("material"))))
        }
        Some((_, Value::Term(_))) => Some("samples".into()),
        _ => None,
    };
    differs.map_or(Ok(()), |found| Err(path.error(Problem::Dispersion(found))))
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
    without_smith(value).is_none()
}

/// The distribution of a value for which it is not known, the first of a mixture; none if there is no
/// such.
fn without_smith(value: &Value) -> Option<&'static str> {
    const NONE: &str = "";
    match value {
        Value::Form(distribution) => match distribution.form.name() {
            "beckmann" | "ggx" => None,
            "mixture" => distribution.values.iter().find_map(without_smith),
            other => Some(other),
        },
        Value::Term(term) => {
            term.get("distribution").map_or(Some(NONE), |(_, part)| without_smith(part))
        }
        _ => Some(NONE),
    }
}
