//! Colours, indices and roughness.

use serde::{Deserializer, Serialize, Serializer};

use super::error::DescriptionError;
use super::parse::{Numbers, Parse};
use super::place::Place;
use crate::error::ParameterError;
use crate::real::{Color, Real, Vector};

/// A colour: `0.5`, or `[r, g, b]`.
///
/// It is read as a part of a description only, whose errors name its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ColorDescription {
    /// The same in every channel.
    Gray(f64),
    /// Red, green and blue.
    Rgb([f64; 3]),
}

impl ColorDescription {
    pub(super) fn color<T: Real>(self) -> T::Vec3 {
        match self {
            Self::Gray(value) => Color::splat(T::lit(value)),
            Self::Rgb([r, g, b]) => Vector::new(T::lit(r), T::lit(g), T::lit(b)),
        }
    }

    /// What a constructor says with this colour, the value of the place, as its one parameter.
    pub(super) fn parameter<T: Real, V>(
        self,
        place: &Place<'_>,
        result: Result<V, ParameterError>,
    ) -> Result<V, DescriptionError> {
        let channel = match (&result, self) {
            (Err(error), Self::Rgb(channels)) => {
                let (lower, upper) = error.range();
                channels.iter().position(|value| T::lit(*value).outside(lower, upper).is_some())
            }
            _ => None,
        };
        match channel {
            Some(channel) => place.index(channel).parameter(result),
            None => place.parameter(result),
        }
    }
}

/// What a constructor says whose parameters are called like the keys of the place, some of them
/// colours.
pub(super) fn colored<T: Real, V>(
    place: &Place<'_>,
    colors: &[(&str, ColorDescription)],
    result: Result<V, ParameterError>,
) -> Result<V, DescriptionError> {
    let parameter = result.as_ref().err().map(ParameterError::parameter);
    match (parameter, colors.iter().find(|(key, _)| Some(*key) == parameter)) {
        (Some(parameter), Some((_, color))) => {
            color.parameter::<T, V>(&place.key(parameter), result)
        }
        _ => place.parameters(result),
    }
}

impl<'de> Parse<'de> for ColorDescription {
    fn parse<D: Deserializer<'de>>(place: &Place<'_>, from: D) -> Result<Self, D::Error> {
        Ok(match Numbers::parse(place, from)? {
            Numbers::One(value) => Self::Gray(value),
            Numbers::Each(channels) => Self::Rgb(channels),
        })
    }
}

impl Serialize for ColorDescription {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Gray(value) => value.serialize(to),
            Self::Rgb(channels) => channels.as_slice().serialize(to),
        }
    }
}

/// A refractive index at one wavelength: `1.5`, or `[eta, k]` of a conductor.
///
/// It is read as a part of a description only, whose errors name its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IndexDescription {
    /// Of a transparent medium.
    Real(f64),
    /// Real and imaginary part.
    Complex([f64; 2]),
}

impl<'de> Parse<'de> for IndexDescription {
    fn parse<D: Deserializer<'de>>(place: &Place<'_>, from: D) -> Result<Self, D::Error> {
        Ok(match Numbers::parse(place, from)? {
            Numbers::One(value) => Self::Real(value),
            Numbers::Each(parts) => Self::Complex(parts),
        })
    }
}

impl Serialize for IndexDescription {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Real(value) => value.serialize(to),
            Self::Complex(parts) => parts.as_slice().serialize(to),
        }
    }
}

/// A roughness: `0.3`, or `[along_x, along_y]`.
///
/// It is read as a part of a description only, whose errors name its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RoughnessDescription {
    /// The same in every direction.
    Isotropic(f64),
    /// Along the tangent and the bitangent.
    Anisotropic([f64; 2]),
}

impl RoughnessDescription {
    /// A distribution of this roughness, which is the key `roughness` of the place.
    pub(super) fn distribution<T: Real, D>(
        self,
        place: &Place<'_>,
        isotropic: impl FnOnce(T) -> Result<D, ParameterError>,
        anisotropic: impl FnOnce(T, T) -> Result<D, ParameterError>,
    ) -> Result<D, DescriptionError> {
        let place = place.key("roughness");
        match self {
            Self::Isotropic(roughness) => place.parameter(isotropic(T::lit(roughness))),
            Self::Anisotropic([x, y]) => {
                let built = anisotropic(T::lit(x), T::lit(y));
                let index = match &built {
                    Err(error) if error.parameter() == "along_y" => 1,
                    _ => 0,
                };
                place.index(index).parameter(built)
            }
        }
    }
}

impl<'de> Parse<'de> for RoughnessDescription {
    fn parse<D: Deserializer<'de>>(place: &Place<'_>, from: D) -> Result<Self, D::Error> {
        Ok(match Numbers::parse(place, from)? {
            Numbers::One(value) => Self::Isotropic(value),
            Numbers::Each(along) => Self::Anisotropic(along),
        })
    }
}

impl Serialize for RoughnessDescription {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Isotropic(value) => value.serialize(to),
            Self::Anisotropic(along) => along.as_slice().serialize(to),
        }
    }
}
