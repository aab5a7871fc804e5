//! Seeds bugs in the formulas, one at a time, and tells which check of the tests finds each.
//!
//! ```sh
//! cargo run --example mutants                          # the list of deliberate bugs
//! cargo run --example mutants -- everywhere            # the obvious bugs at every operation
//! cargo run --example mutants -- everywhere src/fresnel # of the files that begin so
//! ```
//!
//! The first takes a minute, the second half an hour. A release build is no faster but for its
//! dependencies, of which little is used.
//!
//! Nothing is compiled anew for a bug, and none is in the crate: the formulas run over a number
//! that errs at one place of the source.

use std::collections::BTreeMap;
use std::error::Error;
use std::{env, panic};

use brdf_checks::faulty::source;
use brdf_checks::mutation::suite::Suite;
use brdf_checks::mutation::{killed, list, mutant, systematic};
use indicatif::{ProgressBar, ProgressStyle};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let everywhere = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => None,
        ["everywhere"] => Some("src"),
        ["everywhere", files] => Some(files),
        _ => return Err(format!("{arguments:?}: the only option is everywhere").into()),
    };
    // A bug may make a check panic, which is one way to find it and not worth a message.
    panic::set_hook(Box::new(|_| ()));
    let suite = Suite::recorded();
    let alarms = suite.false_alarms();
    if !alarms.is_empty() {
        return Err(format!("something is wrong without a bug: {alarms:#?}").into());
    }
    match everywhere {
        None => deliberate(&suite),
        Some(files) => systematically(&suite, files)?,
    }
    Ok(())
}

/// The list, with every check that finds each of them.
fn deliberate(suite: &Suite) {
    let outcomes = mutant::run(suite, list::mutants(), true);
    println!("{}", mutant::table(&outcomes));
    println!("| models | killed | of |\n|---|---|---|");
    for row in killed(&outcomes) {
        println!("| {} | {} | {} |", row.family, row.killed, row.of);
    }
    let all = outcomes.iter().filter(|outcome| outcome.killed()).count();
    println!("\n{all} of {} killed.\n", outcomes.len());
}

/// The obvious bugs at every operation: how many are found, and which are not.
fn systematically(suite: &Suite, files: &str) -> Result<(), Box<dyn Error>> {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {elapsed}")?;
    let bugs = systematic::bugs(suite, files);
    let bar = ProgressBar::new(bugs.len().try_into()?).with_style(style);
    let outcomes = systematic::run(suite, &bugs, || bar.inc(1));
    bar.finish_and_clear();
    let mut files: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for outcome in &outcomes {
        let (killed, of) = files.entry(outcome.place.file).or_default();
        *killed += usize::from(outcome.killer.is_some());
        *of += 1;
    }
    println!("| file | killed | of |\n|---|---|---|");
    for (file, (killed, of)) in &files {
        println!("| {file} | {killed} | {of} |");
    }
    let survivors: Vec<_> = outcomes.iter().filter(|outcome| outcome.killer.is_none()).collect();
    println!("\n{} of {} killed. Not found:\n", outcomes.len() - survivors.len(), outcomes.len());
    for systematic::Outcome { place, fault, .. } in survivors {
        let line =
            source(place.file).lines().nth(place.line as usize - 1).unwrap_or_default().trim();
        let (file, number, column) = (place.file, place.line, place.column);
        println!("- {file}:{number}:{column} {:?}, {fault}: `{line}`", place.operation);
    }
    Ok(())
}
