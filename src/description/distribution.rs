//! Distributions of facet normals.

use alloc::vec::Vec;

use super::error::DescriptionError;
use super::form::{entrance, forms, part};
use super::place::{Place, Record};
use super::value::RoughnessDescription;
use crate::distribution::{AnyDistribution, AnyMixture, Beckmann, Blinn, Gaussian, Ggx};
use crate::error::range;
use crate::real::Real;

forms! {
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
    pub enum DistributionDescription as "a distribution, such as {\"ggx\": {\"roughness\": 0.3}}" {
        /// [`Gaussian`].
        "gaussian" => Gaussian {
            /// Angle in radians at which D falls to 1/e.
            roughness: f64,
        },
        /// [`Beckmann`].
        "beckmann" => Beckmann {
            /// Root-mean-square slope times √2.
            roughness: RoughnessDescription,
        },
        /// [`Ggx`].
        "ggx" => Ggx {
            /// Scale of the slopes.
            roughness: RoughnessDescription,
        },
        /// [`Blinn`].
        "blinn" => Blinn {
            /// Exponent of the cosine.
            exponent: f64,
        },
        /// A weighted mean of distributions, as [`Mixture`](crate::Mixture).
        "mixture" => Mixture(Vec<WeightedDistribution>),
    }
}
entrance!(DistributionDescription);

part! {
    /// A term of a mixture. It is read as a part of a description only, whose errors name its place.
    pub struct WeightedDistribution {
        /// Weight, divided by the sum of all weights.
        pub weight: f64,
        /// The distribution.
        pub distribution: DistributionDescription,
    }
}

impl DistributionDescription {
    /// The distribution in a number of choice.
    ///
    /// # Errors
    /// If a value is outside its range, or a mixture is too deep or too long.
    pub fn build<T: Real>(&self) -> Result<AnyDistribution<T>, DescriptionError> {
        self.checked(&Place::root(&Record::default()))
    }

    pub(super) fn checked<T: Real>(
        &self,
        place: &Place<'_>,
    ) -> Result<AnyDistribution<T>, DescriptionError> {
        Ok(match self {
            Self::Gaussian { roughness } => AnyDistribution::from(
                place.key("gaussian").parameters(Gaussian::new(T::lit(*roughness)))?,
            ),
            Self::Beckmann { roughness } => {
                let place = place.key("beckmann");
                let built = roughness.distribution(&place, Beckmann::new, Beckmann::anisotropic);
                AnyDistribution::from(built?)
            }
            Self::Ggx { roughness } => {
                let place = place.key("ggx");
                let built = roughness.distribution(&place, Ggx::new, Ggx::anisotropic);
                AnyDistribution::from(built?)
            }
            Self::Blinn { exponent } => {
                AnyDistribution::from(place.key("blinn").parameters(Blinn::new(T::lit(*exponent)))?)
            }
            Self::Mixture(terms) => mixture(terms, &place.key("mixture"))?.into(),
        })
    }
}

/// A mixture; its place is that of the list.
fn mixture<T: Real>(
    terms: &[WeightedDistribution],
    place: &Place<'_>,
) -> Result<AnyMixture<T>, DescriptionError> {
    let mut checked = Vec::new();
    for (index, term) in terms.iter().enumerate() {
        let place = place.term(index)?;
        let weight = T::lit(term.weight);
        place.parameters(range::WEIGHT.check("weight", weight))?;
        checked.push((weight, term.distribution.checked(&place.key("distribution"))?));
    }
    place.parameter(AnyMixture::new(checked))
}
