//! One question, a line of JSON, and its answer, another.

use std::collections::{BTreeMap, BTreeSet};

use brdf::description::{
    BrdfDescription, BsdfDescription, DescriptionError, DistributionDescription, FresnelDescription,
};
use brdf::polarization::{Amplitudes, Complex, Polarized, Stokes};
use brdf::wgsl::{Module, ShaderError};
use brdf::{
    AnyBsdf, AnyFresnel, Brdf, Bsdf, BsdfSample, Distribution, Dual, Fresnel, Lobe, Real,
    TransportMode, Vector,
};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::value::RawValue;

use crate::optics::{Element, Matrices, Response, Surface};

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

trait Number: Real<Mask = bool> + PartialOrd + Serialize {
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
    Value {
        value: [T; 3],
        pdf: T,
    },
    Sample {
        wi: [T; 3],
        weight: [T; 3],
        /// None of a specular lobe.
        pdf: Option<T>,
    },
    Power {
        reflectance: [T; 3],
        transmittance: [T; 3],
    },
    Specular {
        lobes: Vec<Lobes<T>>,
    },
    Albedo {
        albedo: [T; 3],
    },
    Reflectance {
        reflectance: [T; 3],
    },
    FilmReflectance {
        reflectance: [T; 3],
        xyz: [T; 3],
    },
    Average {
        average: [T; 3],
    },
    Density {
        density: T,
    },
    Channels {
        mueller: [[[T; 4]; 4]; 3],
    },
    Surface {
        r: Option<SAndP<[T; 2]>>,
        t: Option<SAndP<[T; 2]>>,
        reflectance: SAndP<T>,
        transmittance: SAndP<T>,
    },
    Optics {
        mueller: [[T; 4]; 4],
        jones: Option<[[[T; 2]; 2]; 2]>,
    },
    Light {
        stokes: [T; 4],
        degree_of_polarization: T,
    },
    Gradient {
        value: [T; 3],
        gradient: BTreeMap<String, [T; 3]>,
    },
    Text {
        text: String,
    },
}

#[derive(Serialize)]
struct Lobes<T> {
    wi: [T; 3],
    weight: [T; 3],
}

#[derive(Serialize)]
struct SAndP<V> {
    s: V,
    p: V,
}

impl<V> From<Polarized<V>> for SAndP<V> {
    fn from(both: Polarized<V>) -> Self {
        Self { s: both.s, p: both.p }
    }
}

fn parts<T: Real>(number: Complex<T>) -> [T; 2] {
    [number.re, number.im]
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
    bsdf: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    specular: Option<&'a RawValue>,
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
    mueller: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    gradient: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    wgsl: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    name: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    surface: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    optics: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    stokes: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    wavelength: Option<&'a RawValue>,
    #[serde(borrow, default, deserialize_with = "given")]
    mode: Option<&'a RawValue>,
}

impl<'a> Keys<'a> {
    /// Those that are there, with their values, in this order.
    fn all(&self) -> Vec<(&'static str, &'a RawValue)> {
        let keys = [
            ("brdf", self.brdf),
            ("bsdf", self.bsdf),
            ("specular", self.specular),
            ("mueller", self.mueller),
            ("gradient", self.gradient),
            ("wgsl", self.wgsl),
            ("fresnel", self.fresnel),
            ("distribution", self.distribution),
            ("surface", self.surface),
            ("optics", self.optics),
            ("wi", self.wi),
            ("wo", self.wo),
            ("u", self.u),
            ("cos", self.cos),
            ("h", self.h),
            ("stokes", self.stokes),
            ("wavelength", self.wavelength),
            ("name", self.name),
            ("mode", self.mode),
        ];
        keys.into_iter().filter_map(|(key, value)| Some((key, value?))).collect()
    }
}

/// Unlike an absent value, `null` is a value, of a wrong type.
fn given<'de, D: Deserializer<'de>>(from: D) -> Result<Option<&'de RawValue>, D::Error> {
    <&RawValue>::deserialize(from).map(Some)
}

