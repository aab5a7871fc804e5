//! Distributions of facet normals, by their forms.

use super::build::Build;
use super::error::DescriptionError;
use crate::distribution::{AnyDistribution, AnyMixture, Beckmann, Blinn, Gaussian, Ggx};
use crate::real::{Color, Real};

pub(super) fn distribution<T: Real, C: Color<T>>(
    at: &Build<'_, T, C>,
) -> Result<AnyDistribution<T>, DescriptionError> {
    Ok(match at.described.form.name() {
        "gaussian" => at.made(Gaussian::new(at.number("roughness")?))?.into(),
        "beckmann" => at.rough(Beckmann::new, Beckmann::anisotropic)?.into(),
        "ggx" => at.rough(Ggx::new, Ggx::anisotropic)?.into(),
        "blinn" => at.made(Blinn::new(at.number("exponent")?))?.into(),
        "mixture" => {
            let terms = at.terms(|term| {
                Ok((term.number("weight")?, term.part("distribution", distribution)?))
            })?;
            at.list(AnyMixture::new(terms))?.into()
        }
        _ => return Err(at.unknown()),
    })
}
