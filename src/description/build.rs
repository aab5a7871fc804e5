//! What a form hands to the constructor of its type.

use alloc::vec::Vec;
use core::marker::PhantomData;

use super::channels::{Channels, RGB};
use super::error::{DescriptionError, Problem};
use super::path::Path;
use super::value::{Described, Numbers, Value};
use crate::error::ParameterError;
use crate::parameter::Preset;
use crate::real::{Color, Real};

/// A form, or a term of its list, that is built in a number.
#[derive(Clone, Copy)]
pub(super) struct Build<'a, T, C> {
    pub(super) described: &'a Described,
    pub(super) path: Path<'a>,
    /// Makes the number of the value at a place.
    pub(super) number: &'a dyn Fn(&Path<'_>, f64) -> T,
    pub(super) channels: Channels<'a>,
    pub(super) color: PhantomData<C>,
}

impl<T: Real, C: Color<T>> Build<'_, T, C> {
    /// The values of a parameter, each in its range.
    ///
    /// What the table does not have is NaN, which no range has.
    fn numbers(&self, key: &'static str) -> Result<Numbers<T>, DescriptionError> {
        let Some((parameter, Value::Numbers(numbers))) = self.described.get(key) else {
            return Ok(Numbers::One(T::lit(f64::NAN)));
        };
        let keyed = self.path.key(key);
        let path = if self.described.form.is_value() { self.path } else { keyed };
        let number = |path: &Path<'_>, index, value| {
            let number = (self.number)(path, value);
            let range = parameter.kind.range(index);
            let checked = range.map_or(Ok(()), |range| range.check::<T, _>(parameter.name, number));
            checked.map_err(|error| path.error(Problem::Parameter(error))).map(|()| number)
        };
        let at = |index, value| number(&path.index(index), index, value);
        Ok(match *numbers {
            Numbers::One(value) => Numbers::One(number(&path, 0, value)?),
            Numbers::Two([x, y]) => Numbers::Two([at(0, x)?, at(1, y)?]),
            Numbers::Three([x, y, z]) => Numbers::Three([at(0, x)?, at(1, y)?, at(2, z)?]),
        })
    }

    pub(super) fn number(&self, key: &'static str) -> Result<T, DescriptionError> {
        Ok(match self.numbers(key)? {
            Numbers::One(number) | Numbers::Two([number, _]) | Numbers::Three([number, ..]) => {
                number
            }
        })
    }

    /// The components of a vector, or red, green and blue; one number stands for all.
    pub(super) fn three(&self, key: &'static str) -> Result<[T; 3], DescriptionError> {
        Ok(match self.numbers(key)? {
            Numbers::Three(numbers) => numbers,
            Numbers::One(number) | Numbers::Two([number, _]) => [number; 3],
        })
    }

    pub(super) fn color(&self, key: &'static str) -> Result<C, DescriptionError> {
        self.color_at(key, RGB)
    }

    /// A colour whose red, green and blue are those of these wavelengths.
    pub(super) fn color_at(&self, key: &'static str, own: [f64; 3]) -> Result<C, DescriptionError> {
        let three = match self.numbers(key)? {
            Numbers::Three(three) => three,
            Numbers::One(gray) | Numbers::Two([gray, _]) => return Ok(C::splat(gray)),
        };
        let number = |place: usize| three.get(place).copied().unwrap_or(T::lit(f64::NAN));
        let channel = |channel| match self.channels.shares(channel, own) {
            [(one, _), (_, 0.0)] => number(one),
            [(one, share), (other, rest)] => {
                number(one) * T::lit(share) + number(other) * T::lit(rest)
            }
        };
        Ok(C::from_channels(C::by_channel(channel)))
    }

    /// The wavelength of each channel: that of a key, or the one it is built for.
    pub(super) fn wavelength(&self, key: &'static str) -> Result<C, DescriptionError> {
        let Channels::Wavelengths(all) = self.channels else {
            return self.color(key);
        };
        let channel = |channel| T::lit(all.get(channel).copied().unwrap_or(f64::NAN));
        Ok(C::from_channels(C::by_channel(channel)))
    }

    /// A number for all, or one along the tangent and one along the bitangent; or an index.
    pub(super) fn one_or_two(&self, key: &'static str) -> Result<(T, Option<T>), DescriptionError> {
        Ok(match self.numbers(key)? {
            Numbers::One(one) | Numbers::Three([one, ..]) => (one, None),
            Numbers::Two([first, second]) => (first, Some(second)),
        })
    }

    /// What has a roughness.
    pub(super) fn rough<D>(
        &self,
        isotropic: impl FnOnce(T) -> Result<D, ParameterError>,
        anisotropic: impl FnOnce(T, T) -> Result<D, ParameterError>,
    ) -> Result<D, DescriptionError> {
        let made = match self.one_or_two("roughness")? {
            (roughness, None) => isotropic(roughness),
            (along_x, Some(along_y)) => anisotropic(along_x, along_y),
        };
        self.made(made)
    }

    /// The terms of a key, by what makes each of them.
    pub(super) fn each<V>(
        &self,
        key: &'static str,
        term: impl Fn(&Build<'_, T, C>) -> Result<V, DescriptionError>,
    ) -> Result<Vec<V>, DescriptionError> {
        let path = self.path.key(key);
        let terms = match self.described.get(key) {
            Some((_, Value::List(terms))) => terms.as_slice(),
            _ => return Err(self.unknown()),
        };
        let each = terms.iter().enumerate().map(|(index, value)| match value {
            Value::Term(described) => term(&Build { described, path: path.index(index), ..*self }),
            _ => Err(self.unknown()),
        });
        each.collect()
    }

    pub(super) fn flag(&self, key: &str) -> bool {
        matches!(self.described.get(key), Some((_, Value::Flag(true))))
    }

    /// Whether all numbers of a parameter are its default.
    pub(super) fn is_default(&self, key: &str) -> bool {
        match self.described.get(key) {
            Some((parameter, Value::Numbers(numbers))) => {
                let is = |number: &f64| parameter.default == Some(Preset::Number(*number));
                match numbers {
                    Numbers::One(number) => is(number),
                    Numbers::Two(numbers) => numbers.iter().all(is),
                    Numbers::Three(numbers) => numbers.iter().all(is),
                }
            }
            _ => false,
        }
    }

    /// A part, by what makes it of its form.
    pub(super) fn part<V>(
        &self,
        key: &'static str,
        build: impl FnOnce(&Build<'_, T, C>) -> Result<V, DescriptionError>,
    ) -> Result<V, DescriptionError> {
        match self.described.get(key) {
            Some((_, Value::Form(described))) => {
                let path = self.path.key(key);
                let name = described.form.name();
                build(&Build { described, path: path.key(name), ..*self })
            }
            _ => Err(self.unknown()),
        }
    }

    /// The terms of a list, by what makes each of them.
    pub(super) fn terms<V>(
        &self,
        term: impl Fn(&Build<'_, T, C>) -> Result<V, DescriptionError>,
    ) -> Result<Vec<V>, DescriptionError> {
        let terms = self.described.values.iter().enumerate();
        terms
            .map(|(index, value)| match value {
                Value::Term(described) => {
                    term(&Build { described, path: self.path.index(index), ..*self })
                }
                _ => Err(self.unknown()),
            })
            .collect()
    }

    /// What a constructor says whose parameters are called like the keys.
    pub(super) fn made<V>(&self, made: Result<V, ParameterError>) -> Result<V, DescriptionError> {
        made.map_err(|error| self.path.key(error.parameter()).error(Problem::Parameter(error)))
    }

    /// What a constructor of a whole list says.
    pub(super) fn list<V>(&self, made: Result<V, ParameterError>) -> Result<V, DescriptionError> {
        made.map_err(|error| self.path.error(Problem::Parameter(error)))
    }

    /// The error of a form that is in the table and that nothing builds.
    pub(super) fn unknown(&self) -> DescriptionError {
        self.path.error(Problem::Unknown)
    }
}
