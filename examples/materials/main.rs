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
mod list;
mod shortcut;

use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};

use brdf::materials::ALL;
use indicatif::{ProgressBar, ProgressStyle};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = folder(env::args().skip(1))?;
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

/// The folder after `--out`, or `gallery/materials`.
fn folder(mut arguments: impl Iterator<Item = String>) -> Result<PathBuf, String> {
    let mut folder = PathBuf::from("gallery/materials");
    while let Some(argument) = arguments.next() {
        match (argument.as_str(), arguments.next()) {
            ("--out", Some(value)) => folder = value.into(),
            _ => return Err(format!("{argument}: the only option is --out FOLDER")),
        }
    }
    Ok(folder)
}
