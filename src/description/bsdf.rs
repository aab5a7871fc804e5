//! Models over the whole sphere, by their forms.

use super::brdf::{brdf, schlick_1994};
use super::build::Build;
use super::check::not_refracting;
use super::distribution::distribution;
use super::error::DescriptionError;
use super::fresnel::fresnel;
use crate::distribution::AnyDistribution;
use crate::interface::{
    AnyBsdf, AnySmith, Mirror, Plastic, RoughDielectric, SmoothDielectric, SplitSchlick1994,
    ThinDielectric,
};
use crate::real::{Color, Real};
use crate::wave::{BeckmannKirchhoff, He1991, Masking};

pub(super) fn bsdf<T: Real, C: Color<T>>(
    at: &Build<'_, T, C>,
) -> Result<AnyBsdf<T, C>, DescriptionError> {
    Ok(match at.described.form.name() {
        "mirror" => Mirror::new(at.part("fresnel", fresnel)?).into(),
        "plastic" => {
            let new = if at.flag("nonlinear") { Plastic::new } else { Plastic::linear };
            at.made(new(at.color("diffuse")?, at.transparent_to_all("ior")?))?.into()
        }
        "dielectric" => {
            at.made(SmoothDielectric::new(at.transparent_to_all("ior")?))?.in_channels::<C>().into()
        }
        "thin_dielectric" => {
            at.made(ThinDielectric::new(at.transparent_to_all("ior")?))?.in_channels::<C>().into()
        }
        "beckmann_kirchhoff_1963" => {
            let (sigma, correlation) = (at.number("sigma")?, at.number("correlation")?);
            let fresnel = at.part("fresnel", fresnel)?;
            let wavelength = at.wavelength("wavelength")?;
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
                at.made(He1991::new(sigma, correlation, fresnel, at.wavelength("wavelength")?))?;
            at.made(model.with_uniform_diffuse(uniform))?.with_masking(masking).into()
        }
        "rough_dielectric" => {
            let facets = at.part("distribution", distribution)?;
            let ior = at.transparent_to_all("ior")?;
            let shadowing = match at.described.word("shadowing") {
                "smith_separable" => AnySmith::Separable,
                _ => AnySmith::Correlated,
            };
            match facets {
                AnyDistribution::Beckmann(facets) => {
                    let rough = at.made(RoughDielectric::new(facets, ior))?;
                    rough.with_shadowing(shadowing).in_channels::<C>().into()
                }
                AnyDistribution::Ggx(facets) => {
                    let rough = at.made(RoughDielectric::new(facets, ior))?;
                    rough.with_shadowing(shadowing).in_channels::<C>().into()
                }
                _ => return Err(not_refracting(at.described, &at.path)),
            }
        }
        "schlick_1994" if at.flag("split") => SplitSchlick1994::new(schlick_1994(at)?).into(),
        _ => brdf(at)?.into(),
    })
}
