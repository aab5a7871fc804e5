//! Lists the materials whose index was measured and draws their curves.
//!
//! ```sh
//! cargo run --release --example materials -- --out materials
//! ```
//!
//! `index.html` shows one figure for each material with its index and its reflectance at normal incidence; figures
//! that compare metals, glasses and second opinions; and the error of one index per channel.

mod colors;
mod comparisons;
mod curves;
#[allow(dead_code, reason = "marks that only the fits need")]
mod figure;
mod folder;
#[path = "../gallery/index.rs"]
mod index;
mod list;
#[path = "../gallery/picture.rs"]
mod picture;
mod shortcut;

use std::error::Error;
use std::{env, fs};

use brdf::materials::{ALL, Kind};
use figure::Figure;
use indicatif::{ProgressBar, ProgressStyle};
use picture::Picture;

const INTRODUCTION: &str = "The measured refractive indices that the crate brdf carries, with the \
    reflectance at normal incidence that follows from them.";

/// The heading under which materials of a kind stand.
const fn section(kind: Kind) -> &'static str {
    match kind {
        Kind::Metal => "Metals",
        Kind::Alloy => "Alloys",
        Kind::Semiconductor => "Semiconductors",
        Kind::Dielectric => "Transparent media",
        Kind::Alternative => "Second opinions",
        Kind::Caution => "Not to be used for colour",
        _ => "Others",
    }
}

fn picture(figure: &Figure, section: &'static str) -> Picture {
    Picture {
        file: format!("{}.svg", figure.name),
        title: figure.title.clone(),
        caption: figure.subtitle.clone(),
        section,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let about = "Lists the materials whose index was measured and draws their curves.";
    let Some(folder) = folder::folder(env::args().skip(1), about, "gallery/materials")? else {
        return Ok(());
    };
    fs::create_dir_all(&folder)?;
    list::print()?;

    let mut figures = Vec::new();
    for figure in comparisons::all()?.into_iter().chain([shortcut::figure()?]) {
        figures.push(("Comparisons", figure));
    }
    for material in ALL {
        figures.push((section(material.kind()), curves::figure(material)?));
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}")?;
    let bar = ProgressBar::new(figures.len().try_into()?).with_style(style);
    for (_, figure) in &figures {
        bar.set_message(figure.name.clone());
        figure.draw(&folder)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    let pictures: Vec<Picture> =
        figures.iter().map(|(section, figure)| picture(figure, section)).collect();
    let page = folder.join("index.html");
    fs::write(
        &page,
        index::page("Refractive indices", INTRODUCTION, &[index::GALLERY], &pictures),
    )?;
    println!("\n{} figures: {}", figures.len(), page.display());
    Ok(())
}
