//! Reading: every value knows its place, so that every error can name it.
//!
//! The traits of serde hand a value no context. Here values are read through
//! [`DeserializeSeed`]s that carry the [`Place`]; it also bounds depth and number, which not every
//! format does.

use alloc::string::String;
use alloc::vec::Vec;
use core::cell::Cell;
use core::fmt;
use core::marker::PhantomData;

use serde::de::{
    DeserializeSeed, Deserializer, Error, Expected, IgnoredAny, MapAccess, SeqAccess, Visitor,
};

use super::error::DescriptionError;
use super::place::{Place, Record};

/// Something that can stand in a description.
pub(super) trait Parse<'de>: Sized {
    fn parse<D: Deserializer<'de>>(place: &Place<'_>, from: D) -> Result<Self, D::Error>;
}

/// Reads the value of a place.
pub(super) struct At<'a, V>(&'a Place<'a>, PhantomData<V>);

impl<'a, V> At<'a, V> {
    pub(super) const fn new(place: &'a Place<'a>) -> Self {
        Self(place, PhantomData)
    }
}

impl<'de, V: Parse<'de>> DeserializeSeed<'de> for At<'_, V> {
    type Value = V;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<V, D::Error> {
        V::parse(self.0, from).inspect_err(|_| self.0.note_failure())
    }
}

/// Reads a whole description and checks its values.
pub(super) fn whole<'de, V: Parse<'de>, D: Deserializer<'de>>(
    from: D,
    check: impl FnOnce(&V, &Place<'_>) -> Result<(), DescriptionError>,
) -> Result<V, D::Error> {
    let record = Record::default();
    let read = At::<V>::new(&Place::root(&record)).deserialize(from);
    let value = read.map_err(|error| {
        let failure = record.into_failure();
        if failure.is_empty() {
            error
        } else {
            D::Error::custom(format_args!("{failure}: {error}"))
        }
    })?;
    check(&value, &Place::root(&Record::default())).map_err(D::Error::custom)?;
    Ok(value)
}

/// How far a reader of a value got, to explain errors that formats raise by themselves.
#[derive(Debug, Default)]
pub(super) struct Progress {
    /// The name that was read.
    name: Cell<Option<&'static str>>,
    /// Whether what is expected was asked for: then an error says it.
    told: Cell<bool>,
}

impl Progress {
    pub(super) fn named(&self, name: &'static str) {
        self.name.set(Some(name));
    }

    pub(super) fn tell(&self) {
        self.told.set(true);
    }

    /// The result, whose error says what is expected here unless it says that already or comes
    /// from further inside.
    pub(super) fn explain<V, E: Error>(
        &self,
        place: &Place<'_>,
        expected: &str,
        result: Result<V, E>,
    ) -> Result<V, E> {
        result.map_err(|error| match self.name.get() {
            _ if self.told.get() || place.has_failed() => error,
            None => E::custom(format_args!("expected {expected}: {error}")),
            Some(name) => {
                E::custom(format_args!("`{name}` must be the only key of its object: {error}"))
            }
        })
    }
}

/// A key, or the name of a variant: one of a few words.
pub(super) struct Word<'a> {
    pub(super) place: &'a Place<'a>,
    pub(super) words: &'static [&'static str],
}

impl<'de> DeserializeSeed<'de> for Word<'_> {
    type Value = &'static str;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<&'static str, D::Error> {
        from.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Word<'_> {
    type Value = &'static str;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.words.len() > 1 {
            f.write_str("one of ")?;
        }
        for (index, word) in self.words.iter().enumerate() {
            let separator = if index == 0 { "" } else { ", " };
            write!(f, "{separator}`{word}`")?;
        }
        Ok(())
    }

    fn visit_str<E: Error>(self, found: &str) -> Result<&'static str, E> {
        self.words.iter().find(|word| **word == found).copied().ok_or_else(|| {
            self.place.note_failure_at_word(&beginning(found));
            E::custom(format_args!("unknown name, expected {}", &self as &dyn Expected))
        })
    }
}

/// As much of a text as an error message should repeat, longer than every name.
pub(super) fn beginning(text: &str) -> String {
    match text.char_indices().nth(40) {
        None => text.into(),
        Some((end, _)) => String::from(&text[..end]) + "…",
    }
}

/// The value of a key, given once.
pub(super) fn once<'de, V: Parse<'de>, A: MapAccess<'de>>(
    slot: &mut Option<V>,
    place: &Place<'_>,
    map: &mut A,
) -> Result<(), A::Error> {
    if slot.is_some() {
        place.note_failure();
        return Err(A::Error::custom("this key is given twice"));
    }
    *slot = Some(map.next_value_seed(At::new(place))?);
    Ok(())
}

