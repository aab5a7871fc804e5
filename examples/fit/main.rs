//! Fits models to measured materials and draws them.
//!
//! ```sh
//! cargo run --release --example fit -- --out gallery/fits
//! ```
//!
//! One figure for each material, a small one for two of them, and the tables of residuals and
//! parameters as Markdown. `docs/measured-fits.md` says how the fits are made.

#[allow(dead_code, reason = "colours that only the materials need")]
#[path = "../materials/colors.rs"]
mod colors;
mod curves;
#[allow(dead_code, reason = "marks that only the materials need")]
#[path = "../materials/figure.rs"]
mod figure;
#[path = "../../tests/common/fits/mod.rs"]
mod fits;

use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};

use fits::family::Family;
use indicatif::{ProgressBar, ProgressStyle};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = folder(env::args().skip(1))?;
    fs::create_dir_all(&folder)?;
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} fits {elapsed}")?;
    let count = fits::measured::TITLES.len() * Family::ALL.len();
    let bar = ProgressBar::new(count.try_into()?).with_style(style);
    let rows = fits::all(|| bar.inc(1));
    bar.finish_and_clear();

    let table = fits::table::text(&rows);
    print!("{table}");
    fs::write(folder.join("fits.md"), table)?;
    let figures = curves::all(&rows);
    for figure in &figures {
        figure.draw(&folder)?;
    }
    println!("\n{} figures in {}", figures.len(), folder.display());
    Ok(())
}

/// The folder after `--out`, or `gallery/fits`.
fn folder(mut arguments: impl Iterator<Item = String>) -> Result<PathBuf, String> {
    let mut folder = PathBuf::from("gallery/fits");
    while let Some(argument) = arguments.next() {
        match (argument.as_str(), arguments.next()) {
            ("--out", Some(value)) => folder = value.into(),
            _ => return Err(format!("{argument}: the only option is --out FOLDER")),
        }
    }
    Ok(folder)
}
