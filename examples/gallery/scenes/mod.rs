//! What is shown: materials, light and words.

mod brushed;
mod diffuse;
mod fresnel;
mod glass;
mod lobes;
mod microfacet;
mod moon;
mod showpiece;
mod wave;

use std::error::Error;

use brdf::Brdf;
use glam::Vec3;

use crate::environment::Environment;
use crate::light::Light;
use crate::picture::Picture;
use crate::sphere::{Material, Tile};

/// A picture to be made: a row of spheres under one light.
pub struct Scene<'a> {
    /// What to say about it.
    pub picture: Picture,
    /// From left to right, each with the label under it.
    pub tiles: Vec<(String, Tile)>,
    /// The light on each sphere.
    pub light: Light<'a>,
}

/// A scene, or the parameter that a model refused.
type Made<'a> = Result<Scene<'a>, Box<dyn Error>>;

/// All scenes, in the order of the page.
pub fn all(square: &Environment) -> Result<Vec<Scene<'_>>, Box<dyn Error>> {
    let mut scenes = Vec::new();
    scenes.extend(showpiece::scenes(square)?);
    scenes.extend(glass::scenes(square)?);
    scenes.extend(diffuse::scenes(square)?);
    scenes.extend(moon::scenes()?);
    scenes.extend(lobes::scenes(square)?);
    scenes.extend(microfacet::scenes(square)?);
    scenes.extend(brushed::scenes(square)?);
    scenes.push(wave::scene(square)?);
    scenes.extend(fresnel::scenes(square)?);
    Ok(scenes)
}

fn material(model: impl Brdf<Color = Vec3> + 'static) -> Material {
    Box::new(model)
}

/// One sphere with its label.
fn single<'a>(
    section: &'static str,
    name: &str,
    words: [&str; 2],
    (label, sphere): (&str, Material),
    light: Light<'a>,
) -> Scene<'a> {
    row(section, name, words, vec![(label.into(), sphere)], light)
}

/// Several spheres with a label each.
fn row<'a>(
    section: &'static str,
    name: &str,
    [title, caption]: [&str; 2],
    spheres: Vec<(String, Material)>,
    light: Light<'a>,
) -> Scene<'a> {
    let caption = format!("{caption} {}", light.words());
    let picture = Picture { file: format!("{name}.png"), title: title.into(), caption, section };
    let tiles = spheres.into_iter().map(|(label, sphere)| (label, Tile::Sphere(sphere))).collect();
    Scene { picture, tiles, light }
}

impl Scene<'_> {
    /// Adds a square with the difference of two, given by their places, so many times.
    fn with_difference(mut self, of: usize, minus: usize, times: f32) -> Self {
        let label = {
            let name = |place: usize| self.tiles.get(place).map_or("", |(label, _)| label.as_str());
            format!("{} − {},\n× {times}", name(of), name(minus))
        };
        self.tiles.push((label, Tile::Difference { of, minus, times }));
        self
    }
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
