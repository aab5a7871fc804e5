//! The checks that a seeded bug has to get past, quickest first.

use std::collections::BTreeSet;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

use brdf::Brdf;
use glam::DVec3;

use super::laws;
use crate::faulty::{Fault, Faulty, Place, Seeded, armed, record};
use crate::models::{self, Promises};
use crate::values::{self, Check, Verdict};

/// A model of the registry with what it promises.
pub struct Subject {
    pub name: &'static str,
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

/// All checks, with the places of the source that each of them reaches.
pub struct Suite {
    formulas: Vec<(Check, BTreeSet<Place>)>,
    models: Vec<BTreeSet<Place>>,
}

impl Suite {
    /// Runs without a fault and notes what is reached.
    pub fn recorded() -> Self {
        let formulas = values::faulty().into_iter();
        let formulas = formulas.map(|check| (check, record(|| drop(check.1()))));
        let probe = |entry: &models::Entry<Faulty>| {
            let subject = Seeded { model: &*entry.model, fault: None };
            record(|| laws::probe(&subject))
        };
        Self { formulas: formulas.collect(), models: models::faulty().iter().map(probe).collect() }
    }

    /// Whether an answer of the model at this place of the registry depends on a place of the source.
    pub fn reaches(&self, model: usize, place: &Place) -> bool {
        self.models[model].contains(place)
    }

    /// Every place that some check reaches.
    pub fn places(&self) -> BTreeSet<Place> {
        let constructors = record(|| drop(models::faulty()));
        let of_formulas = self.formulas.iter().flat_map(|(_, places)| places);
        let of_models = self.models.iter().flatten();
        of_formulas.chain(of_models).copied().chain(constructors).collect()
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
        let built = catch_unwind(|| armed(fault, models::faulty));
        let Ok(entries) = built else {
            let message = "a constructor refuses its parameters".to_owned();
            return vec![Killer { check: "the registry can be built", model: None, message }];
        };
        // A place that no answer of a model reaches may lie in its constructor.
        let reached =
            |places: &BTreeSet<Place>| fault.is_none_or(|fault| places.contains(&fault.place));
        let any = self.models.iter().any(reached);
        let touched = entries.into_iter().zip(&self.models);
        let touched: Vec<_> = touched.filter(|(_, places)| !any || reached(places)).collect();
        let step = if exhaustive || !any { 1 } else { touched.len().div_ceil(ENOUGH).max(1) };
        let subjects: Vec<_> = touched
            .into_iter()
            .step_by(step)
            .map(|(entry, _)| Subject {
                name: entry.name,
                promises: entry.promises,
                model: Box::new(Seeded { model: entry.model, fault }),
            })
            .collect();
        let mut killers = Vec::new();
        for (check, law) in LAWS {
            let broken = subjects.iter().find_map(|subject| {
                let message = quietly(|| law(subject)).err()?;
                Some(Killer { check, model: Some(subject.name), message })
            });
            killers.extend(broken);
            if !exhaustive && !killers.is_empty() {
                break;
            }
        }
        killers
    }
}

/// The verdict of a check; a panic is one too.
fn quietly(check: impl FnOnce() -> Verdict) -> Result<(), String> {
    match catch_unwind(AssertUnwindSafe(check)) {
        Ok(verdict) => verdict.map_err(|error| error.to_string()),
        Err(_) => Err("panics".to_owned()),
    }
}
