//! Distributions and shadowing of microfacets, and the historical forms.

use std::error::Error;

use brdf::{
    Beckmann, Blinn, Blinn1977, Blinn1977Printed, Conductor, Constant, CookTorrance,
    CookTorrance1982Printed, Dielectric, Distribution, Gaussian, Ggx, Lambert, Mixture, Smith,
    SmithCorrelated, SmithSeparable, VCavity,
};
use glam::Vec3;

use super::{ROUGHNESSES, Scene, material, row, series, single};
use crate::environment::Environment;
use crate::light::Light;
use crate::metal;
use crate::spectral::Spectral;
use crate::sphere::Material;

const DISTRIBUTIONS: &str = "Microfacets: distributions";
const SHADOWING: &str = "Microfacets: shadowing";
const HISTORY: &str = "Historical forms";

pub(super) fn scenes(square: &Environment) -> Result<Vec<Scene<'_>>, Box<dyn Error>> {
    let light = Light::Around(square);
    let mut scenes = distributions(light)?;
    scenes.push(alike(light)?);
    scenes.extend(anisotropy(light)?);
    scenes.extend(shadowing(light)?);
    scenes.extend(history(light)?);
    Ok(scenes)
}

/// A metal of these facets with V-cavities.
fn metal(
    distribution: impl Distribution<f32> + 'static,
    metal: Conductor<Spectral>,
) -> Result<Material, Box<dyn Error>> {
    Ok(metal::facets(distribution, metal, VCavity)?)
}

fn mixture(roughness: f32) -> Result<Mixture<f32, Beckmann, 2>, Box<dyn Error>> {
    let (narrow, wide) = (Beckmann::new(roughness)?, Beckmann::new(4.0 * roughness)?);
    Ok(Mixture::new([(0.6, narrow), (0.4, wide)])?)
}

type Constructor = fn(f32) -> Result<Material, Box<dyn Error>>;

fn distributions(light: Light) -> Result<Vec<Scene>, Box<dyn Error>> {
    let models: [(&str, &str, &str, Constructor); 5] = [
        ("gaussian", "Gaussian", "Normal distribution of the angle; α is its 1/e-angle.", |m| {
            metal(Gaussian::new(m)?, metal::gold()?)
        }),
        ("beckmann", "Beckmann", "Normal distribution of the slope.", |m| {
            metal(Beckmann::new(m)?, metal::gold()?)
        }),
        (
            "ggx",
            "GGX",
            "Trowbridge and Reitz's ellipsoids: long tails, a glow around lamps.",
            |m| metal(Ggx::new(m)?, metal::gold()?),
        ),
        (
            "blinn",
            "Blinn",
            "A power of the cosine, with the exponent 2/α² − 2 that peaks as high as Beckmann's.",
            |m| metal(Blinn::from_roughness(m)?, metal::gold()?),
        ),
        (
            "mixture",
            "Mixture",
            "0.6 Beckmann of roughness α + 0.4 of 4α: a sharp reflection in a haze.",
            |m| metal(mixture(m)?, metal::gold()?),
        ),
    ];
    let mut scenes = Vec::new();
    for (name, title, caption, model) in models {
        let file = format!("distribution-{name}-series");
        let caption = &format!("{caption} Gold, V-cavity shadowing.");
        let words = [title, caption.as_str()];
        scenes.push(series(DISTRIBUTIONS, &file, words, ROUGHNESSES, model, light)?);
    }
    Ok(scenes)
}

/// Distributions whose pictures look alike.
fn alike(light: Light) -> Result<Scene, Box<dyn Error>> {
    let words = [
        "Beckmann, Blinn and the Gaussian",
        "Gold, V-cavity shadowing, α = 0.2: three bells of the same width.",
    ];
    let spheres = vec![
        ("Beckmann".into(), metal(Beckmann::new(0.2)?, metal::gold()?)?),
        ("Gaussian".into(), metal(Gaussian::new(0.2)?, metal::gold()?)?),
        ("Blinn".into(), metal(Blinn::from_roughness(0.2)?, metal::gold()?)?),
    ];
    Ok(row(DISTRIBUTIONS, "distributions-alike", words, spheres, light)
        .with_difference(1, 0, 8.0)
        .with_difference(2, 0, 8.0))
}

fn anisotropy(light: Light) -> Result<Vec<Scene>, Box<dyn Error>> {
    let brushed = |along: f32, across: f32| -> Result<Material, Box<dyn Error>> {
        Ok(metal::facets(Ggx::anisotropic(along, across)?, metal::copper()?, SmithCorrelated)?)
    };
    let spheres = vec![
        ("along the parallels, 0.05 × 0.4".into(), brushed(0.05, 0.4)?),
        ("isotropic, 0.15".into(), brushed(0.15, 0.15)?),
        ("along the meridians, 0.4 × 0.05".into(), brushed(0.4, 0.05)?),
    ];
    let words = [
        "Anisotropic GGX",
        "Copper, brushed along the parallels or the meridians, Smith's shadowing: the highlight \
         spreads across the scratches. The pole is in view at the top.",
    ];
    Ok(vec![row(DISTRIBUTIONS, "anisotropic-ggx", words, spheres, light)])
}

