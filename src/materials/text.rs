//! Optical constants from text.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::error::Error;
use core::fmt;

use super::constants::{OpticalConstants, RefractiveIndex, Sample, line};
use crate::error::{ParameterError, range};

/// Why a text has no optical constants, and in which line that is.
#[derive(Clone, Debug, PartialEq)]
pub struct TextError {
    line: usize,
    problem: TextProblem,
}

/// What is wrong with a line.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum TextProblem {
    /// The first line with data is not the header `wavelength_nm,n,k`, or there is none.
    NoHeader,
    /// There is no table of n.
    NoTable,
    /// A table of another type, as a dispersion formula.
    Type(String),
    /// A second table of n, or of k.
    Twice,
    /// The tables of n and of k have no two wavelengths in common.
    Apart,
    /// Not as many numbers as there should be.
    Count {
        /// How many there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// Something in the place of a number.
    NotANumber(String),
    /// What no constructor takes.
    Parameter(ParameterError),
}

impl TextError {
    const fn new(line: usize, problem: TextProblem) -> Self {
        Self { line, problem }
    }

    /// The line, counted from 1; one behind the last if something is missing.
    #[must_use]
    pub const fn line(&self) -> usize {
        self.line
    }

    /// What is wrong.
    #[must_use]
    pub const fn problem(&self) -> &TextProblem {
        &self.problem
    }
}

impl fmt::Display for TextError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.problem)
    }
}

impl fmt::Display for TextProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoHeader => f.write_str("expected the header `wavelength_nm,n,k`"),
            Self::NoTable => f.write_str(
                "expected a list behind `DATA:` with `- type: tabulated nk` or `- type: tabulated n` \
                 and the numbers behind `data: |`",
            ),
            Self::Type(name) => write!(
                f,
                "expected the type `tabulated nk`, `tabulated n` or `tabulated k`, not {name:?}"
            ),
            Self::Twice => f.write_str("this is given twice"),
            Self::Apart => f.write_str("n and k are not known at the same wavelengths"),
            Self::Count { expected, found } => {
                write!(f, "expected {expected} numbers, not {found}")
            }
            Self::NotANumber(text) => write!(f, "{text:?} is not a number"),
            // The line says where.
            Self::Parameter(error) => write!(f, "{} {}", error.parameter(), error.rule()),
        }
    }
}

impl Error for TextError {}

/// The lines of a text with their numbers, without what is blank at their ends.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines().enumerate().map(|(index, line)| (index + 1, line.trim_end()))
}

/// The number behind the last line.
fn end(text: &str) -> usize {
    text.lines().count() + 1
}

fn number(line: usize, text: &str) -> Result<f64, TextError> {
    text.parse().map_err(|_| {
        let beginning = text.chars().take(40).collect();
        TextError::new(line, TextProblem::NotANumber(beginning))
    })
}

/// Exactly as many fields as there should be.
fn fields<'a, const N: usize>(
    line: usize,
    found: impl Iterator<Item = &'a str>,
) -> Result<[&'a str; N], TextError> {
    let found: Vec<&str> = found.collect();
    let count = TextProblem::Count { expected: N, found: found.len() };
    found.try_into().map_err(|_| TextError::new(line, count))
}

/// Samples, and the line of each.
fn checked(
    samples: Vec<Sample>,
    lines: &[usize],
    end: usize,
) -> Result<OpticalConstants, TextError> {
    OpticalConstants::new(samples).map_err(|error| at_line(error, lines, end))
}

/// What is wrong with one of the numbers of these lines, or with all of them, which is said of the end.
fn at_line(error: ParameterError, lines: &[usize], end: usize) -> TextError {
    let line = error.position().and_then(|place| lines.get(place));
    TextError::new(line.copied().unwrap_or(end), TextProblem::Parameter(error))
}

pub(super) fn csv(text: &str) -> Result<OpticalConstants, TextError> {
    let mut rows = lines(text).filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let trimmed = |line| str::split(line, ',').map(str::trim);
    match rows.next() {
        Some((_, header)) if trimmed(header).eq(["wavelength_nm", "n", "k"]) => {}
        other => {
            let line = other.map_or(end(text), |(line, _)| line);
            return Err(TextError::new(line, TextProblem::NoHeader));
        }
    }
    let (mut samples, mut places) = (Vec::new(), Vec::new());
    for (line, row) in rows {
        let [wavelength, eta, k] = fields(line, trimmed(row))?;
        let at = |text| number(line, text);
        samples.push(Sample::new(at(wavelength)?, at(eta)?, at(k)?));
        places.push(line);
    }
    checked(samples, &places, end(text))
}

/// One column of a record: wavelengths and values, and the line of each.
#[derive(Default)]
struct Column {
    wavelengths: Vec<f64>,
    values: Vec<f64>,
    lines: Vec<usize>,
}

impl Column {
    fn push(&mut self, line: usize, wavelength: f64, value: f64) {
        self.wavelengths.push(wavelength);
        self.values.push(value);
        self.lines.push(line);
    }

    fn check(&self, name: &'static str, range: crate::Range) -> Result<(), TextError> {
        ParameterError::check_ascending("wavelength", range::WAVELENGTH, &self.wavelengths)
            .and_then(|()| ParameterError::check_each(name, range, &self.values))
            .map_err(|error| at_line(error, &self.lines, 0))
    }

