//! Draws what boundaries, metals and films do to polarised light.
//!
//! ```sh
//! cargo run --release --example polarization -- --out gallery/polarization
//! ```
//!
//! Reflectances, phases and degrees of polarisation at glass, with the marked angles; Fresnel's rhomb;
//! gold through a polariser; the sky's light on a window; the colours of soap and of an oxide over
//! thickness and angle.

#[allow(dead_code, reason = "colours that only the materials need")]
#[path = "../materials/colors.rs"]
mod colors;
mod curves;
#[allow(dead_code, reason = "marks that only the materials need")]
#[path = "../materials/figure.rs"]
mod figure;
#[allow(dead_code, reason = "captions that only the gallery shows")]
mod films;
#[path = "../materials/folder.rs"]
mod folder;
#[path = "../gallery/lettering.rs"]
mod lettering;
#[allow(dead_code, reason = "a tone curve that only bright pictures need")]
#[path = "../path_tracer/screen.rs"]
mod screen;

use std::error::Error;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let about = "Draws what boundaries, metals and films do to polarised light.";
    let Some(folder) = folder::folder(env::args().skip(1), about, "gallery/polarization")? else {
        return Ok(());
    };
    fs::create_dir_all(&folder)?;
    let figures = [curves::glass()?, curves::rhomb()?, curves::gold()?, curves::sky()?];
    for figure in &figures {
        figure.draw(&folder)?;
    }
    for map in &films::MAPS {
        map.draw(&folder, 1.0)?;
    }
    println!("{} figures in {}", figures.len() + films::MAPS.len(), folder.display());
    Ok(())
}