/// The error of a key that is not given.
pub(super) fn missing<E: Error>(place: &Place<'_>) -> E {
    place.note_failure();
    E::custom("this key is missing")
}

impl<'de> Parse<'de> for f64 {
    fn parse<D: Deserializer<'de>>(_: &Place<'_>, from: D) -> Result<Self, D::Error> {
        struct Number;
        impl Visitor<'_> for Number {
            type Value = f64;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number")
            }
            fn visit_f64<E>(self, value: f64) -> Result<f64, E> {
                Ok(value)
            }
            fn visit_u64<E>(self, value: u64) -> Result<f64, E> {
                Ok(value as f64)
            }
            fn visit_i64<E>(self, value: i64) -> Result<f64, E> {
                Ok(value as f64)
            }
        }
        from.deserialize_any(Number)
    }
}

impl<'de> Parse<'de> for bool {
    fn parse<D: Deserializer<'de>>(_: &Place<'_>, from: D) -> Result<Self, D::Error> {
        serde::Deserialize::deserialize(from)
    }
}

/// The name of a material.
impl<'de> Parse<'de> for String {
    fn parse<D: Deserializer<'de>>(_: &Place<'_>, from: D) -> Result<Self, D::Error> {
        struct Name;
        impl Visitor<'_> for Name {
            type Value = String;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a text")
            }
            fn visit_str<E>(self, value: &str) -> Result<String, E> {
                Ok(value.into())
            }
        }
        from.deserialize_str(Name)
    }
}

/// One number for all, or `N` of them.
pub(super) enum Numbers<const N: usize> {
    One(f64),
    Each([f64; N]),
}

impl<'de, const N: usize> Parse<'de> for Numbers<N> {
    fn parse<D: Deserializer<'de>>(place: &Place<'_>, from: D) -> Result<Self, D::Error> {
        struct OneOrEach<'a, const N: usize>(&'a Place<'a>);
        impl<'de, const N: usize> Visitor<'de> for OneOrEach<'_, N> {
            type Value = Numbers<N>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "a number or a list of {N} numbers")
            }
            fn visit_f64<E>(self, value: f64) -> Result<Self::Value, E> {
                Ok(Numbers::One(value))
            }
            fn visit_u64<E>(self, value: u64) -> Result<Self::Value, E> {
                Ok(Numbers::One(value as f64))
            }
            fn visit_i64<E>(self, value: i64) -> Result<Self::Value, E> {
                Ok(Numbers::One(value as f64))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
                let mut numbers = [0.0; N];
                for (index, number) in numbers.iter_mut().enumerate() {
                    *number = list
                        .next_element_seed(At::new(&self.0.index(index)))?
                        .ok_or_else(|| A::Error::invalid_length(index, &self))?;
                }
                match list.next_element::<IgnoredAny>()? {
                    None => Ok(Numbers::Each(numbers)),
                    Some(_) => Err(A::Error::custom(format_args!(
                        "invalid length, more than {N}, expected {}",
                        &self as &dyn Expected
                    ))),
                }
            }
        }
        from.deserialize_any(OneOrEach(place))
    }
}

/// The terms of a sum or mixture.
impl<'de, V: Parse<'de>> Parse<'de> for Vec<V> {
    fn parse<D: Deserializer<'de>>(place: &Place<'_>, from: D) -> Result<Self, D::Error> {
        struct Terms<'a, V>(&'a Place<'a>, PhantomData<V>);
        impl<'de, V: Parse<'de>> Visitor<'de> for Terms<'_, V> {
            type Value = Vec<V>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list of terms")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<V>, A::Error> {
                // The length that a format announces is not believed.
                let mut terms = Vec::new();
                while let Some(term) =
                    list.next_element_seed(Term(self.0, terms.len(), PhantomData))?
                {
                    terms.push(term);
                }
                Ok(terms)
            }
        }
        from.deserialize_seq(Terms(place, PhantomData))
    }
}

/// One more term of a list, checked against the bounds before it is read.
struct Term<'a, V>(&'a Place<'a>, usize, PhantomData<V>);

impl<'de, V: Parse<'de>> DeserializeSeed<'de> for Term<'_, V> {
    type Value = V;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<V, D::Error> {
        let term = self.0.term(self.1).map_err(|error| {
            self.0.note_failure();
            D::Error::custom(error.problem())
        })?;
        At::new(&term).deserialize(from)
    }
}
