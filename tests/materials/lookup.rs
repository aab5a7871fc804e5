//! Materials are found by key, symbol and name, and nothing is found by accident.

use std::collections::HashSet;

use brdf::materials::{self, ALL, Form, GOLD, GOLD_MCPEAK_2015, Kind, LookupError, Material, find};
use brdf_checks::path;

fn keys<'a>(materials: impl IntoIterator<Item = &'a Material>) -> Vec<&'static str> {
    materials.into_iter().map(Material::key).collect()
}

#[test]
fn every_key_and_name_finds_its_own_material() {
    for material in ALL {
        for name in [material.key(), material.name()] {
            for name in
                [name.to_owned(), name.to_uppercase(), format!(" {}\n", name.to_lowercase())]
            {
                assert!(std::ptr::eq(find(&name).expect("is found"), material), "{name}");
            }
        }
    }
    let names: HashSet<String> = ALL
        .iter()
        .flat_map(|material| {
            HashSet::from([material.key(), material.name()].map(str::to_lowercase))
        })
        .collect();
    let alike = ALL.iter().filter(|one| one.key() == one.name().to_lowercase()).count();
    assert_eq!(names.len() + alike, 2 * ALL.len(), "two materials share a name");
}

#[test]
fn short_names_mean_one_material_or_say_which() {
    for (name, key) in [
        ("mercury", "Hg"),
        ("Brass", "brass_Cu70Zn30"),
        ("red brass", "brass_Cu85Zn15"),
        ("Soda-lime window glass", "soda_lime"),
        ("aluminum", "Al"),
        ("Aluminium", "Al"),
        ("water", "water"),
        ("diamond", "diamond"),
        ("acrylic", "PMMA"),
        ("N-BK7", "BK7"),
        ("electrum", "electrum_Au50Ag50"),
        ("soda-lime", "soda_lime"),
        ("Silica", "fused_silica"),
        ("HALITE", "NaCl"),
        ("steel", "stainless_steel"),
    ] {
        assert_eq!(find(name).map(Material::key).ok(), Some(key), "{name}");
    }
    for (name, want) in
        [("Quartz", ["quartz_o", "quartz_e"].as_slice()), ("calcite", &["calcite_o", "calcite_e"])]
    {
        match find(name) {
            Err(LookupError::Ambiguous { name: got, candidates }) => {
                assert_eq!((got.as_str(), keys(candidates).as_slice()), (name, want));
            }
            other => panic!("{name}: {other:?}"),
        }
    }
}

#[test]
fn what_is_not_there_is_not_found() {
    for name in ["", " ", "Xx", "gol", "golden", "Au_", "(", ",", "\0", "ＡＵ", "Gold ("] {
        match find(name) {
            Err(LookupError::Unknown { name: got, .. }) => assert_eq!(got, name.trim()),
            other => panic!("{name:?}: {other:?}"),
        }
    }
    assert_eq!(find("unobtanium").unwrap_err().to_string(), "no material is called \"unobtanium\"");
}

#[test]
fn near_names_are_suggested() {
    for (name, near) in [
        ("TiO2", ["TiO2_o", "TiO2_e", "TiO2_film"].as_slice()),
        ("golden", &["Au", "Au_mcpeak"]),
        ("coper", &["Cu", "Cu_mcpeak"]),
        ("Titanum", &["Ti", "Ti_rakic"]),
        ("window", &["soda_lime"]),
        ("stainles steel", &["stainless_steel"]),
        ("C", &[]),
        ("Xx", &[]),
        ("unobtanium", &[]),
    ] {
        match find(name) {
            Err(LookupError::Unknown { nearest, .. }) => {
                assert_eq!(keys(nearest), near, "{name}");
            }
            other => panic!("{name}: {other:?}"),
        }
    }
    assert_eq!(
        find("TiO2").unwrap_err().to_string(),
        "no material is called \"TiO2\"; near it are TiO2_o, TiO2_e, TiO2_film"
    );
    // Long texts are compared with nothing.
    assert!(find(&"gold".repeat(1_000_000)).is_err());
}

