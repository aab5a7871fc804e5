//! Models of reflection.

use alloc::vec::Vec;

use super::distribution::DistributionDescription;
use super::error::{DescriptionError, Problem};
use super::form::{entrance, forms, part, words};
use super::fresnel::FresnelDescription;
use super::place::{Place, Record};
use super::value::{ColorDescription, RoughnessDescription, colored};
use crate::any::AnyBrdf;
use crate::diffuse::{Lambert, OrenNayar};
use crate::distribution::{Beckmann, Blinn1977};
use crate::error::range;
use crate::glossy::{BlinnPhong, ClassicPhong, Phong, SchlickPower};
use crate::microfacet::{AnyShadowing, Blinn1977Printed, CookTorrance, CookTorrance1982Printed};
use crate::real::Real;
use crate::sum::WeightedSum;

forms! {
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
    pub enum BrdfDescription as "a model, such as {\"lambert\": {\"albedo\": 0.5}}" {
        /// [`Lambert`].
        "lambert" => Lambert {
            /// Fraction of the light that is reflected.
            albedo: ColorDescription,
        },
        /// [`OrenNayar`].
        "oren_nayar" => OrenNayar {
            /// Fraction of the light that a facet reflects.
            albedo: ColorDescription,
            /// Standard deviation of the tilt of the facets in radians.
            sigma: f64,
            /// [`OrenNayar::with_interreflection`], false if absent.
            interreflection: bool = false,
        },
        /// [`Phong`].
        "phong" => Phong {
            /// Directional albedo at normal incidence.
            specular: ColorDescription,
            /// Sharpness of the lobe.
            exponent: f64,
            /// False for [`ClassicPhong`], true if absent.
            normalized: bool = true,
        },
        /// [`BlinnPhong`].
        "blinn_phong" => BlinnPhong {
            /// Directional albedo at normal incidence.
            specular: ColorDescription,
            /// Sharpness of the lobe.
            exponent: f64,
            /// False for [`BlinnPhong::unnormalized`], true if absent.
            normalized: bool = true,
        },
        /// [`SchlickPower`].
        "schlick_power" => SchlickPower {
            /// Directional albedo at normal incidence.
            specular: ColorDescription,
            /// Sharpness of the lobe.
            exponent: f64,
            /// False for [`SchlickPower::unnormalized`], true if absent.
            normalized: bool = true,
        },
        /// [`CookTorrance`].
        "cook_torrance" => CookTorrance {
            /// D.
            distribution: DistributionDescription,
            /// F.
            fresnel: FresnelDescription,
            /// G, V-cavities if absent.
            shadowing: ShadowingDescription = ShadowingDescription::VCavity,
        },
        /// [`CookTorrance::torrance_sparrow_1967`].
        "torrance_sparrow_1967" => TorranceSparrow1967 {
            /// Sharpness of the distribution in 1/degree.
            c: f64,
            /// F.
            fresnel: FresnelDescription,
        },
        /// [`CookTorrance1982Printed`](crate::CookTorrance1982Printed).
        "cook_torrance_1982_printed" => CookTorrance1982Printed {
            /// Roughness of Beckmann's distribution.
            roughness: RoughnessDescription,
            /// F.
            fresnel: FresnelDescription,
        },
        /// [`Blinn1977Printed`].
        "blinn_1977_printed" => Blinn1977Printed {
            /// Which of Blinn's distributions.
            distribution: Blinn1977Description,
            /// Half-width angle in radians.
            beta: f64,
            /// F.
            fresnel: FresnelDescription,
        },
        /// [`WeightedSum`].
        "sum" => Sum(Vec<WeightedBrdf>),
    }
}
entrance!(BrdfDescription);

part! {
    /// A term of a sum. It is read as a part of a description only, whose errors name its place.
    pub struct WeightedBrdf {
        /// Weight, per channel.
        pub weight: ColorDescription,
        /// The model.
        pub brdf: BrdfDescription,
    }
}

words! {
    /// Shadowing and masking.
    pub enum ShadowingDescription {
        /// [`VCavity`](crate::VCavity).
        "v_cavity" => VCavity,
        /// [`SmithCorrelated`](crate::SmithCorrelated), for Beckmann, GGX and mixtures of them.
        "smith" => Smith,
        /// [`SmithSeparable`](crate::SmithSeparable), for the same.
        "smith_separable" => SmithSeparable,
    }
}

words! {
    /// Which distribution of [`Blinn1977`].
    pub enum Blinn1977Description {
        /// Phong's power of the cosine.
        "d1" => D1,
        /// Torrance and Sparrow's normal distribution of the angle.
        "d2" => D2,
        /// Trowbridge and Reitz's ellipsoids.
        "d3" => D3,
    }
}

impl BrdfDescription {
    /// The model in a number of choice.
    ///
    /// A call of the model costs one dispatch; distribution, Fresnel term and shadowing are known
    /// to the compiler behind it. The terms of a sum are models of their own, with one dispatch
    /// each.
    ///
    /// # Errors
    /// If a value is outside its range, a metal is not known, Smith's shadowing is asked for a
    /// distribution that does not have it, or sums and mixtures are too deep or too long.
    pub fn build<T: Real>(&self) -> Result<AnyBrdf<T>, DescriptionError> {
        self.checked(&Place::root(&Record::default()))
    }

