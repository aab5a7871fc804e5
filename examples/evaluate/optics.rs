//! Surfaces and optical elements as data, at one wavelength.

use brdf::materials::{OpticalConstants, Sample};
use brdf::polarization::{
    Amplitudes, Complex, Incoherent, Interface, Jones, Layer, Layers, Mueller, Plates,
};
use brdf::{ParameterError, Real, materials};
use serde::Deserialize;

/// A smooth surface.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Surface {
    Interface(Pair),
    Stack(Films),
    Plates(Pile),
}

/// Two half spaces.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pair {
    #[serde(default)]
    from: Index,
    to: Index,
}

/// Coherent layers between two half spaces.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Films {
    #[serde(default)]
    outside: Index,
    layers: Vec<Film>,
    substrate: Index,
    /// Read, for it belongs to a stack; a question has a wavelength of its own.
    #[serde(default, rename = "wavelength")]
    _wavelength: Option<Channels>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Film {
    index: Index,
    thickness: f64,
}

/// Plane plates in air without coherence.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pile {
    index: f64,
    count: u32,
    #[serde(default)]
    absorption: f64,
}

/// The index of a medium.
#[derive(Clone, Debug, Deserialize)]
#[serde(
    untagged,
    expecting = "an index is n, [n, k], {\"eta\": n, \"k\": k}, {\"material\": \"Au\"} or \
                 {\"samples\": [[nm, n, k], …]}"
)]
enum Index {
    Real(f64),
    Complex([f64; 2]),
    Channels(EtaK),
    Measured(Measured),
    Own(Own),
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct EtaK {
    eta: Channels,
    k: Channels,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Measured {
    material: String,
}

/// Samples, each a wavelength, n and k.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Own {
    samples: Vec<[f64; 3]>,
}

/// A number for all channels, or one for each.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged, expecting = "a number or a list of 3 numbers")]
enum Channels {
    All(f64),
    Each([f64; 3]),
}

impl Default for Index {
    fn default() -> Self {
        Self::Real(1.0)
    }
}

impl Channels {
    /// What is the same in all channels: a question has one wavelength.
    fn one(&self, key: &str) -> Result<f64, String> {
        match *self {
            Self::All(value) => Ok(value),
            Self::Each([red, green, blue]) if red == green && green == blue => Ok(red),
            Self::Each(_) => {
                Err(format!("{key} must be the same in all channels at one wavelength"))
            }
        }
    }
}

impl Index {
    fn at<T: Real>(&self, path: &str, wavelength: f64) -> Result<Complex<T>, String> {
        let [n, k] = match self {
            Self::Real(n) => [*n, 0.0],
            Self::Complex(index) => *index,
            Self::Channels(EtaK { eta, k }) => {
                [eta.one(&format!("{path}.eta"))?, k.one(&format!("{path}.k"))?]
            }
            Self::Measured(Measured { material }) => {
                let wrong = |error: &dyn std::error::Error| format!("{path}.material: {error}");
                let found = materials::find(material).map_err(|error| wrong(&error))?;
                let index = found.refractive_index(wavelength).map_err(|error| wrong(&error))?;
                [index.eta, index.k]
            }
            Self::Own(Own { samples }) => {
                let samples = samples.iter().map(|[at, n, k]| Sample::new(*at, *n, *k));
                let index = OpticalConstants::new(samples)
                    .and_then(|constants| constants.refractive_index(wavelength))
                    .map_err(|error| format!("{path}.samples: {error}"))?;
                [index.eta, index.k]
            }
        };
        Ok(Complex::new(T::lit(n), T::lit(k)))
    }
}

/// What a surface does to a plane wave.
pub enum Response<T> {
    Coherent(Amplitudes<T>),
    Incoherent(Incoherent<T>),
}

impl Surface {
    /// At a cosine of the angle of incidence and a wavelength in nanometres.
    pub fn response<T: Real>(&self, cos: f64, wavelength: f64) -> Result<Response<T>, String> {
        let (cos, lambda) = (T::lit(cos), T::lit(wavelength));
        match self {
            Self::Interface(Pair { from, to }) => {
                let from = from.at("interface.from", wavelength)?;
                let to = to.at("interface.to", wavelength)?;
                let interface =
                    Interface::new(from, to).map_err(|error| wrong("interface", error))?;
                Ok(Response::Coherent(interface.amplitudes(cos)))
            }
            Self::Stack(Films { outside, layers, substrate, .. }) => {
                let films = layers.iter().enumerate().map(|(place, Film { index, thickness })| {
                    let index = index.at(&format!("stack.layers[{place}].index"), wavelength)?;
                    Ok(Layer { index, thickness: T::lit(*thickness) })
                });
                let films = films.collect::<Result<Vec<_>, String>>()?;
                let outside = outside.at("stack.outside", wavelength)?;
                let substrate = substrate.at("stack.substrate", wavelength)?;
                let stack = Layers::new(outside, &films, substrate, lambda)
                    .map_err(|error| wrong("stack", error))?;
                Ok(Response::Coherent(stack.amplitudes(cos)))
            }
            Self::Plates(Pile { index, count, absorption }) => {
                let pile = Plates::new(T::lit(*index), *count, T::lit(*absorption))
                    .map_err(|error| wrong("plates", error))?;
                Ok(Response::Incoherent(pile.at(cos)))
            }
        }
    }
}

fn wrong(what: &str, error: ParameterError) -> String {
    format!("{what}: {error}")
}

/// An optical element.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Element {
    Reflection(Incidence),
    Transmission(Incidence),
    Rotation(f64),
    Polarizer(f64),
    Retarder(Retarder),
    /// The parts of the elements, row by row.
    Jones([[[f64; 2]; 2]; 2]),
    Chain(Vec<Self>),
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Incidence {
    surface: Surface,
    cos: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Retarder {
    retardance: f64,
    #[serde(default)]
    azimuth: f64,
}

/// The matrices of an element; of one that depolarises there is no Jones matrix.
pub struct Matrices<T> {
    pub mueller: Mueller<T>,
    pub jones: Option<Jones<T>>,
}

impl<T: Real> From<Jones<T>> for Matrices<T> {
    fn from(jones: Jones<T>) -> Self {
        Self { mueller: jones.mueller(), jones: Some(jones) }
    }
}

impl Element {
    /// At a wavelength in nanometres.
    pub fn matrices<T: Real>(&self, wavelength: f64) -> Result<Matrices<T>, String> {
        Ok(match self {
            Self::Reflection(Incidence { surface, cos }) => {
                match surface.response(cosine(*cos)?, wavelength)? {
                    Response::Coherent(found) => found.reflection().into(),
                    Response::Incoherent(found) => {
                        Matrices { mueller: found.mueller_reflection(), jones: None }
                    }
                }
            }
            Self::Transmission(Incidence { surface, cos }) => {
                match surface.response(cosine(*cos)?, wavelength)? {
                    Response::Coherent(found) => found.transmission().into(),
                    Response::Incoherent(found) => {
                        Matrices { mueller: found.mueller_transmission(), jones: None }
                    }
                }
            }
            Self::Rotation(angle) => Jones::rotation(T::lit(*angle)).into(),
            Self::Polarizer(azimuth) => Jones::polarizer(T::lit(*azimuth)).into(),
            Self::Retarder(Retarder { retardance, azimuth }) => {
                Jones::retarder(T::lit(*retardance), T::lit(*azimuth)).into()
            }
            Self::Jones(rows) => {
                let element = |[re, im]: [f64; 2]| Complex::new(T::lit(re), T::lit(im));
                Jones { rows: rows.map(|row| row.map(element)) }.into()
            }
            Self::Chain(elements) => {
                let mut chain = Matrices::from(Jones::rotation(T::zero()));
                for element in elements {
                    let Matrices { mueller, jones } = element.matrices(wavelength)?;
                    chain = Matrices {
                        mueller: mueller * chain.mueller,
                        jones: jones.zip(chain.jones).map(|(jones, chain)| jones * chain),
                    };
                }
                chain
            }
        })
    }
}

/// The cosine of an angle in the medium of the light.
pub fn cosine(cos: f64) -> Result<f64, String> {
    if cos > 0.0 && cos <= 1.0 {
        Ok(cos)
    } else {
        Err(format!("cos must be above 0 and at most 1, not {cos}"))
    }
}
