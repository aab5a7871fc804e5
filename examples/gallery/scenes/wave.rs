//! Rough metal in wave optics.

use brdf::materials::GOLD;
use brdf::{Beckmann, BeckmannKirchhoff, CookTorrance, He1991, SmithCorrelated};
use glam::Vec3;

use super::{Made, material, row};
use crate::environment::Environment;
use crate::light::Light;
use crate::sphere::Tile;

/// The wavelengths of red, green and blue, nm.
const LINES: Vec3 = Vec3::new(650.0, 550.0, 450.0);
/// Slopes of all surfaces.
const ROUGHNESS: f32 = 0.2;

pub(super) fn scene(square: &Environment) -> Made<'_> {
    let gold = GOLD.conductor(LINES)?;
    let words = [
        "Heights against the wavelength",
        "Gold at 650, 550 and 450 nm, slopes of 0.2 throughout: by rays, by Beckmann and Kirchhoff (1963) \
         and by He and others (1991). The lower the heights σ over the wavelength, the clearer the mirror \
         within the haze; red light is mirrored first. He's edge is hidden by shadowing, Beckmann's is not \
         and makes energy.",
    ];
    let mut scene = row("Wave optics", "wave-gold", words, Vec::new(), Light::Around(square));
    let rays = CookTorrance::from_parts(Beckmann::new(ROUGHNESS)?, gold, SmithCorrelated);
    scene.tiles.push(("rays: Beckmann, Smith".into(), Tile::Sphere(material(rays))));
    let waves = BeckmannKirchhoff::new(100.0, 1000.0, gold, LINES)?;
    scene.tiles.push(("Kirchhoff, σ = 100 nm".into(), Tile::Polished(Box::new(waves))));
    for sigma in [200.0, 100.0, 50.0] {
        let waves = He1991::new(sigma, 2.0 * sigma / ROUGHNESS, gold, LINES)?;
        scene.tiles.push((format!("He, σ = {sigma} nm"), Tile::Polished(Box::new(waves))));
    }
    Ok(scene)
}