    pub(super) fn checked<T: Real>(
        &self,
        place: &Place<'_>,
    ) -> Result<AnyBrdf<T>, DescriptionError> {
        Ok(match self {
            Self::Lambert { albedo } => {
                let built = Lambert::new(albedo.color::<T>());
                let colors = [("albedo", *albedo)];
                AnyBrdf::from(colored::<T, _>(&place.key("lambert"), &colors, built)?)
            }
            Self::OrenNayar { albedo, sigma, interreflection } => {
                let new =
                    if *interreflection { OrenNayar::with_interreflection } else { OrenNayar::new };
                let built = new(albedo.color::<T>(), T::lit(*sigma));
                let colors = [("albedo", *albedo)];
                AnyBrdf::from(colored::<T, _>(&place.key("oren_nayar"), &colors, built)?)
            }
            Self::Phong { specular, exponent, normalized } => {
                let (place, colors) = (place.key("phong"), [("specular", *specular)]);
                let (specular, exponent) = (specular.color::<T>(), T::lit(*exponent));
                if *normalized {
                    let built = Phong::new(specular, exponent);
                    AnyBrdf::from(colored::<T, _>(&place, &colors, built)?)
                } else {
                    let built = ClassicPhong::new(specular, exponent);
                    AnyBrdf::from(colored::<T, _>(&place, &colors, built)?)
                }
            }
            Self::BlinnPhong { specular, exponent, normalized } => {
                let (place, colors) = (place.key("blinn_phong"), [("specular", *specular)]);
                let new = if *normalized { BlinnPhong::new } else { BlinnPhong::unnormalized };
                let built = new(specular.color::<T>(), T::lit(*exponent));
                AnyBrdf::from(colored::<T, _>(&place, &colors, built)?)
            }
            Self::SchlickPower { specular, exponent, normalized } => {
                let (place, colors) = (place.key("schlick_power"), [("specular", *specular)]);
                let new = if *normalized { SchlickPower::new } else { SchlickPower::unnormalized };
                let built = new(specular.color::<T>(), T::lit(*exponent));
                AnyBrdf::from(colored::<T, _>(&place, &colors, built)?)
            }
            Self::CookTorrance { distribution, fresnel, shadowing } => {
                let place = place.key("cook_torrance");
                let distribution = distribution.checked(&place.key("distribution"))?;
                let fresnel = fresnel.checked(&place.key("fresnel"))?;
                let shadowing = match shadowing {
                    ShadowingDescription::VCavity => AnyShadowing::VCavity,
                    ShadowingDescription::Smith => AnyShadowing::SmithCorrelated,
                    ShadowingDescription::SmithSeparable => AnyShadowing::SmithSeparable,
                };
                if shadowing != AnyShadowing::VCavity && !distribution.has_smith() {
                    return Err(place.key("shadowing").error(Problem::NoSmith));
                }
                AnyBrdf::from(CookTorrance::new(distribution, fresnel).with_shadowing(shadowing))
            }
            Self::TorranceSparrow1967 { c, fresnel } => {
                let place = place.key("torrance_sparrow_1967");
                let built = CookTorrance::torrance_sparrow_1967(T::lit(*c), ());
                let distribution = *place.parameters(built)?.distribution();
                let fresnel = fresnel.checked(&place.key("fresnel"))?;
                AnyBrdf::from(CookTorrance::new(distribution, fresnel))
            }
            Self::CookTorrance1982Printed { roughness, fresnel } => {
                let place = place.key("cook_torrance_1982_printed");
                let built = roughness.distribution(&place, Beckmann::new, Beckmann::anisotropic);
                let fresnel = fresnel.checked(&place.key("fresnel"))?;
                AnyBrdf::from(CookTorrance1982Printed::new(built?, fresnel))
            }
            Self::Blinn1977Printed { distribution, beta, fresnel } => {
                let place = place.key("blinn_1977_printed");
                let blinn = place.parameters(Blinn1977::new(T::lit(*beta)))?;
                let fresnel = fresnel.checked(&place.key("fresnel"))?;
                match distribution {
                    Blinn1977Description::D1 => {
                        place.parameters(Blinn1977Printed::d1(blinn, fresnel))?.into()
                    }
                    Blinn1977Description::D2 => {
                        place.parameters(Blinn1977Printed::d2(blinn, fresnel))?.into()
                    }
                    Blinn1977Description::D3 => {
                        place.parameters(Blinn1977Printed::d3(blinn, fresnel))?.into()
                    }
                }
            }
            Self::Sum(terms) => AnyBrdf::from(sum(terms, &place.key("sum"))?),
        })
    }
}

/// A sum; its place is that of the list.
fn sum<T: Real>(
    terms: &[WeightedBrdf],
    place: &Place<'_>,
) -> Result<WeightedSum<AnyBrdf<T>, T::Vec3, T>, DescriptionError> {
    let mut checked = Vec::new();
    for (index, term) in terms.iter().enumerate() {
        let place = place.term(index)?;
        let weight = term.weight.color::<T>();
        // Here and not only by the sum, because here the term is known.
        let checked_weight = range::WEIGHT.check::<T, _>("weight", weight);
        term.weight.parameter::<T, _>(&place.key("weight"), checked_weight)?;
        checked.push((weight, term.brdf.checked(&place.key("brdf"))?));
    }
    place.parameter(WeightedSum::new(checked))
}
