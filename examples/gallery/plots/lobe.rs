//! Values over the angle of the viewer as a polar panel.

use plotters::prelude::RGBColor;

use super::figure::{Curve, Panel};
use super::polar::Lobes;
use super::style::INK;

/// How a value becomes a radius.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Radius {
    /// In proportion; the largest value of all fills the circle.
    Common,
    /// In proportion; every lobe fills the circle.
    Own,
    /// By its logarithm; the circle is four decades, the largest value of all fills it.
    Decades,
}

/// Lobes, f over the angle of the viewer in degrees, each with the angle of its light.
pub(super) fn panel(heading: &str, lit: Vec<(Curve, f64)>, radius: Radius) -> Panel {
    // Arrows wear the colours of their lobes where there are several.
    let mut incidence: Vec<(f64, RGBColor)> = Vec::new();
    for (curve, light) in &lit {
        if incidence.iter().all(|(known, _)| known != light) {
            incidence.push((*light, curve.pen.color));
        }
    }
    if let [(_, color)] = &mut incidence[..] {
        *color = INK;
    }
    let mut curves: Vec<Curve> = lit.into_iter().map(|(curve, _)| curve).collect();
    let largest = curves.iter().map(|curve| curve.highest().1).fold(0.0, f64::max);
    let step = round_step(largest / 2.0);
    // In proportion to the value: the circle is a round number, the first above all values.
    let overall = if radius == Radius::Common { step * (largest / step).ceil() } else { largest };
    for curve in &mut curves {
        let largest = if radius == Radius::Own { curve.highest().1 } else { overall };
        for (_, value) in &mut curve.points {
            let part = *value / largest;
            let decades = || (1.0 + part.max(f64::MIN_POSITIVE).log10() / 4.0).max(0.0);
            *value = if radius == Radius::Decades { decades() } else { part };
        }
    }
    let (text, circles) = match radius {
        Radius::Common => {
            let values = (1..=8).map(|index| step * f64::from(index));
            let inside = values.take_while(|value| *value < overall + 0.5 * step);
            ("f / sr⁻¹", inside.map(|value| (value / overall, rounded(value))).collect())
        }
        Radius::Own => {
            ("f over its largest value", [0.5, 1.0].map(|part| (part, format!("{part}"))).to_vec())
        }
        Radius::Decades => {
            let labels = [(0.25, "10⁻³"), (0.5, "10⁻²"), (0.75, "10⁻¹"), (1.0, "1")];
            ("f over the largest value", labels.map(|(part, text)| (part, text.into())).to_vec())
        }
    };
    Panel::Lobes(Lobes { heading: heading.into(), radius: text.into(), incidence, circles, curves })
}

/// The largest of the numbers 1, 2 and 5 times a power of ten up to a number.
fn round_step(most: f64) -> f64 {
    let decade = 10_f64.powf(most.log10().floor());
    [5.0, 2.0, 1.0]
        .map(|leading| leading * decade)
        .into_iter()
        .find(|step| *step <= most)
        .unwrap_or(decade)
}

/// A round number without the digits that rounding leaves behind it.
fn rounded(value: f64) -> String {
    format!("{value:.4}").trim_end_matches('0').trim_end_matches('.').to_owned()
}
