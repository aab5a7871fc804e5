//! Reading refractive indices.

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};

use super::error::Problem;
use super::form::{Form, INDICES, MATERIAL, MATERIAL_IN, SAMPLES, SAMPLES_IN};
use super::leaf::{OneOrEach, Role, Text, Word};
use super::place::Place;
use super::read::{ValueAt, default};
use super::value::{Described, Numbers, Value};
use crate::materials::{OpticalConstants, Sample};
use crate::parameter::{Kind, Parameter};

/// An index: numbers, where its kind has any; the name of a metal; or an object that has one of some
/// sets of keys.
pub(super) struct IndexAt<'a>(pub(super) &'a Place<'a>, pub(super) &'static Parameter);

/// The objects that an index may be, and all their keys.
struct Objects {
    forms: &'static [&'static Form],
    keys: &'static [&'static str],
    expected: &'static str,
}

const MEDIUM: Objects = Objects {
    forms: &[&INDICES, &MATERIAL, &SAMPLES],
    keys: &["eta", "k", "material", "samples"],
    expected: "an object with the keys `eta` and `k` or with the key `material` or `samples`",
};

const MEASURED: Objects = Objects {
    forms: &[&MATERIAL, &SAMPLES],
    keys: &["material", "samples"],
    expected: "an object with the key `material` or `samples`",
};

const RELATIVE: Objects = Objects {
    forms: &[&MATERIAL_IN, &SAMPLES_IN],
    keys: &["material", "samples", "outside"],
    ..MEASURED
};

impl IndexAt<'_> {
    const fn objects(&self) -> &'static Objects {
        match self.1.kind {
            Kind::Medium(..) => &MEDIUM,
            Kind::RealIndex(..) => &MEASURED,
            _ => &RELATIVE,
        }
    }

    fn missing<E: Error>(&self, key: &'static str) -> E {
        self.0.key(key).note_failure();
        E::custom("this key is missing")
    }
}

impl<'de> Visitor<'de> for IndexAt<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let objects = self.objects().expected;
        match self.1.kind.most() {
            0 => write!(f, "a text or {objects}"),
            1 => write!(f, "a number or {objects}"),
            most => write!(f, "a number, a list of {most} numbers, or {objects}"),
        }
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Value, E> {
        if self.1.kind == Kind::Metal {
            return Err(E::invalid_type(serde::de::Unexpected::Float(value), &self));
        }
        OneOrEach(self.0, self.1).visit_f64(value).map(Value::Numbers)
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Value, E> {
        if self.1.kind == Kind::Metal {
            return Err(E::invalid_type(serde::de::Unexpected::Unsigned(value), &self));
        }
        self.visit_f64(value as f64)
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Value, E> {
        self.visit_f64(value as f64)
    }

    fn visit_str<E: Error>(self, value: &str) -> Result<Value, E> {
        if self.1.kind != Kind::Metal {
            return Err(E::invalid_type(serde::de::Unexpected::Str(value), &self));
        }
        Text.visit_str(value).map(Value::Text)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Value, A::Error> {
        if self.1.kind.most() < 2 {
            return Err(A::Error::invalid_type(serde::de::Unexpected::Seq, &self));
        }
        OneOrEach(self.0, self.1).visit_seq(list).map(Value::Numbers)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
        let (place, objects) = (self.0, self.objects());
        let parameter_of = |key: &str| {
            let mut all = objects.forms.iter().flat_map(|form| form.parameters());
            all.find(|parameter| parameter.name == key)
        };
        // In the order in which they are read.
        let mut given: Vec<(&'static str, Value)> = Vec::new();
        while let Some(key) = map.next_key_seed(Word(place, objects.keys, Role::Key))? {
            let Some(parameter) = objects.keys.get(key).and_then(|key| parameter_of(key)) else {
                continue;
            };
            let place = place.key(parameter.name);
            if given.iter().any(|(key, _)| *key == parameter.name) {
                place.note_failure();
                return Err(A::Error::custom("this key is given twice"));
            }
            given.push((parameter.name, map.next_value_seed(ValueAt(place, parameter))?));
        }
        let has = |key: &str| given.iter().any(|(other, _)| *other == key);
        let first = objects.forms.iter().find_map(|form| {
            let first = form.parameters().first()?;
            has(first.name).then_some((*form, first.name))
        });
        let Some((form, first)) = first else {
            return Err(self.missing(if has("k") { "eta" } else { "material" }));
        };
        if let Some((surplus, _)) = given.iter().rev().find(|(key, _)| !form.keys.contains(key)) {
            place.key(surplus).note_failure();
            let message = format_args!("`{first}` and `{surplus}` exclude each other");
            return Err(A::Error::custom(message));
        }
        let mut values = vec![None; form.parameters().len()];
        for (key, value) in given {
            if let Some(index) = form.keys.iter().position(|other| *other == key) {
                values[index] = Some(value);
            }
        }
        let preset: Vec<_> = form.parameters().iter().map(|it| default(it, &values)).collect();
        let all = form.keys.iter().zip(values.into_iter().zip(preset));
        let all =
            all.map(|(key, (value, preset))| value.or(preset).ok_or_else(|| self.missing(key)));
        let values = all.collect::<Result<_, _>>()?;
        Ok(Value::Term(Described { form, values }))
    }
}

/// Samples of optical constants.
pub(super) struct SamplesAt<'a>(pub(super) &'a Place<'a>, pub(super) &'static Parameter);

impl<'de> Visitor<'de> for SamplesAt<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of samples, each a wavelength, n and k")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Value, A::Error> {
        let Self(place, parameter) = self;
        let mut samples = Vec::new();
        while let Some(sample) =
            list.next_element_seed(SampleAt(place, parameter, samples.len()))?
        {
            samples.push(sample);
        }
        OpticalConstants::new(samples).map(Value::Constants).map_err(|error| {
            let problem = Problem::Parameter(error);
            match error.position() {
                // Each number is in its range: it is a wavelength that does not rise.
                Some(row) => place.refuse(place.index(row).index(0).path().error(problem)),
                None => place.refuse(place.path().error(problem)),
            }
        })
    }
}

/// One more sample, if there may be one more.
struct SampleAt<'a>(&'a Place<'a>, &'static Parameter, usize);

impl<'de> DeserializeSeed<'de> for SampleAt<'_> {
    type Value = Sample;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Sample, D::Error> {
        let Self(list, parameter, index) = self;
        let place = list.sample(index).map_err(|problem| {
            list.note_failure();
            D::Error::custom(problem)
        })?;
        let read = from.deserialize_seq(OneOrEach(&place, parameter));
        match read.inspect_err(|_| place.note_failure())? {
            Numbers::Three([wavelength, eta, k]) => Ok(Sample::new(wavelength, eta, k)),
            Numbers::One(_) | Numbers::Two(_) => {
                Err(D::Error::custom("a sample has a wavelength, n and k"))
            }
        }
    }
}
