//! What does a model give here? Questions in, answers out, one line of JSON each.
//!
//! ```sh
//! cargo run --release --example evaluate -- examples/evaluate/questions.jsonl
//! echo '{"fresnel": {"metal": "Au"}, "cos": 0.5}' | cargo run --release --example evaluate
//! ```
//!
//! | question | answer |
//! |---|---|
//! | `{"brdf": B, "wi": [x,y,z], "wo": [x,y,z]}` | `{"value": [r,g,b], "pdf": p}` |
//! | `{"brdf": B, "wo": […], "u": [u0,u1]}` | `{"wi": […], "weight": [r,g,b], "pdf": p}` |
//! | `{"brdf": B, "wo": […]}` | `{"albedo": [r,g,b]}` |
//! | `{"fresnel": F, "cos": c}` | `{"reflectance": [r,g,b]}` |
//! | `{"distribution": D, "h": [x,y,z]}` | `{"density": d}` |
//! | anything wrong | `{"error": "what, where, what is allowed"}` |
//!
//! B, F and D are the descriptions of the module `brdf::description`. Directions are unit vectors
//! in the shading frame; blank lines are no questions. The exit status is 0 if every question has
//! an answer, 1 if one has not, 2 if questions cannot be read or answers not be written.

mod question;
mod stream;

use std::fs::File;
use std::io::{self, BufReader, Read};
use std::process::ExitCode;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use question::Precision;

const USAGE: &str = "\
Answers questions about reflectance: lines of JSON in, lines of JSON out.

Usage: evaluate [--f32 | --f64] [FILE]

  FILE    questions, one a line; standard input if absent or -
  --f64   compute in double precision (default)
  --f32   compute in single precision";

fn main() -> ExitCode {
    let mut precision = Precision::Double;
    let mut file = None;
    for word in std::env::args_os().skip(1) {
        match word.to_str() {
            Some("--f32") => precision = Precision::Single,
            Some("--f64") => precision = Precision::Double,
            Some("-h" | "--help") => {
                println!("{USAGE}");
                return ExitCode::SUCCESS;
            }
            Some(option) if option.starts_with("--") => {
                eprintln!("unknown option {option}\n\n{USAGE}");
                return ExitCode::from(2);
            }
            _ if file.is_none() => file = Some(word),
            _ => {
                eprintln!("more than one file\n\n{USAGE}");
                return ExitCode::from(2);
            }
        }
    }
    let result = match file {
        Some(path) if path != "-" => match File::open(&path) {
            Ok(file) => {
                // Of a pipe the length is not known; it counts as 0.
                let length = file.metadata().map_or(0, |data| data.len());
                run(file, Some(length).filter(|length| *length > 0), precision)
            }
            Err(error) => {
                eprintln!("{}: {error}", path.display());
                return ExitCode::from(2);
            }
        },
        _ => run(io::stdin().lock(), None, precision),
    };
    match result {
        Ok(tally) if tally.failed == 0 => ExitCode::SUCCESS,
        Ok(tally) => {
            eprintln!("{} of {} questions have no answer", tally.failed, tally.questions);
            ExitCode::FAILURE
        }
        // Whoever reads the answers has seen enough.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => ExitCode::from(2),
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

fn run(input: impl Read, length: Option<u64>, precision: Precision) -> io::Result<stream::Tally> {
    // The bar hides itself where standard error is no terminal.
    let progress = ProgressBar::with_draw_target(length, ProgressDrawTarget::stderr());
    let style = match length {
        Some(_) => "{wide_bar} {bytes} of {total_bytes}, {eta}",
        None => "{spinner} {bytes}, {elapsed}",
    };
    progress.set_style(ProgressStyle::with_template(style).expect("a template of known fields"));
    let mut input = BufReader::with_capacity(1 << 16, input);
    let result = stream::answer_all(&mut input, &mut io::stdout().lock(), precision, &progress);
    progress.finish_and_clear();
    result
}
