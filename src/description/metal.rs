//! Metals by name.

use glam::DVec3;

use super::error::Problem;

/// The measured index of a metal, alloy or semiconductor at 650, 550 and 450 nm: its real and its
/// imaginary part.
#[cfg(feature = "materials")]
pub(super) fn metal(name: &str) -> Result<[DVec3; 2], Problem> {
    use crate::materials::Kind;

    let material = lookup(name)?;
    if material.kind() == Kind::Dielectric {
        return Err(Problem::Metal(alloc::format!(
            "{} is no metal; describe it as a dielectric by its index",
            material.key()
        )));
    }
    index(material, DVec3::new(650.0, 550.0, 450.0))
}

/// The measured index of any material at three wavelengths: its real and its imaginary part.
#[cfg(feature = "materials")]
pub(super) fn material(name: &str, wavelength: DVec3) -> Result<[DVec3; 2], Problem> {
    index(lookup(name)?, wavelength)
}

#[cfg(feature = "materials")]
fn lookup(name: &str) -> Result<&'static crate::materials::Material, Problem> {
    use alloc::string::ToString;

    use super::place::beginning;
    use crate::materials::{LookupError, find};

    find(name).map_err(|error| {
        let error = match error {
            LookupError::Unknown { name, nearest } => {
                LookupError::Unknown { name: beginning(&name), nearest }
            }
            ambiguous => ambiguous,
        };
        Problem::Metal(error.to_string())
    })
}

#[cfg(feature = "materials")]
fn index(material: &crate::materials::Material, wavelength: DVec3) -> Result<[DVec3; 2], Problem> {
    use alloc::string::ToString;

    let index = material.refractive_index(wavelength);
    let index = index.map_err(|error| Problem::Metal(error.to_string()))?;
    Ok([index.eta, index.k])
}

#[cfg(not(feature = "materials"))]
pub(super) fn metal(_: &str) -> Result<[DVec3; 2], Problem> {
    Err(Problem::Metal("metals by name need the feature `materials`".into()))
}

#[cfg(not(feature = "materials"))]
pub(super) fn material(_: &str, _: DVec3) -> Result<[DVec3; 2], Problem> {
    Err(Problem::Metal("materials by name need the feature `materials`".into()))
}