enum Question {
    Value { brdf: BrdfDescription, wi: [f64; 3], wo: [f64; 3] },
    Sample { brdf: BrdfDescription, wo: [f64; 3], u: [f64; 2] },
    Albedo { brdf: BrdfDescription, wo: [f64; 3] },
    ValueWithLobes { brdf: BsdfDescription, wi: [f64; 3], wo: [f64; 3] },
    SampleWithLobes { brdf: BsdfDescription, wo: [f64; 3], u: [f64; 2] },
    AlbedoWithLobes { brdf: BsdfDescription, wo: [f64; 3] },
    BsdfValue { bsdf: BsdfDescription, wi: [f64; 3], wo: [f64; 3], mode: TransportMode },
    BsdfSample { bsdf: BsdfDescription, wo: [f64; 3], u: [f64; 3], mode: TransportMode },
    Power { bsdf: BsdfDescription, wo: [f64; 3] },
    Specular { bsdf: BsdfDescription, wo: [f64; 3], mode: TransportMode },
    Mueller { brdf: BsdfDescription, wi: [f64; 3], wo: [f64; 3] },
    Gradient { brdf: BrdfDescription, wi: [f64; 3], wo: [f64; 3] },
    Text { brdf: BrdfDescription, name: String },
    Reflectance { fresnel: FresnelDescription, cos: f64 },
    Average { fresnel: FresnelDescription },
    Density { distribution: DistributionDescription, h: [f64; 3] },
    Surface { surface: Surface, cos: f64, wavelength: f64 },
    Optics { optics: Element, stokes: Option<[f64; 4]>, wavelength: f64 },
}

const KINDS: &str = "a question has the keys brdf, wi, wo; or brdf, wo, u; or brdf, wo; \
                     or bsdf, wi, wo and perhaps mode; or bsdf, wo, u and perhaps mode; or bsdf, wo; \
                     or specular, wo and perhaps mode; or mueller, wi, wo; or gradient, wi, wo; or wgsl, name; or fresnel, cos; or fresnel; or distribution, h; \
                     or surface, cos and perhaps wavelength; \
                     or optics and perhaps stokes, wavelength";

