//! Fresnel terms, by their forms.

use alloc::string::ToString;

use super::build::Build;
use super::channels::Channels;
use super::error::{DescriptionError, Problem};
use crate::fresnel::{
    AnyFresnel, BelcourBarla, Conductor, Constant, Cook, Dielectric, F82, F82Tint, GeneralSchlick,
    Gulbrandsen, Hall, Lazanyi, Schlick, Stack, xyz_in_linear_srgb,
};
use crate::materials::RefractiveIndex;
use crate::polarization::{Complex, Layer};
use crate::real::{Color, Real};

pub(super) fn fresnel<T: Real, C: Color<T>>(
    at: &Build<'_, T, C>,
) -> Result<AnyFresnel<T, C>, DescriptionError> {
    Ok(match at.described.form.name() {
        "constant" => at.made(Constant::new(at.color("reflectance")?))?.into(),
        "dielectric" => at.made(Dielectric::new(at.transparent("ior")?))?.into(),
        "conductor" => at.made(Conductor::new(at.color("eta")?, at.color("k")?))?.into(),
        "metal" => {
            let RefractiveIndex { eta, k } = at.metal()?;
            Conductor::new(eta, k)
                .map_err(|error| at.path.error(Problem::Metal(error.to_string())))?
                .into()
        }
        "schlick" if at.is_default("f90") && at.is_default("exponent") => {
            at.made(Schlick::new(at.color("f0")?))?.into()
        }
        "schlick" => {
            let (f0, f90) = (at.color("f0")?, at.color("f90")?);
            at.made(GeneralSchlick::new(f0, f90, at.number("exponent")?))?.into()
        }
        "lazanyi" => {
            let (f0, a) = (at.color("f0")?, at.color("a")?);
            at.made(Lazanyi::new(f0, a, at.color("alpha")?))?.into()
        }
        "f82" => at.made(F82::new(at.color("f0")?, at.color("f82")?))?.into(),
        "f82_tint" => at.made(F82Tint::new(at.color("f0")?, at.color("tint")?))?.into(),
        "gulbrandsen" => {
            let (reflectivity, tint) = (at.color("reflectivity")?, at.color("edge_tint")?);
            at.made(Gulbrandsen::new(reflectivity, tint))?.into()
        }
        "hall" => {
            let f0 = at.color("f0")?;
            match at.one_or_two("ior")? {
                (ior, None) => at.made(Hall::new(f0, ior))?.into(),
                (eta, Some(k)) => {
                    let reference = at.made(Conductor::new(eta, k))?;
                    at.made(Hall::with_reference(f0, reference))?.into()
                }
            }
        }
        "cook" => {
            let (f0, light) = (at.color("f0")?, at.color("light")?);
            match at.one_or_two("ior")? {
                (ior, None) => at.made(Cook::new(f0, light, ior))?.into(),
                (eta, Some(k)) => {
                    let reference = at.made(Conductor::new(eta, k))?;
                    at.made(Cook::with_reference(f0, light, reference))?.into()
                }
            }
        }
        "stack" => {
            let wavelengths = at.described.channels("wavelength");
            let layers = at.each("layers", |layer| {
                let index = layer.medium("index", wavelengths)?;
                Ok(Layer { index, thickness: layer.number("thickness")? })
            })?;
            let outside = at.medium("outside", wavelengths)?;
            let substrate = at.medium("substrate", wavelengths)?;
            let wavelength = at.wavelength("wavelength")?;
            at.made(Stack::new(outside, &layers, substrate, wavelength))?.into()
        }
        "belcour_barla" => {
            let (film, thickness) = (at.number("film")?, at.number("thickness")?);
            let Complex { re, im } = at.medium("substrate", [f64::NAN; 3])?;
            let first = |color: C| color.channels().as_ref().first().copied();
            let substrate = [re, im].map(|part| first(part).unwrap_or(T::lit(f64::NAN)));
            let outside = at.number("outside")?;
            let Channels::Rgb = at.channels else {
                return Err(at.path.error(Problem::NoSpectrum));
            };
            let colors = xyz_in_linear_srgb().map(|color| {
                let channel = |channel| color.get(channel).copied().unwrap_or(f64::NAN);
                C::from_channels(C::by_channel(|index| T::lit(channel(index))))
            });
            at.made(BelcourBarla::with_colors(film, thickness, substrate, outside, colors))?.into()
        }
        _ => return Err(at.unknown()),
    })
}
