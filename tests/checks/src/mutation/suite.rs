//! The checks that a seeded bug has to get past, quickest first.

use std::collections::BTreeSet;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

use brdf::Brdf;
use glam::DVec3;

use super::laws;
use crate::faulty::{Fault, Faulty, Place, Seeded, armed, record};
use crate::interfaces;
use crate::models::{self, Promises};
use crate::values::{self, Check, Verdict};

/// A model of the registry with what it promises.
pub struct Subject {
    pub model: Box<dyn Brdf<f64, Color = DVec3>>,
    pub promises: &'static Promises,
}

/// What holds for every model of the registry.
type Law = fn(&Subject) -> Verdict;
const LAWS: [(&str, Law); 6] = [
    ("samples agree with value and density", laws::samples_agree),
    ("density is the inverse Jacobian", laws::density_is_the_jacobian),
    ("reciprocity", laws::reciprocity),
    ("robustness", laws::robustness),
    ("energy", laws::energy),
    ("moments of samples", laws::moments_of_samples),
];

/// Where one check that fails is enough, so are about that many of the models that a bug may break.
const ENOUGH: usize = 12;

/// A check that rejected a mutant.
#[derive(Clone, Debug)]
pub struct Killer {
    pub check: &'static str,
    /// The model of the registry that it looked at, if it did.
    pub model: Option<&'static str>,
    pub message: String,
}

impl fmt::Display for Killer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.check)?;
        self.model.map_or(Ok(()), |model| write!(f, " ({model})"))
    }
}

/// What an entry of a list of models computes where, when it is built and when it answers.
struct Reached {
    built: BTreeSet<Place>,
    answered: BTreeSet<Place>,
}

impl Reached {
    fn contains(&self, place: &Place) -> bool {
        self.built.contains(place) || self.answered.contains(place)
    }

    fn places(&self) -> impl Iterator<Item = &Place> {
        self.built.iter().chain(&self.answered)
    }
}

/// All checks, with the places of the source that each of them reaches.
pub struct Suite {
    formulas: Vec<(Check, BTreeSet<Place>)>,
    models: Vec<Reached>,
    interfaces: Vec<Reached>,
}

impl Suite {
    /// Runs without a fault and notes what is reached.
    pub fn recorded() -> Self {
        let formulas = values::faulty().into_iter();
        let formulas = formulas.map(|check| (check, record(|| drop(check.1()))));
        let model = |row: &'static models::Row| {
            let built = record(|| drop(row.faulty()));
            let subject = Subject::new(row, None);
            Reached { built, answered: record(|| laws::probe(&*subject.model)) }
        };
        let interface = |row: &'static interfaces::Row| {
            let built = record(|| drop(row.entry::<Faulty>()));
            let entry = seeded(row, None);
            Reached { built, answered: record(|| interfaces::laws::probe(&entry)) }
        };
        Self {
            formulas: formulas.collect(),
            models: models::rows().iter().map(model).collect(),
            interfaces: over_sphere().map(interface).collect(),
        }
    }

    /// Whether an answer of the model at this place of the registry depends on a place of the source.
    pub fn reaches(&self, model: usize, place: &Place) -> bool {
        self.models[model].answered.contains(place)
    }

    /// Every place that some check reaches.
    pub fn places(&self) -> BTreeSet<Place> {
        let of_formulas = self.formulas.iter().flat_map(|(_, places)| places);
        let of_models = self.models.iter().chain(&self.interfaces).flat_map(Reached::places);
        of_formulas.chain(of_models).copied().collect()
    }

    /// The checks that reject the crate with a fault in it: the first one, or all.
    pub fn killers(&self, fault: &'static Fault, exhaustive: bool) -> Vec<Killer> {
        let mut killers = self.wrong_formulas(Some(fault), exhaustive);
        if exhaustive || killers.is_empty() {
            killers.extend(self.lawbreakers(Some(fault), exhaustive));
        }
        killers
    }

    /// What the checks reject although nothing is wrong.
    pub fn false_alarms(&self) -> Vec<Killer> {
        let mut alarms = self.wrong_formulas(None, true);
        alarms.extend(self.lawbreakers(None, true));
        alarms
    }

    fn wrong_formulas(&self, fault: Option<&'static Fault>, exhaustive: bool) -> Vec<Killer> {
        let wrong = self.formulas.iter().filter_map(|((check, run), places)| {
            let reached = fault.is_none_or(|fault| places.contains(&fault.place));
            let message = reached.then(|| quietly(|| armed(fault, run)).err())??;
            Some(Killer { check, model: None, message })
        });
        wrong.take(if exhaustive { usize::MAX } else { 1 }).collect()
    }

    /// The laws that a model breaks, each with the first model that does.
    fn lawbreakers(&self, fault: Option<&'static Fault>, exhaustive: bool) -> Vec<Killer> {
        let rows = touched(models::rows().iter(), &self.models, fault, exhaustive);
        let build = |row| Subject::new(row, fault);
        let mut killers = broken(&rows, &LAWS, build, |row| &row.name, exhaustive);
        if exhaustive || killers.is_empty() {
            let rows = touched(over_sphere(), &self.interfaces, fault, exhaustive);
            let (build, laws) = (|row| seeded(row, fault), &interfaces::laws::LAWS);
            killers.extend(broken(&rows, laws, build, |row| &row.name, exhaustive));
        }
        killers
    }
}

