//! Distributions of facet normals, by their forms.

use super::build::Build;
use super::error::DescriptionError;
use crate::distribution::{
    AnyDistribution, AnyMixture, Beckmann, Blinn, Gaussian, Ggx, Gtr, StudentT,
};
use crate::real::{Color, Real};

pub(super) fn distribution<T: Real, C: Color<T>>(
    at: &Build<'_, T, C>,
) -> Result<AnyDistribution<T>, DescriptionError> {
    Ok(match at.described.form.name() {
        "gaussian" => at.made(Gaussian::new(at.number("roughness")?))?.into(),
        "beckmann" => at.rough(Beckmann::new, Beckmann::anisotropic)?.into(),
        "ggx" => at.rough(Ggx::new, Ggx::anisotropic)?.into(),
        "blinn" => at.made(Blinn::new(at.number("exponent")?))?.into(),
        "gtr" => at.made(Gtr::new(at.number("roughness")?, at.number("gamma")?))?.into(),
        "student_t" => {
            let gamma = at.number("gamma")?;
            let new = |roughness| StudentT::new(roughness, gamma);
            at.rough(new, |x, y| StudentT::anisotropic(x, y, gamma))?.into()
        }
        "mixture" => {
            let terms = at.terms(|term| {
                Ok((term.number("weight")?, term.part("distribution", distribution)?))
            })?;
            at.list(AnyMixture::new(terms))?.into()
        }
        _ => return Err(at.unknown()),
    })
}
