//! Models over the whole sphere: what is measured of them, and their part of the page.

use std::fmt::Write;

use brdf::description::BrdfDescription;
use brdf_checks::directions::pairs_to_grazing;
use brdf_checks::interfaces::{self, Entry, viewers};
use brdf_checks::measure::sampling::chi_squared::least_of;
use brdf_checks::measure::sphere::{
    Adjointness, Powers, Sampling, adjointness, powers, precision, sampling,
};
use brdf_checks::models;
use glam::DVec3;
use rayon::prelude::*;

/// Where their part of the page begins.
pub(crate) const HEADING: &str = "\n## Models over the whole sphere\n";

/// Draws from each direction, in each precision.
const DRAWS: u32 = 1_000_000;

/// What is measured of a line of `tests/interfaces.jsonl`.
pub(crate) struct Row {
    name: &'static str,
    lossless: bool,
    powers: Powers,
    double: Adjointness,
    single: Adjointness,
    precision: Option<[f64; 2]>,
    sampling: Vec<Sampling>,
}

impl Row {
    pub(crate) fn measure(single: &Entry<f32>, double: &Entry<f64>) -> Self {
        let rough = viewers().into_par_iter().filter(|_| double.row.is_rough());
        Self {
            name: &double.row.name,
            lossless: double.row.lossless,
            powers: powers(double),
            double: adjointness(double),
            single: adjointness(single),
            precision: precision(double, single),
            sampling: rough.map(|wo| sampling(&*double.model, &*single.model, wo, DRAWS)).collect(),
        }
    }

    fn p_value(&self) -> f64 {
        let both = |seen: &Sampling| seen.double.p_value.min(seen.single.p_value);
        self.sampling.iter().map(both).fold(1.0, f64::min)
    }

    /// What the model does that it must not.
    pub(crate) fn fault(&self) -> Option<String> {
        let Powers { least, largest } = self.powers;
        let kept = !self.lossless || least >= 1.0 - 1e-13;
        let right = largest <= 1.0 + 1e-13
            && kept
            && self.double.modes == 0.0
            && self.single.modes == 0.0
            && self.double.reciprocity.max(self.single.reciprocity) <= RECIPROCITY
            && self.p_value() > least_p();
        (!right).then(|| self.line())
    }

    /// The line of the page.
    pub(crate) fn line(&self) -> String {
        let Powers { least, largest } = self.powers;
        let sums = if self.lossless {
            format!("1 ± {:.0e}", (1.0 - least).max(largest - 1.0).max(0.0))
        } else {
            format!("{least:.4} … {largest:.4}")
        };
        let pair = |of: fn(&Adjointness) -> f64| {
            format!("{:.0}, {:.0} ulp", of(&self.double), of(&self.single))
        };
        let [median, worst] =
            self.precision.map_or(["–".to_owned(), "–".to_owned()], |errors| {
                errors.map(|error| format!("{error:.1e}"))
            });
        let p = if self.sampling.is_empty() {
            "–".to_owned()
        } else {
            format!("{:.4}", self.p_value())
        };
        format!(
            "| {} | {sums} | {} | {} | {} | {} | {median} | {worst} | {p} |",
            self.name,
            pair(|found| found.reciprocity),
            pair(|found| found.modes),
            pair(|found| found.lobes),
            pair(|found| found.weights),
        )
    }
}

/// Of f/n² there and back: the squares of the indices and the products with them are rounded.
const RECIPROCITY: f64 = 4.0;

/// How many χ² there are on the page.
fn tests() -> usize {
    2 * viewers().len() * interfaces::rows().iter().filter(|row| row.is_rough()).count()
}

/// What all p-values exceed with probability 0.99 if all samplers are right.
fn least_p() -> f64 {
    least_of(tests())
}

/// How realisable the Mueller matrices of a model of the registry are, if it has any.
pub(crate) fn realizability(row: &'static models::Row) -> Option<String> {
    let description: &BrdfDescription = &row.brdf;
    let model = description.build::<f64>().ok()?;
    model.mueller(DVec3::Z, DVec3::Z)?;
    let mut least = 0.0_f64;
    for (wi, wo) in pairs_to_grazing(MATRICES) {
        let channels = model.mueller(wi, wo)?.channels::<f64>();
        let lit = channels.iter().filter(|channel| channel.rows[0][0] > 1e-290);
        least = lit.map(|channel| channel.realizability()).fold(least, f64::min);
    }
    Some(format!("| {}, polarised | {least:.0e} |", row.name))
}

/// Pairs of directions for Mueller matrices.
const MATRICES: usize = 10_000;

/// The part of the page.
pub(crate) fn page(rows: &[Row], matrices: &[String]) -> String {
    let mut page = format!(
        "{HEADING}
`tests/interfaces.jsonl`, each from {directions} directions of both sides, near the normal, at the
critical angle of n = 1.5 and grazing. A dash is of what a model does not have. The columns mean:

- **R + T.** What returns and passes of a beam, brightest channel: its range over the directions from
  which the model answers. Of a lossless model, how far it is from 1.
- **f/n².** The largest difference of f(wi, wo)/n_o² from f(wo, wi)/n_i² over 1600 pairs all over the
  sphere, in units in the last place, in `f64` and in `f32`.
- **Transposed.** The same of importance, and of radiance with the directions exchanged.
- **Lobes.** The same of the power along a lobe, and along the lobe that leads back. The direction between
  is rounded, which counts most at the critical angle.
- **Weight.** The same of the weight of a draw, and of `eval` · \\|cosθ\\|/`pdf` at its direction.
- **`f32` error.** The relative difference of `eval` in `f32` from `f64` at these pairs in both modes.
- **Smallest p.** {DRAWS} draws from each of the directions in `f64` and as many in `f32`, counted in 384
  cells that follow the lobes of both sides, and one of draws that give no direction, whose expectation is
  1 − ∫ pdf dω; the least probability of a χ² as large. In {tests} such tests of samplers without a fault,
  a p below {least:.1e} turns up with a chance of 1 %.

| model | R + T | f/n² | transposed | lobes | weight | `f32` error, median | largest | smallest p |
|---|---|---|---|---|---|---|---|---|
",
        directions = viewers().len(),
        tests = tests(),
        least = least_p(),
    )
    .replace("\\\\|", "\\|");
    for row in rows {
        let _ = writeln!(page, "{}", row.line());
    }
    let _ = write!(
        page,
        "
## Realisability of Mueller matrices

Of every model that knows how it polarises light, at {MATRICES} pairs of directions: the least of the sums
of products of the eigenvalues of Cloude's coherency matrix, per M₀₀. Below 0 by more than rounding, a matrix
would make light that cannot be.

| model | realisability |
|---|---|
"
    );
    for line in matrices {
        let _ = writeln!(page, "{line}");
    }
    page
}
