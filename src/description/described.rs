//! The descriptions themselves.

use alloc::vec::Vec;
use core::cell::RefCell;
use core::marker::PhantomData;

use super::brdf::brdf;
use super::bsdf::bsdf;
use super::build::Build;
use super::channels::Channels;
use super::distribution::distribution;
use super::error::{DescriptionError, Problem};
use super::fresnel::fresnel;
use super::numbers::{Number, visit_numbers};
use super::path::Path;
use super::read::read;
use super::value::Described;
use crate::any::AnyBrdf;
use crate::distribution::AnyDistribution;
use crate::error::{ParameterError, range};
use crate::fresnel::AnyFresnel;
use crate::interface::AnyBsdf;
use crate::parameter::Part;
use crate::real::{Real, Spectrum};

/// Declares the description of a part: what is read and written as data, and what builds it.
macro_rules! description {
    (
        $(#[$doc:meta])*
        pub struct $name:ident: $part:ident => $any:ident<T $(, $color:ident)?> by $build:ident;
    ) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name(Described);

        impl $name {
            /// What is described, in a number of choice.
            ///
            /// # Errors
            /// If a value is not in its range in this number: reading has checked it in `f64`.
            pub fn build<T: Real>(&self) -> Result<$any<T>, DescriptionError> {
                self.build_with(|_, value| T::lit(value))
            }

            /// What is described, of numbers that are made of the values and their places: symbols,
            /// numbers with derivatives, or other values for some of them.
            ///
            /// Every number comes by, also a default and each channel of a colour in a list; one
            /// for all channels comes once. The indices of a metal are no numbers of a description,
            /// and a Schlick term whose `f90` and `exponent` are the defaults has neither.
            ///
            /// ```
            /// use brdf::Brdf;
            /// use brdf::description::BrdfDescription;
            /// use glam::DVec3;
            ///
            /// let text = r#"{"oren_nayar": {"albedo": [0.8, 0.4, 0.2], "sigma": 0.1}}"#;
            /// let plaster: BrdfDescription = serde_json::from_str(text)?;
            /// let mut places = Vec::new();
            /// let rougher = plaster.build_with(|path, value| {
            ///     places.push(path.to_string());
            ///     if path.to_string() == "oren_nayar.sigma" { 0.3 } else { value }
            /// })?;
            /// assert_eq!(places[2..], ["oren_nayar.albedo[2]", "oren_nayar.sigma"]);
            ///
            /// let text = r#"{"oren_nayar": {"albedo": [0.8, 0.4, 0.2], "sigma": 0.3}}"#;
            /// let described = serde_json::from_str::<BrdfDescription>(text)?.build()?;
            /// assert_eq!(rougher.eval(DVec3::Z, DVec3::Z), described.eval(DVec3::Z, DVec3::Z));
            /// # Ok::<(), Box<dyn std::error::Error>>(())
            /// ```
            ///
            /// # Errors
            /// If a number is not in the range of its parameter.
            pub fn build_with<T: Real>(
                &self,
                number: impl FnMut(&Path<'_>, f64) -> T,
            ) -> Result<$any<T>, DescriptionError> {
                let number = RefCell::new(number);
                let number = |path: &Path<'_>, value| (number.borrow_mut())(path, value);
                let path = Path::ROOT;
                $build(&Build::<T, T::Vec3> {
                    described: &self.0,
                    path: path.key(self.0.form.name()),
                    number: &number,
                    channels: Channels::Rgb,
                    color: PhantomData,
                })
            }

            $(description! { @spectrum $color $any $build })?
        }

        impl $name {
            /// All numbers, in the order in which they stand.
            #[must_use]
            pub fn numbers(&self) -> Vec<Number> {
                let (mut described, mut numbers) = (self.0.clone(), Vec::new());
                let path = Path::ROOT.key(described.form.name());
                visit_numbers(&mut described, &path, &mut |path, value, domain| {
                    numbers.push(Number::new(path, *value, domain));
                });
                numbers
            }

            /// The same description of other numbers, made of the places and values of these.
            ///
            /// # Errors
            /// If a number is not in its range.
            pub fn with_numbers(
                &self,
                mut change: impl FnMut(&Path<'_>, f64) -> f64,
            ) -> Result<Self, DescriptionError> {
                let mut described = self.0.clone();
                let path = Path::ROOT.key(described.form.name());
                visit_numbers(&mut described, &path, &mut |path, value, _| {
                    *value = change(path, *value);
                });
                let changed = Self(described);
                changed.build::<f64>()?;
                Ok(changed)
            }
        }

        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
                self.0.serialize(to)
            }
        }

        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                read(Part::$part, from).map(Self)
            }
        }
    };
    (@spectrum $color:ident $any:ident $build:ident) => {
        /// What is described, at wavelengths of choice in nanometres, one for each channel.
        ///
        /// Materials, samples, stacks and models of waves have the index and the phases of each of these
        /// wavelengths. A `wavelength` in the description, of a stack, of `beckmann_kirchhoff_1963` or of
        /// `he_1991`, counts for nothing, but that in a stack the three numbers of an index stand at its three
        /// wavelengths. Every other colour `[r, g, b]` is a spectrum of straight lines between its values at 650, 550 and 450 nm,
        /// constant beyond them. At these three wavelengths the answers are those of
        /// [`build`](Self::build), whatever other wavelengths are asked for. The tint of `disney_2012` is the base
        /// colour over the luminance of its red, green and blue at all wavelengths. An interface that refracts has one direction for all channels, that
        /// of the middle one: where colours part, as in a prism, build one wavelength at a time.
        ///
        /// ```
        /// use brdf::colorimetry::WAVELENGTHS;
        /// use brdf::description::FresnelDescription;
        /// use brdf::{Fresnel, Illuminant, Observer};
        /// use glam::DVec3;
        ///
        /// let gold: FresnelDescription = serde_json::from_str(r#"{"metal": "Au"}"#)?;
        /// let gold = gold.build_spectrum::<f64, 81>(&WAVELENGTHS)?;
        /// let observer = Observer::new(Illuminant::D65, WAVELENGTHS)?;
        /// let color = observer.linear_srgb(gold.reflectance(1.0));
        /// assert!(color.abs_diff_eq(DVec3::new(1.037621, 0.728354, 0.364500), 1e-6));
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        ///
        /// # Errors
        /// If a wavelength is not in 1 … 10⁹ or not in the range of a material, a value is not in its
        /// range in this number, or a term is the colour of a whole spectrum itself (`belcour_barla`).
        pub fn build_spectrum<T: Real, const N: usize>(
            &self,
            wavelengths: &[f64; N],
        ) -> Result<$any<T, Spectrum<T, N>>, DescriptionError> {
            let path = Path::ROOT;
            ParameterError::check_each("wavelength", range::WAVELENGTH, wavelengths).map_err(
                |error| {
                    let list = path.key("wavelength");
                    let place = list.index(error.position().unwrap_or_default());
                    place.error(Problem::Parameter(error))
                },
            )?;
            $build(&Build::<T, Spectrum<T, N>> {
                described: &self.0,
                path: path.key(self.0.form.name()),
                number: &|_, value| T::lit(value),
                channels: Channels::Wavelengths(wavelengths),
                color: PhantomData,
            })
        }
    };
}

