//! Bakes the tables that renderers look up instead of integrating: the split-sum terms of GGX, and
//! with them its directional albedo.
//!
//! ```sh
//! cargo run --release --example tables -- --size 128 --samples 4096 --out tables
//! ```
//!
//! Writes `ggx.dfg`, whose format `file.rs` describes, and `ggx.png`, a picture of it.

mod bake;
mod chart;
mod file;
#[path = "../gallery/lettering.rs"]
mod lettering;

use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;
use std::{env, fs};

use bake::{Lattice, Memory, middle};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

struct Arguments {
    size: usize,
    samples: usize,
    out: PathBuf,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Arguments { size, samples, out } = arguments(env::args().skip(1))?;
    fs::create_dir_all(&out)?;
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} rows, {eta} left")?;
    let bar = ProgressBar::new(size.try_into()?).with_style(style);
    let lattice = Lattice::new(samples);
    let start = Instant::now();
    let rows = (0..size).into_par_iter().map(|row| {
        let mut memory = Memory::new(&lattice);
        let cells = (0..size)
            .map(|column| {
                let (roughness, cos_theta) = (middle(row, size), middle(column, size));
                bake::cell(roughness, cos_theta, &lattice, &mut memory)
                    .map_err(|error| format!("roughness {roughness}: {error}"))
            })
            .collect::<Result<Vec<_>, String>>();
        bar.inc(1);
        cells
    });
    let rows = rows.collect::<Result<Vec<_>, String>>()?;
    bar.finish_and_clear();
    let each = start.elapsed().as_secs_f64() * 1e9 / (size * size * samples) as f64;
    fs::write(out.join("ggx.dfg"), file::bytes(&rows))?;
    chart::draw(&rows, &out.join("ggx.png"))?;
    println!("ggx.dfg and ggx.png in {}, {each:.1} ns a sample", out.display());
    Ok(())
}

fn arguments(mut arguments: impl Iterator<Item = String>) -> Result<Arguments, String> {
    let mut parsed = Arguments { size: 64, samples: 1024, out: "tables".into() };
    while let Some(name) = arguments.next() {
        let value = arguments.next().ok_or(format!("{name} needs a value"))?;
        let count = || match value.parse() {
            Ok(count @ 1..=65536) => Ok(count),
            _ => Err(format!("{name} must be between 1 and 65536, not {value}")),
        };
        match name.as_str() {
            "--size" => parsed.size = count()?,
            "--samples" => parsed.samples = count()?,
            "--out" => parsed.out = value.into(),
            _ => return Err(format!("{name}: the options are --size, --samples and --out")),
        }
    }
    Ok(parsed)
}
