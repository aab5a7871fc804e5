//! `src/materials/sets.rs` and `src/materials/samples` are made of `data/ior` and `data/notes.csv` by
//! this test.
//!
//! It compares; with `BRDF_REGENERATE=1` in the environment it writes.

use std::fmt::Write;
use std::fs;

use brdf_checks::path;
use brdf_checks::tables::{Row, compare, header, rows};

const HEADER: &str = "\
// Made of `data/ior` and `data/notes.csv` by `tests/materials/generate.rs`; not to be edited.

use super::constants::OpticalConstants;
use super::material::{Form, Kind, Material};
";

#[test]
fn the_embedded_sets_are_those_of_the_tables() {
    let index = corrected(rows("data/ior/index.csv"));
    compare("src/materials/sets.rs", sets(&index).as_bytes());
    for row in &index {
        compare(&format!("src/materials/samples/{}.bin", row["key"]), &samples(row));
    }
    let count = fs::read_dir(path("src/materials/samples")).expect("a folder").count();
    assert_eq!(count, index.len(), "a file in src/materials/samples belongs to no set");
}

/// A Rust string literal.
fn literal(text: &str) -> String {
    format!("{text:?}")
}

/// `Red brass (85% Cu, 15% Zn)` is `RED_BRASS_85_CU_15_ZN`.
fn identifier(name: &str) -> String {
    let words = name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("_").to_uppercase()
}

/// Text in a documentation comment: brackets are no links, addresses are.
fn documentation(text: &str) -> String {
    let text = text.replace('[', "\\[").replace(']', "\\]").replace('*', "\\*");
    let mut words: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let address = word.find("http").map_or("", |start| &word[start..]);
        let address = address.split("See").next().unwrap_or_default();
        let address = address.trim_end_matches(['.', ',', ')', ']', '\\']);
        words.push(match address {
            "" => word.to_owned(),
            _ => word.replace(address, &format!("<{address}>")),
        });
    }
    words.join(" ")
}

/// The index with what the notes know better.
fn corrected(mut index: Vec<Row>) -> Vec<Row> {
    for row in &mut index {
        let file = format!("data/ior/{}", row["file"]);
        row.insert("preparation".into(), header(&file, "data"));
    }
    for note in rows("data/notes.csv") {
        let row = index.iter_mut().find(|row| row["key"] == note["key"]);
        let row = row.unwrap_or_else(|| panic!("a note on {}, which is no set", note["key"]));
        for column in ["kind", "preparation", "remark"] {
            if !note[column].is_empty() {
                row.insert(column.into(), note[column].clone());
            }
        }
    }
    index
}

fn sets(index: &[Row]) -> String {
    let mut text = HEADER.to_owned();
    for row in index {
        let kind = match row["kind"].as_str() {
            "metal" => "Metal",
            "alloy" => "Alloy",
            "semiconductor" => "Semiconductor",
            "dielectric" => "Dielectric",
            "metal-alt" => "Alternative",
            "caution" => "Caution",
            other => panic!("unknown kind {other}"),
        };
        let form = match row["source_form"].as_str() {
            "table" => "Table",
            "formula" => "Formula",
            other => panic!("unknown form {other}"),
        };
        let remark = match row["remark"].as_str() {
            "" => "None".to_owned(),
            remark => format!("Some({})", literal(remark)),
        };
        let (key, name, citation) = (&row["key"], &row["name"], &row["citation"]);
        let warning = match (kind, row["remark"].as_str()) {
            (_, "") => String::new(),
            ("Caution", remark) => {
                format!("\n///\n/// **Not for colour:** {}.", documentation(remark))
            }
            (_, remark) => format!("\n///\n/// Remark: {}.", documentation(remark)),
        };
        let (lower, upper) = (&row["lambda_min_nm"], &row["lambda_max_nm"]);
        write!(
            text,
            "
/// {name}, {lower} to {upper} nm.{warning}
///
/// {}
pub static {}: Material = Material {{
    key: {},
    name: {},
    kind: Kind::{kind},
    citation: {},
    license: {},
    form: Form::{form},
    preparation: {},
    remark: {remark},
    constants: OpticalConstants::packed(include_bytes!(\"samples/{key}.bin\")),
}};
",
            documentation(citation),
            identifier(name),
            literal(key),
            literal(name),
            literal(citation),
            literal(&row["license"]),
            literal(&row["preparation"]),
        )
        .expect("a string takes all text");
    }
    write!(
        text,
        "
/// All materials: metals, alloys, second opinions on metals, semiconductors, dielectrics.
pub static ALL: [&Material; {}] = [
",
        index.len()
    )
    .expect("a string takes all text");
    for row in index {
        writeln!(text, "    &{},", identifier(&row["name"])).expect("a string takes all text");
    }
    text.push_str("];\n");
    text
}

fn samples(set: &Row) -> Vec<u8> {
    let mut bytes = Vec::new();
    for row in rows(&format!("data/ior/{}", set["file"])) {
        bytes.extend(&word(&row["wavelength_nm"], 24).to_le_bytes()[..3]);
        bytes.extend(word(&row["n"], 32).to_le_bytes());
        bytes.extend(&word(&row["k"], 24).to_le_bytes()[..3]);
    }
    bytes
}

/// A decimal number as its digits below 4 bits of decimal places.
fn word(number: &str, bits: u32) -> u32 {
    let (digits, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let exponent: i32 = exponent.parse().expect("an exponent");
    let mut integer: u32 = format!("{whole}{fraction}").parse().expect("digits");
    let mut places = i32::try_from(fraction.len()).expect("few digits") - exponent;
    while places > 0 && integer.is_multiple_of(10) {
        (integer, places) = (integer / 10, places - 1);
    }
    let fits = (0..16).contains(&places) && integer < 1 << (bits - 4);
    assert!(fits, "{number} does not fit into {bits} bits");
    integer | u32::try_from(places).expect("not negative") << (bits - 4)
}
