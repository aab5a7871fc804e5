//! Distributions and shadowing of microfacets, and the historical forms.

use std::error::Error;

use brdf::{
    Beckmann, Blinn, Blinn1977, Blinn1977Printed, Conductor, Constant, CookTorrance,
    CookTorrance1982Printed, Dielectric, Distribution, Gaussian, Ggx, Lambert, Mixture,
    SmithCorrelated, SmithSeparable, VCavity,
};
use glam::Vec3;

use super::{ROUGHNESSES, Scene, material, row, series, single};
use crate::environment::Environment;
use crate::metal;
use crate::sphere::{Light, Material};

const DISTRIBUTIONS: &str = "Microfacets: distributions";
const SHADOWING: &str = "Microfacets: shadowing";
const HISTORY: &str = "Historical forms";

pub(super) fn scenes<'a>(
    square: &'a Environment,
    furnace: &'a Environment,
) -> Result<Vec<Scene<'a>>, Box<dyn Error>> {
    let (light, furnace) = (Light::Around(square), Light::Around(furnace));
    let mut scenes = distributions(light)?;
    scenes.extend(anisotropy(light)?);
    scenes.extend(shadowing(light, furnace)?);
    scenes.extend(history(light, furnace)?);
    Ok(scenes)
}

/// A metal of these facets with V-cavities.
fn metal(distribution: impl Distribution<f32> + 'static, metal: Conductor) -> Material {
    material(CookTorrance::from_parts(distribution, metal, VCavity))
}

fn mixture(roughness: f32) -> Result<Mixture<f32, Beckmann, 2>, Box<dyn Error>> {
    let (narrow, wide) = (Beckmann::new(roughness)?, Beckmann::new(4.0 * roughness)?);
    Ok(Mixture::new([(0.6, narrow), (0.4, wide)])?)
}

type Constructor = fn(f32) -> Result<Material, Box<dyn Error>>;

fn distributions(light: Light) -> Result<Vec<Scene>, Box<dyn Error>> {
    let models: [(&str, &str, &str, Constructor); 5] = [
        ("gaussian", "Gaussian", "Normal distribution of the angle; α is its 1/e-angle.", |m| {
            Ok(metal(Gaussian::new(m)?, metal::gold()?))
        }),
        ("beckmann", "Beckmann", "Normal distribution of the slope.", |m| {
            Ok(metal(Beckmann::new(m)?, metal::gold()?))
        }),
        (
            "ggx",
            "GGX",
            "Trowbridge and Reitz's ellipsoids: long tails, a glow around lamps.",
            |m| Ok(metal(Ggx::new(m)?, metal::gold()?)),
        ),
        (
            "blinn",
            "Blinn",
            "A power of the cosine, with the exponent 2/α² − 2 that peaks as high as Beckmann's.",
            |m| Ok(metal(Blinn::from_roughness(m)?, metal::gold()?)),
        ),
        (
            "mixture",
            "Mixture",
            "0.6 Beckmann of roughness α + 0.4 of 4α: a sharp reflection in a haze.",
            |m| Ok(metal(mixture(m)?, metal::gold()?)),
        ),
    ];
    let mut scenes = Vec::new();
    for (name, title, caption, model) in models {
        let (file, heading) = (format!("distribution-{name}"), format!("{title}, α = 0.2"));
        scenes.push(single(DISTRIBUTIONS, &file, [&heading, caption], model(0.2)?, light));
    }
    for (name, title, _, model) in models {
        let file = format!("distribution-{name}-series");
        let words = [&format!("{title}: roughness"), "Gold, V-cavity shadowing."];
        scenes.push(series(DISTRIBUTIONS, &file, words, ROUGHNESSES, model, light)?);
    }
    Ok(scenes)
}

