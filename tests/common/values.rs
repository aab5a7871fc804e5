//! Reference values, computed with 50 digits: `tests/data/values.json`.

use std::path::Path;
use std::sync::LazyLock;

use brdf::from_spherical;
use glam::DVec3;
use serde_json::Value;

static ALL: LazyLock<Value> = LazyLock::new(|| {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/values.json");
    let text = std::fs::read_to_string(path).expect("the values are in the repository");
    serde_json::from_str(&text).expect("the values are JSON")
});

/// One group of cases with the tolerance |got − want| ≤ atol + rtol·|want|.
pub struct Group {
    name: String,
    rtol: f64,
    atol: f64,
    cases: Vec<Value>,
}

/// One case: named inputs and named outputs.
pub struct Case<'a> {
    group: &'a Group,
    index: usize,
    value: &'a Value,
}

impl Group {
    /// Reads a group and panics if it is not there or empty.
    pub fn read(name: &str) -> Self {
        let group = &ALL["groups"][name];
        let number = |key: &str| group[key].as_f64().unwrap_or_else(|| panic!("{name}: no {key}"));
        let cases = group["cases"].as_array().expect("a group has cases").clone();
        assert!(!cases.is_empty(), "{name} is empty");
        Self { name: name.to_owned(), rtol: number("rtol"), atol: number("atol"), cases }
    }

    pub fn cases(&self) -> impl Iterator<Item = Case<'_>> {
        self.cases.iter().enumerate().map(|(index, value)| Case { group: self, index, value })
    }
}

impl Case<'_> {
    /// An input, or panic.
    pub fn input(&self, key: &str) -> f64 {
        self.value["in"][key].as_f64().unwrap_or_else(|| panic!("{}: no input {key}", self.name()))
    }

    /// An input that is a list of numbers.
    pub fn inputs(&self, key: &str) -> Vec<f64> {
        let list = self.value["in"][key].as_array();
        let list = list.unwrap_or_else(|| panic!("{}: no list {key}", self.name()));
        list.iter().map(|value| value.as_f64().expect("a number")).collect()
    }

    /// The raw output: for booleans, null, lists and complex numbers.
    pub fn output(&self, key: &str) -> &Value {
        let output = &self.value["out"];
        output.get(key).unwrap_or_else(|| panic!("{}: no output {key}", self.name()))
    }

    /// The direction with the angles `theta_<which>` and `phi_<which>`; azimuth 0 where not given.
    pub fn direction(&self, which: &str) -> DVec3 {
        let phi = self.value["in"][format!("phi_{which}")].as_f64().unwrap_or(0.0);
        from_spherical(self.input(&format!("theta_{which}")), phi)
    }

    /// Asserts a number.
    pub fn check(&self, key: &str, got: f64) {
        self.check_number(key, got, self.number(key));
    }

    /// An output that is a number.
    pub fn number(&self, key: &str) -> f64 {
        let want = self.output(key).as_f64();
        want.unwrap_or_else(|| panic!("{}: {key} is not a number", self.name()))
    }

    /// Asserts a list of numbers: a vector, a colour.
    pub fn check_list(&self, key: &str, got: &[f64]) {
        let want = self.output(key).as_array().expect("a list");
        assert_eq!(got.len(), want.len(), "{} {key}", self.name());
        for (got, want) in got.iter().zip(want) {
            self.check_number(key, *got, want.as_f64().expect("a number"));
        }
    }

    /// Asserts a number that is not an output by itself, with the group's tolerance.
    pub fn check_number(&self, key: &str, got: f64, want: f64) {
        if let Err(message) = self.compare(key, got, want) {
            panic!("{message}");
        }
    }

    /// The same as an answer, with what is wrong in words.
    pub fn compare(&self, key: &str, got: f64, want: f64) -> Result<(), String> {
        let tolerance = self.group.atol + self.group.rtol * want.abs();
        let off = (got - want).abs();
        if off <= tolerance {
            return Ok(());
        }
        let name = self.name();
        Err(format!(
            "{name} {key}: got {got:e}, want {want:e}, off by {off:e}, allowed {tolerance:e}"
        ))
    }

    fn name(&self) -> String {
        format!("{}[{}] {}", self.group.name, self.index, self.value["in"])
    }
}
