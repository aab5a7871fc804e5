//! Plots of the formulas.

mod approximations;
mod cartesian;
mod diffuse;
mod energy;
mod figure;
mod fresnel;
mod lobe;
mod lobes;
mod microfacet;
mod moon;
mod polar;
mod shadowing;
mod style;

use std::error::Error;
use std::path::Path;

use crate::picture::Picture;
use figure::Figure;

/// What draws one figure.
type Draw = fn() -> Result<Figure, Box<dyn Error>>;

/// In the order of the page.
const FIGURES: [Draw; 21] = [
    fresnel::glass,
    fresnel::metals,
    fresnel::copper_polarized,
    approximations::schlick_dielectric,
    approximations::schlick_metal,
    approximations::copper,
    microfacet::distributions,
    microfacet::roughness,
    microfacet::mixture,
    shadowing::fixed_light,
    shadowing::mirror,
    lobes::diffuse,
    lobes::phong,
    lobes::microfacet,
    lobes::microfacet_decades,
    lobes::off_specular,
    approximations::powers,
    diffuse::full_moon,
    moon::phases,
    energy::conserving,
    energy::not_conserving,
];

/// Writes all plots into `out`; calls `progress` with the name of each that is done.
pub fn all(out: &Path, progress: &dyn Fn(&str)) -> Result<Vec<Picture>, Box<dyn Error>> {
    let mut pictures = Vec::new();
    let figures = FIGURES.into_iter().map(|draw| draw());
    for figure in figures.chain(energy::registry().into_iter().map(Ok)) {
        let picture = figure?.write(out)?;
        progress(&picture.file);
        pictures.push(picture);
    }
    Ok(pictures)
}
