//! No public model and no form of the descriptions is missing from the registry.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Debug;

use brdf::description::{BrdfDescription, DistributionDescription, FresnelDescription};
use brdf_checks::models::{self, Bounds, Promises, Row};
use brdf_checks::path;
use serde::de::DeserializeOwned;

/// The sources of the crate without comments and tests, each as one line.
fn sources() -> Vec<String> {
    let mut sources = Vec::new();
    let mut rooms = vec![path("src")];
    while let Some(room) = rooms.pop() {
        for entry in room.read_dir().expect("a directory of sources") {
            let path = entry.expect("an entry of it").path();
            if path.is_dir() {
                rooms.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = std::fs::read_to_string(&path).expect("a source file");
                // Documentation shows how users write their own; tests have helpers.
                let text = text.split("#[cfg(test)]").next().unwrap_or_default();
                let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
                sources.push(code.collect::<Vec<_>>().join(" "));
            }
        }
    }
    sources
}

/// The types of the crate that implement a trait over numbers, read from the sources.
fn implementors(of: &str) -> BTreeSet<String> {
    let of = |code: &String| -> Vec<String> {
        code.split("impl").filter_map(|rest| implementor(rest, of)).collect()
    };
    sources().iter().flat_map(of).collect()
}

/// What the types of the crate that are other types with parameters are called, and those others.
fn aliases() -> BTreeMap<String, String> {
    let name = |text: &str| -> String {
        text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
    };
    let mut found = BTreeMap::new();
    for code in sources() {
        for rest in code.split("pub type ").skip(1) {
            if let Some((left, right)) = rest.split(';').next().and_then(|it| it.split_once("> = "))
            {
                found.insert(name(left), name(right));
            }
        }
    }
    found
}

/// The name of the type in `<T, D> Trait<T> for Name<D> where`, without its path and arguments.
fn implementor(rest: &str, of: &str) -> Option<String> {
    let head = rest.split('{').next()?;
    let (left, right) = head.split_once(" for ")?;
    let implemented = without_parameters(left.trim_start())?.trim_start().strip_prefix(of)?;
    let name: String =
        right.trim().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    // Pointers, and the placeholders of macros, are forwarded to what they point at.
    let is_model = !name.is_empty() && !["Box", "Arc", "Rc"].contains(&name.as_str());
    (implemented.starts_with('<') && is_model).then_some(name)
}

/// What follows `<T, D: Trait<T>>`.
fn without_parameters(text: &str) -> Option<&str> {
    let mut depth = 0_u32;
    for (at, letter) in text.char_indices() {
        match letter {
            '<' => depth += 1,
            '>' => depth = depth.checked_sub(1)?,
            _ => {}
        }
        if depth == 0 {
            return Some(if letter == '>' { &text[at + 1..] } else { &text[at..] });
        }
    }
    None
}

/// What is written in the lines of the registry.
fn written() -> BTreeSet<String> {
    models::rows().iter().flat_map(Row::words).collect()
}

/// What a reader expects in the place of a name that it does not know.
fn expected<D: DeserializeOwned + Debug>(text: &str) -> Vec<String> {
    let error = serde_json::from_str::<D>(text).expect_err(text).to_string();
    let (_, expected) = error.split_once("expected one of ").unwrap_or_else(|| panic!("{error}"));
    let names: Vec<String> = expected.split('`').skip(1).step_by(2).map(str::to_owned).collect();
    assert!(names.len() > 2, "{error}");
    names
}

