//! The measured index of one material.

use core::fmt;
use core::ops::RangeInclusive;

use super::samples::{RefractiveIndex, Sample, Samples};
use crate::error::{ParameterError, Range};
use crate::fresnel::{Conductor, Dielectric};
use crate::real::{Color, Real};

/// What a material is, and whether it is a good choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// A pure metal.
    Metal,
    /// A mixture of metals.
    Alloy,
    /// A semiconductor.
    Semiconductor,
    /// A transparent or weakly absorbing medium.
    Dielectric,
    /// A second opinion on a metal that has another set.
    Alternative,
    /// A set not to be used for colour; [`Material::remark`] says why. These are tantalum and zinc.
    Caution,
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Metal => "metal",
            Self::Alloy => "alloy",
            Self::Semiconductor => "semiconductor",
            Self::Dielectric => "dielectric",
            Self::Alternative => "alternative",
            Self::Caution => "caution",
        })
    }
}

/// The form in which the source gives its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Form {
    /// A table: the samples are the numbers of the source.
    Table,
    /// A dispersion formula: the samples are its values every 5 nm.
    Formula,
}

/// A material whose index was measured: the table, and where that comes from.
///
/// The statics of [`materials`](super) are all there are.
pub struct Material {
    pub(super) key: &'static str,
    pub(super) name: &'static str,
    pub(super) kind: Kind,
    pub(super) citation: &'static str,
    pub(super) license: &'static str,
    pub(super) form: Form,
    pub(super) preparation: &'static str,
    pub(super) remark: Option<&'static str>,
    pub(super) samples: Samples,
}

impl Material {
    /// A short unique key: the chemical symbol of an element, with the author after `_` for a
    /// second opinion.
    #[must_use]
    pub const fn key(&self) -> &'static str {
        self.key
    }

    /// Name in English, unique too.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// Chemical symbol, if the material is an element.
    #[must_use]
    pub fn symbol(&self) -> Option<&'static str> {
        let element = matches!(
            self.kind,
            Kind::Metal | Kind::Semiconductor | Kind::Alternative | Kind::Caution
        );
        element.then(|| self.key.split_once('_').map_or(self.key, |(symbol, _)| symbol))
    }

    /// What it is.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        self.kind
    }

    /// The publication to cite.
    #[must_use]
    pub const fn citation(&self) -> &'static str {
        self.citation
    }

    /// SPDX identifier of the licence of the data.
    #[must_use]
    pub const fn license(&self) -> &'static str {
        self.license
    }

    /// Whether the source is a table or a formula.
    #[must_use]
    pub const fn form(&self) -> Form {
        self.form
    }

    /// How the samples were made of the source, and whether k is zero only because the source does
    /// not give it.
    #[must_use]
    pub const fn preparation(&self) -> &'static str {
        self.preparation
    }

    /// What to know before use, if anything.
    #[must_use]
    pub const fn remark(&self) -> Option<&'static str> {
        self.remark
    }

    /// The wavelengths in nanometres between which the index is known.
    #[must_use]
    pub fn range(&self) -> RangeInclusive<f64> {
        let (lower, upper) = self.samples.range();
        lower..=upper
    }

    /// The samples, by increasing wavelength.
    pub fn samples(&self) -> impl ExactSizeIterator<Item = Sample> + DoubleEndedIterator {
        self.samples.iter()
    }

    /// The index at a wavelength in nanometres, or at several: one for each channel of a colour.
    /// Between samples n and k are interpolated linearly in the wavelength.
    ///
    /// ```
    /// use brdf::Spectrum;
    /// use brdf::materials::SILICON;
    ///
    /// let red = SILICON.refractive_index(658.0_f64)?;
    /// assert!((red.eta - 3.8393).abs() < 1e-4 && (red.k - 0.01555).abs() < 1e-5);
    /// let lines = SILICON.refractive_index(Spectrum([488.0_f32, 658.0]))?;
    /// assert!((lines.eta.0[1] - 3.8393).abs() < 1e-4);
    /// // A hair beyond the end of the range, 826.6 nm.
    /// SILICON.refractive_index(295.2 + 100.0 * ((826.6 - 295.2) / 100.0))?;
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// If a wavelength is not in [`range`](Self::range); one that lies beyond by rounding counts as its
    /// end.
    pub fn refractive_index<T, C>(
        &self,
        wavelength: C,
    ) -> Result<RefractiveIndex<C>, ParameterError>
    where
        T: Real + Into<f64>,
        C: Color<T>,
    {
        let (shortest, longest) = self.samples.range();
        // What leaves the range by the rounding of a product or of a sum counts as its end.
        let rounding = 4.0 * T::SPACING;
        if let Some(value) =
            wavelength.outside(shortest * (1.0 - rounding), longest * (1.0 + rounding))
        {
            Range::new(shortest, longest).check("wavelength", value)?;
        }
        let at = |wavelength: T| self.samples.interpolate(wavelength.into());
        Ok(RefractiveIndex {
            eta: wavelength.map(|wavelength| T::lit(at(wavelength).eta)),
            k: wavelength.map(|wavelength| T::lit(at(wavelength).k)),
        })
    }

    /// Fresnel's reflectance of the material in air at a wavelength in nanometres, or at several:
    /// one for each channel of a colour.
    ///
    /// Three wavelengths as red, green and blue are a shortcut; [`Observer`](crate::Observer) has
    /// the exact colour and the error of the shortcut.
    ///
    /// # Errors
    /// If a wavelength is not in [`range`](Self::range).
    pub fn conductor<T, C>(&self, wavelength: C) -> Result<Conductor<C>, ParameterError>
    where
        T: Real + Into<f64>,
        C: Color<T>,
    {
        let RefractiveIndex { eta, k } = self.refractive_index(wavelength)?;
        Conductor::new(eta, k)
    }

    /// Fresnel's reflectance of a transparent material in air at a wavelength in nanometres, or at
    /// several: one for each channel of a colour. What k does to the reflectance, less than
    /// 10⁻⁷ in all these sets, is left out.
    ///
    /// ```
    /// use brdf::Fresnel;
    /// use brdf::materials::{GOLD, find};
    ///
    /// let glass = find("N-BK7")?.dielectric(587.6_f64)?;
    /// assert!((glass.reflectance(1.0) - 0.04216).abs() < 1e-5);
    /// assert_eq!(GOLD.dielectric(700.0_f64).unwrap_err().parameter(), "k");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If a wavelength is not in [`range`](Self::range), or k is above 10⁻³ there.
    pub fn dielectric<T, C>(&self, wavelength: C) -> Result<Dielectric<C>, ParameterError>
    where
        T: Real + Into<f64>,
        C: Color<T>,
    {
        let RefractiveIndex { eta, k } = self.refractive_index(wavelength)?;
        Range::new(0.0, 1e-3).check("k", k)?;
        Dielectric::new(eta)
    }
}

impl fmt::Debug for Material {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Material({})", self.key)
    }
}

impl fmt::Display for Material {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name)
    }
}
