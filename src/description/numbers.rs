//! All numbers of a description, with their places and ranges.

use alloc::string::{String, ToString};

use super::form::Content;
use super::path::Path;
use super::value::{Described, Numbers, Value};
use crate::error::Range;
use crate::parameter::Kind;

/// A number of a description.
///
/// ```
/// use brdf::description::BrdfDescription;
///
/// let text = r#"{"sum": [{"weight": 1, "brdf": {"oren_nayar": {"albedo": 0.5, "sigma": 0.1}}}]}"#;
/// let numbers = serde_json::from_str::<BrdfDescription>(text)?.numbers();
/// assert_eq!(numbers[2].path, "sum[0].brdf.oren_nayar.sigma");
/// assert_eq!((numbers[2].value, numbers[2].range.lower), (0.1, 0.0));
///
/// let text = r#"{"lafortune": {"diffuse": [0.3, 0.2, 0.1], "lobes": [{"c": [-1, -1, 1], "exponent": 9}]}}"#;
/// let numbers = serde_json::from_str::<BrdfDescription>(text)?.numbers();
/// assert_eq!((numbers[2].path.as_str(), numbers[2].channel), ("lafortune.diffuse[2]", Some(2)));
/// assert_eq!((numbers[6].path.as_str(), numbers[6].channel), ("lafortune.lobes[0].c[2]", None));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Number {
    /// Where it stands, as [`Path`] and errors write it.
    pub path: String,
    /// What it is.
    pub value: f64,
    /// What it may be.
    pub range: Range,
    /// Which channel of a colour it is, counted from 0; none where it stands for all channels, or is no part of
    /// a colour, as a roughness and a component of a vector.
    pub channel: Option<usize>,
}

impl Number {
    pub(super) fn new(path: &Path<'_>, value: f64, Domain { range, channel }: Domain) -> Self {
        Self { path: path.to_string(), value, range, channel }
    }
}

/// What a number may be, and of which channel.
pub(super) struct Domain {
    range: Range,
    channel: Option<usize>,
}

/// What is told of every number, and may change it.
pub(super) type Visit<'a> = &'a mut dyn FnMut(&Path<'_>, &mut f64, Domain);

/// Shows all numbers of a form, or of a term of a list, in the order in which they stand.
pub(super) fn visit_numbers(described: &mut Described, path: &Path<'_>, visit: Visit<'_>) {
    let form = described.form;
    let parameters = form.parameters();
    for (index, value) in described.values.iter_mut().enumerate() {
        if let (Content::Terms(_), Value::Term(term)) = (form.content(), &mut *value) {
            visit_numbers(term, &path.index(index), visit);
            continue;
        }
        let Some(parameter) = parameters.get(index) else { continue };
        let keyed = path.key(parameter.name);
        let place = if form.is_value() { path } else { &keyed };
        match value {
            Value::Numbers(numbers) => {
                let one = matches!(numbers, Numbers::One(_));
                let is_color = matches!(numbers, Numbers::Three(_))
                    && !matches!(parameter.kind, Kind::Vector(_));
                for (index, value) in numbers.as_mut_slice().iter_mut().enumerate() {
                    let indexed = place.index(index);
                    if let Some(range) = parameter.kind.range(index) {
                        let channel = is_color.then_some(index);
                        let domain = Domain { range, channel };
                        visit(if one { place } else { &indexed }, value, domain);
                    }
                }
            }
            Value::Form(part) => visit_numbers(part, &place.key(part.form.name()), visit),
            Value::Term(part) => visit_numbers(part, place, visit),
            Value::List(parts) => {
                for (index, part) in parts.iter_mut().enumerate() {
                    if let Value::Term(part) = part {
                        visit_numbers(part, &place.index(index), visit);
                    }
                }
            }
            Value::Flag(_) | Value::Word(..) | Value::Text(_) | Value::Constants(_) => {}
        }
    }
}
