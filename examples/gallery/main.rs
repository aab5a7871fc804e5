//! Pictures and plots of every model, on one page:
//! `cargo run --release --example gallery -- [--out DIR] [--small]`.

mod picture;
mod plots;

use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let out = PathBuf::from("gallery");
    std::fs::create_dir_all(&out)?;
    let pictures = plots::all(&out, &|_| {})?;
    println!("{} pictures in {}", pictures.len(), out.display());
    Ok(())
}
