//! n and k over the wavelength.

use alloc::boxed::Box;
use core::ops::RangeInclusive;

#[cfg(feature = "materials")]
use super::packed::{self, Packed};
use super::text::{self, TextError};
use crate::error::{ParameterError, Range, range};
use crate::fresnel::{Conductor, Dielectric};
use crate::real::{Color, Real};

/// A complex refractive index n + ik, or the indices of several wavelengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefractiveIndex<C = f64> {
    /// Real part n.
    pub eta: C,
    /// Imaginary part k, the extinction coefficient, zero or positive.
    pub k: C,
}

impl<C> RefractiveIndex<C> {
    /// The index relative to a transparent medium of index `outside`, (n + ik)/n₀: what
    /// [`Conductor`] and [`Dielectric`] take where the light does not arrive through air.
    ///
    /// # Errors
    /// If `outside` is not in 10⁻⁴ … 10⁴.
    pub fn relative_to<T>(self, outside: C) -> Result<Self, ParameterError>
    where
        T: Real,
        C: Color<T>,
    {
        range::ETA.check("outside", outside)?;
        Ok(self.over(outside))
    }

    /// The same for an index outside that is in its range.
    pub(crate) fn over<T>(self, outside: C) -> Self
    where
        T: Real,
        C: Color<T>,
    {
        let over = |part: C| part.zip(outside, |part, outside| part / outside);
        Self { eta: over(self.eta), k: over(self.k) }
    }
}

/// The index at one wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Wavelength in nanometres.
    pub wavelength: f64,
    /// Index there.
    pub index: RefractiveIndex,
}

impl Sample {
    /// n + ik at a wavelength in nanometres.
    #[must_use]
    pub const fn new(wavelength: f64, eta: f64, k: f64) -> Self {
        Self { wavelength, index: RefractiveIndex { eta, k } }
    }
}

/// The optical constants n and k of a medium over the wavelength: samples with straight lines between
/// them.
///
/// Every built-in `Material` is one, with a name and a source, and hands out these methods;
/// what takes `&OpticalConstants` takes `&GOLD` too.
///
/// # Definition
/// ```text
/// n(λ) = (1 − t) n_j + t n_{j+1}    k(λ) likewise    t = (λ − λ_j)/(λ_{j+1} − λ_j)    λ_j ≤ λ ≤ λ_{j+1}
/// ```
///
/// | symbol | meaning | range |
/// |---|---|---|
/// | λ_j | wavelength of a sample, nm | 1 … 10⁹, each above the one before it |
/// | n_j | real part of the index | 10⁻⁴ … 10⁴ |
/// | k_j | imaginary part, the extinction coefficient; k ≥ 0 absorbs | 0 … 10⁴ |
///
/// There are at least two samples. Beyond the first and the last nothing is known, and nothing is
/// extrapolated.
///
/// ```
/// use brdf::Fresnel;
/// use brdf::materials::{OpticalConstants, Sample};
///
/// let alloy = OpticalConstants::new([
///     Sample::new(450.0, 1.4, 1.9),
///     Sample::new(550.0, 0.4, 2.4),
///     Sample::new(650.0, 0.2, 3.6),
/// ])?;
/// let index = alloy.refractive_index(600.0_f64)?;
/// assert!((index.eta - 0.3).abs() < 1e-15 && (index.k - 3.0).abs() < 1e-15);
/// let red = alloy.conductor(650.0_f64)?.reflectance(1.0);
/// assert!((red - 0.944444).abs() < 1e-6);
///
/// let error = OpticalConstants::new([Sample::new(450.0, 1.4, 1.9), Sample::new(450.0, 0.4, 2.4)]);
/// assert_eq!(
///     error.unwrap_err().to_string(),
///     "wavelength[1] must be above 450, the one before it, not 450"
/// );
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[doc(alias("n and k", "nk", "IOR", "refractive index", "dispersion"))]
#[derive(Clone, Debug, PartialEq)]
pub struct OpticalConstants(Store);

