//! Pictures and plots of every model, on one page:
//! `cargo run --release --example gallery -- [--out DIR] [--small] [--only WORD]`.
//!
//! `--out` names the folder, `gallery` if nothing is said; `--small` makes tiny pictures of few
//! rays, within seconds, to see that everything runs; `--only` makes the spheres alone whose file has
//! the word in its name, and no page.

mod environment;
#[path = "../polarization/films.rs"]
mod films;
mod index;
mod lettering;
mod light;
mod metal;
mod moon;
mod picture;
#[path = "../path_tracer/plastic.rs"]
mod plastic;
mod plots;
mod prism;
mod ray;
mod scenes;
#[path = "../path_tracer/screen.rs"]
mod screen;
mod solid;
#[allow(dead_code, reason = "light and pigments that only the path tracer needs")]
#[path = "../path_tracer/spectral.rs"]
mod spectral;
mod sphere;
mod square;

use std::error::Error;
use std::path::PathBuf;

use indicatif::{ProgressBar, ProgressStyle};
use sphere::Quality;

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
    only: Option<String>,
}

fn arguments() -> Result<Arguments, String> {
    let mut arguments = Arguments { out: PathBuf::from("gallery"), small: false, only: None };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--small" => arguments.small = true,
            "--out" => arguments.out = words.next().ok_or("--out needs a folder")?.into(),
            "--only" => arguments.only = Some(words.next().ok_or("--only needs a word")?),
            other => {
                return Err(format!(
                    "unknown argument {other}; known: --out DIR, --small, --only WORD"
                ));
            }
        }
    }
    Ok(arguments)
}

fn main() -> Result<(), Box<dyn Error>> {
    let Arguments { out, small, only } = arguments()?;
    std::fs::create_dir_all(&out).map_err(|error| format!("{}: {error}", out.display()))?;
    let square = square::square()?;
    let mut scenes = scenes::all(&square)?;
    if let Some(word) = &only {
        scenes.retain(|scene| scene.picture.file.contains(word));
    }

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
    if only.is_some() {
        bar.finish_and_clear();
        println!("{} pictures: {}", pictures.len(), out.display());
        return Ok(());
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
