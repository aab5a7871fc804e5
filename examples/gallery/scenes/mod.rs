//! What is shown: materials, light and words.

mod diffuse;
mod fresnel;
mod lobes;
mod microfacet;
mod showpiece;

use std::error::Error;

use brdf::Brdf;
use glam::Vec3;

use crate::environment::Environment;
use crate::picture::Picture;
use crate::sphere::{Light, Material};

/// A picture to be made: a row of spheres under one light.
pub struct Scene<'a> {
    /// What to say about it.
    pub picture: Picture,
    /// From left to right.
    pub spheres: Vec<Material>,
    /// The light on each.
    pub light: Light<'a>,
}

/// A scene, or the parameter that a model refused.
type Made<'a> = Result<Scene<'a>, Box<dyn Error>>;

/// All scenes, in the order of the page.
/// `furnace` is light of the same radiance from everywhere.
pub fn all<'a>(
    square: &'a Environment,
    furnace: &'a Environment,
) -> Result<Vec<Scene<'a>>, Box<dyn Error>> {
    let mut scenes = Vec::new();
    scenes.extend(showpiece::scenes(square)?);
    scenes.extend(diffuse::scenes(square)?);
    scenes.extend(lobes::scenes(square)?);
    scenes.extend(microfacet::scenes(square, furnace)?);
    scenes.extend(fresnel::scenes(square, furnace)?);
    Ok(scenes)
}

fn material(model: impl Brdf<Color = Vec3> + 'static) -> Material {
    Box::new(model)
}

/// One sphere.
fn single<'a>(
    section: &'static str,
    name: &str,
    [title, caption]: [&str; 2],
    sphere: Material,
    light: Light<'a>,
) -> Scene<'a> {
    let picture = Picture {
        file: format!("{name}.png"),
        title: title.into(),
        caption: caption.into(),
        section,
    };
    Scene { picture, spheres: vec![sphere], light }
}

/// Several spheres with a label each, which the caption lists.
fn row<'a>(
    section: &'static str,
    name: &str,
    [title, caption]: [&str; 2],
    spheres: Vec<(String, Material)>,
    light: Light<'a>,
) -> Scene<'a> {
    let (labels, spheres): (Vec<_>, Vec<_>) = spheres.into_iter().unzip();
    let caption = format!("{caption} Left to right: {}.", labels.join(" | "));
    let picture = Picture { file: format!("{name}.png"), title: title.into(), caption, section };
    Scene { picture, spheres, light }
}

/// The same model with one number that grows from left to right.
fn series<'a, const N: usize>(
    section: &'static str,
    name: &str,
    words: [&str; 2],
    (symbol, numbers): (&str, [f32; N]),
    model: impl Fn(f32) -> Result<Material, Box<dyn Error>>,
    light: Light<'a>,
) -> Made<'a> {
    let mut spheres = Vec::new();
    for number in numbers {
        spheres.push((format!("{symbol} = {number}"), model(number)?));
    }
    Ok(row(section, name, words, spheres, light))
}

/// The roughnesses of a series.
const ROUGHNESSES: (&str, [f32; 5]) = ("α", [0.05, 0.1, 0.2, 0.4, 0.8]);