/// Where the samples are.
#[derive(Clone)]
enum Store {
    /// In a static of the crate.
    #[cfg(feature = "materials")]
    Packed(&'static [Packed]),
    Own(Box<[Sample]>),
}

impl core::fmt::Debug for Store {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_list().entries((0..self.len()).map(|place| self.sample(place))).finish()
    }
}

impl PartialEq for Store {
    fn eq(&self, other: &Self) -> bool {
        self.len() == other.len()
            && (0..self.len()).all(|place| self.sample(place) == other.sample(place))
    }
}

impl Store {
    fn len(&self) -> usize {
        match self {
            #[cfg(feature = "materials")]
            Self::Packed(samples) => samples.len(),
            Self::Own(samples) => samples.len(),
        }
    }

    /// The sample at a place that there is.
    fn sample(&self, place: usize) -> Sample {
        match self {
            #[cfg(feature = "materials")]
            Self::Packed(samples) => packed::sample(&samples[place]),
            Self::Own(samples) => samples[place],
        }
    }

    /// How many samples lie at a wavelength or below it.
    fn below(&self, at: f64) -> usize {
        match self {
            #[cfg(feature = "materials")]
            Self::Packed(samples) => {
                samples.partition_point(|bytes| packed::wavelength(bytes) <= at)
            }
            Self::Own(samples) => samples.partition_point(|sample| sample.wavelength <= at),
        }
    }
}

impl OpticalConstants {
    /// Samples in the order of their wavelengths.
    ///
    /// # Errors
    /// If there are fewer than two samples, a wavelength is not in 1 … 10⁹ nm or not above the one
    /// before it, n is not in 10⁻⁴ … 10⁴ or k not in 0 … 10⁴. The error of a sample has its
    /// [position](ParameterError::position).
    pub fn new(samples: impl IntoIterator<Item = Sample>) -> Result<Self, ParameterError> {
        let samples: Box<[Sample]> = samples.into_iter().collect();
        Range::new(2.0, f64::INFINITY).check("number of samples", samples.len() as f64)?;
        let column = |part: fn(&Sample) -> f64| samples.iter().map(part).collect::<Box<[f64]>>();
        ParameterError::check_ascending(
            "wavelength",
            range::WAVELENGTH,
            &column(|sample| sample.wavelength),
        )?;
        ParameterError::check_each("eta", range::ETA, &column(|sample| sample.index.eta))?;
        ParameterError::check_each("k", range::K, &column(|sample| sample.index.k))?;
        Ok(Self(Store::Own(samples)))
    }

    /// Samples from text with commas: `#` begins a line of remarks, the first other line is the header
    /// `wavelength_nm,n,k`, and each that follows has a wavelength in nanometres, n and k. Empty lines
    /// count for nothing.
    ///
    /// ```
    /// use brdf::materials::OpticalConstants;
    ///
    /// let text = "# Gold, evaporated\nwavelength_nm,n,k\n450,1.4,1.9\n550,0.4,2.4\n650,0.2,\n";
    /// let error = OpticalConstants::from_csv(text).unwrap_err();
    /// assert_eq!(error.to_string(), "line 5: \"\" is not a number");
    /// let gold = OpticalConstants::from_csv(&(text.replace(",\n", ",3.6\n")))?;
    /// assert_eq!(gold.range(), 450.0..=650.0);
    /// # Ok::<(), brdf::materials::TextError>(())
    /// ```
    ///
    /// # Errors
    /// If the text is not so, or [`new`](Self::new) refuses the samples; with the number of the line.
    pub fn from_csv(text: &str) -> Result<Self, TextError> {
        text::csv(text)
    }

