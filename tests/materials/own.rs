//! Optical constants of one's own: from samples, from text with commas, from records of the
//! refractiveindex.info database.

use std::fmt::Write;
use std::fs;

use brdf::materials::{ALL, GOLD, OpticalConstants, Sample, TextProblem};
use brdf::{ParameterError, Spectrum};
use brdf_checks::path;
use brdf_checks::tables::rows;
use proptest::prelude::*;

/// The text of each built-in set makes the same constants, which answer the same bits.
#[test]
fn the_text_of_a_built_in_set_is_that_set() {
    for (material, entry) in ALL.into_iter().zip(rows("data/ior/index.csv")) {
        let text = fs::read_to_string(path(&format!("data/ior/{}", entry["file"]))).expect("text");
        let own = OpticalConstants::from_csv(&text).expect("a table");
        assert_eq!(own, **material, "{material}");
        assert_eq!(OpticalConstants::new(material.samples()).as_ref(), Ok(&**material));
        let (first, last) = material.range().into_inner();
        let between = [0.1, 0.5, 0.77].map(|part| first * (1.0 - part) + last * part);
        let at = Spectrum(between);
        assert_eq!(own.refractive_index(at), material.refractive_index(at), "{material}");
        assert_eq!(own.conductor(at), material.conductor(at), "{material}");
    }
}

/// A record of the database, as its files are laid out.
fn record(tables: &[(&str, &[&str])]) -> String {
    let mut text = String::from(
        "# this file is part of refractiveindex.info database\n\nREFERENCES: |\n    P. B. Johnson and \
         R. W. Christy.\n    DATA: of noble metals.\nCOMMENTS: \"Room temperature\"\nDATA:\n",
    );
    for (name, lines) in tables {
        let _ = writeln!(text, "  - type: {name}\n    data: |");
        for line in *lines {
            let _ = writeln!(text, "        {line}");
        }
    }
    text + "SPECS:\n    n_is_absolute: false\n    data: |\n        1 2 3\n"
}

#[test]
fn records_of_the_database_are_read() {
    // Its file has the wavelengths in micrometres; the built-in set is of the same numbers.
    let lines: Vec<String> = GOLD
        .samples()
        .map(|it| format!("{:.4} {} {}", it.wavelength / 1e3, it.index.eta, it.index.k))
        .collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    let text = record(&[("tabulated nk", &lines)]);
    let own = OpticalConstants::from_refractiveindex_info(&text).expect("a record");
    assert_eq!(own, *GOLD);

    // Indented less, with blanks behind words, and exponents.
    let text =
        "DATA:\r\n- type: tabulated nk \r\n  data: |\r\n    4E-1 1.5 1e-7\r\n    0.5e0 1.4 0";
    let own = OpticalConstants::from_refractiveindex_info(text).expect("a record");
    let want = [Sample::new(400.0, 1.5, 1e-7), Sample::new(500.0, 1.4, 0.0)];
    assert!(own.samples().eq(want), "{own:?}");
}

#[test]
fn two_tables_are_joined_where_both_are_known() {
    let eta: (&str, &[&str]) = ("tabulated n", &["0.4 1.6", "0.6 1.5", "0.8 1.4"]);
    let k: (&str, &[&str]) = ("tabulated k", &["0.5 0.01", "0.6 0.02", "0.9 0.05"]);
    let want = [
        Sample::new(500.0, 1.55, 0.01),
        Sample::new(600.0, 1.5, 0.02),
        Sample::new(800.0, 1.4, 0.04),
    ];
    for tables in [[eta, k], [k, eta]] {
        let joined = OpticalConstants::from_refractiveindex_info(&record(&tables)).expect("both");
        assert_eq!(joined.samples().len(), 3);
        for (got, want) in joined.samples().zip(want) {
            assert_eq!(got.wavelength, want.wavelength);
            assert!((got.index.eta - want.index.eta).abs() < 1e-15);
            assert!((got.index.k - want.index.k).abs() < 1e-15);
        }
    }
    let clear = OpticalConstants::from_refractiveindex_info(&record(&[eta])).expect("n alone");
    let want = [(400.0, 1.6), (600.0, 1.5), (800.0, 1.4)].map(|(at, n)| Sample::new(at, n, 0.0));
    assert!(clear.samples().eq(want));
}

#[test]
fn samples_are_checked_like_the_built_in_ones() {
    let good = [Sample::new(400.0, 1.5, 0.0), Sample::new(500.0, 1.4, 0.1)];
    let error = |place: usize, sample: Sample| -> ParameterError {
        let mut samples = good;
        samples[place] = sample;
        let error = OpticalConstants::new(samples).unwrap_err();
        assert_eq!(error.position(), Some(place));
        error
    };
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY, 2e9] {
        assert_eq!(error(1, Sample::new(wrong, 1.0, 0.0)).parameter(), "wavelength");
        assert_eq!(error(0, Sample::new(400.0, -wrong.abs(), 0.0)).parameter(), "eta");
        let negative = if wrong == 0.0 { -1e-300 } else { -wrong.abs() };
        assert_eq!(error(1, Sample::new(500.0, 1.0, negative)).parameter(), "k");
    }
    for wrong in [400.0, 399.0] {
        let text = error(1, Sample::new(wrong, 1.0, 0.0)).to_string();
        assert_eq!(
            text,
            format!("wavelength[1] must be above 400, the one before it, not {wrong}")
        );
    }
    for few in 0..2 {
        let error = OpticalConstants::new(good.into_iter().take(few)).unwrap_err();
        assert_eq!(error.to_string(), format!("number of samples must be at least 2, not {few}"));
    }
}

