//! Fits models to measured materials and draws them.
//!
//! ```sh
//! cargo run --release --example fit -- --out gallery/fits
//! ```
//!
//! `index.html` shows one figure for each material; beside it lie a small figure of two of them
//! and the tables of residuals and parameters as Markdown. `docs/measured-fits.md` says how the fits are made.

#[allow(dead_code, reason = "colours that only the materials need")]
#[path = "../materials/colors.rs"]
mod colors;
mod curves;
#[allow(dead_code, reason = "marks that only the materials need")]
#[path = "../materials/figure.rs"]
mod figure;
#[path = "../materials/folder.rs"]
mod folder;
#[path = "../gallery/index.rs"]
mod index;
mod metal;
#[path = "../gallery/picture.rs"]
mod picture;

use std::error::Error;
use std::{env, fs};

use brdf_checks::fits::{self, family::Family};
use indicatif::{ProgressBar, ProgressStyle};
use picture::Picture;

const INTRODUCTION: &str = "Models of the crate brdf fitted to measured materials. The tables of \
    residuals and parameters are in fits.md beside this page.";

fn main() -> Result<(), Box<dyn Error>> {
    let about = "Fits models to measured materials and draws them beside the measurements.";
    let Some(folder) = folder::folder(env::args().skip(1), about, "gallery/fits")? else {
        return Ok(());
    };
    fs::create_dir_all(&folder)?;
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} fits {elapsed}")?;
    let count = fits::measured::TITLES.len() * Family::ALL.len();
    let bar = ProgressBar::new(count.try_into()?).with_style(style);
    let rows = fits::all(|| bar.inc(1));
    bar.finish_and_clear();

    println!("n and k at 550 nm from the reflectance every 5°, with a noise of 0.001:\n");
    println!("{}", metal::table()?);
    let table = fits::table::text(&rows);
    print!("{table}");
    fs::write(folder.join("fits.md"), table)?;
    let figures = curves::all(&rows);
    for figure in &figures {
        figure.draw(&folder)?;
    }
    let picture = |figure: &figure::Figure| Picture {
        file: format!("{}.svg", figure.name),
        title: figure.title.clone(),
        caption: figure.subtitle.clone(),
        section: "Measured points and fitted curves",
    };
    let pictures: Vec<Picture> = figures.iter().map(picture).collect();
    let page = folder.join("index.html");
    let title = "Models fitted to measured materials";
    fs::write(&page, index::page(title, INTRODUCTION, &[index::GALLERY], &pictures))?;
    println!("\n{} figures: {}", figures.len(), page.display());
    Ok(())
}