#[test]
fn every_form_of_the_descriptions_has_a_line() {
    let shadowing = r#"{"cook_torrance": {"distribution": {"ggx": {"roughness": 1}},
        "fresnel": {"constant": 1}, "shadowing": "?"}}"#;
    let blinn_1977 = r#"{"blinn_1977_printed": {"distribution": "?"}}"#;
    let forms = [
        expected::<BrdfDescription>(r#"{"?": 0}"#),
        expected::<DistributionDescription>(r#"{"?": 0}"#),
        expected::<FresnelDescription>(r#"{"?": 0}"#),
        expected::<BrdfDescription>(shadowing),
        expected::<BrdfDescription>(blinn_1977),
    ];
    let written = written();
    let missing: Vec<_> = forms.iter().flatten().filter(|form| !written.contains(*form)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// What a key switches on and off is there both ways.
#[test]
fn every_switch_is_on_and_off() {
    let written = written();
    let switches: Vec<_> = written.iter().filter_map(|word| word.strip_suffix(": true")).collect();
    assert!(switches.contains(&"normalized") && switches.contains(&"interreflection"));
    for word in &written {
        if let Some((key, _)) = word.split_once(": ") {
            for truth in [true, false] {
                assert!(written.contains(&format!("{key}: {truth}")), "{key} is never {truth}");
            }
        }
    }
}

/// Asserts that each type that implements a trait of the crate is one that the registry knows.
fn assert_all_registered(trait_name: &str, some: &[&str], known: impl Fn(&str) -> bool) {
    let found = implementors(trait_name);
    for name in some {
        assert!(found.contains(*name), "{name} was not found among {found:?}");
    }
    for name in found.iter().filter(|name| !name.starts_with("Any")) {
        assert!(known(name), "the {trait_name} {name} is missing from the registry");
    }
}

/// Whether a form is written in the registry that is called like the type.
fn is_written(type_name: &str) -> bool {
    let form = match type_name {
        "SmithCorrelated" => "smith".to_owned(),
        "SmithMixture" => "mixture".to_owned(),
        "GeneralSchlick" => "schlick".to_owned(),
        other => snake_case(other),
    };
    written().contains(&form)
}

/// `v_cavity` for `VCavity`.
fn snake_case(camel_case: &str) -> String {
    let mut name = String::new();
    for letter in camel_case.chars() {
        if letter.is_uppercase() && !name.is_empty() {
            name.push('_');
        }
        name.extend(letter.to_lowercase());
    }
    name
}

#[test]
fn every_model_is_registered() {
    let aliases = aliases();
    let types: BTreeSet<String> = models::rows()
        .iter()
        .map(Row::type_name)
        .map(|name| aliases.get(&name).cloned().unwrap_or(name))
        .collect();
    let some = ["Lambert", "CookTorrance", "WeightedSum", "Scaled"];
    // A sum of two known types is, bit for bit, the one in a list (`limits`): its lines are those.
    let registered =
        |name: &str| types.contains(if name == "SumOfTwo" { "WeightedSum" } else { name });
    assert_all_registered("Brdf", &some, registered);
    let models = implementors("Brdf");
    assert!(types.iter().all(|name| models.contains(name)), "{types:?} {models:?}");
}

#[test]
fn every_distribution_is_registered() {
    assert_all_registered("Distribution", &["Beckmann", "Mixture"], is_written);
}

#[test]
fn every_shadowing_is_registered() {
    assert_all_registered("Shadowing", &["VCavity"], is_written);
    // A macro implements the others.
    let members: BTreeSet<String> = sources()
        .iter()
        .flat_map(|code| code.split("impl From<").skip(1))
        .filter_map(|rest| rest.split_once("> for AnyShadowing"))
        .map(|(name, _)| name.to_owned())
        .filter(|name| name.chars().all(char::is_alphanumeric))
        .collect();
    assert!(members.contains("SmithSeparable"), "{members:?}");
    assert!(members.iter().all(|name| is_written(name)), "{members:?}");
}

#[test]
fn every_fresnel_term_is_registered() {
    assert_all_registered("Fresnel", &["Conductor", "Cook"], is_written);
}

#[test]
fn names_are_unique() {
    let names: BTreeSet<_> = models::rows().iter().map(|row| &row.name).collect();
    assert_eq!(names.len(), models::rows().len());
}

#[test]
fn the_bounds_of_a_form_hold_for_its_lines() {
    for row in models::rows() {
        let Promises { gain, bounds, largest_weight, .. } = row.promises;
        let albedo = gain.map_or(1.0, |gain| gain.albedo);
        let bounds = bounds.unwrap_or(Bounds { albedo: 1.0, weight: largest_weight });
        let within = albedo <= bounds.albedo && largest_weight <= 1.01 * bounds.weight;
        assert!(within, "{}: {bounds:?}", row.name);
    }
}
