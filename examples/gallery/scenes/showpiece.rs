//! Finished materials: one of each kind, and sums of models.

use std::error::Error;

use brdf::{BlinnPhong, Ggx, Lambert, OrenNayar, SmithCorrelated, WeightedSum};
use glam::Vec3;

use super::{Scene, material, row, series, single};
use crate::environment::Environment;
use crate::light::Light;
use crate::metal;
use crate::plastic::Plastic;
use crate::sphere::Material;

const SECTION: &str = "Materials";

pub(super) fn scenes(square: &Environment) -> Result<Vec<Scene<'_>>, Box<dyn Error>> {
    let light = Light::Around(square);
    let red = Vec3::new(0.65, 0.06, 0.04);
    let clay = Vec3::new(0.72, 0.42, 0.30);
    let plastic = |roughness: f32| -> Result<Material, Box<dyn Error>> {
        Ok(material(Plastic::new(red, roughness, 1.5)?))
    };
    let facets = |roughness: f32, conductor| -> Result<Material, Box<dyn Error>> {
        Ok(metal::facets(Ggx::new(roughness)?, conductor, SmithCorrelated)?)
    };
    let lacquer = [
        (Vec3::splat(0.7), material(Lambert::new(Vec3::new(0.05, 0.18, 0.55))?)),
        (Vec3::splat(0.3), material(BlinnPhong::new(Vec3::ONE, 200.0)?)),
    ];
    Ok(vec![
        row(
            SECTION,
            "five-materials",
            [
                "Five materials",
                "Metals: GGX, Smith's shadowing, and the indices measured by Johnson and Christy at \
                 sixteen wavelengths, seen by the standard observer. Plastic: a pigment under a coat \
                 of index 1.5, which reflects no more than it receives. Clay: Oren–Nayar.",
            ],
            vec![
                ("gold, α = 0.2".into(), facets(0.2, metal::gold()?)?),
                ("copper, α = 0.3".into(), facets(0.3, metal::copper()?)?),
                ("plastic, α = 0.1".into(), plastic(0.1)?),
                ("clay, σ = 0.5".into(), material(OrenNayar::new(clay, 0.5)?)),
                ("silver, α = 0.1".into(), facets(0.1, metal::silver()?)?),
            ],
            light,
        ),
        single(
            SECTION,
            "sum-lacquer",
            [
                "Weighted sum: lacquer",
                "0.7 Lambert + 0.3 Blinn–Phong, n = 200: the weights add up to 1, so no energy is \
                 made.",
            ],
            ("0.7 Lambert + 0.3 Blinn–Phong", material(WeightedSum::new(lacquer)?)),
            light,
        ),
        series(
            SECTION,
            "plastic-series",
            [
                "Plastic from polished to frosted",
                "A model of the gallery's own: the pigment gets the light that the coat of index 1.5 \
                 lets through, on the way in and on the way out.",
            ],
            super::ROUGHNESSES,
            plastic,
            light,
        )?,
    ])
}
