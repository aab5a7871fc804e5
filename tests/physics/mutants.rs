//! Bugs seeded on purpose, one at a time: the checks find every one.

use std::sync::LazyLock;

use brdf_checks::models;
use brdf_checks::mutation::files::{known, of_forms, survivors};
use brdf_checks::mutation::list::mutants;
use brdf_checks::mutation::mutant::{run, table};
use brdf_checks::mutation::suite::Suite;

/// One of so many bugs is looked for in large files; `cargo run --example mutants -- everywhere` looks for all.
const SOME: usize = 8;

/// What the checks reach, which takes as long to note as a dozen bugs to find.
static SUITE: LazyLock<Suite> = LazyLock::new(Suite::recorded);

/// Otherwise a rejected mutant would say nothing.
#[test]
fn the_checks_pass_where_nothing_is_wrong() {
    let alarms = SUITE.false_alarms();
    assert!(alarms.is_empty(), "{alarms:#?}");
}

/// What a bug touches is known, so that not every model is looked at for every bug.
#[test]
fn models_reach_the_places_they_compute_at() {
    let suite = &*SUITE;
    for outcome in run(suite, mutants().filter(|mutant| mutant.family == "Lambert"), false) {
        let place = outcome.mutant.place();
        assert!(suite.reaches(0, &place), "{outcome:?}");
        let reaching = (0..models::double().len()).filter(|&model| suite.reaches(model, &place));
        let (reaching, all) = (reaching.count(), models::double().len());
        assert!(reaching < all / 2, "{reaching} of {all}: {outcome:?}");
    }
}

#[test]
fn every_mutant_is_killed() {
    let outcomes = run(&SUITE, mutants(), false);
    println!("{}", table(&outcomes));
    assert!(outcomes.len() >= 20);
    let alive: Vec<_> = outcomes.iter().filter(|outcome| !outcome.killed()).collect();
    assert!(alive.is_empty(), "{} of {}: {alive:#?}", alive.len(), outcomes.len());
}

/// A new form has its obvious bugs looked for in its own file, if nothing else is known of it.
#[test]
fn the_obvious_bugs_in_the_files_of_forms_are_found() {
    let files = of_forms();
    assert!(files.contains("src/diffuse/lambert.rs") && files.contains("src/fresnel/conductor.rs"));
    let known = |file: &str| known().iter().find(|known| known.file == file);
    let suite = &*SUITE;
    let mut differ = Vec::new();
    for file in &files {
        let known = known(file);
        if known.is_some_and(|known| known.skipped.is_some()) {
            continue;
        }
        let mut want: Vec<(String, String)> = known
            .iter()
            .flat_map(|known| &known.survivors)
            .map(|survivor| (survivor.line.clone(), survivor.bug.clone()))
            .collect();
        let least = known.and_then(|known| known.least.as_ref());
        let (mut got, count) = survivors(suite, file, if least.is_some() { SOME } else { 1 });
        if let Some(least) = least {
            let found = 1.0 - got.len() as f64 / count as f64;
            println!("{file}: {found:.3} of {count}");
            if count == 0 || found < least.part {
                differ.push(format!("{file}: {found} of {count}, not {least:?}: {got:#?}"));
            }
            continue;
        }
        want.sort();
        got.sort();
        if got != want {
            differ.push(format!("{file}: {got:#?} instead of {want:#?}"));
        }
    }
    assert!(differ.is_empty(), "{}", differ.join("\n"));
}

#[test]
fn what_is_known_of_files_is_of_files_of_forms() {
    let files = of_forms();
    for known in known() {
        assert!(files.contains(&known.file), "{}", known.file);
    }
}
