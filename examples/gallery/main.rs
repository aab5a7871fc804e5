//! Pictures and plots of every model, on one page:
//! `cargo run --release --example gallery -- [--out DIR] [--small]`.
//!
//! `--out` names the folder, `gallery` if nothing is said; `--small` makes tiny pictures of few
//! rays, within seconds, to see that everything runs.

mod environment;
#[path = "../polarization/films.rs"]
mod films;
mod index;
mod lettering;
mod metal;
mod picture;
#[path = "../path_tracer/plastic.rs"]
mod plastic;
mod plots;
mod prism;
mod scenes;
#[path = "../path_tracer/screen.rs"]
mod screen;
mod solid;
#[allow(dead_code, reason = "light and pigments that only the path tracer needs")]
#[path = "../path_tracer/spectral.rs"]
mod spectral;
mod sphere;

use std::error::Error;
use std::path::PathBuf;

use environment::{Environment, Lamp};
use glam::Vec3;
use indicatif::{ProgressBar, ProgressStyle};
use sphere::Quality;

const SQUARE: &[u8] = include_bytes!("data/city_256x128.hdr");

/// Puts the brightest clouds to the left of the viewer and the buildings behind.
const TURN: f32 = 0.1;
/// White balance: a little warm, as the eye would have it.
const EXPOSURE: Vec3 = Vec3::new(0.475, 0.45, 0.36);
/// A round lamp before the square, at the left above the viewer's shoulder.
const LAMP: Lamp =
    Lamp { towards: Vec3::new(-0.5, 0.62, 0.6), radius: 0.2, radiance: Vec3::new(13.0, 11.5, 9.0) };

const INTRODUCTION: &str = "Every model of the crate brdf on a sphere, and its formulas as plots. \
    The square is a photographed one under an overcast sky, and the lamp is round and warm, above \
    at the left. Exposure is fixed, so brightnesses compare. Colours whose largest channel is at most 0.76 \
    are shown as they are; brighter ones bend towards white. No sphere sees another. Where \
    spheres look alike, a square shows the difference of the pictures' values, so many times, on \
    grey. α is roughness, n an exponent or an index of refraction, σ an angle in radians.";

/// Other pages: where they are from this one, what is on them, and the example that makes them.
const PAGES: [index::Link; 2] = [
    index::Link {
        page: "materials/index.html",
        title: "Refractive indices",
        made_by: "cargo run --release --example materials",
    },
    index::Link {
        page: "fits/index.html",
        title: "Models fitted to measured materials",
        made_by: "cargo run --release --example fit",
    },
];

struct Arguments {
    out: PathBuf,
    small: bool,
}

fn arguments() -> Result<Arguments, String> {
    let mut arguments = Arguments { out: PathBuf::from("gallery"), small: false };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--small" => arguments.small = true,
            "--out" => arguments.out = words.next().ok_or("--out needs a folder")?.into(),
            other => return Err(format!("unknown argument {other}; known: --out DIR, --small")),
        }
    }
    Ok(arguments)
}

fn main() -> Result<(), Box<dyn Error>> {
    let Arguments { out, small } = arguments()?;
    std::fs::create_dir_all(&out).map_err(|error| format!("{}: {error}", out.display()))?;
    let square = Environment::new(SQUARE, TURN, EXPOSURE, LAMP)?;
    let scenes = scenes::all(&square)?;

    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg} {elapsed}")?;
    let bar = ProgressBar::new(scenes.len() as u64).with_style(style);
    let mut pictures = Vec::new();
    for scene in scenes {
        bar.set_message(scene.picture.file.clone());
        let quality = match small {
            true => Quality { tile: 40, rays: 16 },
            false => Quality { tile: 300, rays: 32 },
        };
        let path = out.join(&scene.picture.file);
        sphere::render(&scene.tiles, scene.light, quality)?
            .save(&path)
            .map_err(|error| format!("{}: {error}", path.display()))?;
        pictures.push(scene.picture);
        bar.inc(1);
    }
    let prism = prism::draw(&out, if small { 40 } else { 400 })?;
    pictures.push(prism);
    for map in &films::MAPS {
        map.draw(&out, if small { 0.1 } else { 1.0 })?;
        let (file, title) = (format!("{}.png", map.name), map.title.to_owned());
        let caption = map.caption.to_owned();
        pictures.push(picture::Picture { file, title, caption, section: "Glass and films" });
    }
    // How many plots there are, they alone know.
    let plots = plots::all(&out, &|name| {
        bar.set_message(name.to_owned());
        bar.inc_length(1);
        bar.inc(1);
    })?;
    pictures.extend(plots);
    bar.finish_and_clear();

    let page = out.join("index.html");
    std::fs::write(&page, index::page("Reflectance models", INTRODUCTION, &PAGES, &pictures))
        .map_err(|error| format!("{}: {error}", page.display()))?;
    println!("{} pictures: {}", pictures.len(), page.display());
    Ok(())
}
