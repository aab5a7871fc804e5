//! What a description consists of: a checked tree of values.

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use super::form::Form;
use crate::materials::OpticalConstants;
use crate::parameter::Parameter;

/// A form, or a term of its list, with the values of its parameters in their order; or a form with
/// its terms.
#[derive(Clone, PartialEq)]
pub(super) struct Described {
    pub(super) form: &'static Form,
    pub(super) values: Vec<Value>,
}

/// The value of a parameter.
#[derive(Clone, PartialEq)]
pub(super) enum Value {
    Numbers(Numbers<f64>),
    Flag(bool),
    /// Some words, and which of them.
    Word(&'static [&'static str], usize),
    Text(String),
    Form(Described),
    Term(Described),
    /// Terms of a key.
    List(Vec<Self>),
    Constants(OpticalConstants),
}

/// One number for all, or a number for each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Numbers<V> {
    One(V),
    Two([V; 2]),
    Three([V; 3]),
}

impl<V> Numbers<V> {
    pub(super) fn as_mut_slice(&mut self) -> &mut [V] {
        match self {
            Self::One(one) => core::slice::from_mut(one),
            Self::Two(numbers) => numbers,
            Self::Three(numbers) => numbers,
        }
    }
}

impl Described {
    /// The value of a parameter, and the parameter.
    pub(super) fn get(&self, key: &str) -> Option<(&'static Parameter, &Value)> {
        self.form.parameters().iter().zip(&self.values).find(|(parameter, _)| parameter.name == key)
    }

    /// The text that a parameter is; empty if it is something else.
    pub(super) fn text(&self, key: &str) -> &str {
        if let Some((_, Value::Text(text))) = self.get(key) { text } else { "" }
    }

    /// The numbers of a colour.
    pub(super) fn channels(&self, key: &str) -> [f64; 3] {
        match self.get(key) {
            Some((_, Value::Numbers(Numbers::Three(numbers)))) => *numbers,
            Some((_, Value::Numbers(Numbers::One(number) | Numbers::Two([number, _])))) => {
                [*number; 3]
            }
            _ => [f64::NAN; 3],
        }
    }

    /// The word that a parameter is; empty if it is something else.
    pub(super) fn word(&self, key: &str) -> &'static str {
        match self.get(key) {
            Some((_, Value::Word(words, index))) => words.get(*index).copied().unwrap_or_default(),
            _ => "",
        }
    }
}

/// As in `lambert [0.5]`.
impl fmt::Debug for Described {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ", self.form.name())?;
        f.debug_list().entries(&self.values).finish()
    }
}

impl fmt::Debug for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Numbers(Numbers::One(number)) => number.fmt(f),
            Self::Numbers(Numbers::Two(numbers)) => numbers.fmt(f),
            Self::Numbers(Numbers::Three(numbers)) => numbers.fmt(f),
            Self::Flag(flag) => flag.fmt(f),
            Self::Word(words, index) => words.get(*index).fmt(f),
            Self::Text(text) => text.fmt(f),
            Self::Form(described) => described.fmt(f),
            Self::Term(term) => f.debug_list().entries(&term.values).finish(),
            Self::List(terms) => terms.fmt(f),
            Self::Constants(constants) => constants.fmt(f),
        }
    }
}
