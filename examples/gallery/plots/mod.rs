//! Plots of the formulas.

mod cartesian;
mod figure;
mod fresnel;
mod metals;
mod polar;
mod style;

use std::error::Error;
use std::path::Path;

use crate::picture::Picture;
use figure::Figure;

/// What draws one figure.
type Draw = fn() -> Result<Figure, Box<dyn Error>>;

/// In the order of the page.
const FIGURES: [Draw; 3] = [fresnel::glass, fresnel::metals, fresnel::copper_polarized];

/// Writes all plots into `out`; calls `progress` with the name of each that is done.
pub fn all(out: &Path, progress: &dyn Fn(&str)) -> Result<Vec<Picture>, Box<dyn Error>> {
    let mut pictures = Vec::with_capacity(FIGURES.len());
    for draw in FIGURES {
        let picture = draw()?.write(out)?;
        progress(&picture.file);
        pictures.push(picture);
    }
    Ok(pictures)
}
