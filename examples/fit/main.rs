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
#[path = "../materials/folder.rs"]
mod folder;

use std::error::Error;
use std::{env, fs};

use brdf_checks::fits::{self, family::Family};
use indicatif::{ProgressBar, ProgressStyle};

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
