//! The reader of all descriptions.
//!
//! The traits of serde hand a value no context. Here every value is read by a [`DeserializeSeed`]
//! that knows its place and its parameter, so that every error names the place.

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use serde::de::{
    Deserialize, DeserializeSeed, Deserializer, EnumAccess, Error, MapAccess, SeqAccess,
    VariantAccess, Visitor,
};

use super::check::{check, has_smith};
use super::error::Problem;
use super::form::{Content, Form, List, Room, white};
use super::index::{IndexAt, SamplesAt};
use super::leaf::{AllWords, OneOrEach, Role, Text, Word, Words};
use super::place::{Place, Progress, Record};
use super::value::{Described, Numbers, Value};
use crate::parameter::{Kind, Parameter, Part, Preset};

/// Reads a whole description.
pub(super) fn read<'de, D: Deserializer<'de>>(part: Part, from: D) -> Result<Described, D::Error> {
    let record = Record::default();
    let read = FormAt(Place::root(&record), Room::of(part)).deserialize(from);
    read.map_err(|error| match record.into_failure() {
        (Some(refusal), _) => D::Error::custom(refusal),
        (None, place) if place.is_empty() => error,
        (None, place) => D::Error::custom(format_args!("{place}: {error}")),
    })
}

/// Reads one of the forms of a room.
struct FormAt<'a>(Place<'a>, &'static Room);

impl<'de> DeserializeSeed<'de> for FormAt<'_> {
    type Value = Described;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Described, D::Error> {
        let Self(place, room) = self;
        let progress = Progress::default();
        let forms = Forms { place: &place, room, progress: &progress };
        let read = from.deserialize_enum(room.name, room.names, forms);
        let read = progress.explain(&place, &room.expected, read);
        read.inspect_err(|_| place.note_failure())
    }
}

struct Forms<'a> {
    place: &'a Place<'a>,
    room: &'static Room,
    progress: &'a Progress,
}

impl<'de> Visitor<'de> for Forms<'_> {
    type Value = Described;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.progress.tell();
        f.write_str(self.room.expected)
    }

    fn visit_enum<A: EnumAccess<'de>>(self, named: A) -> Result<Described, A::Error> {
        let (found, content) = named.variant_seed(Word(self.place, self.room.names, Role::Form))?;
        let Some(form) = self.room.forms.get(found) else {
            return Err(A::Error::unknown_variant("", self.room.names));
        };
        self.progress.named(form.name());
        let place = self.place.key(form.name());
        let described = match form.content() {
            Content::Keys(_) => {
                let progress = Progress::default();
                let keys = Keys { place: &place, form, progress: &progress };
                let read = content.struct_variant(form.keys, keys);
                progress.explain(&place, &AllKeys(form), read)
            }
            Content::Value(parameter) => content
                .newtype_variant_seed(ValueAt(place, parameter))
                .map(|value| Described { form, values: vec![value] }),
            Content::Terms(_) => content
                .newtype_variant_seed(Terms(&place, form))
                .map(|values| Described { form, values }),
        };
        described
            .and_then(|described| {
                check(&described, place.path()).map_err(|refusal| place.refuse(refusal))?;
                Ok(described)
            })
            .inspect_err(|_| place.note_failure())
    }
}

/// An object with the keys of a form, or of a term of its list.
struct Keys<'a> {
    place: &'a Place<'a>,
    form: &'static Form,
    progress: &'a Progress,
}

/// What is expected of such an object.
struct AllKeys(&'static Form);

impl fmt::Display for AllKeys {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object with the keys")?;
        self.0.keys.iter().try_for_each(|key| write!(f, " `{key}`"))
    }
}

impl<'de> Visitor<'de> for Keys<'_> {
    type Value = Described;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.progress.tell();
        write!(f, "{}", AllKeys(self.form))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Described, A::Error> {
        let Self { place, form, .. } = self;
        let parameters = form.parameters();
        let mut values = vec![None; parameters.len()];
        while let Some(key) = map.next_key_seed(Word(place, form.keys, Role::Key))? {
            let (Some(parameter), Some(value)) = (parameters.get(key), values.get_mut(key)) else {
                continue;
            };
            let place = place.key(parameter.name);
            if value.is_some() {
                place.note_failure();
                return Err(A::Error::custom("this key is given twice"));
            }
            *value = Some(map.next_value_seed(ValueAt(place, parameter))?);
        }
        let default_of = |parameter| default(parameter, &values);
        let defaults: Vec<_> = parameters.iter().map(default_of).collect();
        let with_default = parameters.iter().zip(values.into_iter().zip(defaults));
        let given = with_default.map(|(parameter, (value, default))| {
            value.or(default).ok_or_else(|| {
                place.key(parameter.name).note_failure();
                A::Error::custom("this key is missing")
            })
        });
        Ok(Described { form, values: given.collect::<Result<_, _>>()? })
    }
}

