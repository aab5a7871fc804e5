//! What the range of a single number cannot tell.

use glam::DVec3;

use super::error::{DescriptionError, Problem};
use super::metal::{material, metal};
use super::path::Path;
use super::value::{Described, Numbers, Value};
use crate::error::range;
use crate::real::Color;

/// Checks a form whose numbers are in their ranges, and whose parts are checked.
pub(super) fn check(described: &Described, path: &Path<'_>) -> Result<(), DescriptionError> {
    match described.form.name() {
        "sum" => total(described, "total weight", path),
        "mixture" => total(described, "sum of weights", path),
        "stack" => stack(described, path),
        "belcour_barla" => same_in_all_channels(described, &path.key("substrate")),
        "metal" => metal(described.text("name")).map(drop).map_err(|problem| path.error(problem)),
        "rough_dielectric" if !is_facets(described) => {
            Err(path.key("distribution").error(Problem::NotRefracting))
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

/// Whether the materials of a stack are known at its wavelengths.
fn stack(stack: &Described, path: &Path<'_>) -> Result<(), DescriptionError> {
    let wavelength = DVec3::from(stack.channels("wavelength"));
    let known = |described: &Described, key, path: &Path<'_>| match described.get(key) {
        Some((_, Value::Term(index))) if !index.text("material").is_empty() => {
            let found = material(index.text("material"), wavelength).map(drop);
            found.map_err(|problem| path.key(key).key("material").error(problem))
        }
        _ => Ok(()),
    };
    known(stack, "outside", path)?;
    if let Some((_, Value::List(layers))) = stack.get("layers") {
        let path = path.key("layers");
        for (index, layer) in layers.iter().enumerate() {
            if let Value::Term(layer) = layer {
                known(layer, "index", &path.index(index))?;
            }
        }
    }
    known(stack, "substrate", path)
}

/// Whether the index of a substrate is the same in all channels.
fn same_in_all_channels(film: &Described, path: &Path<'_>) -> Result<(), DescriptionError> {
    let same = match film.get("substrate") {
        Some((_, Value::Term(index))) if index.text("material").is_empty() => {
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
