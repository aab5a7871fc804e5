//! Models of reflection, by their forms.

use super::build::Build;
use super::distribution::distribution;
use super::error::DescriptionError;
use super::fresnel::fresnel;
use crate::any::AnyBrdf;
use crate::diffuse::{Lambert, OrenNayar};
use crate::distribution::{Beckmann, Blinn1977};
use crate::glossy::{BlinnPhong, ClassicPhong, Phong, SchlickPower};
use crate::microfacet::{AnyShadowing, Blinn1977Printed, CookTorrance, CookTorrance1982Printed};
use crate::planetary::{LommelSeeliger, Minnaert};
use crate::real::{Color, Real};
use crate::sum::WeightedSum;

pub(super) fn brdf<T: Real, C: Color<T>>(
    at: &Build<'_, T, C>,
) -> Result<AnyBrdf<T, C>, DescriptionError> {
    let lobe = || Ok((at.color("specular")?, at.number("exponent")?));
    Ok(match at.described.form.name() {
        "lambert" => at.made(Lambert::new(at.color("albedo")?))?.into(),
        "oren_nayar" => {
            let whole = at.flag("interreflection");
            let new = if whole { OrenNayar::with_interreflection } else { OrenNayar::new };
            at.made(new(at.color("albedo")?, at.number("sigma")?))?.into()
        }
        "phong" => {
            let (specular, exponent) = lobe()?;
            if at.flag("normalized") {
                at.made(Phong::new(specular, exponent))?.into()
            } else {
                at.made(ClassicPhong::new(specular, exponent))?.into()
            }
        }
        "blinn_phong" => {
            let (specular, exponent) = lobe()?;
            let normalized = at.flag("normalized");
            let new = if normalized { BlinnPhong::new } else { BlinnPhong::unnormalized };
            at.made(new(specular, exponent))?.into()
        }
        "schlick_power" => {
            let (specular, exponent) = lobe()?;
            let normalized = at.flag("normalized");
            let new = if normalized { SchlickPower::new } else { SchlickPower::unnormalized };
            at.made(new(specular, exponent))?.into()
        }
        "minnaert" => at.made(Minnaert::new(at.color("albedo")?, at.number("k")?))?.into(),
        "lommel_seeliger" => at.made(LommelSeeliger::new(at.color("w")?, at.number("xi")?))?.into(),
        "cook_torrance" => {
            let distribution = at.part("distribution", distribution)?;
            let fresnel = at.part("fresnel", fresnel)?;
            let shadowing = match at.described.word("shadowing") {
                "smith" => AnyShadowing::SmithCorrelated,
                "smith_separable" => AnyShadowing::SmithSeparable,
                _ => AnyShadowing::VCavity,
            };
            CookTorrance::from_parts(distribution, fresnel, shadowing).into()
        }
        "torrance_sparrow_1967" => {
            let (c, fresnel) = (at.number("c")?, at.part("fresnel", fresnel)?);
            at.made(CookTorrance::torrance_sparrow_1967(c, fresnel))?.into()
        }
        "cook_torrance_1982_printed" => {
            let distribution = at.rough(Beckmann::new, Beckmann::anisotropic)?;
            CookTorrance1982Printed::new(distribution, at.part("fresnel", fresnel)?).into()
        }
        "blinn_1977_printed" => {
            let blinn = at.made(Blinn1977::new(at.number("beta")?))?;
            let fresnel = at.part("fresnel", fresnel)?;
            match at.described.word("distribution") {
                "d1" => at.made(Blinn1977Printed::d1(blinn, fresnel))?.into(),
                "d2" => at.made(Blinn1977Printed::d2(blinn, fresnel))?.into(),
                "d3" => at.made(Blinn1977Printed::d3(blinn, fresnel))?.into(),
                _ => return Err(at.unknown()),
            }
        }
        "sum" => {
            let terms = at.terms(|term| Ok((term.color("weight")?, term.part("brdf", brdf)?)))?;
            at.list(WeightedSum::<AnyBrdf<T, C>, _, T>::new(terms))?.into()
        }
        _ => return Err(at.unknown()),
    })
}
