//! Discs of the moon.

use std::error::Error;

use super::{Scene, row};
use crate::light::Light;
use crate::moon;

const SECTION: &str = "The moon";

/// The phases, with the name of the picture, its title and what to see.
const PHASES: [(f32, &str, &str, &str); 4] = [
    (
        0.0,
        "moon-full",
        "The full moon",
        "Lambert's disc darkens towards its edge; the moon does not, nor do the laws that were made for it. \
         Hapke's parameters follow the measured curve of brightness (below): w = 0.22, ξ = −0.2, B₀ = 1.96, \
         h = 0.06, θ̄ = 0.28. All are equally bright in the middle of this disc.",
    ),
    (
        45.0,
        "moon-gibbous",
        "Three quarters of the way",
        "The same surfaces as at full moon and in the same exposure: Hapke's has lost more than half of its \
         radiance, for the grains no longer hide their shadows.",
    ),
    (
        90.0,
        "moon-half",
        "Half moon",
        "As before. Hapke's half moon has a thirteenth of the light of the full one, as the real one has; Lambert's a third.",
    ),
    (
        135.0,
        "moon-crescent",
        "Crescent",
        "As before. Minnaert's law knows no phase: where light and viewer graze it is brighter than at full \
         moon.",
    ),
];

pub(super) fn scenes<'a>() -> Result<Vec<Scene<'a>>, Box<dyn Error>> {
    let irradiance = 0.75 / moon::middle()?;
    let mut scenes = Vec::new();
    for (degrees, name, title, caption) in PHASES {
        let light = Light::Sun { phase: degrees.to_radians(), irradiance };
        let models = moon::models()?;
        let spheres = models.into_iter().map(|(name, model)| (name.to_owned(), model));
        scenes.push(row(SECTION, name, [title, caption], spheres.collect(), light));
    }
    Ok(scenes)
}
