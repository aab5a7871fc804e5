//! The reference values, computed with 50 digits: `tests/data/values.json`.

use std::collections::BTreeSet;
use std::sync::{LazyLock, Mutex, PoisonError};

use brdf::{Real, from_spherical};
use glam::DVec3;
use serde_json::Value;

use super::{Number, Verdict, fail, plain, vector};

static ALL: LazyLock<Value> = LazyLock::new(|| {
    serde_json::from_str(&crate::text("tests/data/values.json")).expect("the values are JSON")
});

/// The groups that were read so far.
static READ: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// The groups that nothing has read yet.
pub fn unread() -> Vec<&'static str> {
    let read = READ.lock().unwrap_or_else(PoisonError::into_inner);
    let groups = ALL["groups"].as_object().expect("groups").keys();
    groups.map(String::as_str).filter(|group| !read.contains(*group)).collect()
}

/// Runs a check on every case of a group.
///
/// # Panics
/// If the group is not there or empty.
pub(super) fn each(group: &str, check: impl Fn(&Case<'_>) -> Verdict) -> Verdict {
    READ.lock().unwrap_or_else(PoisonError::into_inner).insert(group.to_owned());
    let values = &ALL["groups"][group];
    let number = |key: &str| values[key].as_f64().unwrap_or_else(|| panic!("{group}: no {key}"));
    let (rtol, atol) = (number("rtol"), number("atol"));
    let cases = values["cases"].as_array().expect("a group has cases");
    assert!(!cases.is_empty(), "{group} is empty");
    cases
        .iter()
        .enumerate()
        .try_for_each(|(index, value)| check(&Case { group, index, value, rtol, atol }))
}

/// One case: named inputs and named outputs, with the tolerance |got − want| ≤ atol + rtol·|want|.
pub(super) struct Case<'a> {
    group: &'a str,
    index: usize,
    value: &'a Value,
    rtol: f64,
    atol: f64,
}

impl Case<'_> {
    /// An input, or panic.
    pub(super) fn number(&self, key: &str) -> f64 {
        self.value["in"][key].as_f64().unwrap_or_else(|| panic!("{}: no input {key}", self.name()))
    }

    /// An input in the number of the check.
    pub(super) fn input<T: Real>(&self, key: &str) -> T {
        T::lit(self.number(key))
    }

    /// An input that is a list of numbers.
    pub(super) fn inputs<T: Real>(&self, key: &str) -> Vec<T> {
        let list = self.value["in"][key].as_array();
        let list = list.unwrap_or_else(|| panic!("{}: no list {key}", self.name()));
        list.iter().map(|value| T::lit(value.as_f64().expect("a number"))).collect()
    }

    /// The raw output: for booleans, null, lists and complex numbers.
    pub(super) fn output(&self, key: &str) -> &Value {
        let output = &self.value["out"];
        output.get(key).unwrap_or_else(|| panic!("{}: no output {key}", self.name()))
    }

    /// Whether there is an output.
    pub(super) fn has(&self, key: &str) -> bool {
        self.value["out"].get(key).is_some()
    }

    /// The direction with the angles `theta_<which>` and `phi_<which>`; azimuth 0 where not given.
    pub(super) fn direction(&self, which: &str) -> DVec3 {
        let phi = self.value["in"][format!("phi_{which}")].as_f64().unwrap_or(0.0);
        from_spherical(self.number(&format!("theta_{which}")), phi)
    }

    /// The same in the number of the check.
    pub(super) fn vector<T: Real>(&self, which: &str) -> T::Vec3 {
        vector::<T>(self.direction(which))
    }

    /// Holds a number against an output.
    pub(super) fn same(&self, key: &str, got: impl Into<f64>) -> Verdict {
        let want = self.output(key).as_f64();
        let want = want.unwrap_or_else(|| panic!("{}: {key} is not a number", self.name()));
        self.compare(key, got, want)
    }

    /// Holds a vector against an output that is a list.
    pub(super) fn same_vector<T: Number>(&self, key: &str, got: T::Vec3) -> Verdict {
        let want = self.output(key).as_array().expect("a list");
        assert_eq!(want.len(), 3, "{} {key}", self.name());
        plain::<T>(got)
            .to_array()
            .into_iter()
            .zip(want)
            .try_for_each(|(got, want)| self.compare(key, got, want.as_f64().expect("a number")))
    }

    /// Holds a number against one that is not an output by itself, with the group's tolerance.
    pub(super) fn compare(&self, key: &str, got: impl Into<f64>, want: f64) -> Verdict {
        let got: f64 = got.into();
        let tolerance = self.atol + self.rtol * want.abs();
        let off = (got - want).abs();
        if off <= tolerance {
            return Ok(());
        }
        let name = self.name();
        fail(format!(
            "{name} {key}: got {got:e}, want {want:e}, off by {off:e}, allowed {tolerance:e}"
        ))
    }

    fn name(&self) -> String {
        format!("{}[{}] {}", self.group, self.index, self.value["in"])
    }
}
