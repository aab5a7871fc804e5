//! What does a model give here? Questions in, answers out, one line of JSON each.
//!
//! ```sh
//! cargo run --release --features serde,wgsl --example evaluate -- examples/evaluate/questions.jsonl
//! echo '{"fresnel": {"metal": "Au"}, "cos": 0.5}' |
//!     cargo run --release --features serde,wgsl --example evaluate
//! ```
//!
//! | question | answer |
//! |---|---|
//! | `{"brdf": B, "wi": [x,y,z], "wo": [x,y,z]}` | `{"value": [r,g,b], "pdf": p}` |
//! | `{"brdf": B, "wo": […], "u": [u0,u1]}` | `{"wi": […], "weight": [r,g,b], "pdf": p}` |
//! | `{"brdf": B, "wo": […]}` | `{"albedo": [r,g,b]}` |
//! | `{"fresnel": F, "cos": c}` | `{"reflectance": [r,g,b]}` |
//! | `{"distribution": D, "h": [x,y,z]}` | `{"density": d}` |
//! | `{"wgsl": B, "name": "gold"}` | `{"text": "…"}`: `gold_eval`, `gold_pdf`, `gold_sample` in WGSL |
//! | anything wrong | `{"error": "what, where, what is allowed", "line": n}` |
//!
//! B, F and D are the descriptions of the module `brdf::description`. Directions are unit vectors
//! in the shading frame. A line has at most 1 MiB; blank lines are no questions, but count in the
//! number of the line. The exit status is 0 if every question has
//! an answer, 1 if one has not, 2 if questions cannot be read or answers not be written.

mod command;
mod question;
mod stream;

use std::io;
use std::process::ExitCode;

use command::Streams;
use indicatif::ProgressDrawTarget;

fn main() -> ExitCode {
    let streams = Streams {
        input: io::stdin().lock(),
        output: io::stdout().lock(),
        errors: io::stderr(),
        progress: ProgressDrawTarget::stderr(),
    };
    command::run(std::env::args_os().skip(1), streams).into()
}
