//! Reading what has no parts: numbers, words and texts.

use alloc::string::String;
use core::fmt;

use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, Error, Expected, IgnoredAny, SeqAccess, Unexpected,
    VariantAccess, Visitor,
};

use super::form::forms;
use super::place::{Place, Progress, beginning};
use super::value::Numbers;
use crate::parameter::{Kind, Parameter};

/// A number, or as many as the parameter has.
pub(super) struct OneOrEach<'a>(pub(super) &'a Place<'a>, pub(super) &'static Parameter);

impl<'de> Visitor<'de> for OneOrEach<'_> {
    type Value = Numbers<f64>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_vector() {
            return f.write_str("a list of 3 numbers");
        }
        f.write_str("a number")?;
        match self.1.kind.most() {
            1 => Ok(()),
            most => write!(f, " or a list of {most} numbers"),
        }
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Self::Value, E> {
        self.one(value, Unexpected::Float(value))
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Self::Value, E> {
        self.one(value as f64, Unexpected::Unsigned(value))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Self::Value, E> {
        self.one(value as f64, Unexpected::Signed(value))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let Self(place, parameter) = self;
        let most = parameter.kind.most();
        let mut numbers = [0.0; 3];
        if most == 1 {
            return Err(A::Error::invalid_type(Unexpected::Seq, &self));
        }
        for (index, number) in numbers.iter_mut().take(most).enumerate() {
            let component = Component(place.index(index), parameter, index);
            *number = list
                .next_element_seed(component)?
                .ok_or_else(|| A::Error::invalid_length(index, &self))?;
        }
        match (list.next_element::<IgnoredAny>()?, numbers) {
            (None, [x, y, _]) if most == 2 => Ok(Numbers::Two([x, y])),
            (None, numbers) => Ok(Numbers::Three(numbers)),
            (Some(_), _) => Err(A::Error::custom(format_args!(
                "invalid length, more than {most}, expected {}",
                &self as &dyn Expected
            ))),
        }
    }
}

impl OneOrEach<'_> {
    /// Whether one number does not stand for all.
    const fn is_vector(&self) -> bool {
        matches!(self.1.kind, Kind::Vector(_))
    }

    fn one<E: Error>(self, value: f64, found: Unexpected<'_>) -> Result<Numbers<f64>, E> {
        if self.is_vector() {
            return Err(E::invalid_type(found, &self));
        }
        let Self(place, parameter) = self;
        place.check(parameter, 0, value)?;
        Ok(Numbers::One(value))
    }
}

/// A number of a list.
struct Component<'a>(Place<'a>, &'static Parameter, usize);

impl<'de> DeserializeSeed<'de> for Component<'_> {
    type Value = f64;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<f64, D::Error> {
        let Self(place, parameter, index) = self;
        from.deserialize_any(Number)
            .and_then(|value| place.check(parameter, index, value).map(|()| value))
            .inspect_err(|_| place.note_failure())
    }
}

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

pub(super) struct Text;

impl Visitor<'_> for Text {
    type Value = String;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a text")
    }

    fn visit_str<E>(self, value: &str) -> Result<String, E> {
        Ok(value.into())
    }
}

/// One of a few words alone.
pub(super) struct Words<'a> {
    pub(super) place: &'a Place<'a>,
    pub(super) words: &'static [&'static str],
    pub(super) progress: &'a Progress,
}

pub(super) struct AllWords(pub(super) &'static [&'static str]);

impl fmt::Display for AllWords {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a text, one of")?;
        self.0.iter().try_for_each(|word| write!(f, " \"{word}\""))
    }
}

impl<'de> Visitor<'de> for Words<'_> {
    type Value = usize;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.progress.tell();
        write!(f, "{}", AllWords(self.words))
    }

    fn visit_enum<A: EnumAccess<'de>>(self, word: A) -> Result<usize, A::Error> {
        let (index, content) = word.variant_seed(Word(self.place, self.words, Role::Value))?;
        content.unit_variant()?;
        Ok(index)
    }
}

/// What a word is.
#[derive(Clone, Copy)]
pub(super) enum Role {
    Key,
    Form,
    /// The value of a parameter.
    Value,
}

/// Which of a few words.
pub(super) struct Word<'a>(
    pub(super) &'a Place<'a>,
    pub(super) &'static [&'static str],
    pub(super) Role,
);

impl<'de> DeserializeSeed<'de> for Word<'_> {
    type Value = usize;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<usize, D::Error> {
        from.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Word<'_> {
    type Value = usize;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.1.len() > 1 {
            f.write_str("one of ")?;
        }
        for (index, word) in self.1.iter().enumerate() {
            let separator = if index == 0 { "" } else { ", " };
            write!(f, "{separator}`{word}`")?;
        }
        Ok(())
    }

    fn visit_str<E: Error>(self, found: &str) -> Result<usize, E> {
        self.1.iter().position(|word| *word == found).ok_or_else(|| {
            let (named, expected) = (beginning(found), &self as &dyn Expected);
            match (self.2, elsewhere(found)) {
                (Role::Value, _) => {
                    self.0.note_failure();
                    E::custom(format_args!("unknown name {named:?}, expected {expected}"))
                }
                (Role::Form, Some(description)) => {
                    self.0.note_failure_at_word(&named);
                    E::custom(format_args!(
                        "unknown name here, a form of `{description}`, expected {expected}"
                    ))
                }
                (Role::Form, None) | (Role::Key, _) => {
                    self.0.note_failure_at_word(&named);
                    E::custom(format_args!("unknown name, expected {expected}"))
                }
            }
        })
    }
}

/// The description that has a form of this name.
fn elsewhere(name: &str) -> Option<&'static str> {
    forms().find(|(_, form)| form.name() == name).map(|(_, form)| form.room().name)
}
