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
//! | `{"mueller": B, "wi": […], "wo": […]}` | `{"mueller": [M_r, M_g, M_b]}` |
//! | `{"gradient": B, "wi": [x,y,z], "wo": [x,y,z]}` | `{"value": [r,g,b], "gradient": {"PATH": [dr,dg,db], …}}`: derivatives of the value by every number, under the place of it; a colour of three numbers counts as one, each component of a vector by itself |
//! | `{"fresnel": F, "cos": c}` | `{"reflectance": [r,g,b]}`; for `belcour_barla` also `"xyz": [x,y,z]` |
//! | `{"fresnel": F}` | `{"average": [r,g,b]}` |
//! | `{"distribution": D, "h": [x,y,z]}` | `{"density": d}` |
//! | `{"wgsl": B, "name": "gold"}` | `{"text": "…"}`: `gold_eval`, `gold_pdf`, `gold_sample` in WGSL |
//! | `{"surface": P, "cos": c, "wavelength": λ}` | `{"r": {"s": [re,im], "p": […]}, "t": {…}, "reflectance": {"s": R, "p": R}, "transmittance": {…}}` |
//! | `{"optics": O, "wavelength": λ}` | `{"mueller": […], "jones": […]}` |
//! | `{"optics": O, "stokes": [I,Q,U,V], "wavelength": λ}` | `{"stokes": [I,Q,U,V], "degree_of_polarization": p}` |
//! | anything wrong | `{"error": "what, where, what is allowed", "line": n}` |
//!
//! B, F and D are the descriptions of the module `brdf::description`. A surface P, an optical element
//! O and their frames are those of the page `docs/evaluate.md`; λ is 550 nm where it is not given. Directions are unit vectors
//! in the shading frame. A line has at most 1 MiB; blank lines are no questions, but count in the
//! number of the line. The exit status is 0 if every question has
//! an answer, 1 if one has not, 2 if questions cannot be read or answers not be written.

mod command;
mod optics;
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
