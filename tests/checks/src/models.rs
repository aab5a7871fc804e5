//! The registry, `tests/registry.jsonl`: every model with representative parameters, in any number.
//! What holds of all models is tested over this list; a new model gets the whole suite by its line.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use brdf::description::BrdfDescription;
use brdf::{AnyBrdf, Brdf, Color, Lanes, Lift, Real, Sample};
use serde::{Deserialize, Deserializer};
use serde_json::Value;

use crate::faulty::Faulty;
use crate::traced::Traced;

pub type Model<T> = dyn Brdf<T, Color = <T as Real>::Vec3>;

/// A line of the registry.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    pub name: String,
    /// Its numbers rounded to `f32`, so that all kinds of numbers say the same of the same model.
    #[serde(deserialize_with = "rounded")]
    pub brdf: BrdfDescription,
    /// The Rust type of the model, if it is called otherwise than the form.
    #[serde(rename = "type")]
    other_type: Option<String>,
    #[serde(default)]
    pub promises: Promises,
}

/// What a model promises of itself.
#[derive(Clone, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Promises {
    /// f(wi, wo) = f(wo, wi).
    pub reciprocal: bool,
    /// Where the directional albedo exceeds 1; `None` for a model that promises it never does.
    pub gain: Option<Gain>,
    /// How far its `albedo` may be from the integral, relative to an albedo above 1: the error of
    /// its formula, or that of its integral over facets.
    pub albedo_error: f64,
    /// No sample weighs more, but for what grooves add; 10³⁰⁸ for weights
    /// without bound.
    pub largest_weight: f64,
    /// What is added to the largest weight, over the larger of both cosines.
    pub grooves: f64,
    /// No direction is drawn from two places of the unit square. Where one of several models or
    /// distributions is drawn from, it is.
    pub one_to_one: bool,
    /// The density jumps at a right angle from the mirror direction.
    pub jumps: bool,
    /// What holds whatever the parameters, for colours up to 1; a model that conserves energy has an
    /// albedo of 1 at most and samples of its `largest_weight`.
    pub bounds: Option<Bounds>,
}

impl Default for Promises {
    fn default() -> Self {
        Self {
            reciprocal: true,
            gain: None,
            albedo_error: 1e-7,
            largest_weight: 1.0,
            grooves: 0.0,
            one_to_one: true,
            jumps: false,
            bounds: None,
        }
    }
}

impl Promises {
    /// The largest weight of a sample, for the cosines of both directions.
    pub fn weight(&self, cos_i: f64, cos_o: f64) -> f64 {
        self.largest_weight + self.grooves / cos_i.max(cos_o)
    }
}

/// The largest directional albedo of a model that is not conserving, brightest channel.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gain {
    pub albedo: f64,
    /// The polar angle of the viewer where it is reached.
    pub degrees: f64,
}

/// The largest albedo and weight of a sample of all models of one form.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bounds {
    pub albedo: f64,
    /// But for what grooves add.
    pub weight: f64,
}

/// One model under test.
pub struct Entry<T: Real> {
    pub name: &'static str,
    pub promises: &'static Promises,
    pub model: Box<Model<T>>,
}

/// A number in which models are compiled here with all that batches ask for.
pub trait Compiled: Real {
    /// Any model as an object.
    fn object(model: AnyBrdf<Self>) -> Box<Model<Self>>;
}

impl Compiled for f32 {
    #[inline(never)]
    fn object(model: AnyBrdf) -> Box<Model<Self>> {
        Box::new(model)
    }
}

impl Compiled for f64 {
    #[inline(never)]
    fn object(model: AnyBrdf<Self>) -> Box<Model<Self>> {
        Box::new(model)
    }
}

static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| {
    let text = crate::text("tests/registry.jsonl");
    let row = |line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{line}: {error}"));
    text.lines().map(row).collect()
});

/// All lines.
pub fn rows() -> &'static [Row] {
    &ROWS
}

/// All models in double precision. What makes models is never compiled where it is asked for, or all
/// models would be.
#[inline(never)]
pub fn double() -> &'static [Entry<f64>] {
    static ALL: LazyLock<Vec<Entry<f64>>> = LazyLock::new(|| all(Row::whole));
    &ALL
}

/// All models in single precision.
#[inline(never)]
pub fn single() -> &'static [Entry<f32>] {
    static ALL: LazyLock<Vec<Entry<f32>>> = LazyLock::new(|| all(Row::whole));
    &ALL
}

/// All models in lanes of double precision, as many as a register of 128 bits has: built in lanes,
/// and built as scalars and lifted.
#[inline(never)]
pub fn double_lanes() -> [Vec<Entry<Lanes<f64, 2>>>; 2] {
    [all(Row::one_by_one), all(|row| row.lifted(|parameter: f64| Lanes([parameter; 2])))]
}

