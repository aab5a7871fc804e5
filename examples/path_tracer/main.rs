//! A path tracer with multiple importance sampling, written from the public parts of `brdf`.
//!
//! ```sh
//! cargo run --release --example path_tracer -- --out picture.png
//! cargo run --release --example path_tracer -- --check
//! ```
//!
//! The picture of the crate's front page is `--samples 400 --out docs/gallery.jpg`.
//!
//! `path.rs` is the part to read beside a lecture: light is gathered by directions drawn from the
//! lamps and by directions drawn from the surface, weighed by the power heuristic. It carries
//! sixteen wavelengths, so that metals have the colour of their measured indices. `--check` traces
//! a white furnace instead, whose every pixel must be 1, and the same surface under a lamp by each
//! of the two ways of drawing alone.

mod check;
mod draws;
mod film;
mod light;
mod path;
mod plastic;
mod scene;
mod screen;
mod shape;
mod spectral;
mod studio;

use std::error::Error;
use std::path::PathBuf;

use film::Film;
use indicatif::{ProgressBar, ProgressStyle};

const HELP: &str = "Traces the paths of light in a small studio.

  --out FILE     the picture, .png or .jpg, path_tracer.png if absent
  --width N      its width in pixels, 1200 if absent; the height is half of it
  --samples N    paths through each pixel, 256 if absent
  --small        120 pixels and 16 paths, to see that everything runs
  --check        measures what is known instead of making a picture";

struct Arguments {
    out: PathBuf,
    width: u32,
    samples: u32,
    check: bool,
}

/// What was asked for; nothing if that was help.
fn arguments(mut words: impl Iterator<Item = String>) -> Result<Option<Arguments>, String> {
    let mut parsed =
        Arguments { out: "path_tracer.png".into(), width: 1200, samples: 256, check: false };
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or(format!("{word} needs a value"));
        let count = |text: String| match text.parse() {
            Ok(count @ 1..=65536) => Ok(count),
            _ => Err(format!("{word} must be between 1 and 65536, not {text}")),
        };
        match word.as_str() {
            "--out" => parsed.out = value()?.into(),
            "--width" => parsed.width = value().and_then(count)?,
            "--samples" => parsed.samples = value().and_then(count)?,
            "--small" => (parsed.width, parsed.samples) = (120, 16),
            "--check" => parsed.check = true,
            "-h" | "--help" => {
                println!("{HELP}");
                return Ok(None);
            }
            _ => return Err(format!("unknown argument {word}\n{HELP}")),
        }
    }
    Ok(Some(parsed))
}

fn main() -> Result<(), Box<dyn Error>> {
    let Some(Arguments { out, width, samples, check }) = arguments(std::env::args().skip(1))?
    else {
        return Ok(());
    };
    if check {
        return check::all();
    }
    let film = Film { width, height: width.div_ceil(2), samples };
    let (scene, camera) = (studio::scene()?, studio::camera());
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} rows {elapsed}, {eta} left")?;
    let bar = ProgressBar::new(film.height.into()).with_style(style);
    let picture = film.expose(
        &camera,
        |ray, draws| path::radiance(&scene, ray, draws),
        || {
            bar.inc(1);
        },
    )?;
    bar.finish_and_clear();
    film::save(&picture, &out).map_err(|error| format!("{}: {error}", out.display()))?;
    println!("{}", out.display());
    Ok(())
}