#[test]
fn errors_of_texts_name_the_line() {
    let csv = |text: &str| OpticalConstants::from_csv(text).unwrap_err().to_string();
    let head = "# remark\nwavelength_nm,n,k\n\n";
    for (text, want) in [
        ("", "line 1: expected the header `wavelength_nm,n,k`"),
        ("# remark\n400,1,0\n", "line 2: expected the header `wavelength_nm,n,k`"),
        (&format!("{head}400,1,0\n500,1\n"), "line 5: expected 3 numbers, not 2"),
        (&format!("{head}400,1,0,0\n"), "line 4: expected 3 numbers, not 4"),
        (&format!("{head}400,1,0\n500,x,0\n"), "line 5: \"x\" is not a number"),
        (&format!("{head}400,1,0\n500,1,nan\n"), "line 5: k must be between 0 and 10000, not NaN"),
        (
            &format!("{head}400,1,0\n# remark\n500,0,0\n"),
            "line 6: eta must be between 0.0001 and 10000, not 0",
        ),
        (
            &format!("{head}400,1,0\n500,1,0\n450,1,0\n"),
            "line 6: wavelength must be above 500, the one before it, not 450",
        ),
        (&format!("{head}400,1,0\n"), "line 5: number of samples must be at least 2, not 1"),
        (head, "line 4: number of samples must be at least 2, not 0"),
    ] {
        assert_eq!(csv(text), want, "{text}");
    }

    let record = |tables: &[(&str, &[&str])]| {
        OpticalConstants::from_refractiveindex_info(&record(tables)).unwrap_err()
    };
    // Line 8 names the type, line 10 is the first of its numbers.
    let eta: (&str, &[&str]) = ("tabulated n", &["0.4 1.6", "0.6 1.5"]);
    for (tables, line, want) in [
        (&[("formula 2", &[][..])][..], 8, "expected the type `tabulated nk`, `tabulated n` or"),
        (&[("tabulated k", &["0.4 1"])], 15, "expected a list behind `DATA:` with"),
        (&[], 12, "expected a list behind `DATA:` with"),
        (&[eta, eta], 12, "this is given twice"),
        (&[("tabulated nk", &["0.4 1 0", "0.5 1"])], 11, "expected 3 numbers, not 2"),
        (&[("tabulated nk", &["0.4 1 0", "0.5 1 one"])], 11, "\"one\" is not a number"),
        (&[("tabulated nk", &["0.4 1 0", "0.4 1 0"])], 11, "wavelength must be above 400,"),
        (
            &[("tabulated nk", &["0.4 1 -1", "0.5 1 0"])],
            10,
            "k must be between 0 and 10000, not -1",
        ),
        (
            &[eta, ("tabulated k", &["0.4 0", "0.5 -1"])],
            15,
            "k must be between 0 and 10000, not -1",
        ),
        (&[eta, ("tabulated k", &["0.6 0", "0.7 0"])], 20, "n and k are not known at the same"),
        (&[("tabulated n", &["0.4 1.5"])], 15, "number of samples must be at least 2, not 1"),
    ] {
        let error = record(tables);
        assert!(error.to_string().starts_with(&format!("line {line}: {want}")), "{error}");
        assert_eq!(error.line(), line);
    }
    let formula = record(&[("formula 2", &[])]);
    assert_eq!(*formula.problem(), TextProblem::Type("formula 2".into()));
}

proptest! {
    /// Whatever the text, there is an answer, and what is accepted is in its ranges.
    #[test]
    fn no_text_is_too_strange(
        lines in proptest::collection::vec(
            prop_oneof![
                Just("DATA:".to_owned()),
                Just("  - type: tabulated nk".to_owned()),
                Just("  - type: tabulated k".to_owned()),
                Just("    data: |".to_owned()),
                Just("wavelength_nm,n,k".to_owned()),
                "[ ]{0,9}[0-9.e -]{0,12}",
                "[0-9.e,-]{0,12}",
                "\\PC{0,20}",
            ],
            0..12,
        ),
    ) {
        let text = lines.join("\n");
        let csv = OpticalConstants::from_csv(&text);
        let record = OpticalConstants::from_refractiveindex_info(&text);
        for accepted in [csv, record] {
            match accepted {
                Ok(constants) => prop_assert!(OpticalConstants::new(constants.samples()).is_ok()),
                Err(error) => prop_assert!(error.line() >= 1 && error.line() <= lines.len() + 1),
            }
        }
    }
}
