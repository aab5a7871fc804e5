//! One question, a line of JSON, and its answer, another.

use brdf::description::{BrdfDescription, DistributionDescription, FresnelDescription};
use brdf::wgsl::{Module, ShaderError};
use brdf::{Brdf, Distribution, Fresnel, Real, Vector};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::value::RawValue;

/// The number to compute with.
#[derive(Clone, Copy, Debug)]
pub enum Precision {
    Single,
    Double,
}

/// Appends the answer to a question, without the end of the line; or says why there is none.
pub fn answer(line: &[u8], precision: Precision, to: &mut Vec<u8>) -> Result<(), String> {
    match precision {
        Precision::Single => answer_in::<f32>(line, to),
        Precision::Double => answer_in::<f64>(line, to),
    }
}

/// Appends an answer that is an error, with the number of the line in the input.
pub fn refuse(error: &str, line: u64, to: &mut Vec<u8>) {
    write(&Refusal { error, line }, to);
}

fn answer_in<T: Number>(line: &[u8], to: &mut Vec<u8>) -> Result<(), String> {
    let answer = Question::read(line)?.answer::<T>()?;
    write(&answer, to);
    Ok(())
}

fn write(answer: &impl Serialize, to: &mut Vec<u8>) {
    serde_json::to_writer(to, answer).expect("numbers and texts can be written into memory");
}

trait Number: Real + PartialOrd + Serialize {
    /// The largest number below 1.
    const BELOW_ONE: Self;
}

impl Number for f32 {
    const BELOW_ONE: Self = 1.0 - Self::EPSILON / 2.0;
}

impl Number for f64 {
    const BELOW_ONE: Self = 1.0 - Self::EPSILON / 2.0;
}

#[derive(Serialize)]
#[serde(untagged)]
enum Answer<T> {
    Value { value: [T; 3], pdf: T },
    Sample { wi: [T; 3], weight: [T; 3], pdf: T },
    Albedo { albedo: [T; 3] },
    Reflectance { reflectance: [T; 3] },
    Density { density: T },
    Text { text: String },
}

#[derive(Serialize)]
struct Refusal<'a> {
    error: &'a str,
    line: u64,
}

/// The keys of a question, each still as text.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "an object with the keys of a question")]
struct Keys<'a> {
    #[serde(borrow, default, deserialize_with = "given")]
    brdf: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    fresnel: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    distribution: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    wi: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    wo: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    u: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    cos: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    h: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    wgsl: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    name: Option<&'a RawValue>,
}

/// Unlike an absent value, `null` is a value, of a wrong type.
fn given<'de, D: Deserializer<'de>>(from: D) -> Result<Option<&'de RawValue>, D::Error> {
    <&RawValue>::deserialize(from).map(Some)
}

enum Question {
    Value { brdf: BrdfDescription, wi: [f64; 3], wo: [f64; 3] },
    Sample { brdf: BrdfDescription, wo: [f64; 3], u: [f64; 2] },
    Albedo { brdf: BrdfDescription, wo: [f64; 3] },
    Reflectance { fresnel: FresnelDescription, cos: f64 },
    Density { distribution: DistributionDescription, h: [f64; 3] },
    Text { brdf: BrdfDescription, name: String },
}

const KINDS: &str = "a question has the keys brdf, wi, wo; or brdf, wo, u; or brdf, wo; \
                     or fresnel, cos; or distribution, h; or wgsl, name";

impl Question {
    fn read(line: &[u8]) -> Result<Self, String> {
        let keys: Keys = serde_json::from_slice(line).map_err(|error| message(&error, 0))?;
        match keys {
            Keys {
                brdf: Some(brdf),
                wo: Some(wo),
                wi,
                u,
                fresnel: None,
                distribution: None,
                cos: None,
                h: None,
                wgsl: None,
                name: None,
            } => {
                let brdf = read(line, "brdf", brdf)?;
                let wo = direction(line, "wo", wo)?;
                match (wi, u) {
                    (None, None) => Ok(Self::Albedo { brdf, wo }),
                    (Some(wi), None) => {
                        Ok(Self::Value { brdf, wi: direction(line, "wi", wi)?, wo })
                    }
                    (None, Some(u)) => Ok(Self::Sample { brdf, wo, u: uniform(line, u)? }),
                    (Some(_), Some(_)) => Err(KINDS.into()),
                }
            }
            Keys {
                fresnel: Some(fresnel),
                cos: Some(cos),
                brdf: None,
                distribution: None,
                wi: None,
                wo: None,
                u: None,
                h: None,
                wgsl: None,
                name: None,
            } => Ok(Self::Reflectance {
                fresnel: read(line, "fresnel", fresnel)?,
                cos: cosine(line, cos)?,
            }),
            Keys {
                distribution: Some(distribution),
                h: Some(h),
                brdf: None,
                fresnel: None,
                wi: None,
                wo: None,
                u: None,
                cos: None,
                wgsl: None,
                name: None,
            } => Ok(Self::Density {
                distribution: read(line, "distribution", distribution)?,
                h: direction(line, "h", h)?,
            }),
            Keys {
                wgsl: Some(brdf),
                name: Some(name),
                brdf: None,
                fresnel: None,
                distribution: None,
                wi: None,
                wo: None,
                u: None,
                cos: None,
                h: None,
            } => {
                Ok(Self::Text { brdf: read(line, "wgsl", brdf)?, name: read(line, "name", name)? })
            }
            _ => Err(KINDS.into()),
        }
    }