    /// The value at a wavelength, if the column reaches there.
    fn at(&self, wavelength: f64) -> Option<f64> {
        let above = self.wavelengths.partition_point(|other| *other < wavelength);
        let (end, last) = (self.wavelengths.get(above)?, self.values.get(above)?);
        if *end == wavelength {
            return Some(*last);
        }
        let below = above.checked_sub(1)?;
        let (start, first) = (self.wavelengths.get(below)?, self.values.get(below)?);
        Some(line(wavelength, [*start, *end], [*first, *last]))
    }
}

/// What a table holds.
#[derive(Clone, Copy, PartialEq)]
enum Table {
    Both,
    Eta,
    K,
}

/// The columns of a record.
#[derive(Default)]
struct Record {
    eta: Option<Column>,
    k: Option<Column>,
}

impl Record {
    /// Begins a table.
    fn begin(&mut self, line: usize, table: Table) -> Result<(), TextError> {
        let (eta, k) = (table != Table::K, table != Table::Eta);
        if (eta && self.eta.is_some()) || (k && self.k.is_some()) {
            return Err(TextError::new(line, TextProblem::Twice));
        }
        self.eta = self.eta.take().or_else(|| eta.then(Column::default));
        self.k = self.k.take().or_else(|| k.then(Column::default));
        Ok(())
    }

    /// Takes a row of the table.
    fn row(&mut self, line: usize, table: Table, row: &str) -> Result<(), TextError> {
        let at = |text| number(line, text);
        let words = row.split_whitespace();
        let (wavelength, eta, k) = match table {
            Table::Both => {
                let [wavelength, eta, k] = fields(line, words)?;
                (wavelength, Some(at(eta)?), Some(at(k)?))
            }
            Table::Eta => {
                let [wavelength, eta] = fields(line, words)?;
                (wavelength, Some(at(eta)?), None)
            }
            Table::K => {
                let [wavelength, k] = fields(line, words)?;
                (wavelength, None, Some(at(k)?))
            }
        };
        let wavelength = nanometres(line, wavelength)?;
        for (column, value) in [(&mut self.eta, eta), (&mut self.k, k)] {
            if let (Some(column), Some(value)) = (column, value) {
                column.push(line, wavelength, value);
            }
        }
        Ok(())
    }

    fn join(self, end: usize) -> Result<OpticalConstants, TextError> {
        let Some(eta) = self.eta else {
            return Err(TextError::new(end, TextProblem::NoTable));
        };
        eta.check("eta", range::ETA)?;
        let Some(k) = self.k else {
            let samples = eta.wavelengths.iter().zip(&eta.values);
            let samples = samples.map(|(at, eta)| Sample::new(*at, *eta, 0.0)).collect();
            return checked(samples, &eta.lines, end);
        };
        k.check("k", range::K)?;
        let mut wavelengths: Vec<f64> = [&*eta.wavelengths, &k.wavelengths].concat();
        wavelengths.sort_by(f64::total_cmp);
        wavelengths.dedup();
        let joined = wavelengths.into_iter().filter_map(|wavelength| {
            let index = RefractiveIndex { eta: eta.at(wavelength)?, k: k.at(wavelength)? };
            Some(Sample { wavelength, index })
        });
        let joined: Vec<Sample> = joined.collect();
        if joined.len() < 2 && eta.values.len() > 1 && k.values.len() > 1 {
            return Err(TextError::new(end, TextProblem::Apart));
        }
        checked(joined, &[], end)
    }
}

/// Micrometres as a decimal number in nanometres, with the decimal point moved in the text: the `f64`
/// next to that.
fn nanometres(line: usize, text: &str) -> Result<f64, TextError> {
    let micrometres = number(line, text)?;
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let moved =
        exponent.parse::<i32>().map(|exponent| format!("{digits}e{}", exponent.saturating_add(3)));
    Ok(moved.ok().and_then(|moved| moved.parse().ok()).unwrap_or(micrometres * 1e3))
}

pub(super) fn refractiveindex_info(text: &str) -> Result<OpticalConstants, TextError> {
    let indent = |line: &str| line.len() - line.trim_start_matches(' ').len();
    let mut record = Record::default();
    // The table that is open, and where its key `data` stands once that is read.
    let mut open: Option<(Table, Option<usize>)> = None;
    let rows = lines(text).filter(|(_, line)| !line.is_empty());
    let under = rows.skip_while(|(_, line)| *line != "DATA:").skip(1);
    for (number, line) in under {
        let (indent, content) = (indent(line), line.trim_start());
        match open {
            Some((table, Some(key))) if indent > key => record.row(number, table, content)?,
            // The next key of the record ends the list.
            _ if indent == 0 && !content.starts_with(['-', '#']) => break,
            _ => {
                let entry = content.strip_prefix('-').map(str::trim_start);
                if entry.is_some() {
                    open = None;
                }
                match (entry.unwrap_or(content).split_once(':'), &mut open) {
                    (Some(("type", name)), open) => {
                        let table = match name.trim() {
                            "tabulated nk" => Table::Both,
                            "tabulated n" => Table::Eta,
                            "tabulated k" => Table::K,
                            other => {
                                let other = other.chars().take(40).collect::<String>();
                                return Err(TextError::new(number, TextProblem::Type(other)));
                            }
                        };
                        record.begin(number, table)?;
                        *open = Some((table, None));
                    }
                    (Some(("data", "" | " |")), Some((_, data))) => *data = Some(indent),
                    _ => {}
                }
            }
        }
    }
    record.join(end(text))
}
