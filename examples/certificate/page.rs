//! The text of the certificate.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use crate::row::{ANGLES, DERIVATIVES, PAIRS, Row, SIZE};
use brdf_checks::measure::sampling::chi_squared::least_of;
use brdf_checks::measure::sampling::{WEIGHT_ULPS, viewers};
use brdf_checks::mutation::mutant::Outcome;

const HEAD: &str = "\
# What was measured of every model

Written by `cargo run --release --example certificate`; `-- --check` measures every 32nd line anew and
compares. The first table has one line for each model, with the worst of its sets of parameters. A
model whose albedo exceeds 1 reflects more than it receives; a `WeightedSum` does not if its terms do not
and the weights of each channel add up to at most 1. Where a largest albedo has two figures, the
second is that of the sets that exceed 1, and names the worst of them.
";

const ALL: &str = "
## All sets of parameters

The second table has one line for each model and set of parameters that the tests know
(`tests/registry.jsonl`). Its columns mean:";

const BUGS: &str = "\
Each formula runs on any number, so a bug can be seeded by a number that errs: at one place of the
source, in one operation, it answers something else. Nothing of this is in the crate. The checks
(`tests/checks/src/mutation`) run once for each bug, which counts as found if at least one fails.
They all pass when no bug is seeded.";

const COSTS: &str = "
## What a call costs

Divisions, square roots and other functions (exponentials, logarithms, powers, trigonometric and
error functions) in one call with three channels, as written: the compiler leaves out what a model
does not use of the half vector, and what depends on parameters alone.

| model | `eval`: divisions | roots | functions | `pdf`: divisions | roots | functions | `sample`: divisions | roots | functions |
|---|---|---|---|---|---|---|---|---|---|
";

/// How many χ² so many rows have.
fn tests(rows: usize) -> usize {
    2 * rows * viewers::all().len()
}

/// What all p-values of so many rows exceed with probability 0.99 if all samplers are right.
pub(crate) fn least(rows: usize) -> f64 {
    least_of(tests(rows))
}

/// What the columns mean.
fn legend(rows: &[Row]) -> String {
    let directions = viewers::all().len();
    let (draws, tests, least) = (SIZE.draws, tests(rows.len()), least(rows.len()));
    let (pairs, _) = DERIVATIVES;
    format!(
        "- **Largest albedo.** ∫ f cosθ dω by adaptive cubature of `eval` in `f64` at {ANGLES} angles of
  the viewer from 0° to 89.99°, along both axes where the model is anisotropic; brightest channel.
  No more than 1 + 10⁻¹² for a model that promises to conserve energy.
- **Reciprocal.** The largest difference of f(wi, wo) from f(wo, wi) over {PAIRS} pairs of
  directions, a half of them grazing with cosines down to 10⁻⁶, in units in the last place, in `f64`
  and in `f32`.
- **`f32` error.** The relative difference of `eval` in `f32` from `f64` at the same pairs: median,
  largest, and the largest part of what mixed forward and backward stability allows: 2·10⁻⁶ and
  what a rounding of the directions themselves does.
- **Derivatives.** How many were compared: of `eval`, `pdf`, `sample` and, where it is a formula,
  `albedo`, over duals of `f64`, by every number of the model and by the azimuth and tilt of both
  directions, at {pairs} pairs, at pairs that are equally steep and at the normal. The largest relative
  difference from Richardson's extrapolation of differences, derivatives below 10⁻³ of the value over the number
  counting as that; and how many such differences cannot tell to a quarter of 10⁻⁶.
- **∫ pdf − 1.** The largest |∫ pdf dω + P(no direction) − 1| over {directions} directions of the viewer,
  from the normal to a cosine of 0.001: one integral by cubature of `pdf`, the other over the uniform
  numbers for which `sample` fails.
- **Smallest p.** {draws} samples from each of these directions in `f64` and as many in `f32`, counted
  in about 256 cells that follow the lobe, against the integral of `pdf` over each cell; the least
  probability of a χ² as large, 0 if a sample falls where none can. In {tests} such tests of samplers
  without a fault, a p below {least:.1e} turns up with a chance of 1 %. The uniform numbers have 53
  bits, those in `f32` are rounded down to 24 significant ones: numbers in steps of 2⁻²⁴ would be 0, which
  may be the end of a tail, once in 1.7·10⁷ times.
- **Weight.** How far the weight of a sample is from `eval` · cosθ/`pdf`, in units in the last place; in
  theory, by counting roundings, no more than {WEIGHT_ULPS:.0}.
- **Bugs found.** Of the bugs below those in an operation on the way to the model's answers."
    )
}

