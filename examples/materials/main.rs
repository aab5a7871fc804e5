//! Lists the measured materials and draws their curves.
//!
//! ```sh
//! cargo run --release --example materials -- --out materials
//! ```
//!
//! One figure for each material with its index and its reflectance at normal incidence; figures
//! that compare metals, glasses and second opinions; and the error of one index per channel.

mod colors;
mod comparisons;
mod curves;
#[allow(dead_code, reason = "marks that only the fits need")]
mod figure;
mod folder;
mod list;
mod shortcut;

use std::error::Error;
use std::{env, fs};

use brdf::materials::ALL;
use indicatif::{ProgressBar, ProgressStyle};

fn main() -> Result<(), Box<dyn Error>> {
    let about = "Lists the measured materials and draws their curves.";
    let Some(folder) = folder::folder(env::args().skip(1), about, "gallery/materials")? else {
        return Ok(());
    };
    fs::create_dir_all(&folder)?;
    list::print()?;

    let mut figures = comparisons::all()?;
    figures.push(shortcut::figure()?);
    for material in ALL {
        figures.push(curves::figure(material)?);
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}")?;
    let bar = ProgressBar::new(figures.len().try_into()?).with_style(style);
    for figure in &figures {
        bar.set_message(figure.name.clone());
        figure.draw(&folder)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    println!("\n{} figures in {}", figures.len(), folder.display());
    Ok(())
}
