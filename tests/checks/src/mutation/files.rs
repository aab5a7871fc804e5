//! Where the obvious bugs are all looked for: in the file of every form of description.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use serde::Deserialize;

use super::suite::Suite;
use super::systematic::{Bug, Outcome, bugs, run};
use crate::faulty::source;
use crate::{models, path, text};

/// A line of `tests/seeded.jsonl`: what is known of a file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Known {
    pub file: String,
    /// Why the obvious bugs are not looked for.
    #[serde(default)]
    pub skipped: Option<String>,
    /// The bugs that no check can find.
    #[serde(default)]
    pub survivors: Vec<Survivor>,
    /// Instead of a list of those: the least part of the bugs that is found.
    #[serde(default)]
    pub least: Option<Least>,
}

/// How many of the bugs of a file are found.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Least {
    pub part: f64,
    /// What the others are.
    pub others: String,
}

/// A bug that no check can find.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Survivor {
    /// The line of the source.
    pub line: String,
    pub bug: String,
    /// Why it is none.
    pub why: String,
}

/// What is known of files.
pub fn known() -> &'static [Known] {
    static ALL: LazyLock<Vec<Known>> = LazyLock::new(|| {
        let text = text("tests/seeded.jsonl");
        let known =
            |line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{line}: {error}"));
        text.lines().map(known).collect()
    });
    &ALL
}

/// The files in the rooms of models, distributions, Fresnel terms and shadowings that are called like
/// a word of the registry.
pub fn of_forms() -> BTreeSet<String> {
    let words: BTreeSet<String> = models::rows().iter().flat_map(models::Row::words).collect();
    let rooms = path("src").read_dir().expect("the sources").map(|room| room.expect("a room"));
    let rooms = rooms.filter(|room| room.path().is_dir() && room.file_name() != "description");
    let rooms: Vec<String> =
        rooms.map(|room| format!("src/{}", room.file_name().display())).collect();
    let files =
        rooms.iter().flat_map(|room| words.iter().map(move |word| format!("{room}/{word}.rs")));
    files.filter(|file| path(file).is_file()).collect()
}

/// The obvious bugs of a file that no check finds, each as its line and what it is, of every so many bugs;
/// and how many were looked for.
pub fn survivors(suite: &Suite, file: &str, every: usize) -> (Vec<(String, String)>, usize) {
    let bugs: Vec<Bug> = bugs(suite, file).into_iter().step_by(every).collect();
    let outcomes = run(suite, &bugs, || {});
    let alive = outcomes.iter().filter(|outcome| outcome.killer.is_none());
    let alive = alive.map(|Outcome { place, fault, .. }| {
        let line = source(place.file).lines().nth(place.line as usize - 1).unwrap_or_default();
        (line.trim().to_owned(), format!("{:?}: {fault}", place.operation))
    });
    (alive.collect(), outcomes.len())
}
