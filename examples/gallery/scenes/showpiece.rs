//! Finished materials: the picture of the front page and sums of models.

use std::error::Error;

use brdf::{Beckmann, BlinnPhong, CookTorrance, Dielectric, Lambert, OrenNayar, WeightedSum};
use glam::Vec3;

use super::{Scene, material, row, series, single};
use crate::environment::Environment;
use crate::metal;
use crate::sphere::{Light, Material};

const SECTION: &str = "Materials";

/// Diffuse colour under a clear coat of gloss.
fn plastic(color: Vec3, roughness: f32) -> Result<Material, Box<dyn Error>> {
    let coat = CookTorrance::new(Beckmann::new(roughness)?, Dielectric::new(Vec3::splat(1.5))?);
    let terms = [(Vec3::splat(0.9), material(Lambert::new(color)?)), (Vec3::ONE, material(coat))];
    Ok(material(WeightedSum::new(terms)?))
}

pub(super) fn scenes(square: &Environment) -> Result<Vec<Scene<'_>>, Box<dyn Error>> {
    let light = Light::Around(square);
    let metal = |conductor, roughness: f32| -> Result<Material, Box<dyn Error>> {
        Ok(material(CookTorrance::new(Beckmann::new(roughness)?, conductor)))
    };
    let red = Vec3::new(0.65, 0.06, 0.04);
    let clay = Vec3::new(0.72, 0.42, 0.30);
    let hero = row(
        SECTION,
        "hero",
        [
            "Five materials",
            "Metals: Cook–Torrance with Beckmann's distribution and indices measured by Johnson and \
             Christy, interpolated at 650, 550 and 450 nm for red, green and blue.",
        ],
        vec![
            ("gold, α = 0.25".into(), metal(metal::gold()?, 0.25)?),
            ("copper, α = 0.35".into(), metal(metal::copper()?, 0.35)?),
            ("plastic: Lambert + Cook–Torrance, α = 0.1".into(), plastic(red, 0.1)?),
            ("clay: Oren–Nayar, σ = 0.5".into(), material(OrenNayar::new(clay, 0.5)?)),
            ("silver, α = 0.15".into(), metal(metal::silver()?, 0.15)?),
        ],
        light,
    );
    let lacquer = [
        (Vec3::splat(0.7), material(Lambert::new(Vec3::new(0.05, 0.18, 0.55))?)),
        (Vec3::splat(0.3), material(BlinnPhong::new(Vec3::ONE, 200.0)?)),
    ];
    Ok(vec![
        hero,
        single(
            SECTION,
            "sum-plastic",
            ["Weighted sum: plastic", "0.9 Lambert + a clear coat of index 1.5, α = 0.1."],
            plastic(red, 0.1)?,
            light,
        ),
        single(
            SECTION,
            "sum-lacquer",
            ["Weighted sum: lacquer", "0.7 Lambert + 0.3 Blinn–Phong, n = 200."],
            material(WeightedSum::new(lacquer)?),
            light,
        ),
        series(
            SECTION,
            "sum-plastic-series",
            [
                "Plastic from polished to frosted",
                "The same sum with the roughness of the coat growing.",
            ],
            super::ROUGHNESSES,
            |roughness| plastic(red, roughness),
            light,
        )?,
    ])
}
