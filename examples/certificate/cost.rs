//! What a call of a model costs.

use brdf::Vector;

use brdf_checks::faulty::place::count;
use brdf_checks::faulty::{Faulty, FaultyVector, Operation};
use brdf_checks::models;

/// How often a formula asks for what takes a processor long.
#[derive(Clone, Copy, Default)]
pub(crate) struct Cost {
    pub(crate) divisions: u32,
    pub(crate) roots: u32,
    /// Exponentials, logarithms, powers, trigonometric functions, error functions.
    pub(crate) functions: u32,
}

/// Of `eval`, `pdf` and `sample` of the entry at this place of the registry. Formulas do not branch,
/// so that one call of each tells.
pub(crate) fn costs(index: usize) -> [Cost; 3] {
    let model = &*models::faulty()[index].model;
    let direction = |x: f64, y: f64| {
        FaultyVector::new(Faulty(x), Faulty(y), Faulty((1.0 - x * x - y * y).sqrt()))
    };
    let (wi, wo) = (direction(0.3, -0.4), direction(-0.1, 0.6));
    let u = [Faulty(0.3), Faulty(0.7)];
    [
        cost(|| _ = model.eval(wi, wo)),
        cost(|| _ = model.pdf(wi, wo)),
        cost(|| _ = model.sample(wo, u)),
    ]
}

fn cost(call: impl FnOnce()) -> Cost {
    let mut cost = Cost::default();
    for (operation, times) in count(call) {
        match operation {
            Operation::Div => cost.divisions += times,
            Operation::Sqrt | Operation::Rsqrt => cost.roots += times,
            // One of each.
            Operation::Normalize => {
                cost.divisions += times;
                cost.roots += times;
            }
            Operation::Powf
            | Operation::PowerOfPart
            | Operation::Exp
            | Operation::ExpM1
            | Operation::Ln
            | Operation::Ln1p
            | Operation::Sin
            | Operation::Cos
            | Operation::SinCos
            | Operation::SinCosTurns
            | Operation::Tan
            | Operation::Asin
            | Operation::Acos
            | Operation::AngleSquared
            | Operation::Atan2
            | Operation::Erf
            | Operation::Erfc
            | Operation::ErfInv => cost.functions += times,
            _ => {}
        }
    }
    cost
}