fn anisotropy(light: Light) -> Result<Vec<Scene>, Box<dyn Error>> {
    let brushed = |along: f32, across: f32| -> Result<Material, Box<dyn Error>> {
        let model = CookTorrance::new(Ggx::anisotropic(along, across)?, metal::copper()?);
        Ok(material(model.with_shadowing(SmithCorrelated)))
    };
    let spheres = vec![
        ("brushed along the parallels, 0.05 × 0.4".into(), brushed(0.05, 0.4)?),
        ("isotropic, 0.15".into(), brushed(0.15, 0.15)?),
        ("brushed along the meridians, 0.4 × 0.05".into(), brushed(0.4, 0.05)?),
    ];
    let words = [
        "Anisotropic GGX",
        "Brushed copper, Smith's shadowing: the highlight spreads across the scratches. The pole is \
         in view at the top.",
    ];
    Ok(vec![row(DISTRIBUTIONS, "anisotropic-ggx", words, spheres, light)])
}

fn shadowing<'a>(light: Light<'a>, furnace: Light<'a>) -> Result<Vec<Scene<'a>>, Box<dyn Error>> {
    let white = Constant::new(Vec3::ONE)?;
    let smooth = CookTorrance::new(Beckmann::new(0.3)?, metal::silver()?);
    let rough = CookTorrance::new(Ggx::new(0.8)?, white);
    let one = |name: &str, title: &str, sphere| {
        let words = [title, "Silver, Beckmann's distribution, α = 0.3."];
        single(SHADOWING, name, words, sphere, light)
    };
    Ok(vec![
        one("shadowing-v-cavity", "V-cavity", material(smooth.with_shadowing(VCavity))),
        one(
            "shadowing-smith-correlated",
            "Smith, correlated heights",
            material(smooth.with_shadowing(SmithCorrelated)),
        ),
        one(
            "shadowing-smith-separable",
            "Smith, separable",
            material(smooth.with_shadowing(SmithSeparable)),
        ),
        row(
            SHADOWING,
            "shadowing-furnace",
            [
                "A rough mirror in a white furnace",
                "GGX, α = 0.8, F = 1, radiance 1 from everywhere: the picture is the directional \
                 albedo. A surface that lost nothing would look like the white at the left; what \
                 is missing is light that would be reflected more than once.",
            ],
            vec![
                ("white: Lambert, albedo 1".into(), material(Lambert::new(Vec3::ONE)?)),
                ("V-cavity".into(), material(rough.with_shadowing(VCavity))),
                ("Smith correlated".into(), material(rough.with_shadowing(SmithCorrelated))),
                ("Smith separable".into(), material(rough.with_shadowing(SmithSeparable))),
            ],
            furnace,
        ),
        series(
            SHADOWING,
            "shadowing-smith-series",
            ["Roughness with Smith's shadowing", "Silver, GGX, correlated heights."],
            ROUGHNESSES,
            |m| {
                let model = CookTorrance::new(Ggx::new(m)?, metal::silver()?);
                Ok(material(model.with_shadowing(SmithCorrelated)))
            },
            light,
        )?,
    ])
}

fn history<'a>(light: Light<'a>, furnace: Light<'a>) -> Result<Vec<Scene<'a>>, Box<dyn Error>> {
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
            material(frosted),
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
                ("normalised".into(), metal(beckmann, copper)),
                ("as printed".into(), material(CookTorrance1982Printed::new(beckmann, copper))),
            ],
            light,
        ),
        row(
            HISTORY,
            "cook-torrance-1982-furnace",
            [
                "The same in a white furnace",
                "Radiance 1 from everywhere; a surface brighter than the white at the left makes \
                 energy.",
            ],
            vec![
                ("white: Lambert, albedo 1".into(), material(Lambert::new(Vec3::ONE)?)),
                ("normalised".into(), metal(beckmann, copper)),
                ("as printed".into(), material(CookTorrance1982Printed::new(beckmann, copper))),
            ],
            furnace,
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
                ("D₁".into(), material(Blinn1977Printed::d1(wide, copper)?)),
                ("D₂".into(), material(Blinn1977Printed::d2(wide, copper)?)),
                ("D₃".into(), material(Blinn1977Printed::d3(wide, copper)?)),
            ],
            light,
        ),
    ])
}
