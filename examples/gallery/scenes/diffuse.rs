//! Lambert and Oren–Nayar.

use std::error::Error;
use std::f32::consts::PI;

use brdf::{Lambert, OrenNayar};
use glam::Vec3;

use super::{Scene, material, row, series, single};
use crate::environment::Environment;
use crate::light::Light;
use crate::sphere::Material;

const SECTION: &str = "Diffuse models";

pub(super) fn scenes(square: &Environment) -> Result<Vec<Scene<'_>>, Box<dyn Error>> {
    let light = Light::Around(square);
    let clay = Vec3::new(0.72, 0.42, 0.30);
    let gray = Vec3::splat(0.8);
    // The sun behind the viewer, of such strength that white paper facing it has radiance 0.9.
    let moon = Light::Distant { towards: Vec3::Z, irradiance: 0.9 * PI };
    let compared = || -> Result<Vec<(String, Material)>, Box<dyn Error>> {
        let mut spheres = vec![("Lambert".into(), material(Lambert::new(gray)?))];
        for sigma in [0.1, 0.3] {
            let model = material(OrenNayar::new(gray, sigma)?);
            spheres.push((format!("Oren–Nayar, σ = {sigma}"), model));
        }
        Ok(spheres)
    };
    Ok(vec![
        single(
            SECTION,
            "lambert",
            ["Lambert", "Equal radiance in all directions; albedo 0.72, 0.42, 0.30."],
            ("Lambert", material(Lambert::new(clay)?)),
            light,
        ),
        single(
            SECTION,
            "oren-nayar",
            [
                "Oren–Nayar, σ = 0.3",
                "The same albedo on rough ground: flatter than Lambert, brighter at the edge.",
            ],
            ("Oren–Nayar, σ = 0.3", material(OrenNayar::new(clay, 0.3)?)),
            light,
        ),
        row(
            SECTION,
            "oren-nayar-full-moon",
            [
                "Full moon: light from the viewer's side",
                "With σ the edge stays bright and the sphere looks like a disc, as the moon does; \
                 σ = 0 is Lambert exactly.",
            ],
            compared()?,
            moon,
        )
        .with_difference(1, 0, 4.0)
        .with_difference(2, 0, 4.0),
        row(
            SECTION,
            "oren-nayar-square",
            ["The same in the square", "Light from the sides hides most of the difference."],
            compared()?,
            light,
        )
        .with_difference(1, 0, 4.0)
        .with_difference(2, 0, 4.0),
        series(
            SECTION,
            "oren-nayar-series",
            [
                "Oren–Nayar from smooth to very rough",
                "The centre darkens by A, the edge gains by B.",
            ],
            ("σ", [0.0, 0.1, 0.2, 0.4, 0.8]),
            |sigma| Ok(material(OrenNayar::new(gray, sigma)?)),
            moon,
        )?,
        row(
            SECTION,
            "oren-nayar-interreflection",
            [
                "Oren–Nayar with and without interreflection",
                "σ = 0.5: the constant 0.57 in place of 0.33 brightens the surface.",
            ],
            vec![
                ("without, 0.33".into(), material(OrenNayar::new(gray, 0.5)?)),
                ("with, 0.57".into(), material(OrenNayar::with_interreflection(gray, 0.5)?)),
            ],
            moon,
        )
        .with_difference(1, 0, 16.0),
    ])
}