description! {
    /// A model of reflection. The keys are the parameters of the type with the same name.
    ///
    /// ```
    /// use brdf::Brdf;
    /// use brdf::description::BrdfDescription;
    /// use glam::Vec3;
    ///
    /// let plastic: BrdfDescription = serde_json::from_str(r#"{"sum": [
    ///     {"weight": 0.9, "brdf": {"lambert": {"albedo": [0.8, 0.2, 0.1]}}},
    ///     {"weight": 0.1, "brdf": {"phong": {"specular": 1, "exponent": 40}}}
    /// ]}"#)?;
    /// let plastic = plastic.build::<f32>()?;
    /// assert!((plastic.albedo(Vec3::Z).x - 0.82).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub struct BrdfDescription: Brdf => AnyBrdf<T, C> by brdf;
}

description! {
    /// A model over the whole sphere of directions: every model of reflection, and those that have
    /// specular lobes or transmit. The keys are the parameters of the type with the same name.
    ///
    /// ```
    /// use brdf::description::BsdfDescription;
    /// use brdf::{Bsdf, TransportMode};
    /// use glam::DVec3;
    ///
    /// let text = r#"{"rough_dielectric": {"distribution": {"ggx": {"roughness": 0.3}}, "ior": 1.5}}"#;
    /// let frosted: BsdfDescription = serde_json::from_str(text)?;
    /// let f = frosted.build::<f64>()?.eval(-DVec3::Z, DVec3::Z, TransportMode::Radiance);
    /// assert!((f.x - 13.581221810508403).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub struct BsdfDescription: Bsdf => AnyBsdf<T, C> by bsdf;
}

description! {
    /// A Fresnel term. The keys are the parameters of the type with the same name. A metal is one of
    /// the measured sets, by its symbol or name; `Ta` and `Zn` are accepted although their sets are
    /// not for colour.
    ///
    /// ```
    /// use brdf::Fresnel;
    /// use brdf::description::FresnelDescription;
    ///
    /// let glass: FresnelDescription = serde_json::from_str(r#"{"dielectric": {"ior": 1.5}}"#)?;
    /// let glass = glass.build::<f64>()?;
    /// assert!((glass.reflectance(1.0).x - 0.04).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub struct FresnelDescription: Fresnel => AnyFresnel<T, C> by fresnel;
}

description! {
    /// A distribution of facet normals. The keys are the parameters of the type with the same name.
    ///
    /// ```
    /// use brdf::Distribution;
    /// use brdf::description::DistributionDescription;
    /// use glam::DVec3;
    ///
    /// let text = r#"{"beckmann": {"roughness": [0.2, 0.5]}}"#;
    /// let brushed: DistributionDescription = serde_json::from_str(text)?;
    /// let density = brushed.build::<f64>()?.density(DVec3::Z);
    /// assert!((density - 1.0 / (std::f64::consts::PI * 0.2 * 0.5)).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub struct DistributionDescription: Distribution => AnyDistribution<T> by distribution;
}