fn shadowing(light: Light) -> Result<Vec<Scene>, Box<dyn Error>> {
    let white = Constant::new(Vec3::ONE)?;
    let rough = CookTorrance::new(Ggx::new(0.8)?, white);
    fn compared<D: Smith + Copy + 'static>(
        d: D,
    ) -> Result<Vec<(String, Material)>, Box<dyn Error>> {
        Ok(vec![
            ("V-cavity".into(), metal::facets(d, metal::silver()?, VCavity)?),
            ("Smith correlated".into(), metal::facets(d, metal::silver()?, SmithCorrelated)?),
            ("Smith separable".into(), metal::facets(d, metal::silver()?, SmithSeparable)?),
        ])
    }
    let terms = |name: &str, words, spheres| {
        row(SHADOWING, name, words, spheres, light)
            .with_difference(1, 0, 4.0)
            .with_difference(2, 1, 16.0)
    };
    Ok(vec![
        terms(
            "shadowing-beckmann",
            [
                "Three shadowings, Beckmann",
                "Silver, α = 0.6: its tails are so short that the correlation of heights hardly \
                 counts. V-cavities draw other facets than Smith's surface, which adds noise.",
            ],
            compared(Beckmann::new(0.6)?)?,
        ),
        terms(
            "shadowing-ggx",
            [
                "Three shadowings, GGX",
                "Silver, α = 0.6: Smith's surface hides more, the separable form most.",
            ],
            compared(Ggx::new(0.6)?)?,
        ),
        row(
            SHADOWING,
            "shadowing-furnace",
            [
                "A rough mirror in a white furnace",
                "GGX, α = 0.8, F = 1: the picture is the directional albedo. A surface that loses \
                 nothing cannot be seen, as the one at the left; what is missing from the others is \
                 light that would be reflected more than once.",
            ],
            vec![
                ("Lambert, albedo 1: not seen".into(), material(Lambert::new(Vec3::ONE)?)),
                ("V-cavity".into(), material(rough.with_shadowing(VCavity))),
                ("Smith correlated".into(), material(rough.with_shadowing(SmithCorrelated))),
                ("Smith separable".into(), material(rough.with_shadowing(SmithSeparable))),
            ],
            Light::Furnace,
        ),
        series(
            SHADOWING,
            "shadowing-smith-series",
            ["Roughness with Smith's shadowing", "Silver, GGX, correlated heights."],
            ROUGHNESSES,
            |m| Ok(metal::facets(Ggx::new(m)?, metal::silver()?, SmithCorrelated)?),
            light,
        )?,
    ])
}

fn history(light: Light) -> Result<Vec<Scene>, Box<dyn Error>> {
    let frosted = CookTorrance::torrance_sparrow_1967(0.05, Dielectric::new(Vec3::splat(1.5))?)?;
    let (beckmann, copper) = (Beckmann::new(0.4)?, metal::copper()?);
    let wide = Blinn1977::new(0.3)?;
    Ok(vec![
        single(
            HISTORY,
            "torrance-sparrow",
            [
                "Torrance–Sparrow 1967",
                "Ground glass: c = 0.05 per degree, which is a Gaussian of α = 20°; index 1.5, \
                 surface reflection only.",
            ],
            ("ground glass", material(frosted)),
            light,
        ),
        row(
            HISTORY,
            "cook-torrance-1982",
            [
                "Cook–Torrance: right and as printed in 1982",
                "Copper, α = 0.4. The printed constants make the surface four times too bright: it \
                 reflects more light than it receives.",
            ],
            vec![
                ("normalised".into(), metal(beckmann, copper)?),
                ("as printed".into(), metal::seen(CookTorrance1982Printed::new(beckmann, copper))?),
            ],
            light,
        ),
        row(
            HISTORY,
            "cook-torrance-1982-furnace",
            [
                "The same in a white furnace",
                "A surface that is brighter than the white around it makes energy.",
            ],
            vec![
                ("Lambert, albedo 1: not seen".into(), material(Lambert::new(Vec3::ONE)?)),
                ("normalised".into(), metal(beckmann, copper)?),
                ("as printed".into(), metal::seen(CookTorrance1982Printed::new(beckmann, copper))?),
            ],
            Light::Furnace,
        ),
        row(
            HISTORY,
            "blinn-1977",
            [
                "Blinn 1977 as printed",
                "Copper, the three distributions unnormalised, each half as high at 0.3 rad; too \
                 bright or too dark, as the constant has it.",
            ],
            vec![
                ("D₁".into(), metal::seen(Blinn1977Printed::d1(wide, copper)?)?),
                ("D₂".into(), metal::seen(Blinn1977Printed::d2(wide, copper)?)?),
                ("D₃".into(), metal::seen(Blinn1977Printed::d3(wide, copper)?)?),
            ],
            light,
        ),
    ])
}
