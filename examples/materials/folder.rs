//! The one option of the examples that draw.

use std::path::PathBuf;

/// The folder after `--out`, or the one that is usual; none if help was asked for and given.
pub fn folder(
    mut arguments: impl Iterator<Item = String>,
    about: &str,
    usual: &str,
) -> Result<Option<PathBuf>, String> {
    let mut folder = PathBuf::from(usual);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "-h" | "--help" => {
                println!("{about}\n\n  --out FOLDER   where the figures go, {usual} if absent");
                return Ok(None);
            }
            "--out" => folder = arguments.next().ok_or("--out needs a folder")?.into(),
            _ => return Err(format!("unknown argument {argument}; known: --out FOLDER, --help")),
        }
    }
    Ok(Some(folder))
}