    /// Samples from the text of a record of the refractiveindex.info database, in YAML: the tables
    /// under its key `DATA`. Wavelengths are in micrometres there.
    ///
    /// There is one table of n and k together, `tabulated nk`, or one of n, `tabulated n`, perhaps with
    /// one of k, `tabulated k`. Without k it is 0. Two tables are joined over the wavelengths that both
    /// cover, with a sample where either has one.
    ///
    /// Other keys (references, comments, conditions) are passed over. Of YAML only the layout that the
    /// database has is read: a list of types, the numbers of each in a block behind `data: |`, one
    /// sample a line.
    ///
    /// ```
    /// use brdf::materials::OpticalConstants;
    ///
    /// let gold = OpticalConstants::from_refractiveindex_info(
    ///     "REFERENCES: \"Johnson, Christy 1972\"
    /// DATA:
    ///   - type: tabulated nk
    ///     data: |
    ///         0.4509 1.38 1.914
    ///         0.5486 0.43 2.455
    ///         0.6595 0.14 3.697
    /// ",
    /// )?;
    /// assert_eq!(gold.range(), 450.9..=659.5);
    /// # Ok::<(), brdf::materials::TextError>(())
    /// ```
    ///
    /// # Errors
    /// If there is no such table, a dispersion formula in its place, or [`new`](Self::new) refuses the
    /// samples; with the number of the line.
    pub fn from_refractiveindex_info(text: &str) -> Result<Self, TextError> {
        text::refractiveindex_info(text)
    }

    /// Samples that are known to be good.
    #[cfg(feature = "materials")]
    pub(super) const fn packed(bytes: &'static [u8]) -> Self {
        Self(Store::Packed(bytes.as_chunks().0))
    }

    /// The wavelengths in nanometres between which the index is known.
    #[must_use]
    pub fn range(&self) -> RangeInclusive<f64> {
        let wavelength = |place| self.0.sample(place).wavelength;
        wavelength(0)..=wavelength(self.0.len() - 1)
    }

    /// The samples, by increasing wavelength.
    pub fn samples(&self) -> impl ExactSizeIterator<Item = Sample> + DoubleEndedIterator {
        (0..self.0.len()).map(|place| self.0.sample(place))
    }

    /// The index at a wavelength in the range.
    fn interpolate(&self, at: f64) -> RefractiveIndex {
        // An end of the range rounded to single precision may lie just outside.
        let range = self.range();
        let at = at.max(*range.start()).min(*range.end());
        // The last sample has no successor: it is the upper end of the last interval.
        let upper = self.0.below(at).min(self.0.len() - 1);
        let (below, above) = (self.0.sample(upper - 1), self.0.sample(upper));
        let ends = [below.wavelength, above.wavelength];
        RefractiveIndex {
            eta: line(at, ends, [below.index.eta, above.index.eta]),
            k: line(at, ends, [below.index.k, above.index.k]),
        }
    }

