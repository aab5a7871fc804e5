//! Draws what boundaries, metals and films do to polarised light.
//!
//! ```sh
//! cargo run --release --example polarization -- --out gallery/polarization
//! ```
//!
//! Reflectances, phases and degrees of polarisation at glass, with the marked angles; Fresnel's rhomb;
//! gold through a polariser; the colours of soap and of an oxide over thickness and angle.

#[allow(dead_code, reason = "colours that only the materials need")]
#[path = "../materials/colors.rs"]
mod colors;
mod curves;
#[allow(dead_code, reason = "marks that only the materials need")]
#[path = "../materials/figure.rs"]
mod figure;
mod films;
#[path = "../materials/folder.rs"]
mod folder;

use std::error::Error;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let about = "Draws what boundaries, metals and films do to polarised light.";
    let Some(folder) = folder::folder(env::args().skip(1), about, "gallery/polarization")? else {
        return Ok(());
    };
    fs::create_dir_all(&folder)?;
    let figures = [curves::glass()?, curves::rhomb()?, curves::gold()?];
    for figure in &figures {
        figure.draw(&folder)?;
    }
    let maps = films::all();
    for map in &maps {
        map.draw(&folder)?;
    }
    println!("{} figures in {}", figures.len() + maps.len(), folder.display());
    Ok(())
}