impl Question {
    fn read(line: &[u8]) -> Result<Self, String> {
        let keys: Keys = serde_json::from_slice(line).map_err(|error| message(&error, 0))?;
        let brdf = |value| read(line, "brdf", value);
        let wi = |value| direction(line, "wi", value);
        let wo = |value| direction(line, "wo", value);
        let lobes = |value| read(line, "brdf", value);
        let bsdf = |value| read(line, "bsdf", value);
        match *keys.all() {
            [("brdf", it), ("wo", seen)] if has_lobes(it) => {
                Ok(Self::AlbedoWithLobes { brdf: lobes(it)?, wo: wo(seen)? })
            }
            [("brdf", it), ("wi", lit), ("wo", seen)] if has_lobes(it) => {
                Ok(Self::ValueWithLobes { brdf: lobes(it)?, wi: wi(lit)?, wo: wo(seen)? })
            }
            [("brdf", it), ("wo", seen), ("u", u)] if has_lobes(it) => {
                Ok(Self::SampleWithLobes { brdf: lobes(it)?, wo: wo(seen)?, u: uniform(line, u)? })
            }
            [("bsdf", it), ("wo", seen)] => Ok(Self::Power { bsdf: bsdf(it)?, wo: wo(seen)? }),
            [("bsdf", it), ("wi", lit), ("wo", seen), ref rest @ ..] => Ok(Self::BsdfValue {
                bsdf: bsdf(it)?,
                wi: wi(lit)?,
                wo: wo(seen)?,
                mode: mode(line, rest)?,
            }),
            [("bsdf", it), ("wo", seen), ("u", u), ref rest @ ..] => Ok(Self::BsdfSample {
                bsdf: bsdf(it)?,
                wo: wo(seen)?,
                u: uniform(line, u)?,
                mode: mode(line, rest)?,
            }),
            [("specular", it), ("wo", seen), ref rest @ ..] => Ok(Self::Specular {
                bsdf: read(line, "specular", it)?,
                wo: wo(seen)?,
                mode: mode(line, rest)?,
            }),
            [("brdf", it), ("wo", seen)] => Ok(Self::Albedo { brdf: brdf(it)?, wo: wo(seen)? }),
            [("brdf", it), ("wi", lit), ("wo", seen)] => {
                Ok(Self::Value { brdf: brdf(it)?, wi: wi(lit)?, wo: wo(seen)? })
            }
            [("brdf", it), ("wo", seen), ("u", u)] => {
                Ok(Self::Sample { brdf: brdf(it)?, wo: wo(seen)?, u: uniform(line, u)? })
            }
            [("mueller", it), ("wi", lit), ("wo", seen)] => {
                Ok(Self::Mueller { brdf: read(line, "mueller", it)?, wi: wi(lit)?, wo: wo(seen)? })
            }
            [("gradient", it), ("wi", lit), ("wo", seen)] => Ok(Self::Gradient {
                brdf: read(line, "gradient", it)?,
                wi: wi(lit)?,
                wo: wo(seen)?,
            }),
            [("wgsl", it), ("name", name)] => {
                Ok(Self::Text { brdf: read(line, "wgsl", it)?, name: read(line, "name", name)? })
            }
            [("fresnel", it), ("cos", cos)] => Ok(Self::Reflectance {
                fresnel: read(line, "fresnel", it)?,
                cos: cosine(line, cos)?,
            }),
            [("fresnel", it)] => Ok(Self::Average { fresnel: read(line, "fresnel", it)? }),
            [("distribution", it), ("h", h)] => Ok(Self::Density {
                distribution: read(line, "distribution", it)?,
                h: direction(line, "h", h)?,
            }),
            [("surface", it), ("cos", cos), ref rest @ ..] => Ok(Self::Surface {
                surface: read(line, "surface", it)?,
                cos: crate::optics::cosine(read(line, "cos", cos)?)?,
                wavelength: wavelength(line, rest)?,
            }),
            [("optics", it), ("stokes", light), ref rest @ ..] => Ok(Self::Optics {
                optics: read(line, "optics", it)?,
                stokes: Some(stokes(line, light)?),
                wavelength: wavelength(line, rest)?,
            }),
            [("optics", it), ref rest @ ..] => Ok(Self::Optics {
                optics: read(line, "optics", it)?,
                stokes: None,
                wavelength: wavelength(line, rest)?,
            }),
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
                    pdf: Some(sample.pdf),
                }
            }
            Self::ValueWithLobes { brdf, wi, wo } => {
                let model = brdf.build::<T>().map_err(|error| format!("brdf: {error}"))?;
                value(&model, wi, wo, TransportMode::Radiance)
            }
            Self::SampleWithLobes { brdf, wo, u } => {
                let model = brdf.build::<T>().map_err(|error| format!("brdf: {error}"))?;
                let [x, y] = u.map(|u| T::lit(u).min(T::BELOW_ONE));
                match &model {
                    AnyBsdf::BeckmannKirchhoff(model) => {
                        return Ok(drawn::<T>(model.sample_by_two(vector::<T>(wo), [x, y])));
                    }
                    AnyBsdf::He1991(model) => {
                        return Ok(drawn::<T>(model.sample_by_two(vector::<T>(wo), [x, y])));
                    }
                    _ => {}
                }
                let lobes = model.specular(vector::<T>(wo), TransportMode::Radiance);
                // The first number chooses and is used again.
                let first = lobes.reflected.weight.x();
                let rest = if x < first { x / first } else { (x - first) / (T::one() - first) };
                sample(&model, wo, [rest, y, x], TransportMode::Radiance)
            }
            Self::AlbedoWithLobes { brdf, wo } => {
                let model = brdf.build::<T>().map_err(|error| format!("brdf: {error}"))?;
                Answer::Albedo { albedo: components(model.power(vector::<T>(wo)).reflectance) }
            }
            Self::BsdfValue { bsdf, wi, wo, mode } => {
                let model = bsdf.build::<T>().map_err(|error| format!("bsdf: {error}"))?;
                value(&model, wi, wo, *mode)
            }
            Self::BsdfSample { bsdf, wo, u, mode } => {
                let model = bsdf.build::<T>().map_err(|error| format!("bsdf: {error}"))?;
                sample(&model, wo, u.map(|u| T::lit(u).min(T::BELOW_ONE)), *mode)
            }
            Self::Power { bsdf, wo } => {
                let model = bsdf.build::<T>().map_err(|error| format!("bsdf: {error}"))?;
                let power = model.power(vector::<T>(wo));
                Answer::Power {
                    reflectance: components(power.reflectance),
                    transmittance: components(power.transmittance),
                }
            }
            Self::Specular { bsdf, wo, mode } => {
                let model = bsdf.build::<T>().map_err(|error| format!("specular: {error}"))?;
                let lobes = model.specular(vector::<T>(wo), *mode);
                let lobes = [lobes.reflected, lobes.transmitted].into_iter();
                let there = lobes.map(|Lobe { wi, weight }| Lobes {
                    wi: components::<T>(wi),
                    weight: components::<T>(weight),
                });
                let there = there.filter(|lobe| lobe.weight.iter().any(|it| *it > T::zero()));
                Answer::Specular { lobes: there.collect() }
            }
            Self::Albedo { brdf, wo } => {
                let model = brdf.build::<T>().map_err(|error| format!("brdf: {error}"))?;
                Answer::Albedo { albedo: components(model.albedo(vector::<T>(wo))) }
            }
            Self::Reflectance { fresnel, cos } => {
                let term = fresnel.build::<T>().map_err(|error| format!("fresnel: {error}"))?;
                let (cos, reflectance) = (T::lit(*cos), term.reflectance(T::lit(*cos)));
                let reflectance = components(reflectance);
                match term {
                    AnyFresnel::BelcourBarla(film) => {
                        Answer::FilmReflectance { reflectance, xyz: film.xyz(cos) }
                    }
                    _ => Answer::Reflectance { reflectance },
                }
            }
            Self::Average { fresnel } => {
                let term = fresnel.build::<T>().map_err(|error| format!("fresnel: {error}"))?;
                Answer::Average { average: components(term.average()) }
            }
            Self::Mueller { brdf, wi, wo } => {
                let model = brdf.build::<T>().map_err(|error| format!("mueller: {error}"))?;
                let matrix = model.mueller(vector::<T>(wi), vector::<T>(wo)).ok_or(
                    "mueller: the model must consist of facets with a Fresnel term that knows \
                     amplitudes: dielectric, conductor, metal, stack",
                )?;
                let channel = |channel: usize| {
                    matrix.rows.map(|row| row.map(|color| components::<T>(color)[channel]))
                };
                Answer::Channels { mueller: [channel(0), channel(1), channel(2)] }
            }
            Self::Gradient { brdf, wi, wo } => {
                let (wi, wo) = (vector::<T>(wi), vector::<T>(wo));
                gradient(brdf, wi, wo).map_err(|error| format!("gradient: {error}"))?
            }
            Self::Text { brdf, name } => {
                let mut module = Module::new();
                module.add_described(name, brdf).map_err(|error| match error {
                    ShaderError::Description(error) => format!("wgsl: {error}"),
                    error => error.to_string(),
                })?;
                Answer::Text { text: module.to_string() }
            }
            Self::Surface { surface, cos, wavelength } => {
                let found = surface.response::<T>(*cos, *wavelength);
                match found.map_err(|error| format!("surface: {error}"))? {
                    Response::Coherent(found) => {
                        let Amplitudes { r, t, transmittance } = found;
                        Answer::Surface {
                            r: Some(r.map(parts).into()),
                            t: Some(t.map(parts).into()),
                            reflectance: found.reflectance().into(),
                            transmittance: transmittance.into(),
                        }
                    }
                    Response::Incoherent(found) => Answer::Surface {
                        r: None,
                        t: None,
                        reflectance: found.reflectance.into(),
                        transmittance: found.transmittance.into(),
                    },
                }
            }
            Self::Optics { optics, stokes, wavelength } => {
                let matrices = optics.matrices::<T>(*wavelength);
                let Matrices { mueller, jones } =
                    matrices.map_err(|error| format!("optics: {error}"))?;
                match stokes {
                    Some(light) => {
                        let light = mueller * Stokes::from(light.map(T::lit));
                        Answer::Light {
                            stokes: light.to_array(),
                            degree_of_polarization: light.degree_of_polarization(),
                        }
                    }
                    None => Answer::Optics {
                        mueller: mueller.rows,
                        jones: jones.map(|jones| jones.rows.map(|row| row.map(parts))),
                    },
                }
            }
            Self::Density { distribution, h } => {
                let distribution =
                    distribution.build::<T>().map_err(|error| format!("distribution: {error}"))?;
                Answer::Density { density: distribution.density(vector::<T>(h)) }
            }
        })
    }
}