/// The page: a line for each kind of model, one for each entry of the registry, and the bugs.
pub(crate) fn certificate(rows: &[Row], bugs: &[Outcome]) -> String {
    let mut page = format!(
        "{HEAD}
{}{ALL}

{}

| model | largest albedo | at | reciprocal | `f32` error, median | largest | of its bound | derivatives | largest error | undecided | ∫ pdf − 1 | smallest p | weight | bugs found |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|
",
        summary(rows),
        legend(rows)
    );
    for row in rows {
        let _ = writeln!(page, "{} {} of {} |", measured(row), row.found, row.bugs);
    }
    page += COSTS;
    for row in rows {
        let _ = writeln!(page, "{}", costs(row));
    }
    let found = bugs.iter().filter(|bug| bug.killed()).count();
    let _ = write!(page, "\n## {found} of {} seeded bugs are found\n\n{BUGS}\n\n", bugs.len());
    page += "| part | bug | found by |\n|---|---|---|\n";
    for bug in bugs {
        let checks: BTreeSet<&str> = bug.killers.iter().map(|killer| killer.check).collect();
        let checks: Vec<&str> = checks.into_iter().collect();
        let (family, meaning) = (bug.mutant.family, bug.mutant.meaning);
        let _ = writeln!(page, "| {family} | {meaning} | {} |", checks.join("; "));
    }
    page
}

/// The line of a model without the bugs.
pub(crate) fn measured(row: &Row) -> String {
    format!(
        "| {} | {:.5} | {:.2}° | {} | {:.1e} | {:.1e} | {:.2} | {} | {:.0e} | {} | {:.0e} | {:.4} | {:.0} ulp |",
        row.name,
        row.energy.maximum,
        row.energy.degrees,
        reciprocal(row),
        row.precision.median,
        row.precision.maximum,
        row.precision.ratio,
        row.derivatives.compared,
        row.derivatives.largest,
        row.derivatives.undecided,
        row.mass_error(),
        row.p_value(),
        row.weight_ulps(),
    )
}

/// The line of what a call costs.
pub(crate) fn costs(row: &Row) -> String {
    let costs =
        row.costs.map(|cost| format!("{} | {} | {} |", cost.divisions, cost.roots, cost.functions));
    format!("| {} | {}", row.name, costs.join(" "))
}

/// Zero, or how far from it.
fn reciprocal(row: &Row) -> String {
    let (double, single) = (row.reciprocity_f64, row.reciprocity_f32);
    if double.ulp.max(single.ulp) < 1e3 {
        format!("{:.0}, {:.0} ulp", double.ulp, single.ulp)
    } else {
        format!("no, {:.0} % apart", 100.0 * double.relative)
    }
}

/// A table with one line for each kind of model, the worst of its entries.
fn summary(rows: &[Row]) -> String {
    let mut kinds: Vec<&str> = Vec::new();
    let mut entries: BTreeMap<&str, Vec<&Row>> = BTreeMap::new();
    for row in rows {
        if !entries.contains_key(row.kind.as_str()) {
            kinds.push(&row.kind);
        }
        entries.entry(&row.kind).or_default().push(row);
    }
    let mut table = String::from(
        "| model | sets of parameters | reciprocal | largest albedo | smallest p of χ² | `f32` error, median, largest |
|---|---|---|---|---|---|
",
    );
    for kind in kinds {
        let rows = &entries[kind];
        let largest = |of: fn(&Row) -> f64| rows.iter().map(|row| of(row)).fold(0.0, f64::max);
        let exact = largest(|row| row.reciprocity_f64.ulp.max(row.reciprocity_f32.ulp)) == 0.0;
        let _ = writeln!(
            table,
            "| `{kind}` | {} | {} | {} | {:.4} of {} | {:.1e}, {:.1e} |",
            rows.len(),
            if exact { "to the last bit" } else { "no" },
            albedos(rows),
            rows.iter().map(|row| row.p_value()).fold(1.0, f64::min),
            rows.iter().map(|row| 2 * row.sampling.len()).sum::<usize>(),
            largest(|row| row.precision.median),
            largest(|row| row.precision.maximum),
        );
    }
    table
}

/// The largest albedo of the entries that conserve energy, and of those that do not.
fn albedos(rows: &[&Row]) -> String {
    let brightest = |gains: bool| {
        let some = rows.iter().filter(|row| (row.energy.maximum > 1.0 + 1e-12) == gains);
        some.max_by(|a, b| a.energy.maximum.total_cmp(&b.energy.maximum))
    };
    let conserving = brightest(false).map(|row| format!("{:.4}", row.energy.maximum));
    let gaining = brightest(true).map(|row| format!("{:.4} ({})", row.energy.maximum, row.name));
    conserving.into_iter().chain(gaining).collect::<Vec<_>>().join("; ")
}
