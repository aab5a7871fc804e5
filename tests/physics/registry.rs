//! No public model is missing from the registry.

use std::collections::BTreeSet;
use std::path::Path;

use crate::common::models;

/// The types of the crate that implement a trait over numbers, read from the sources. Descriptions
/// build models of these types and are tested to equal them.
fn implementors(of: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut rooms = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
    while let Some(room) = rooms.pop() {
        for entry in room.read_dir().expect("a directory of sources") {
            let path = entry.expect("an entry of it").path();
            if path.is_dir() {
                rooms.extend((!path.ends_with("description")).then_some(path));
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = std::fs::read_to_string(&path).expect("a source file");
                // Documentation shows how users write their own; tests have helpers.
                let text = text.split("#[cfg(test)]").next().unwrap_or_default();
                let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
                let code: String = code.collect::<Vec<_>>().join(" ");
                found.extend(code.split("impl").filter_map(|rest| implementor(rest, of)));
            }
        }
    }
    found
}

/// The name of the type in `<T, D> Trait<T> for Name<D> where`, without its path and arguments.
fn implementor(rest: &str, of: &str) -> Option<String> {
    let head = rest.split('{').next()?;
    let (left, right) = head.split_once(" for ")?;
    let implemented = left.rsplit([' ', '>']).find(|word| !word.is_empty());
    let trait_name = left.match_indices(of).any(|(at, _)| {
        let before = left[..at].chars().next_back().unwrap_or(' ');
        let after = left[at + of.len()..].chars().next().unwrap_or(' ');
        before == ' ' && after == '<'
    });
    implemented?;
    let name: String =
        right.trim().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    // Pointers, and the placeholders of macros, are forwarded to what they point at.
    let is_model = !name.is_empty() && !["Box", "Arc", "Rc"].contains(&name.as_str());
    (trait_name && is_model).then_some(name)
}

/// The types of all entries, as one text. A type's name leaves out the V-cavities that
/// Cook-Torrance has by default.
fn registered() -> String {
    let v_cavities = |name: &str| name.contains("CookTorrance<") && !name.contains("Smith");
    let names = models::all::<f64>().into_iter().map(|entry| {
        entry.type_name.to_owned() + if v_cavities(entry.type_name) { " VCavity " } else { " " }
    });
    names.collect()
}

fn assert_all_registered(trait_name: &str, at_least: &[&str]) {
    let found = implementors(trait_name);
    for name in at_least {
        assert!(found.contains(*name), "{name} was not found among {found:?}");
    }
    let registered = registered();
    for name in &found {
        let word = |part: &str| part == name.as_str();
        let known = registered.split(|c: char| !c.is_alphanumeric() && c != '_').any(word);
        assert!(known, "the {trait_name} {name} is missing from the registry");
    }
}

#[test]
fn every_model_is_registered() {
    let some = ["Lambert", "CookTorrance", "WeightedSum", "Blinn1977Printed"];
    assert_all_registered("Brdf", &some);
}

#[test]
fn every_distribution_is_registered() {
    assert_all_registered("Distribution", &["Beckmann", "Mixture"]);
}

#[test]
fn every_shadowing_is_registered() {
    assert_all_registered("Shadowing", &["VCavity", "SmithSeparable"]);
}

#[test]
fn every_fresnel_term_is_registered() {
    assert_all_registered("Fresnel", &["Conductor", "Cook"]);
}

#[test]
fn names_are_unique() {
    let entries = models::all::<f64>();
    let names: BTreeSet<_> = entries.iter().map(|entry| entry.name).collect();
    assert_eq!(names.len(), entries.len());
}