impl Subject {
    fn new(row: &'static models::Row, fault: Option<&'static Fault>) -> Self {
        let model = Seeded { model: armed(fault, || row.faulty()).model, fault };
        Self { promises: &row.promises, model: Box::new(model) }
    }
}

/// The models over the whole sphere but those of wave optics: their formulas are checked by values and
/// integrals, and each of their answers takes as long as hundreds of others.
fn over_sphere() -> impl Iterator<Item = &'static interfaces::Row> {
    interfaces::rows().iter().filter(|row| !row.is_wave())
}

/// A model over the whole sphere whose answers are those of numbers that err.
fn seeded(row: &'static interfaces::Row, fault: Option<&'static Fault>) -> interfaces::Entry<f64> {
    let entry = armed(fault, || row.entry::<Faulty>());
    interfaces::Entry {
        row,
        model: Box::new(Seeded { model: entry.model, fault }),
        two_sided: Box::new(Seeded { model: entry.two_sided, fault }),
    }
}

/// The models that a fault touches; not all of them where one check that fails is enough.
fn touched<R>(
    rows: impl Iterator<Item = &'static R>,
    reached: &[Reached],
    fault: Option<&'static Fault>,
    exhaustive: bool,
) -> Vec<&'static R> {
    let touched = |reached: &Reached| fault.is_none_or(|fault| reached.contains(&fault.place));
    let rows = rows.zip(reached).filter(|(_, reached)| touched(reached));
    let rows: Vec<_> = rows.map(|(row, _)| row).collect();
    let step = if exhaustive { 1 } else { rows.len().div_ceil(ENOUGH).max(1) };
    rows.into_iter().step_by(step).collect()
}

/// A law with its name.
type Named<S> = (&'static str, fn(&S) -> Verdict);

/// The laws that models break, each with the first model that does: one, or all.
fn broken<R, S>(
    rows: &[&'static R],
    laws: &[Named<S>],
    build: impl Fn(&'static R) -> S,
    name: impl Fn(&'static R) -> &'static str,
    exhaustive: bool,
) -> Vec<Killer> {
    let build = |row: &&'static R| catch_unwind(AssertUnwindSafe(|| (*row, build(row))));
    let Ok(subjects) = rows.iter().map(build).collect::<Result<Vec<_>, _>>() else {
        let message = "a constructor refuses its parameters".to_owned();
        return vec![Killer { check: "the registry can be built", model: None, message }];
    };
    let found = laws.iter().filter_map(|&(check, law)| {
        subjects.iter().find_map(|(row, subject)| {
            let message = quietly(|| law(subject)).err()?;
            Some(Killer { check, model: Some(name(row)), message })
        })
    });
    found.take(if exhaustive { usize::MAX } else { 1 }).collect()
}

/// The verdict of a check; a panic is one too.
fn quietly(check: impl FnOnce() -> Verdict) -> Result<(), String> {
    match catch_unwind(AssertUnwindSafe(check)) {
        Ok(verdict) => verdict.map_err(|error| error.to_string()),
        Err(_) => Err("panics".to_owned()),
    }
}
