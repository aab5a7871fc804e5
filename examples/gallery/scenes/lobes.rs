//! Phong's, Blinn's and Schlick's lobes.

use std::error::Error;
use std::f32::consts::PI;

use brdf::{BlinnPhong, ClassicPhong, Lambert, Phong, SchlickPower, WeightedSum};
use glam::Vec3;

use super::{Scene, material, row, series};
use crate::environment::Environment;
use crate::light::Light;
use crate::sphere::Material;

const SECTION: &str = "Lobes around the mirror direction";
/// Reflects 0.9 of the light that falls along the normal.
const SPECULAR: Vec3 = Vec3::splat(0.9);

/// The exponents of a series.
const EXPONENTS: (&str, [f32; 5]) = ("n", [3.0, 10.0, 30.0, 100.0, 1000.0]);

/// A lobe on a dark blue ground, which shows the shape of the sphere.
fn on_ground(lobe: Material) -> Result<Material, Box<dyn Error>> {
    let ground = material(Lambert::new(Vec3::new(0.05, 0.12, 0.3))?);
    Ok(material(WeightedSum::new([(Vec3::splat(0.85), ground), (Vec3::splat(0.15), lobe)])?))
}

pub(super) fn scenes(square: &Environment) -> Result<Vec<Scene<'_>>, Box<dyn Error>> {
    let mut scenes = models(square)?;
    scenes.extend(comparisons(square)?);
    Ok(scenes)
}

type Constructor = fn(f32) -> Result<Material, Box<dyn Error>>;

/// Each model with several exponents.
fn models(square: &Environment) -> Result<Vec<Scene<'_>>, Box<dyn Error>> {
    let light = Light::Around(square);
    let models: [(&str, &str, &str, Constructor); 4] = [
        ("phong", "Phong", "Power of the cosine to the mirror direction, normalised.", |n| {
            Ok(material(Phong::new(SPECULAR, n)?))
        }),
        (
            "classic-phong",
            "Classic Phong",
            "As printed in 1975: the radiance does not fall towards the edge, and without a \
             constant the surface darkens as the exponent grows.",
            |n| Ok(material(ClassicPhong::new(SPECULAR, n)?)),
        ),
        (
            "blinn-phong",
            "Blinn–Phong",
            "Power of the cosine of the half vector, exactly normalised.",
            |n| Ok(material(BlinnPhong::new(SPECULAR, n)?)),
        ),
        (
            "schlick-power",
            "Schlick's power",
            "A rational stand-in for Phong's power: the centre is as bright in the unnormalised \
             form, the tails are heavier.",
            |n| Ok(material(SchlickPower::new(SPECULAR, n)?)),
        ),
    ];
    let mut scenes = Vec::new();
    for (name, title, caption, model) in models {
        let file = format!("{name}-series");
        scenes.push(series(SECTION, &file, [title, caption], EXPONENTS, model, light)?);
    }
    Ok(scenes)
}

fn comparisons(square: &Environment) -> Result<Vec<Scene<'_>>, Box<dyn Error>> {
    let lamp = |degrees: f32| {
        let angle = degrees.to_radians();
        let towards = Vec3::new(angle.sin(), 0.0, angle.cos());
        Light::Distant { towards, irradiance: 2.0 * PI }
    };
    let pair = || -> Result<Vec<(String, Material)>, Box<dyn Error>> {
        Ok(vec![
            ("Phong, n = 15".into(), on_ground(material(Phong::new(SPECULAR, 15.0)?))?),
            ("Blinn–Phong, n = 60".into(), on_ground(material(BlinnPhong::new(SPECULAR, 60.0)?))?),
        ])
    };
    let schlick = |n| -> Result<Material, Box<dyn Error>> {
        on_ground(material(SchlickPower::new(SPECULAR, n)?))
    };
    Ok(vec![
        row(
            SECTION,
            "phong-blinn-square",
            [
                "Phong against Blinn–Phong in the square",
                "Exponents n and 4n: alike where the light is near the viewer. 0.85 Lambert + 0.15 \
                 lobe.",
            ],
            pair()?,
            Light::Around(square),
        )
        .with_difference(1, 0, 4.0),
        row(
            SECTION,
            "phong-blinn-front",
            ["Phong against Blinn–Phong, one lamp", "The two highlights are nearly the same."],
            pair()?,
            lamp(40.0),
        )
        .with_difference(1, 0, 4.0),
        row(
            SECTION,
            "phong-blinn-grazing",
            [
                "Phong against Blinn–Phong, grazing light",
                "Phong's highlight spreads along the edge; Blinn's stays narrow across the plane \
                 of incidence, as reflections on water do.",
            ],
            pair()?,
            lamp(115.0),
        ),
        row(
            SECTION,
            "schlick-phong",
            [
                "Schlick's power against Phong",
                "n = 30: more light in the tail, less in the centre.",
            ],
            vec![
                ("Phong".into(), on_ground(material(Phong::new(SPECULAR, 30.0)?))?),
                ("Schlick".into(), schlick(30.0)?),
            ],
            lamp(40.0),
        )
        .with_difference(1, 0, 4.0),
    ])
}