    /// The index at a wavelength in nanometres, or at several: one for each channel of a colour.
    /// Between samples n and k are interpolated linearly in the wavelength.
    ///
    /// ```
    /// # #[cfg(feature = "materials")] {
    /// use brdf::Spectrum;
    /// use brdf::materials::SILICON;
    ///
    /// let red = SILICON.refractive_index(658.0_f64)?;
    /// assert!((red.eta - 3.8393).abs() < 1e-4 && (red.k - 0.01555).abs() < 1e-5);
    /// let lines = SILICON.refractive_index(Spectrum([488.0_f32, 658.0]))?;
    /// assert!((lines.eta.0[1] - 3.8393).abs() < 1e-4);
    /// // A hair beyond the end of the range, 826.6 nm.
    /// SILICON.refractive_index(295.2 + 100.0 * ((826.6 - 295.2) / 100.0))?;
    /// # }
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
        let (shortest, longest) = self.range().into_inner();
        // What leaves the range by the rounding of a product or of a sum counts as its end.
        let rounding = 4.0 * T::SPACING;
        if let Some(value) =
            wavelength.outside(shortest * (1.0 - rounding), longest * (1.0 + rounding))
        {
            Range::new(shortest, longest).check("wavelength", value)?;
        }
        let at = |wavelength: T| self.interpolate(wavelength.into());
        Ok(RefractiveIndex {
            eta: wavelength.map(|wavelength| T::lit(at(wavelength).eta)),
            k: wavelength.map(|wavelength| T::lit(at(wavelength).k)),
        })
    }

    /// Fresnel's reflectance of the medium in air at a wavelength in nanometres, or at several:
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

    /// Fresnel's reflectance of the medium under a transparent one of index `outside`: gold under
    /// water, silver under a coat. The angle of incidence is that in the medium outside.
    ///
    /// ```
    /// # #[cfg(feature = "materials")] {
    /// use brdf::Fresnel;
    /// use brdf::materials::{GOLD, WATER_HALE_QUERRY_1973};
    ///
    /// let water = WATER_HALE_QUERRY_1973.refractive_index(550.0_f64)?.eta;
    /// let [dry, wet] = [GOLD.conductor(550.0)?, GOLD.conductor_in(water, 550.0)?];
    /// assert!((dry.reflectance(1.0) - 0.791553).abs() < 1e-6);
    /// assert!((wet.reflectance(1.0) - 0.754141).abs() < 1e-6);
    /// # }
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// If a wavelength is not in [`range`](Self::range), `outside` not in 10⁻⁴ … 10⁴, or the index
    /// relative to it not in the range of [`Conductor`].
    pub fn conductor_in<T, C>(
        &self,
        outside: C,
        wavelength: C,
    ) -> Result<Conductor<C>, ParameterError>
    where
        T: Real + Into<f64>,
        C: Color<T>,
    {
        let RefractiveIndex { eta, k } = self.refractive_index(wavelength)?.relative_to(outside)?;
        Conductor::new(eta, k)
    }

    /// Fresnel's reflectance of a transparent medium in air at a wavelength in nanometres, or at
    /// several: one for each channel of a colour. What k does to the reflectance, less than
    /// 10⁻⁷ in all built-in sets, is left out.
    ///
    /// ```
    /// # #[cfg(feature = "materials")] {
    /// use brdf::Fresnel;
    /// use brdf::materials::{GOLD, N_BK7_GLASS_SCHOTT};
    ///
    /// let glass = N_BK7_GLASS_SCHOTT.dielectric(587.6_f64)?;
    /// assert!((glass.reflectance(1.0) - 0.04216).abs() < 1e-5);
    /// assert_eq!(GOLD.dielectric(700.0_f64).unwrap_err().parameter(), "k");
    /// # }
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// If a wavelength is not in [`range`](Self::range), or k is above 10⁻³ there.
    pub fn dielectric<T, C>(&self, wavelength: C) -> Result<Dielectric<C>, ParameterError>
    where
        T: Real + Into<f64>,
        C: Color<T>,
    {
        Dielectric::new(self.transparent(wavelength)?.eta)
    }

    /// Fresnel's reflectance of a transparent medium under another one of index `outside`: glass under
    /// water.
    ///
    /// # Errors
    /// As of [`dielectric`](Self::dielectric), or if `outside` is not in 10⁻⁴ … 10⁴, or the index
    /// relative to it not in the range of [`Dielectric`].
    pub fn dielectric_in<T, C>(
        &self,
        outside: C,
        wavelength: C,
    ) -> Result<Dielectric<C>, ParameterError>
    where
        T: Real + Into<f64>,
        C: Color<T>,
    {
        Dielectric::new(self.transparent(wavelength)?.relative_to(outside)?.eta)
    }

    /// The index, if it absorbs so little that n alone will do.
    pub(crate) fn transparent<T, C>(
        &self,
        wavelength: C,
    ) -> Result<RefractiveIndex<C>, ParameterError>
    where
        T: Real + Into<f64>,
        C: Color<T>,
    {
        let index = self.refractive_index(wavelength)?;
        Range::new(0.0, 1e-3).check("k", index.k)?;
        Ok(index)
    }
}

/// The value at a place on the straight line between two.
pub(super) fn line(at: f64, [start, end]: [f64; 2], [first, last]: [f64; 2]) -> f64 {
    let part = (at - start) / (end - start);
    first * (1.0 - part) + last * part
}
