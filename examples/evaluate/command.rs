//! The command line.

use std::ffi::OsString;
use std::fs::File;
use std::io::{self, BufReader, Read, Write};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::question::Precision;
use crate::stream::{Tally, answer_all};

const USAGE: &str = "\
Answers questions about reflectance: lines of JSON in, lines of JSON out.

Usage: evaluate [--f32 | --f64] [FILE]

  FILE    questions, one a line; standard input if absent or -
  --f64   compute in double precision (default)
  --f32   compute in single precision

A line has at most 1 MiB; blank lines are no questions. A line without an answer is answered by an
error with its number, and the run goes on. Exit status: 0 if every question has an answer, 1 if one
has not, 2 if questions cannot be read or answers not be written.";

/// The standard streams, or what stands for them.
pub struct Streams<R, W, E> {
    pub input: R,
    pub output: W,
    pub errors: E,
    pub progress: ProgressDrawTarget,
}

/// The exit status: 0 if every question has an answer, 1 if one has not, 2 if questions cannot be
/// read or answers not be written.
pub fn run<R: Read, W: Write, E: Write>(
    words: impl IntoIterator<Item = OsString>,
    mut streams: Streams<R, W, E>,
) -> u8 {
    match attempt(words, &mut streams) {
        Ok(status) => status,
        // Whoever reads the answers has seen enough.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => 2,
        Err(error) => {
            // If this cannot be written either, the status is all that is left to say it.
            let _ = writeln!(streams.errors, "{error}");
            2
        }
    }
}

fn attempt<R: Read, W: Write, E: Write>(
    words: impl IntoIterator<Item = OsString>,
    streams: &mut Streams<R, W, E>,
) -> io::Result<u8> {
    let mut precision = Precision::Double;
    let mut file = None;
    for word in words {
        match word.to_str() {
            Some("--f32") => precision = Precision::Single,
            Some("--f64") => precision = Precision::Double,
            Some("-h" | "--help") => {
                writeln!(streams.output, "{USAGE}")?;
                return Ok(0);
            }
            Some(option) if option.starts_with("--") => {
                writeln!(streams.errors, "unknown option {option}\n\n{USAGE}")?;
                return Ok(2);
            }
            _ if file.is_none() => file = Some(word),
            _ => {
                writeln!(streams.errors, "more than one file\n\n{USAGE}")?;
                return Ok(2);
            }
        }
    }
    let tally = match file {
        Some(path) if path != "-" => {
            let file = File::open(&path).map_err(|error| {
                io::Error::new(error.kind(), format!("{}: {error}", path.display()))
            })?;
            // Of a pipe the length is not known; it counts as 0.
            let length = file.metadata().map_or(0, |data| data.len());
            let progress = bar(Some(length).filter(|length| *length > 0), streams);
            answer(file, &mut streams.output, precision, &progress)
        }
        _ => {
            let progress = bar(None, streams);
            answer(&mut streams.input, &mut streams.output, precision, &progress)
        }
    }?;
    if tally.failed == 0 {
        return Ok(0);
    }
    writeln!(streams.errors, "{} of {} questions have no answer", tally.failed, tally.questions)?;
    Ok(1)
}

/// A progress bar, which hides itself where its target is no terminal.
fn bar<R, W, E>(length: Option<u64>, streams: &mut Streams<R, W, E>) -> ProgressBar {
    let target = std::mem::replace(&mut streams.progress, ProgressDrawTarget::hidden());
    let progress = ProgressBar::with_draw_target(length, target);
    let style = match length {
        Some(_) => "{wide_bar} {bytes} of {total_bytes}, {eta}",
        None => "{spinner} {bytes}, {elapsed}",
    };
    progress.with_style(ProgressStyle::with_template(style).expect("a template of known fields"))
}

fn answer(
    input: impl Read,
    output: &mut impl Write,
    precision: Precision,
    progress: &ProgressBar,
) -> io::Result<Tally> {
    let mut input = BufReader::with_capacity(1 << 16, input);
    let result = answer_all(&mut input, output, precision, progress);
    progress.finish_and_clear();
    result
}
