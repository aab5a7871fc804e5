//! Pictures and plots of every model, on one page:
//! `cargo run --release --example gallery -- [--out DIR] [--small]`.
//!
//! `--out` names the folder, `gallery` if nothing is said; `--small` makes tiny pictures of few
//! rays, within seconds, to see that everything runs.

mod environment;
mod index;
mod metal;
mod picture;
mod plots;
mod scenes;
mod sphere;

use std::error::Error;
use std::path::PathBuf;

use environment::Environment;
use indicatif::{ProgressBar, ProgressStyle};
use sphere::Quality;

const STUDIO: &[u8] = include_bytes!("data/studio_128x64.hdr");

const INTRODUCTION: &str = "Every model of the crate brdf on a sphere. Unless a caption says \
    otherwise, the light is a photographed studio, with an umbrella at the left and a spotlight \
    behind at the right. Exposure is fixed, so brightnesses compare; the tone curve is 1 − exp(−L), \
    then sRGB. Nothing else is done to the pictures, and no sphere sees another. m is roughness, n \
    an exponent or an index of refraction, σ an angle in radians.";

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
    let studio = Environment::new(STUDIO, TURN, EXPOSURE)?;
    let scenes = scenes::all(&studio)?;

    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg} {elapsed}")?;
    let bar = ProgressBar::new(scenes.len() as u64).with_style(style);
    let mut pictures = Vec::new();
    for scene in scenes {
        bar.set_message(scene.picture.file.clone());
        let quality = match (small, scene.spheres.len()) {
            (true, _) => Quality { tile: 40, rays: 8 },
            (false, 1) => Quality { tile: 288, rays: 96 },
            (false, _) => Quality { tile: 240, rays: 96 },
        };
        let path = out.join(&scene.picture.file);
        sphere::render(&scene.spheres, scene.light, quality)
            .save(&path)
            .map_err(|error| format!("{}: {error}", path.display()))?;
        pictures.push(scene.picture);
        bar.inc(1);
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
    std::fs::write(&page, index::page(INTRODUCTION, &pictures))
        .map_err(|error| format!("{}: {error}", page.display()))?;
    println!("{} pictures: {}", pictures.len(), page.display());
    Ok(())
}

/// Puts the umbrella to the left of the viewer.
const TURN: f32 = 0.288;
/// White paper facing the umbrella has a radiance of about 1.
const EXPOSURE: f32 = 0.4;
