//! Fresnel terms.

use alloc::string::String;

use super::error::{DescriptionError, Problem};
use super::form::{entrance, forms};
use super::place::{Place, Record};
use super::value::{ColorDescription, IndexDescription, colored};
use crate::fresnel::{AnyFresnel, Conductor, Constant, Cook, Dielectric, Hall, Schlick};
use crate::real::Real;

forms! {
    /// A Fresnel term. The keys are the parameters of the type with the same name.
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
    pub enum FresnelDescription as "a Fresnel term, such as {\"schlick\": {\"f0\": 0.04}}" {
        /// [`Constant`]: the same at all angles.
        "constant" => Constant(ColorDescription),
        /// [`Dielectric`].
        "dielectric" => Dielectric {
            /// Relative index, transmitted over incident; below 1 is from inside.
            ior: ColorDescription,
        },
        /// [`Conductor`].
        "conductor" => Conductor {
            /// Real part of the index.
            eta: ColorDescription,
            /// Imaginary part of the index.
            k: ColorDescription,
        },
        /// A metal, alloy or semiconductor by its symbol or name: its measured index at 650, 550
        /// and 450 nm. It needs the feature `materials`. `Ta` and `Zn` are accepted although their
        /// sets are not for colour (`materials::Kind::Caution`).
        "metal" => Metal(String),
        /// [`Schlick`].
        "schlick" => Schlick {
            /// Reflectance at normal incidence.
            f0: ColorDescription,
        },
        /// [`Hall`], driven by a dielectric or a conductor.
        "hall" => Hall {
            /// Reflectance at normal incidence.
            f0: ColorDescription,
            /// Index whose exact curve drives the interpolation, 1.5 if absent.
            ior: IndexDescription = IndexDescription::Real(1.5),
        },
        /// [`Cook`], driven by a dielectric or a conductor.
        "cook" => Cook {
            /// Reflectance at normal incidence.
            f0: ColorDescription,
            /// Colour of the light.
            light: ColorDescription,
            /// Index whose exact curve drives the interpolation, 1.5 if absent.
            ior: IndexDescription = IndexDescription::Real(1.5),
        },
    }
}
entrance!(FresnelDescription);

impl FresnelDescription {
    /// The Fresnel term in a number of choice.
    ///
    /// # Errors
    /// If a value is outside its range or the metal is not known.
    pub fn build<T: Real>(&self) -> Result<AnyFresnel<T>, DescriptionError> {
        self.checked(&Place::root(&Record::default()))
    }

    pub(super) fn checked<T: Real>(
        &self,
        place: &Place<'_>,
    ) -> Result<AnyFresnel<T>, DescriptionError> {
        Ok(match self {
            Self::Constant(reflectance) => {
                let built = Constant::new(reflectance.color::<T>());
                let place = place.key("constant");
                AnyFresnel::from(reflectance.parameter::<T, _>(&place, built)?)
            }
            Self::Dielectric { ior } => {
                let built = Dielectric::new(ior.color::<T>());
                let (place, colors) = (place.key("dielectric"), [("ior", *ior)]);
                AnyFresnel::from(colored::<T, _>(&place, &colors, built)?)
            }
            Self::Conductor { eta, k } => {
                let built = Conductor::new(eta.color::<T>(), k.color::<T>());
                let (place, colors) = (place.key("conductor"), [("eta", *eta), ("k", *k)]);
                AnyFresnel::from(colored::<T, _>(&place, &colors, built)?)
            }
            Self::Metal(name) => {
                let place = place.key("metal");
                AnyFresnel::from(metal::<T>(name).map_err(|problem| place.error(problem))?)
            }
            Self::Schlick { f0 } => {
                let built = Schlick::new(f0.color::<T>());
                let (place, colors) = (place.key("schlick"), [("f0", *f0)]);
                AnyFresnel::from(colored::<T, _>(&place, &colors, built)?)
            }
            Self::Hall { f0, ior } => {
                let (place, colors) = (place.key("hall"), [("f0", *f0)]);
                let f0 = f0.color::<T>();
                match *ior {
                    IndexDescription::Real(ior) => {
                        let built = Hall::new(f0, T::lit(ior));
                        AnyFresnel::from(colored::<T, _>(&place, &colors, built)?)
                    }
                    IndexDescription::Complex(ior) => {
                        let built = Hall::with_reference(f0, conductor(ior, &place)?);
                        AnyFresnel::from(colored::<T, _>(&place, &colors, built)?)
                    }
                }
            }
            Self::Cook { f0, light, ior } => {
                let (place, colors) = (place.key("cook"), [("f0", *f0), ("light", *light)]);
                let (f0, light) = (f0.color::<T>(), light.color::<T>());
                match *ior {
                    IndexDescription::Real(ior) => {
                        let built = Cook::new(f0, light, T::lit(ior));
                        AnyFresnel::from(colored::<T, _>(&place, &colors, built)?)
                    }
                    IndexDescription::Complex(ior) => {
                        let built = Cook::with_reference(f0, light, conductor(ior, &place)?);
                        AnyFresnel::from(colored::<T, _>(&place, &colors, built)?)
                    }
                }
            }
        })
    }
}

/// The conductor whose index is the key `ior` of the place.
fn conductor<T: Real>(
    [eta, k]: [f64; 2],
    place: &Place<'_>,
) -> Result<Conductor<T>, DescriptionError> {
    let built = Conductor::new(T::lit(eta), T::lit(k));
    let index = match &built {
        Err(error) if error.parameter() == "k" => 1,
        _ => 0,
    };
    place.key("ior").index(index).parameter(built)
}

#[cfg(feature = "materials")]
fn metal<T: Real>(name: &str) -> Result<Conductor<T::Vec3>, Problem> {
    use alloc::format;
    use alloc::string::ToString;

    use super::parse::beginning;
    use crate::materials::{Kind, LookupError, find};
    use crate::real::Vector;

    let material = find(name).map_err(|error| {
        let error = match error {
            LookupError::Unknown { name, nearest } => {
                LookupError::Unknown { name: beginning(&name), nearest }
            }
            ambiguous => ambiguous,
        };
        Problem::Metal(error.to_string())
    })?;
    if material.kind() == Kind::Dielectric {
        return Err(Problem::Metal(format!(
            "{} is no metal; describe it as a dielectric by its index",
            material.key()
        )));
    }
    let index = material.refractive_index(glam::DVec3::new(650.0, 550.0, 450.0));
    let index = index.map_err(|error| Problem::Metal(error.to_string()))?;
    let lit = |value: glam::DVec3| -> T::Vec3 {
        Vector::new(T::lit(value.x), T::lit(value.y), T::lit(value.z))
    };
    Conductor::new(lit(index.eta), lit(index.k)).map_err(|error| Problem::Metal(error.to_string()))
}

#[cfg(not(feature = "materials"))]
fn metal<T: Real>(_: &str) -> Result<Conductor<T::Vec3>, Problem> {
    Err(Problem::Metal("metals by name need the feature `materials`".into()))
}

#[cfg(all(test, not(feature = "materials")))]
mod tests {
    use super::*;

    #[test]
    fn metals_need_their_feature() {
        let error = FresnelDescription::Metal("Au".into()).build::<f32>().err();
        assert_eq!(
            error.map(|error| alloc::string::ToString::to_string(&error)).as_deref(),
            Some("metal: metals by name need the feature `materials`")
        );
    }
}
