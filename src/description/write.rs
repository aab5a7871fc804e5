//! The writer of all descriptions.

use serde::ser::{SerializeStruct, SerializeStructVariant};
use serde::{Serialize, Serializer};

use super::form::Content;
use super::value::{Described, Numbers, Value};

impl Serialize for Described {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let (room, name) = (self.form.room(), self.form.name());
        let index = index(room.names.iter().position(|other| *other == name));
        match self.form.content() {
            Content::Keys(parameters) => {
                let count = self.values.len();
                let mut keys = to.serialize_struct_variant(room.name, index, name, count)?;
                for (parameter, value) in parameters.iter().zip(&self.values) {
                    keys.serialize_field(parameter.name, value)?;
                }
                keys.end()
            }
            Content::Value(_) | Content::Terms(_) => {
                to.serialize_newtype_variant(room.name, index, name, &Inner(self))
            }
        }
    }
}

/// The value or the list of terms of a form without keys.
struct Inner<'a>(&'a Described);

impl Serialize for Inner<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match (self.0.form.content(), self.0.values.as_slice()) {
            (Content::Value(_), [value]) => value.serialize(to),
            (_, terms) => terms.serialize(to),
        }
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Numbers(Numbers::One(number)) => number.serialize(to),
            Self::Numbers(Numbers::Two(numbers)) => numbers.as_slice().serialize(to),
            Self::Numbers(Numbers::Three(numbers)) => numbers.as_slice().serialize(to),
            Self::Flag(flag) => flag.serialize(to),
            Self::Word(words, place) => {
                let word = words.get(*place).copied().unwrap_or_default();
                to.serialize_unit_variant("Word", index(Some(*place)), word)
            }
            Self::Text(text) => text.serialize(to),
            Self::Form(described) => described.serialize(to),
            Self::List(terms) => terms.serialize(to),
            Self::Constants(constants) => to.collect_seq(constants.samples().map(|it| {
                Self::Numbers(Numbers::Three([it.wavelength, it.index.eta, it.index.k]))
            })),
            Self::Term(term) => {
                let name = term.form.room().term;
                let mut keys = to.serialize_struct(name, term.values.len())?;
                for (parameter, value) in term.form.parameters().iter().zip(&term.values) {
                    keys.serialize_field(parameter.name, value)?;
                }
                keys.end()
            }
        }
    }
}

/// The place of a name in its list, which formats without names write.
fn index(place: Option<usize>) -> u32 {
    place.and_then(|place| u32::try_from(place).ok()).unwrap_or_default()
}
