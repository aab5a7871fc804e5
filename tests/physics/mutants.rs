//! Bugs seeded on purpose, one at a time: the checks find every one.

use brdf_checks::models;
use brdf_checks::mutation::list::mutants;
use brdf_checks::mutation::mutant::{run, table};
use brdf_checks::mutation::suite::Suite;

/// Otherwise a rejected mutant would say nothing.
#[test]
fn the_checks_pass_where_nothing_is_wrong() {
    let alarms = Suite::recorded().false_alarms();
    assert!(alarms.is_empty(), "{alarms:#?}");
}

/// What a bug touches is known, so that not every model is looked at for every bug.
#[test]
fn models_reach_the_places_they_compute_at() {
    let suite = Suite::recorded();
    for outcome in run(&suite, mutants().filter(|mutant| mutant.family == "Lambert"), false) {
        let place = outcome.mutant.place();
        assert!(suite.reaches(0, &place), "{outcome:?}");
        let reaching = (0..models::double().len()).filter(|&model| suite.reaches(model, &place));
        assert!(reaching.count() < 20, "{outcome:?}");
    }
}

#[test]
fn every_mutant_is_killed() {
    let outcomes = run(&Suite::recorded(), mutants(), false);
    println!("{}", table(&outcomes));
    assert!(outcomes.len() >= 20);
    let alive: Vec<_> = outcomes.iter().filter(|outcome| !outcome.killed()).collect();
    assert!(alive.is_empty(), "{} of {}: {alive:#?}", alive.len(), outcomes.len());
}