/// The value of a parameter that is not given, beside those that are.
pub(super) fn default(parameter: &Parameter, given: &[Option<Value>]) -> Option<Value> {
    let one_of = |word: &str| match parameter.kind {
        Kind::Word(words) => {
            Some(Value::Word(words, words.iter().position(|other| *other == word)?))
        }
        _ => None,
    };
    match parameter.default? {
        Preset::Number(number) => Some(Value::Numbers(Numbers::One(number))),
        Preset::Color(numbers) => Some(Value::Numbers(Numbers::Three(numbers))),
        Preset::Flag(flag) => Some(Value::Flag(flag)),
        Preset::Word(word) => one_of(word),
        Preset::White => Some(Value::Form(white())),
        Preset::Shadowing => {
            let smith = given.iter().flatten().any(has_smith);
            one_of(if smith { "smith" } else { "v_cavity" })
        }
    }
}

/// Reads the value of a parameter.
pub(super) struct ValueAt<'a>(pub(super) Place<'a>, pub(super) &'static Parameter);

impl<'de> DeserializeSeed<'de> for ValueAt<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Value, D::Error> {
        let Self(place, parameter) = self;
        let read = match parameter.kind {
            Kind::Part(part) => FormAt(place, Room::of(part)).deserialize(from).map(Value::Form),
            Kind::Medium(..) | Kind::RealIndex(..) | Kind::RelativeIndex(..) | Kind::Metal => {
                from.deserialize_any(IndexAt(&place, parameter))
            }
            Kind::Samples => from.deserialize_seq(SamplesAt(&place, parameter)),
            Kind::List(parameters) => match List::of(parameters) {
                Some(list) => from.deserialize_seq(Listed(&place, list)).map(Value::List),
                None => Err(D::Error::custom("no list of these is known")),
            },
            Kind::Flag => bool::deserialize(from).map(Value::Flag),
            Kind::Text => from.deserialize_str(Text).map(Value::Text),
            Kind::Word(words) => {
                let progress = Progress::default();
                let visitor = Words { place: &place, words, progress: &progress };
                let read = from.deserialize_enum(parameter.name, words, visitor);
                progress
                    .explain(&place, &AllWords(words), read)
                    .map(|index| Value::Word(words, index))
            }
            Kind::Number(_)
            | Kind::Color(_)
            | Kind::Vector(_)
            | Kind::Roughness(_)
            | Kind::Index(..) => {
                from.deserialize_any(OneOrEach(&place, parameter)).map(Value::Numbers)
            }
        };
        read.inspect_err(|_| place.note_failure())
    }
}

/// The terms of a sum or mixture.
struct Terms<'a>(&'a Place<'a>, &'static Form);

impl<'de> DeserializeSeed<'de> for Terms<'_> {
    type Value = Vec<Value>;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Vec<Value>, D::Error> {
        let place = self.0;
        from.deserialize_seq(self).inspect_err(|_| place.note_failure())
    }
}

impl<'de> Visitor<'de> for Terms<'_> {
    type Value = Vec<Value>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of terms")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<Value>, A::Error> {
        // The length that a format announces is not believed.
        let mut terms = Vec::new();
        while let Some(term) = list.next_element_seed(TermAt(self.0, self.1, terms.len()))? {
            terms.push(term);
        }
        Ok(terms)
    }
}

/// One more term of a list, checked against the bounds before it is read.
struct TermAt<'a>(&'a Place<'a>, &'static Form, usize);

impl<'de> DeserializeSeed<'de> for TermAt<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Value, D::Error> {
        let Self(list, form, index) = self;
        let place = list.term(index).map_err(|problem| {
            list.note_failure();
            D::Error::custom(problem)
        })?;
        term(&place, form, from)
    }
}

/// Reads an object with the keys of a term.
fn term<'de, D: Deserializer<'de>>(
    place: &Place<'_>,
    form: &'static Form,
    from: D,
) -> Result<Value, D::Error> {
    let progress = Progress::default();
    let keys = Keys { place, form, progress: &progress };
    let read = from.deserialize_struct(form.room().term, form.keys, keys);
    let read = progress.explain(place, &AllKeys(form), read);
    read.map(Value::Term).inspect_err(|_| place.note_failure())
}

/// The terms of a key.
struct Listed<'a>(&'a Place<'a>, &'static List);

impl<'de> Visitor<'de> for Listed<'_> {
    type Value = Vec<Value>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a list of {}", self.1.term.name())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<Value>, A::Error> {
        let Self(place, expected) = self;
        let mut terms = Vec::new();
        while let Some(term) = list.next_element_seed(OneMore(place, expected, terms.len()))? {
            terms.push(term);
        }
        if terms.is_empty() {
            (expected.check_count)(0).map_err(|error| {
                place.refuse::<A::Error>(place.path().error(Problem::Parameter(error)))
            })?;
        }
        Ok(terms)
    }
}

/// One more term of a key, if there may be one more.
struct OneMore<'a>(&'a Place<'a>, &'static List, usize);

impl<'de> DeserializeSeed<'de> for OneMore<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Value, D::Error> {
        let Self(place, list, index) = self;
        (list.check_count)(index + 1).map_err(|error| {
            place.refuse::<D::Error>(place.path().error(Problem::Parameter(error)))
        })?;
        term(&place.index(index), &list.term, from)
    }
}
