//! Materials are found by key, symbol and name, and nothing is found by accident.

use std::collections::HashSet;

use brdf::materials::{self, ALL, Form, GOLD, GOLD_MCPEAK_2015, Kind, LookupError, Material, find};

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
    ] {
        assert_eq!(find(name).map(Material::key).ok(), Some(key), "{name}");
    }
    for (name, want) in [
        ("Quartz", ["quartz_o", "quartz_e"].as_slice()),
        ("acrylic", &["PMMA", "PMMA_sultanova"]),
        ("calcite", &["calcite_o", "calcite_e"]),
    ] {
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
            Err(LookupError::Unknown { name: got }) => assert_eq!(got, name.trim()),
            other => panic!("{name:?}: {other:?}"),
        }
    }
    assert_eq!(find("unobtanium").unwrap_err().to_string(), "no material is called \"unobtanium\"");
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
