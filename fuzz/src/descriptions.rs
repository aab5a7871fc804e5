//! Descriptions of arbitrary values: some can be built, most cannot.

use arbitrary::{Arbitrary, Result, Unstructured};
use brdf::description::{
    Blinn1977Description, BrdfDescription, ColorDescription, DistributionDescription,
    FresnelDescription, IndexDescription, RoughnessDescription, ShadowingDescription, WeightedBrdf,
    WeightedDistribution,
};

use crate::numbers::{Channels, Number};

/// A description of any form and depth.
#[derive(Clone, Debug)]
pub struct Described(pub BrdfDescription);

impl<'a> Arbitrary<'a> for Described {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        brdf(u).map(Self)
    }
}

fn number(u: &mut Unstructured<'_>) -> Result<f64> {
    Ok(Number::arbitrary(u)?.0)
}

fn color(u: &mut Unstructured<'_>) -> Result<ColorDescription> {
    Ok(match u.arbitrary()? {
        true => ColorDescription::Gray(number(u)?),
        false => ColorDescription::Rgb(Channels::arbitrary(u)?.0),
    })
}

fn index(u: &mut Unstructured<'_>) -> Result<IndexDescription> {
    Ok(match u.arbitrary()? {
        true => IndexDescription::Real(number(u)?),
        false => IndexDescription::Complex([number(u)?, number(u)?]),
    })
}

fn roughness(u: &mut Unstructured<'_>) -> Result<RoughnessDescription> {
    Ok(match u.arbitrary()? {
        true => RoughnessDescription::Isotropic(number(u)?),
        false => RoughnessDescription::Anisotropic([number(u)?, number(u)?]),
    })
}

fn fresnel(u: &mut Unstructured<'_>) -> Result<FresnelDescription> {
    Ok(match u.int_in_range(0..=6)? {
        0 => FresnelDescription::Constant(color(u)?),
        1 => FresnelDescription::Dielectric { ior: color(u)? },
        2 => FresnelDescription::Conductor { eta: color(u)?, k: color(u)? },
        3 => FresnelDescription::Metal(match u.arbitrary()? {
            true => (*u.choose(&["Au", "silver", "Cu", "brass", "quartz", "BK7"])?).into(),
            false => u.arbitrary()?,
        }),
        4 => FresnelDescription::Schlick { f0: color(u)? },
        5 => FresnelDescription::Hall { f0: color(u)?, ior: index(u)? },
        _ => FresnelDescription::Cook { f0: color(u)?, light: color(u)?, ior: index(u)? },
    })
}

fn distribution(u: &mut Unstructured<'_>) -> Result<DistributionDescription> {
    Ok(match u.int_in_range(0..=5)? {
        0 => DistributionDescription::Gaussian { roughness: number(u)? },
        1 => DistributionDescription::Beckmann { roughness: roughness(u)? },
        2 => DistributionDescription::Ggx { roughness: roughness(u)? },
        3 => DistributionDescription::Blinn { exponent: number(u)? },
        _ => {
            let mut terms = Vec::new();
            // Ends with the bytes, as each term takes some.
            while u.arbitrary()? && !u.is_empty() {
                let weight = number(u)?;
                terms.push(WeightedDistribution { weight, distribution: distribution(u)? });
            }
            DistributionDescription::Mixture(terms)
        }
    })
}

fn brdf(u: &mut Unstructured<'_>) -> Result<BrdfDescription> {
    Ok(match u.int_in_range(0..=11)? {
        0 => BrdfDescription::Lambert { albedo: color(u)? },
        1 => BrdfDescription::OrenNayar {
            albedo: color(u)?,
            sigma: number(u)?,
            interreflection: u.arbitrary()?,
        },
        2 => BrdfDescription::Phong {
            specular: color(u)?,
            exponent: number(u)?,
            normalized: u.arbitrary()?,
        },
        3 => BrdfDescription::BlinnPhong {
            specular: color(u)?,
            exponent: number(u)?,
            normalized: u.arbitrary()?,
        },
        4 => BrdfDescription::SchlickPower {
            specular: color(u)?,
            exponent: number(u)?,
            normalized: u.arbitrary()?,
        },
        5 => BrdfDescription::TorranceSparrow1967 { c: number(u)?, fresnel: fresnel(u)? },
        6 => BrdfDescription::CookTorrance1982Printed {
            roughness: roughness(u)?,
            fresnel: fresnel(u)?,
        },
        7 => BrdfDescription::Blinn1977Printed {
            distribution: *u.choose(&[
                Blinn1977Description::D1,
                Blinn1977Description::D2,
                Blinn1977Description::D3,
            ])?,
            beta: number(u)?,
            fresnel: fresnel(u)?,
        },
        8 | 9 => {
            let mut terms = Vec::new();
            while u.arbitrary()? && !u.is_empty() {
                terms.push(WeightedBrdf { weight: color(u)?, brdf: brdf(u)? });
            }
            BrdfDescription::Sum(terms)
        }
        _ => BrdfDescription::CookTorrance {
            distribution: distribution(u)?,
            fresnel: fresnel(u)?,
            shadowing: *u.choose(&[
                ShadowingDescription::VCavity,
                ShadowingDescription::Smith,
                ShadowingDescription::SmithSeparable,
            ])?,
        },
    })
}
