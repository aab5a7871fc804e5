//! Models over the whole sphere, by their forms.

use super::brdf::brdf;
use super::build::Build;
use super::distribution::distribution;
use super::error::{DescriptionError, Problem};
use super::fresnel::fresnel;
use crate::distribution::AnyDistribution;
use crate::interface::{
    AnyBsdf, AnySmith, Mirror, Plastic, RoughDielectric, SmoothDielectric, ThinDielectric,
};
use crate::real::Real;
use crate::wave::{BeckmannKirchhoff, He1991, Masking};

pub(super) fn bsdf<T: Real>(at: &Build<'_, T>) -> Result<AnyBsdf<T>, DescriptionError> {
    Ok(match at.described.form.name() {
        "mirror" => Mirror::new(at.part("fresnel", fresnel)?).into(),
        "plastic" => {
            let new = if at.flag("nonlinear") { Plastic::new } else { Plastic::linear };
            at.made(new(at.color("diffuse")?, at.number("ior")?))?.into()
        }
        "beckmann_kirchhoff_1963" => {
            let (sigma, correlation) = (at.number("sigma")?, at.number("correlation")?);
            let fresnel = at.part("fresnel", fresnel)?;
            let wavelength = at.color("wavelength")?;
            at.made(BeckmannKirchhoff::new(sigma, correlation, fresnel, wavelength))?.into()
        }
        "he_1991" => {
            let (sigma, correlation) = (at.number("sigma")?, at.number("correlation")?);
            let fresnel = at.part("fresnel", fresnel)?;
            let uniform = at.color("uniform_diffuse")?;
            let masking = match at.described.word("masking") {
                "printed" => Masking::Printed,
                _ => Masking::Corrected,
            };
            let model =
                at.made(He1991::new(sigma, correlation, fresnel, at.color("wavelength")?))?;
            at.made(model.with_uniform_diffuse(uniform))?.with_masking(masking).into()
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
        _ => brdf(at)?.into(),
    })
}
