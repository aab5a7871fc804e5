//! Gold through the history of reflectance models, on one page:
//! `cargo run --release --example history -- [--out DIR] [--small]`.
//!
//! For each model a sphere, its lobes, what it added and what a call of it costs, which is measured here. `--out`
//! names the folder, `gallery/history` if nothing is said; `--small` makes tiny pictures and measures
//! little, within seconds, to see that everything runs. What is said of the models is that of
//! `docs/history.md`, of which the pictures and the table are written too.

mod cost;
#[path = "../gallery/environment.rs"]
mod environment;
#[path = "../gallery/index.rs"]
mod index;
#[path = "../gallery/lettering.rs"]
mod lettering;
#[allow(dead_code, reason = "light that only the gallery needs")]
#[path = "../gallery/light.rs"]
mod light;
#[path = "../gallery/picture.rs"]
mod picture;
mod plots;
#[path = "../gallery/ray.rs"]
mod ray;
#[path = "../path_tracer/screen.rs"]
mod screen;
#[allow(dead_code, reason = "glass that only the gallery needs")]
#[path = "../gallery/solid.rs"]
mod solid;
#[allow(dead_code, reason = "squares that only the gallery needs")]
#[path = "../gallery/sphere.rs"]
mod sphere;
#[path = "../gallery/square.rs"]
mod square;
mod steps;
mod words;

use std::error::Error;
use std::path::{Path, PathBuf};

use cost::Cost;
use image::{RgbImage, imageops};
use light::Light;
use picture::Picture;
use sphere::{Quality, Tile};
use steps::Step;

const INTRODUCTION: &str = "One piece of gold with slopes of 0.3, by the models in the order in which they \
    were found. The light is that of the gallery: a photographed square under an overcast sky, and a lamp; \
    the exposure is fixed. Lobes are values at 550 nm in the plane of incidence; the light comes from the \
    left. Times are those of calls through a pointer on the machine that made this page.";

/// Spheres in a row of the picture of all.
const COLUMNS: usize = 4;

fn arguments() -> Result<(PathBuf, bool), String> {
    let (mut out, mut small) = (PathBuf::from("gallery/history"), false);
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--small" => small = true,
            "--out" => out = words.next().ok_or("--out needs a folder")?.into(),
            other => return Err(format!("unknown argument {other}; known: --out DIR, --small")),
        }
    }
    Ok((out, small))
}

fn main() -> Result<(), Box<dyn Error>> {
    let (out, small) = arguments()?;
    std::fs::create_dir_all(&out).map_err(|error| format!("{}: {error}", out.display()))?;
    let steps = steps::all()?;
    let chapters = words::chapters(steps.len())?;
    let costs = cost::all(&steps, small);
    let quality =
        if small { Quality { tile: 40, rays: 16 } } else { Quality { tile: 300, rays: 64 } };

    let square = square::square()?;
    let (mut pictures, mut spheres) = (Vec::new(), Vec::new());
    for (place, step) in steps.iter().enumerate() {
        let chapter = &chapters[place];
        let tile = Tile::Polished(Box::new(step.model.clone()));
        let label = (step.label.to_owned(), tile);
        let sphere = sphere::render(&[label], Light::Around(&square), quality)?;
        let file = format!("{}.png", step.file);
        save(&sphere, &out.join(&file))?;
        spheres.push(sphere);
        let caption = format!("{} {}", chapter.text, costs[place]);
        pictures.push(Picture {
            file,
            title: step.label.into(),
            caption,
            section: chapter.heading,
        });
        let before = place.checked_sub(1).map(|before| &steps[before]);
        pictures.push(plots::step(step, before, chapter.heading, &out)?);
    }
    save(&together(&spheres), &out.join("history.jpg"))?;
    plots::all(&steps, &out)?;

    let page = out.join("index.html");
    let links = [index::GALLERY];
    std::fs::write(&page, index::page("History", INTRODUCTION, &links, &pictures))
        .map_err(|error| format!("{}: {error}", page.display()))?;
    println!("{}", table(&chapters, &steps, &costs));
    println!("{} steps: {}", steps.len(), page.display());
    Ok(())
}

fn save(picture: &RgbImage, path: &Path) -> Result<(), String> {
    picture.save(path).map_err(|error| format!("{}: {error}", path.display()))
}

/// All spheres in one picture.
fn together(spheres: &[RgbImage]) -> RgbImage {
    let (width, height) = spheres.first().map_or((1, 1), RgbImage::dimensions);
    let rows = spheres.len().div_ceil(COLUMNS);
    let mut all = RgbImage::new(width * COLUMNS as u32, height * rows as u32);
    for (place, sphere) in spheres.iter().enumerate() {
        let (x, y) = ((place % COLUMNS) as u32 * width, (place / COLUMNS) as u32 * height);
        imageops::replace(&mut all, sphere, x.into(), y.into());
    }
    all
}

/// The table of `docs/history.md`.
fn table(chapters: &[words::Chapter], steps: &[Step], costs: &[Cost]) -> String {
    let mut table = String::from("| step | `eval` | `pdf` | `sample` |\n|---|---|---|---|\n");
    for ((chapter, step), cost) in chapters.iter().zip(steps).zip(costs) {
        let [eval, pdf, sample] = cost.0;
        let year = chapter.heading.split(':').next().unwrap_or_default();
        table += &format!("| {year} {} | {eval:.0} | {pdf:.0} | {sample:.0} |\n", step.label);
    }
    table
}