/// The same in single precision.
#[inline(never)]
pub fn single_lanes() -> [Vec<Entry<Lanes<f32, 4>>>; 2] {
    [all(Row::one_by_one), all(|row| row.lifted(|parameter: f32| Lanes([parameter; 4])))]
}

/// All models over numbers that err; built anew, with the fault that is armed.
#[inline(never)]
pub fn faulty() -> Vec<Entry<Faulty>> {
    all(Row::one_by_one)
}

fn all<T: Real>(entry: impl Fn(&'static Row) -> Entry<T>) -> Vec<Entry<T>> {
    rows().iter().map(entry).collect()
}

/// A model that is asked for one answer at a time: blocks of answers, which batches ask for, are
/// not compiled for each model and instruction set.
struct OneByOne<T: Real>(AnyBrdf<T>);

impl<T: Real> Brdf<T> for OneByOne<T> {
    type Color = T::Vec3;

    #[inline(never)]
    fn eval(&self, wi: T::Vec3, wo: T::Vec3) -> T::Vec3 {
        self.0.eval(wi, wo)
    }

    #[inline(never)]
    fn pdf(&self, wi: T::Vec3, wo: T::Vec3) -> T {
        self.0.pdf(wi, wo)
    }

    #[inline(never)]
    fn sample(&self, wo: T::Vec3, u: [T; 2]) -> Sample<T, T::Vec3> {
        self.0.sample(wo, u)
    }

    fn albedo(&self, wo: T::Vec3) -> T::Vec3 {
        self.0.albedo(wo)
    }
}

impl Row {
    /// The model over symbols; its parameters go to the record of this thread.
    pub fn traced(&'static self) -> Entry<Traced> {
        self.one_by_one()
    }

    fn whole<T: Compiled>(&'static self) -> Entry<T> {
        self.entry(T::object(self.build()))
    }

    fn one_by_one<T: Real>(&'static self) -> Entry<T> {
        self.entry(Box::new(OneByOne(self.build())))
    }

    fn lifted<T: Real, U: Real>(&'static self, lift: impl Fn(T) -> U + Copy) -> Entry<U>
    where
        T::Vec3: Color<T, Over<U> = U::Vec3>,
    {
        self.entry(Box::new(OneByOne(self.build::<T>().lift(lift))))
    }

    fn build<T: Real>(&self) -> AnyBrdf<T> {
        self.brdf.build().unwrap_or_else(|error| panic!("{}: {error}", self.name))
    }

    fn entry<T: Real>(&'static self, model: Box<Model<T>>) -> Entry<T> {
        Entry { name: &self.name, promises: &self.promises, model }
    }

    /// What the form of its description is called.
    pub fn form(&self) -> String {
        let value = serde_json::to_value(&self.brdf).expect("a description can be written");
        let form = value.as_object().and_then(|form| form.keys().next());
        form.expect("a form has a name").clone()
    }

    /// What is written in its description: names of forms, keys and words, with the defaults of keys
    /// that are left out; a truth value as `key: true`.
    pub fn words(&self) -> BTreeSet<String> {
        let mut found = BTreeSet::new();
        let value = serde_json::to_value(&self.brdf).expect("a description can be written");
        collect_words(&value, &mut found);
        found
    }

    /// Whether its albedo is a formula and not the mean of samples.
    pub fn has_exact_albedo(&self) -> bool {
        self.promises.albedo_error <= Promises::default().albedo_error
    }

    /// What the Rust type of the model is called, without the types of its parts.
    pub fn type_name(&self) -> String {
        self.other_type.clone().unwrap_or_else(|| camel_case(&self.form()))
    }
}

/// A description whose numbers are such that `f32` and `f64` round them alike.
fn rounded<'de, D: Deserializer<'de>>(from: D) -> Result<BrdfDescription, D::Error> {
    let mut value = Value::deserialize(from)?;
    round(&mut value);
    serde_json::from_value(value).map_err(serde::de::Error::custom)
}

#[allow(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
fn round(value: &mut Value) {
    match value {
        Value::Number(number) => {
            let number = number.as_f64().map(|number| f64::from(number as f32));
            *value = number.into();
        }
        Value::Array(list) => list.iter_mut().for_each(round),
        Value::Object(keys) => keys.values_mut().for_each(round),
        Value::Null | Value::Bool(_) | Value::String(_) => {}
    }
}

fn collect_words(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::String(word) => _ = found.insert(word.clone()),
        Value::Array(list) => list.iter().for_each(|value| collect_words(value, found)),
        Value::Object(keys) => {
            for (key, value) in keys {
                found.insert(key.clone());
                if let Value::Bool(truth) = value {
                    found.insert(format!("{key}: {truth}"));
                }
                collect_words(value, found);
            }
        }
        Value::Null | Value::Bool(_) | Value::Number(_) => {}
    }
}

/// `OrenNayar` for `oren_nayar`.
fn camel_case(snake_case: &str) -> String {
    let word = |word: &str| {
        let mut letters = word.chars();
        letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect::<String>()
    };
    snake_case.split('_').map(word).collect()
}