/// The other names are those of the documentation, and hide no name.
#[test]
fn other_names_are_documented() {
    let source = std::fs::read_to_string(path("src/materials/lookup.rs")).expect("is there");
    let mut count = 0;
    let rows = source.lines().filter_map(|line| line.strip_prefix("/// | ")).skip(1);
    for (names, key) in rows.filter_map(|row| row.split_once(" | ")) {
        for name in names.split(", ") {
            assert_eq!(find(name).expect(name).key(), key.trim_matches(['`', ' ', '|']), "{name}");
            assert!(ALL.iter().all(|one| one.key() != name && one.name() != name), "{name}");
            count += 1;
        }
    }
    assert_eq!(count, 12);
}

/// One rule for metals and for transparent media: the key with an author is the second opinion.
#[test]
fn second_opinions_are_listed_from_both_sides() {
    let mut pairs = 0;
    for material in ALL {
        let others = keys(material.alternatives());
        match material.key() {
            "Ag" | "Al" | "Au" | "Cu" | "Mo" | "Pt" | "Cr" | "Ti" | "W" | "water" | "diamond"
            | "PMMA" | "polycarbonate" | "polystyrene" => {
                assert_eq!(others.len(), 1, "{material}");
                assert!(others[0].starts_with(&format!("{}_", material.key())));
                assert_eq!(keys(find(others[0]).expect("a key").alternatives()), [material.key()]);
                pairs += 1;
            }
            "quartz_o" | "quartz_e" | "TiO2_o" | "TiO2_film" | "soda_lime" | "Zn" => {
                assert!(others.is_empty(), "{material}: {others:?}");
            }
            _ => assert!(others.len() < 2, "{material}: {others:?}"),
        }
    }
    let listed: usize = ALL.iter().map(|one| one.alternatives().count()).sum();
    assert_eq!((pairs, listed), (14, 28));
}

#[test]
fn second_opinions_stay_selectable() {
    assert_eq!(keys(GOLD.alternatives()), ["Au_mcpeak"]);
    assert_eq!(keys(GOLD_MCPEAK_2015.alternatives()), ["Au"]);
    assert!(GOLD.citation().starts_with("P. B. Johnson and R. W. Christy"));
    assert!(GOLD_MCPEAK_2015.citation().contains("McPeak"));
    let second: Vec<_> = ALL.into_iter().filter(|one| one.kind() == Kind::Alternative).collect();
    assert_eq!(second.len(), 9);
    for material in second {
        let symbol = material.symbol().expect("an element");
        let first = find(symbol).expect("has a first set");
        assert_eq!(first.kind(), Kind::Metal);
        assert_eq!(keys(first.alternatives()), [material.key()]);
    }
    assert_eq!(materials::BRASS_70_CU_30_ZN.symbol(), None);
    assert_eq!(materials::BRASS_70_CU_30_ZN.alternatives().count(), 0);
}

#[test]
fn every_material_says_where_it_comes_from() {
    for material in ALL {
        assert!(material.citation().len() > 30, "{material}");
        assert_eq!(material.license(), "CC0-1.0");
        let formula = material.preparation().starts_with("dispersion formula");
        assert_eq!(formula, material.form() == Form::Formula, "{material}");
    }
}

/// What a set says about itself does not contradict where it comes from and what it holds.
#[test]
fn remarks_are_right() {
    for material in ALL {
        let (citation, remark) = (material.citation(), material.remark().unwrap_or_default());
        let (lower, upper) = material.range().into_inner();
        for (words, end) in [("starts at ", lower), ("ends at ", upper)] {
            if let Some(limit) = remark.strip_prefix(words) {
                assert_eq!(limit, format!("{end} nm"), "{material}");
            }
        }
        let digitised = citation.contains("extracted from a figure");
        assert_eq!(material.preparation() == "samples read off a figure", digitised, "{material}");
        assert_eq!(remark.contains("figure"), digitised, "{material}");
        // Of a model the database says so in words of several kinds.
        let calculated =
            ["Calculation script", "MATLAB model"].iter().any(|w| citation.contains(w))
                && material.form() == Form::Table;
        assert_eq!(material.preparation().starts_with("table of a"), calculated, "{material}");
        assert_eq!(remark.contains("values of a"), calculated, "{material}");
    }
}
