//! Reflectance of the facets: metals, glass and the approximations.

use std::error::Error;

use brdf::{Beckmann, Conductor, Constant, Cook, CookTorrance, Dielectric, Fresnel, Hall, Schlick};
use glam::Vec3;

use super::{Scene, material, row, series, single};
use crate::environment::Environment;
use crate::metal;
use crate::sphere::{Light, Material};

const SECTION: &str = "Microfacets: reflectance";

/// These facets with Beckmann's distribution and V-cavities.
fn facets(fresnel: impl Fresnel<f32, Color = Vec3> + 'static) -> Result<Material, Box<dyn Error>> {
    Ok(material(CookTorrance::new(Beckmann::new(0.2)?, fresnel)))
}

fn polished(
    fresnel: impl Fresnel<f32, Color = Vec3> + 'static,
) -> Result<Material, Box<dyn Error>> {
    Ok(material(CookTorrance::new(Beckmann::new(0.05)?, fresnel)))
}

pub(super) fn scenes<'a>(
    square: &'a Environment,
    furnace: &'a Environment,
) -> Result<Vec<Scene<'a>>, Box<dyn Error>> {
    let light = Light::Around(square);
    let measured = "Exact equations with n and k measured by Johnson and Christy, interpolated at \
                    650, 550 and 450 nm for red, green and blue; α = 0.2.";
    let copper: Conductor = metal::copper()?;
    let f0 = copper.reflectance(1.0);
    let glass = Dielectric::new(Vec3::splat(1.5))?;
    let warm = Vec3::new(1.0, 0.85, 0.6);
    let one = |name: &str, words, sphere| single(SECTION, name, words, sphere, light);
    Ok(vec![
        one("fresnel-gold", ["Conductor: gold", measured], facets(metal::gold()?)?),
        one("fresnel-copper", ["Conductor: copper", measured], facets(copper)?),
        one("fresnel-silver", ["Conductor: silver", measured], facets(metal::silver()?)?),
        one(
            "fresnel-dielectric",
            [
                "Dielectric",
                "Exact equations for the index 1.5: four hundredths at the centre, everything at \
                 the edge. Surface reflection only, as on black glass; α = 0.2.",
            ],
            facets(glass)?,
        ),
        one(
            "fresnel-schlick",
            ["Schlick", "The polynomial with F₀ = 0.04 in place of the index 1.5; α = 0.2."],
            facets(Schlick::new(Vec3::splat(0.04))?)?,
        ),
        one(
            "fresnel-hall",
            ["Hall", "From copper's F₀ to white along the curve of the index 1.5; α = 0.2."],
            facets(Hall::new(f0, 1.5)?)?,
        ),
        one(
            "fresnel-cook",
            [
                "Cook",
                "The colour of reflected light: the same under light of colour 1, 0.85, 0.6, to \
                 which the edge tends; α = 0.2.",
            ],
            facets(Cook::new(f0, warm, 1.5)?)?,
        ),
        one(
            "fresnel-constant",
            ["Constant", "Copper's F₀ at all angles: no whitening at the edge; α = 0.2."],
            facets(Constant::new(f0)?)?,
        ),
        row(
            SECTION,
            "fresnel-copper-forms",
            [
                "Copper four ways",
                "In a white furnace, radiance 1 from everywhere: all have the F₀ of the measured indices \
                 and differ in how the colour turns white towards the edge. α = 0.05.",
            ],
            vec![
                ("Conductor".into(), polished(copper)?),
                ("Schlick".into(), polished(Schlick::new(f0)?)?),
                ("Hall, index 1.5".into(), polished(Hall::new(f0, 1.5)?)?),
                ("Constant".into(), polished(Constant::new(f0)?)?),
            ],
            Light::Around(furnace),
        ),
        series(
            SECTION,
            "fresnel-index-series",
            ["Index of refraction", "Exact dielectric, surface reflection only; α = 0.2."],
            ("n", [1.1, 1.33, 1.5, 2.0, 2.42]),
            |index| facets(Dielectric::new(Vec3::splat(index))?),
            light,
        )?,
    ])
}
