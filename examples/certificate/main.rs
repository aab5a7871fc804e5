//! Measures what the documentation says of every model and writes it down.
//!
//! ```sh
//! cargo run --release --example certificate            # writes docs/certificate.md
//! cargo run --release --example certificate -- --check # fails if it says something else
//! cargo run --release --example certificate -- --sphere # of models over the whole sphere alone
//! ```
//!
//! The same measurements as in the tests, on the same list of models, at full size. Fails, and
//! writes nothing, if samples do not do what models say, or derivatives are not those of the answers.

mod cost;
mod page;
mod row;
mod sphere;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use brdf_checks::mutation::list::mutants;
use brdf_checks::mutation::mutant;
use brdf_checks::mutation::suite::Suite;
use brdf_checks::{interfaces, models};
use indicatif::{ProgressBar, ProgressStyle};
use row::Row;

fn main() -> Result<(), Box<dyn Error>> {
    let task = task(env::args().skip(1))?;
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/certificate.md");
    let every = if task == Task::Check { EVERY } else { 1 };
    let (over_sphere, matrices) = measure_sphere(every)?;
    if task == Task::Sphere {
        let page = fs::read_to_string(&path)?;
        let begin = page.find(sphere::HEADING).unwrap_or(page.len());
        fs::write(&path, page[..begin].to_owned() + &sphere::page(&over_sphere, &matrices))?;
        return Ok(());
    }
    let mut rows = measure(every)?;
    if task == Task::Check {
        return compare(&fs::read_to_string(&path)?, &rows, &over_sphere, matrices);
    }
    let suite = Suite::recorded();
    let bugs = mutant::run(&suite, mutants(), true);
    for (index, row) in rows.iter_mut().enumerate() {
        let reached: Vec<_> =
            bugs.iter().filter(|bug| suite.reaches(index, &bug.mutant.place())).collect();
        row.bugs = reached.len();
        row.found = reached.iter().filter(|bug| bug.killed()).count();
    }
    let page = page::certificate(&rows, &bugs) + &sphere::page(&over_sphere, &matrices);
    fs::write(&path, page)?;
    Ok(())
}

/// Of so many lines one is measured anew to check the page.
const EVERY: usize = 8;

fn bar(count: usize) -> Result<ProgressBar, Box<dyn Error>> {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {elapsed} {msg}")?;
    Ok(ProgressBar::new(count.try_into()?).with_style(style))
}

/// The models of the registry, or one of `every` so many.
fn measure(every: usize) -> Result<Vec<Row>, Box<dyn Error>> {
    let (single, double) = (models::single(), models::double());
    let bar = bar(double.len())?;
    let pairs = row::Pairs::new();
    let mut rows = Vec::new();
    for (index, (single, double)) in single.iter().zip(double).enumerate() {
        if index % every == 0 {
            bar.set_message(double.name);
            rows.push(Row::measure(index, single, double, &pairs));
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    let least = page::least(&rows);
    without_faults(rows.iter().filter_map(|row| row.fault(least)).collect())?;
    Ok(rows)
}

/// The models over the whole sphere, or one of `every` so many, and the realisability of Mueller matrices.
fn measure_sphere(every: usize) -> Result<(Vec<sphere::Row>, Vec<String>), Box<dyn Error>> {
    let (single, double) = (interfaces::single(), interfaces::double());
    let bar = bar(double.len())?;
    let mut rows = Vec::new();
    for (single, double) in single.iter().zip(double).step_by(every) {
        bar.set_message(&*double.row.name);
        rows.push(sphere::Row::measure(single, double));
        bar.inc(every as u64);
    }
    bar.finish_and_clear();
    without_faults(rows.iter().filter_map(sphere::Row::fault).collect())?;
    let matrices = models::rows().iter().step_by(every).filter_map(sphere::realizability);
    Ok((rows, matrices.collect()))
}

fn without_faults(faults: Vec<String>) -> Result<(), Box<dyn Error>> {
    if faults.is_empty() {
        return Ok(());
    }
    eprintln!("{}", faults.join("\n"));
    Err(format!("{} models are not what they say", faults.len()).into())
}

/// Whether the page has a line for every model, and says what was measured of some of them.
fn compare(
    page: &str,
    rows: &[Row],
    over_sphere: &[sphere::Row],
    matrices: Vec<String>,
) -> Result<(), Box<dyn Error>> {
    let begins = |line: &str| page.lines().any(|known| known.starts_with(line));
    let names = models::double().iter().map(|entry| entry.name);
    let names = names.chain(interfaces::rows().iter().map(|row| row.name.as_str()));
    let missing = names.map(|name| format!("| {name} | "));
    let measured = rows.iter().flat_map(|row| [page::measured(row), page::costs(row)]);
    let measured = measured.chain(over_sphere.iter().map(sphere::Row::line)).chain(matrices);
    let wrong: Vec<String> = missing.chain(measured).filter(|line| !begins(line)).collect();
    if wrong.is_empty() {
        return Ok(());
    }
    Err(format!("docs/certificate.md does not say:\n{}", wrong.join("\n")).into())
}

/// What is to be done.
#[derive(PartialEq)]
enum Task {
    Write,
    Check,
    Sphere,
}

fn task(arguments: impl Iterator<Item = String>) -> Result<Task, String> {
    let mut task = Task::Write;
    for argument in arguments {
        task = match argument.as_str() {
            "--check" => Task::Check,
            "--sphere" => Task::Sphere,
            _ => return Err(format!("{argument}: the only options are --check and --sphere")),
        }
    }
    Ok(task)
}