    fn answer<T: Number>(&self) -> Result<Answer<T>, String> {
        Ok(match self {
            Self::Value { brdf, wi, wo } => {
                let model = brdf.build::<T>().map_err(|error| format!("brdf: {error}"))?;
                let (wi, wo) = (vector::<T>(wi), vector::<T>(wo));
                Answer::Value { value: components(model.eval(wi, wo)), pdf: model.pdf(wi, wo) }
            }
            Self::Sample { brdf, wo, u } => {
                let model = brdf.build::<T>().map_err(|error| format!("brdf: {error}"))?;
                // What is below 1 stays below 1 in every number.
                let u = u.map(|u| T::lit(u).min(T::BELOW_ONE));
                let sample = model.sample(vector::<T>(wo), u);
                Answer::Sample {
                    wi: components(sample.wi),
                    weight: components(sample.weight),
                    pdf: sample.pdf,
                }
            }
            Self::Albedo { brdf, wo } => {
                let model = brdf.build::<T>().map_err(|error| format!("brdf: {error}"))?;
                Answer::Albedo { albedo: components(model.albedo(vector::<T>(wo))) }
            }
            Self::Reflectance { fresnel, cos } => {
                let term = fresnel.build::<T>().map_err(|error| format!("fresnel: {error}"))?;
                Answer::Reflectance { reflectance: components(term.reflectance(T::lit(*cos))) }
            }
            Self::Density { distribution, h } => {
                let distribution =
                    distribution.build::<T>().map_err(|error| format!("distribution: {error}"))?;
                Answer::Density { density: distribution.density(vector::<T>(h)) }
            }
            Self::Text { brdf, name } => {
                let mut module = Module::new();
                module.add_described(name, brdf).map_err(|error| match error {
                    ShaderError::Description(error) => format!("wgsl: {error}"),
                    error => error.to_string(),
                })?;
                Answer::Text { text: module.to_string() }
            }
        })
    }
}

/// The value of a key. An error counts its columns from the start of the line.
fn read<V: DeserializeOwned>(line: &[u8], key: &str, value: &RawValue) -> Result<V, String> {
    let text = value.get();
    let start = text.as_ptr().addr() - line.as_ptr().addr();
    serde_json::from_str(text).map_err(|error| format!("{key}: {}", message(&error, start)))
}

/// An error in a text that begins at a column of the line: there is one line only.
fn message(error: &serde_json::Error, start: usize) -> String {
    let message = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    match message.strip_suffix(&place) {
        Some(message) => format!("{message} at column {}", start + error.column()),
        None => message,
    }
}

/// Numbers in a list of a fixed length.
fn list<const N: usize>(line: &[u8], key: &str, value: &RawValue) -> Result<[f64; N], String> {
    let numbers: Vec<f64> = read(line, key, value)?;
    let length = numbers.len();
    numbers.try_into().map_err(|_| format!("{key} must be a list of {N} numbers, not of {length}"))
}

/// A unit vector, within the tolerance that the models have. It has to be one in both numbers, so
/// that the same questions have an answer.
fn direction(line: &[u8], key: &str, value: &RawValue) -> Result<[f64; 3], String> {
    let w = list(line, key, value)?;
    if is_unit::<f64>(&w) && is_unit::<f32>(&w) {
        Ok(w)
    } else {
        let [x, y, z] = w;
        let squared = x * x + y * y + z * z;
        Err(format!(
            "{key} must be a unit vector (squared length between 0.99 and 1.01, in single \
             precision too), not of squared length {}",
            shown(squared)
        ))
    }
}

/// As [`brdf::above_surface`] has it.
fn is_unit<T: Number>(w: &[f64; 3]) -> bool {
    (vector::<T>(w).length_squared() - T::lit(1.0)).abs() <= T::lit(0.01)
}

fn uniform(line: &[u8], value: &RawValue) -> Result<[f64; 2], String> {
    let u: [f64; 2] = list(line, "u", value)?;
    match u.iter().enumerate().find(|(_, u)| !(0.0..1.0).contains(*u)) {
        None => Ok(u),
        Some((index, u)) => {
            Err(format!("u[{index}] must be at least 0 and below 1, not {}", shown(*u)))
        }
    }
}

fn cosine(line: &[u8], value: &RawValue) -> Result<f64, String> {
    let cos: f64 = read(line, "cos", value)?;
    if (-1.0..=1.0).contains(&cos) {
        Ok(cos)
    } else {
        Err(format!("cos must be between -1 and 1, not {}", shown(cos)))
    }
}

/// A number as the errors of the crate show it: with an exponent where it would have many zeros.
fn shown(number: f64) -> String {
    let magnitude = number.abs();
    if magnitude == 0.0 || (1e-4..1e6).contains(&magnitude) {
        number.to_string()
    } else {
        format!("{number:e}")
    }
}

fn vector<T: Real>([x, y, z]: &[f64; 3]) -> T::Vec3 {
    Vector::new(T::lit(*x), T::lit(*y), T::lit(*z))
}

fn components<T: Real>(vector: T::Vec3) -> [T; 3] {
    [vector.x(), vector.y(), vector.z()]
}
