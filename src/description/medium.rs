//! Reading the index of a medium.

use alloc::vec;
use core::fmt;

use serde::de::{Error, MapAccess, SeqAccess, Visitor};

use super::form::{Form, INDICES, MATERIAL};
use super::leaf::{OneOrEach, Word};
use super::place::Place;
use super::read::ValueAt;
use super::value::{Described, Value};
use crate::parameter::Parameter;

/// The keys of both objects that an index may be.
const KEYS: &[&str] = &["eta", "k", "material"];

/// n, `[n, k]`, `{"eta": C, "k": C}` or `{"material": "Au"}`.
pub(super) struct MediumAt<'a>(pub(super) &'a Place<'a>, pub(super) &'static Parameter);

impl<'de> Visitor<'de> for MediumAt<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "a number, a list of 2 numbers, or an object with the keys `eta` and `k` or the key \
             `material`",
        )
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Value, E> {
        OneOrEach(self.0, self.1).visit_f64(value).map(Value::Numbers)
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Value, E> {
        self.visit_f64(value as f64)
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Value, E> {
        self.visit_f64(value as f64)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Value, A::Error> {
        OneOrEach(self.0, self.1).visit_seq(list).map(Value::Numbers)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
        let place = self.0;
        let parameters = || INDICES.parameters().iter().chain(MATERIAL.parameters());
        let mut values = [None, None, None];
        while let Some(key) = map.next_key_seed(Word(place, KEYS))? {
            let (Some(parameter), Some(value)) = (parameters().nth(key), values.get_mut(key))
            else {
                continue;
            };
            let place = place.key(parameter.name);
            if value.is_some() {
                place.note_failure();
                return Err(A::Error::custom("this key is given twice"));
            }
            *value = Some(map.next_value_seed(ValueAt(place, parameter))?);
        }
        let term = |form: &'static Form, values| Value::Term(Described { form, values });
        let missing = |key| {
            place.key(key).note_failure();
            A::Error::custom("this key is missing")
        };
        match values {
            [Some(eta), Some(k), None] => Ok(term(&INDICES, vec![eta, k])),
            [None, None, Some(name)] => Ok(term(&MATERIAL, vec![name])),
            [Some(_), None, None] => Err(missing("k")),
            [None, Some(_), None] => Err(missing("eta")),
            [None, None, None] => Err(missing("material")),
            [_, _, Some(_)] => {
                place.key("material").note_failure();
                Err(A::Error::custom("`material` must be the only key of its object"))
            }
        }
    }
}