/// A model over the whole sphere at a pair.
fn value<T: Number>(
    model: &impl Bsdf<T, Color = T::Vec3>,
    wi: &[f64; 3],
    wo: &[f64; 3],
    mode: TransportMode,
) -> Answer<T> {
    let (value, pdf) = model.eval_pdf(vector::<T>(wi), vector::<T>(wo), mode);
    Answer::Value { value: components(value), pdf }
}

fn sample<T: Number>(
    model: &impl Bsdf<T, Color = T::Vec3>,
    wo: &[f64; 3],
    u: [T; 3],
    mode: TransportMode,
) -> Answer<T> {
    drawn(model.sample(vector::<T>(wo), u, mode))
}

fn drawn<T: Number>(sample: BsdfSample<T, T::Vec3>) -> Answer<T> {
    let BsdfSample { wi, weight, pdf, specular } = sample;
    Answer::Sample {
        wi: components(wi),
        weight: components(weight),
        pdf: (!specular).then_some(pdf),
    }
}

/// The value for a pair, and its derivatives by every number that the model is made of. The channels of
/// a colour count as one: each channel of the value depends on its own. The components of a vector do not.
fn gradient<T: Number>(
    brdf: &BrdfDescription,
    wi: T::Vec3,
    wo: T::Vec3,
) -> Result<Answer<T>, DescriptionError> {
    let mut places = Vec::new();
    let model = brdf.build_with(|path, value| {
        places.push(path.to_string());
        T::lit(value)
    })?;
    let channels: BTreeSet<String> = brdf
        .numbers()
        .into_iter()
        .filter_map(|number| number.channel.map(|_| number.path))
        .collect();
    let counted = |place: &str| match place.rsplit_once('[') {
        Some((color, _)) if channels.contains(place) => color.to_owned(),
        _ => place.to_owned(),
    };
    let mut gradient = BTreeMap::new();
    for place in &places {
        let place = counted(place);
        if gradient.contains_key(&place) {
            continue;
        }
        let model = brdf.build_with(|path, value| {
            let moves = counted(&path.to_string()) == place;
            let value = T::lit(value);
            if moves { Dual::<T, 1>::variable(value, 0) } else { Dual::constant(value) }
        })?;
        let f = model.eval(Dual::vector(wi), Dual::vector(wo));
        gradient.insert(place, [f.x, f.y, f.z].map(|channel| channel.derivatives[0]));
    }
    Ok(Answer::Gradient { value: components(model.eval(wi, wo)), gradient })
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

/// Whether a model of reflection has specular lobes: its form is one that descriptions count among those
/// over the whole sphere.
fn has_lobes(model: &RawValue) -> bool {
    let name = model.get().trim_start_matches(['{', ' ', '\t', '\r']);
    let split = name.starts_with("\"schlick_1994\"") && name.contains("\"split\"");
    let lobes = ["\"mirror\"", "\"plastic\"", "\"beckmann_kirchhoff_1963\"", "\"he_1991\""];
    split || lobes.into_iter().any(|lobes| name.starts_with(lobes))
}

/// The mode of transport of a question, if nothing else follows.
fn mode(line: &[u8], rest: &[(&str, &RawValue)]) -> Result<TransportMode, String> {
    match *rest {
        [] => Ok(TransportMode::Radiance),
        [("mode", value)] => match read::<String>(line, "mode", value)?.as_str() {
            "radiance" => Ok(TransportMode::Radiance),
            "importance" => Ok(TransportMode::Importance),
            other => Err(format!("mode must be radiance or importance, not {other}")),
        },
        _ => Err(KINDS.into()),
    }
}

fn uniform<const N: usize>(line: &[u8], value: &RawValue) -> Result<[f64; N], String> {
    let u: [f64; N] = list(line, "u", value)?;
    match u.iter().enumerate().find(|(_, u)| !(0.0..1.0).contains(*u)) {
        None => Ok(u),
        Some((index, u)) => {
            Err(format!("u[{index}] must be at least 0 and below 1, not {}", shown(*u)))
        }
    }
}

/// The wavelength of a question in nanometres, if nothing else follows.
fn wavelength(line: &[u8], rest: &[(&str, &RawValue)]) -> Result<f64, String> {
    match *rest {
        [] => Ok(550.0),
        [("wavelength", value)] => {
            let wavelength: f64 = read(line, "wavelength", value)?;
            if (1.0..=1e9).contains(&wavelength) {
                Ok(wavelength)
            } else {
                Err(format!("wavelength must be between 1 and 1e9, not {}", shown(wavelength)))
            }
        }
        _ => Err(KINDS.into()),
    }
}

/// Light that there is: no more of it polarised than all of it, but for rounding.
fn stokes(line: &[u8], value: &RawValue) -> Result<[f64; 4], String> {
    let [i, q, u, v]: [f64; 4] = list(line, "stokes", value)?;
    if (q * q + u * u + v * v).sqrt() <= i * (1.0 + 1e-6) {
        Ok([i, q, u, v])
    } else {
        Err(format!("stokes must have an I of at least √(Q² + U² + V²), not {}", shown(i)))
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
