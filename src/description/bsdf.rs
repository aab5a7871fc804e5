//! Models over the whole sphere, by their forms.

use super::brdf::{brdf, schlick_1994};
use super::build::Build;
use super::distribution::distribution;
use super::error::{DescriptionError, Problem};
use super::fresnel::fresnel;
use crate::distribution::AnyDistribution;
use crate::interface::{
    AnyBsdf, AnySmith, Mirror, Plastic, RoughDielectric, SmoothDielectric, SplitSchlick1994,
    ThinDielectric,
};
use crate::real::Real;

pub(super) fn bsdf<T: Real>(at: &Build<'_, T>) -> Result<AnyBsdf<T>, DescriptionError> {
    Ok(match at.described.form.name() {
        "mirror" => Mirror::new(at.part("fresnel", fresnel)?).into(),
        "plastic" => {
            let new = if at.flag("nonlinear") { Plastic::new } else { Plastic::linear };
            at.made(new(at.color("diffuse")?, at.number("ior")?))?.into()
        }
        "dielectric" => at.made(SmoothDielectric::new(at.number("ior")?))?.into(),
        "thin_dielectric" => at.made(ThinDielectric::new(at.number("ior")?))?.into(),
        "rough_dielectric" => {
            let facets = at.part("distribution", distribution)?;
            let ior = at.number("ior")?;
            let shadowing = match at.described.word("shadowing") {
                "smith_separable" => AnySmith::Separable,
                _ => AnySmith::Correlated,
            };
            match facets {
                AnyDistribution::Beckmann(facets) => {
                    at.made(RoughDielectric::new(facets, ior))?.with_shadowing(shadowing).into()
                }
                AnyDistribution::Ggx(facets) => {
                    at.made(RoughDielectric::new(facets, ior))?.with_shadowing(shadowing).into()
                }
                _ => return Err(at.path.key("distribution").error(Problem::NotRefracting)),
            }
        }
        "schlick_1994" if at.flag("split") => SplitSchlick1994::new(schlick_1994(at)?).into(),
        _ => brdf(at)?.into(),
    })
}
