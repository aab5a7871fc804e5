//! Reflectance of the facets: metals, glass and the approximations.

use std::error::Error;

use brdf::{
    Beckmann, Conductor, Constant, Cook, CookTorrance, Dielectric, Fresnel, Hall, Illuminant,
    Observer, Schlick, VCavity,
};
use glam::Vec3;

use super::{Scene, material, row, series};
use crate::environment::Environment;
use crate::light::Light;
use crate::metal;
use crate::spectral::{Spectral, WAVELENGTHS};
use crate::sphere::Material;

const SECTION: &str = "Microfacets: reflectance";

/// These facets with Beckmann's distribution, α = 0.2, and V-cavities.
fn facets(fresnel: impl Fresnel<f32, Color = Vec3> + 'static) -> Result<Material, Box<dyn Error>> {
    Ok(material(CookTorrance::new(Beckmann::new(0.2)?, fresnel).with_shadowing(VCavity)))
}

/// The same of a reflectance at sixteen wavelengths.
fn spectral<F>(roughness: f32, fresnel: F) -> Result<Material, Box<dyn Error>>
where
    F: Fresnel<f32, Color = Spectral> + 'static,
{
    Ok(metal::facets(Beckmann::new(roughness)?, fresnel, VCavity)?)
}

pub(super) fn scenes(square: &Environment) -> Result<Vec<Scene<'_>>, Box<dyn Error>> {
    let light = Light::Around(square);
    let mut scenes = exact(light)?;
    scenes.extend(approximations(light)?);
    Ok(scenes)
}

fn exact(light: Light) -> Result<Vec<Scene>, Box<dyn Error>> {
    let metals = vec![
        ("gold".into(), spectral(0.2, metal::gold()?)?),
        ("copper".into(), spectral(0.2, metal::copper()?)?),
        ("silver".into(), spectral(0.2, metal::silver()?)?),
    ];
    Ok(vec![
        row(
            SECTION,
            "fresnel-metals-spheres",
            [
                "Conductors",
                "Exact equations with n and k measured by Johnson and Christy, at sixteen \
                 wavelengths, seen by the standard observer; α = 0.2.",
            ],
            metals,
            light,
        ),
        series(
            SECTION,
            "fresnel-index-series",
            [
                "Dielectrics",
                "Exact equations: for the index 1.5 four hundredths at the centre, everything at the \
                 edge. Surface reflection only, as on black glass; α = 0.2.",
            ],
            ("n", [1.1, 1.33, 1.5, 2.0, 2.42]),
            |index| facets(Dielectric::new(Vec3::splat(index))?),
            light,
        )?,
    ])
}

fn approximations(light: Light) -> Result<Vec<Scene>, Box<dyn Error>> {
    let copper: Conductor<Spectral> = metal::copper()?;
    let f0 = copper.reflectance(1.0);
    let seen: Vec3 = Observer::new(Illuminant::D65, WAVELENGTHS)?.linear_srgb(f0);
    let warm = Vec3::new(1.0, 0.85, 0.6);
    let forms = |roughness| -> Result<Vec<(String, Material)>, Box<dyn Error>> {
        Ok(vec![
            ("exact".into(), spectral(roughness, copper)?),
            ("Schlick".into(), spectral(roughness, Schlick::new(f0)?)?),
            ("Hall, index 1.5".into(), spectral(roughness, Hall::new(f0, 1.5)?)?),
            ("constant".into(), spectral(roughness, Constant::new(f0)?)?),
        ])
    };
    Ok(vec![
        row(
            SECTION,
            "fresnel-copper-forms",
            [
                "Copper four ways",
                "All have the reflectance of the measured indices at the centre and differ in how \
                 the colour turns white towards the edge; α = 0.05.",
            ],
            forms(0.05)?,
            Light::Furnace,
        )
        .with_difference(1, 0, 8.0)
        .with_difference(2, 0, 8.0)
        .with_difference(3, 0, 8.0),
        row(
            SECTION,
            "fresnel-copper-square",
            ["Copper four ways in the square", "The same forms, α = 0.2."],
            forms(0.2)?,
            light,
        )
        .with_difference(1, 0, 32.0)
        .with_difference(2, 0, 32.0)
        .with_difference(3, 0, 32.0),
        row(
            SECTION,
            "fresnel-schlick",
            [
                "Schlick for glass",
                "The polynomial with F₀ = 0.04 in place of the index 1.5; α = 0.2.",
            ],
            vec![
                ("exact".into(), facets(Dielectric::new(Vec3::splat(1.5))?)?),
                ("Schlick".into(), facets(Schlick::new(Vec3::splat(0.04))?)?),
            ],
            light,
        )
        .with_difference(1, 0, 8.0),
        row(
            SECTION,
            "fresnel-cook",
            [
                "Cook's colours",
                "Hall's copper turns white towards the edge. Cook's is the colour of the reflected \
                 light under a light of colour 1, 0.85, 0.6, to which its edge tends; α = 0.2.",
            ],
            vec![
                ("Hall".into(), facets(Hall::new(seen, 1.5)?)?),
                ("Cook".into(), facets(Cook::new(seen, warm, 1.5)?)?),
            ],
            light,
        ),
    ])
}
