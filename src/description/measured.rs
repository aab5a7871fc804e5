//! Indices of measured materials and of samples.

use alloc::string::ToString;

use super::build::Build;
use super::channels::RGB;
use super::error::{DescriptionError, Problem};
use super::path::Path;
use super::value::{Described, Value};
use crate::error::ParameterError;
use crate::materials::{OpticalConstants, RefractiveIndex};
use crate::polarization::Complex;
use crate::real::{Color, Real};

/// Finds optical constants by a name.
type Named = fn(&str) -> Result<&'static OpticalConstants, Problem>;

/// The optical constants that an object with a material or samples has, and their place.
fn constants<'a>(
    described: &'a Described,
    path: &'a Path<'a>,
    named: Named,
) -> Result<(&'a OpticalConstants, Path<'a>), DescriptionError> {
    if let Some((_, Value::Constants(constants))) = described.get("samples") {
        return Ok((constants, path.key("samples")));
    }
    let path = path.key("material");
    let found = named(described.text("material")).map_err(|problem| path.error(problem))?;
    Ok((found, path))
}

/// Those of a material.
#[cfg(feature = "materials")]
fn named(name: &str) -> Result<&'static OpticalConstants, Problem> {
    Ok(lookup(name)?)
}

/// Those of a metal, alloy or semiconductor.
#[cfg(feature = "materials")]
fn metal(name: &str) -> Result<&'static OpticalConstants, Problem> {
    let material = lookup(name)?;
    if material.kind() == crate::materials::Kind::Dielectric {
        return Err(Problem::Metal(alloc::format!(
            "{} is no metal; describe it as a dielectric by its index",
            material.key()
        )));
    }
    Ok(material)
}

#[cfg(feature = "materials")]
fn lookup(name: &str) -> Result<&'static crate::materials::Material, Problem> {
    use super::place::beginning;
    use crate::materials::{LookupError, find};

    find(name).map_err(|error| {
        let error = match error {
            LookupError::Unknown { name, nearest } => {
                LookupError::Unknown { name: beginning(&name), nearest }
            }
            ambiguous => ambiguous,
        };
        Problem::Metal(error.to_string())
    })
}

#[cfg(not(feature = "materials"))]
fn named(name: &str) -> Result<&'static OpticalConstants, Problem> {
    Err(Problem::Metal(alloc::format!(
        "materials by name, such as {:?}, need the feature `materials`",
        super::place::beginning(name)
    )))
}

#[cfg(not(feature = "materials"))]
fn metal(name: &str) -> Result<&'static OpticalConstants, Problem> {
    named(name)
}

impl<T: Real, C: Color<T>> Build<'_, T, C> {
    /// The index of a medium in each channel, where red, green and blue have these wavelengths.
    pub(super) fn medium(
        &self,
        key: &'static str,
        own: [f64; 3],
    ) -> Result<Complex<C>, DescriptionError> {
        let Some((_, Value::Term(described))) = self.described.get(key) else {
            let (eta, k) = self.one_or_two(key)?;
            return Ok(Complex::new(C::splat(eta), C::splat(k.unwrap_or(T::zero()))));
        };
        let path = self.path.key(key);
        if described.get("eta").is_some() {
            let index = Build { described, path, ..*self };
            return Ok(Complex::new(index.color_at("eta", own)?, index.color_at("k", own)?));
        }
        let (constants, path) = constants(described, &path, named)?;
        let index = self.at_channels(own, |at| constants.refractive_index(at));
        let RefractiveIndex { eta, k } = index.map_err(|problem| path.error(problem))?;
        Ok(Complex::new(eta, k))
    }

    /// The index of a transparent medium in each channel; relative to that outside, if it has one.
    pub(super) fn transparent(&self, key: &'static str) -> Result<C, DescriptionError> {
        let Some((_, Value::Term(described))) = self.described.get(key) else {
            return self.color(key);
        };
        let path = self.path.key(key);
        let (constants, place) = constants(described, &path, named)?;
        let index = self.at_channels(RGB, |at| constants.transparent(at));
        let index = index.map_err(|problem| place.error(problem))?;
        let outside = Build { described, path, ..*self }.outside()?;
        Ok(outside.map_or(index, |outside| index.over(outside)).eta)
    }

    /// The index of a transparent medium that is the same in all channels: that of the middle one.
    pub(super) fn transparent_to_all(&self, key: &'static str) -> Result<T, DescriptionError> {
        let Some((_, Value::Term(described))) = self.described.get(key) else {
            return self.number(key);
        };
        let path = self.path.key(key);
        let (constants, place) = constants(described, &path, named)?;
        let index = constants.transparent(self.channels.wavelength(self.channels.middle(), RGB));
        let problem = |error: ParameterError| place.error(Problem::Metal(error.to_string()));
        Ok(T::lit(index.map_err(problem)?.eta))
    }

    /// The index of a metal, relative to that outside.
    pub(super) fn metal(&self) -> Result<RefractiveIndex<C>, DescriptionError> {
        let Some((_, Value::Term(described))) = self.described.get("name") else {
            let name = self.described.text("name");
            let index = metal(name)
                .and_then(|constants| self.at_channels(RGB, |at| constants.refractive_index(at)));
            return index.map_err(|problem| self.path.error(problem));
        };
        let (constants, place) = constants(described, &self.path, metal)?;
        let index = self.at_channels(RGB, |at| constants.refractive_index(at));
        let index = index.map_err(|problem| place.error(problem))?;
        let outside = Build { described, ..*self }.outside()?;
        Ok(outside.map_or(index, |outside| index.over(outside)))
    }

    /// The index outside of what is measured, unless that is air or does not matter.
    fn outside(&self) -> Result<Option<C>, DescriptionError> {
        if self.described.get("outside").is_none() || self.is_default("outside") {
            return Ok(None);
        }
        self.transparent("outside").map(Some)
    }

    /// What optical constants answer at the wavelength of each channel, where red, green and blue
    /// have wavelengths of their own.
    fn at_channels(
        &self,
        own: [f64; 3],
        index: impl Fn(f64) -> Result<RefractiveIndex, ParameterError>,
    ) -> Result<RefractiveIndex<C>, Problem> {
        let mut problem = None;
        let all = C::by_channel(|channel| {
            index(self.channels.wavelength(channel, own)).unwrap_or_else(|error| {
                problem.get_or_insert(Problem::Metal(error.to_string()));
                RefractiveIndex { eta: f64::NAN, k: f64::NAN }
            })
        });
        let part = |part: fn(&RefractiveIndex) -> f64| {
            let of = |channel| all.as_ref().get(channel).map_or(f64::NAN, part);
            C::from_channels(C::by_channel(|channel| T::lit(of(channel))))
        };
        match problem {
            Some(problem) => Err(problem),
            None => Ok(RefractiveIndex { eta: part(|it| it.eta), k: part(|it| it.k) }),
        }
    }
}
