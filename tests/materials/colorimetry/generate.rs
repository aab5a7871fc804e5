//! `src/colorimetry/tables.rs` is made of `data/cie` by this test.
//!
//! It compares; with `BRDF_REGENERATE=1` in the environment it writes.

use std::fmt::Write;

use brdf_checks::tables::{Row, compare, number, rows};

const HEADER: &str = "\
// Made of `data/cie` by `tests/colorimetry/generate.rs`; not to be edited. Tables of CIE 015 and
// CIE 018 as shipped by colour-science 0.4.7, copyright 2013 Colour Developers, BSD 3-clause:
// LICENSE-BSD-3-Clause-colour-science.
";

/// The rows from 380 to 780 nm.
fn visible(relative: &str) -> Vec<Row> {
    let mut rows = rows(relative);
    rows.retain(|row| (380.0..=780.0).contains(&number(row, "wavelength_nm")));
    for (index, row) in rows.iter().enumerate() {
        assert_eq!(number(row, "wavelength_nm"), 380.0 + 5.0 * index as f64);
    }
    rows
}

/// One array of the source text.
fn array(text: &mut String, head: &str, values: impl Iterator<Item = String>) {
    writeln!(text, "\n{head} = [").expect("a string takes all text");
    for value in values {
        writeln!(text, "    {value},").expect("a string takes all text");
    }
    text.push_str("];\n");
}

#[test]
fn the_embedded_tables_are_those_of_the_data() {
    let (matching, power) =
        (visible("data/cie/cmf_1931_2deg_5nm.csv"), visible("data/cie/illuminants_5nm.csv"));
    assert!(power.iter().all(|row| number(row, "E") == 100.0));
    let float = |row: &Row, column: &str| format!("{:?}", number(row, column));
    let mut text = HEADER.to_owned();
    array(
        &mut text,
        "/// The wavelengths of the tables in nanometres: 380 to 780 in steps of 5.\n\
         pub const WAVELENGTHS: [f64; 81]",
        matching.iter().map(|row| float(row, "wavelength_nm")),
    );
    array(
        &mut text,
        "/// x̄, ȳ and z̄ of the CIE 1931 2° standard observer at the [`WAVELENGTHS`].\n\
         pub static COLOR_MATCHING: [[f64; 3]; 81]",
        matching.iter().map(|row| {
            format!("[{}, {}, {}]", float(row, "xbar"), float(row, "ybar"), float(row, "zbar"))
        }),
    );
    for (column, what) in [("D65", "daylight of 6504 K"), ("A", "a tungsten lamp of 2856 K")] {
        array(
            &mut text,
            &format!(
                "/// Relative power of {what}, 100 at 560 nm.\n\
                 pub(super) static {column}: [f64; 81]"
            ),
            power.iter().map(|row| float(row, column)),
        );
    }
    compare("src/colorimetry/tables.rs", text.as_bytes());
}
