//! Counts against expectations by Pearson's χ².

use statrs::distribution::{ChiSquared, ContinuousCDF};

/// What the comparison says.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The probability of counts that agree no better, of a right sampler. Zero where something
    /// was counted that cannot be.
    pub p_value: f64,
    /// Terms of the sum, after pooling.
    pub terms: usize,
    /// The cells that contribute most: index, count, expectation.
    pub worst: Vec<(usize, f64, f64)>,
}

/// Cells whose expectations with their errors together stay below this count as impossible.
const IMPOSSIBLE: f64 = 1e-6;
/// The least expectation of a term.
const LEAST: f64 = 5.0;

/// Compares counts with expectations of the same sum, each with its error. Cells that expect
/// little are pooled, beginning with those that expect least.
pub fn compare(counts: &[u32], expectations: &[(f64, f64)]) -> Verdict {
    let mut cells: Vec<(usize, f64, f64, f64)> = counts
        .iter()
        .zip(expectations)
        .enumerate()
        .map(|(index, (&count, &(expectation, error)))| {
            (index, f64::from(count), expectation, expectation + error)
        })
        .collect();
    cells.sort_by(|a, b| a.3.total_cmp(&b.3));

    let (mut terms, mut pool, mut impossible) = (Vec::new(), (0.0, 0.0), Vec::new());
    let mut most = 0.0;
    for &(index, count, expectation, with_error) in &cells {
        pool = (pool.0 + count, pool.1 + expectation);
        most += with_error;
        if most <= IMPOSSIBLE && count > 0.0 {
            impossible.push((index, count, expectation));
        }
        if pool.1 >= LEAST {
            terms.push((index, pool.0, pool.1));
            pool = (0.0, 0.0);
        }
    }
    // Less than a term is left only where that was all.
    let part = |&(_, count, expectation): &(usize, f64, f64)| {
        let difference: f64 = count - expectation;
        difference * difference / expectation
    };
    let statistic: f64 = terms.iter().map(part).sum();
    let p_value = if !impossible.is_empty() {
        0.0
    } else if terms.len() < 2 {
        1.0
    } else {
        let freedom = (terms.len() - 1) as f64;
        ChiSquared::new(freedom).expect("a positive number of degrees").sf(statistic)
    };
    let count = terms.len();
    terms.sort_by(|a, b| part(b).total_cmp(&part(a)));
    terms.truncate(4);
    impossible.extend(terms);
    Verdict { p_value, terms: count, worst: impossible }
}

/// What the least of `count` p-values exceeds with probability 0.99 if all samplers are right
/// (Šidák).
pub fn least_of(count: usize) -> f64 {
    // 1 − 0.99^(1/count), without the difference.
    -(0.99_f64.ln() / count as f64).exp_m1()
}
