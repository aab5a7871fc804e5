//! Tables of numbers as text: rows of comma-separated values with a header and `#` comments.

use std::collections::HashMap;
use std::fs;

use crate::path;

/// A row of a table with a header, by column.
pub type Row = HashMap<String, String>;

/// The rows of a file.
pub fn rows(relative: &str) -> Vec<Row> {
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_path(path(relative))
        .unwrap_or_else(|error| panic!("{relative}: {error}"));
    let rows: Vec<Row> = reader.deserialize().map(|row| row.expect("a row")).collect();
    assert!(!rows.is_empty(), "{relative} is empty");
    rows
}

/// A number in a row.
pub fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column}: {:?} is not a number", row[column]))
}

/// The text of a line `# label: text` in the head of a file.
pub fn header(relative: &str, label: &str) -> String {
    let text = crate::text(relative);
    let start = format!("# {label}: ");
    let line = text.lines().find_map(|line| line.strip_prefix(&start));
    line.unwrap_or_else(|| panic!("{relative}: no {label}")).to_owned()
}

/// Compares a file that is made of others with what it should be; with `BRDF_REGENERATE=1` in
/// the environment, writes it first.
pub fn compare(relative: &str, want: &[u8]) {
    if std::env::var_os("BRDF_REGENERATE").is_some() {
        fs::write(path(relative), want).expect("the file can be written");
    }
    let got = fs::read(path(relative)).unwrap_or_default();
    assert!(got == want, "{relative} is out of date: run this test with BRDF_REGENERATE=1");
}
