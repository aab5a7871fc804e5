//! Measures what the documentation says of every model and writes it down.
//!
//! ```sh
//! cargo run --release --example certificate            # writes docs/certificate.md
//! cargo run --release --example certificate -- --check # fails if it says something else
//! ```
//!
//! The same measurements as in the tests, on the same list of models, at full size. Fails, and
//! writes nothing, if samples do not do what models say, or derivatives are not those of the answers.

mod cost;
mod page;
mod row;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use brdf_checks::models;
use brdf_checks::mutation::list::mutants;
use brdf_checks::mutation::mutant;
use brdf_checks::mutation::suite::Suite;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use row::Row;

fn main() -> Result<(), Box<dyn Error>> {
    let check = check(env::args().skip(1))?;
    let (single, double) = (models::single(), models::double());
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {elapsed} {msg}")?;
    let pairs = row::Pairs::new();
    let measured: Vec<usize> =
        (0..double.len()).filter(|index| !check || index % EVERY == 0).collect();
    let bar = ProgressBar::new(measured.len().try_into()?).with_style(style);
    let least = page::least(measured.len());
    let measure = |index: usize| {
        let (single, double) = (&single[index], &double[index]);
        bar.set_message(double.name);
        let row = Row::measure(index, single, double, &pairs);
        let fault = row.fault(least);
        // At once, for all of them take long.
        if let Some(fault) = &fault {
            bar.suspend(|| eprintln!("{fault}"));
        }
        bar.inc(1);
        (row, fault.is_some())
    };
    let (mut rows, faults): (Vec<Row>, Vec<bool>) = measured.into_par_iter().map(measure).unzip();
    let faults = faults.into_iter().filter(|fault| *fault).count();
    if faults > 0 {
        bar.finish_and_clear();
        return Err(format!("{faults} models are not what they say").into());
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/certificate.md");
    if check {
        bar.finish_and_clear();
        return compare(&fs::read_to_string(&path)?, &rows);
    }
    bar.set_message("seeded bugs");
    let suite = Suite::recorded();
    let bugs = mutant::run(&suite, mutants(), true);
    for (index, row) in rows.iter_mut().enumerate() {
        let reached: Vec<_> =
            bugs.iter().filter(|bug| suite.reaches(index, &bug.mutant.place())).collect();
        row.bugs = reached.len();
        row.found = reached.iter().filter(|bug| bug.killed()).count();
    }
    bar.finish_and_clear();
    fs::write(&path, page::certificate(&rows, &bugs))?;
    Ok(())
}

/// Of so many lines one is measured anew to check the page.
const EVERY: usize = 32;

/// Whether the page has a line for every model, and says what was measured of some of them.
fn compare(page: &str, rows: &[Row]) -> Result<(), Box<dyn Error>> {
    let begins = |line: &str| page.lines().any(|known| known.starts_with(line));
    let missing = models::double().iter().map(|entry| format!("| {} | ", entry.name));
    let measured = rows.iter().flat_map(|row| [page::measured(row), page::costs(row)]);
    let wrong: Vec<String> = missing.chain(measured).filter(|line| !begins(line)).collect();
    if wrong.is_empty() {
        return Ok(());
    }
    Err(format!("docs/certificate.md does not say:\n{}", wrong.join("\n")).into())
}

/// Whether `--check` was given.
fn check(arguments: impl Iterator<Item = String>) -> Result<bool, String> {
    let mut check = false;
    for argument in arguments {
        match argument.as_str() {
            "--check" => check = true,
            _ => return Err(format!("{argument}: the only option is --check")),
        }
    }
    Ok(check)
}
