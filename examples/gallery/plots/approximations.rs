//! How far the approximations are from the exact formulas.

use std::error::Error;

use brdf::{Brdf, Conductor, Dielectric, Fresnel, Hall, Phong, Schlick, SchlickPower};
use glam::DVec3;
use plotters::style::text_anchor::{HPos, VPos};

use super::cartesian::{Axis, Mark, Plot};
use super::figure::{Curve, Figure, Panel};
use super::metals::{COPPER, GOLD, SILVER};
use super::style::PENS;

const SECTION: &str = "Approximations";
const ANGLE: &str = "angle of incidence θ / °";
const RIGHT_ANGLE: (f64, f64) = (0.0, 90.0);

/// Schlick's reflectance minus the exact one in hundredths, over the angle in degrees.
fn schlick_error(
    exact: impl Fresnel<f64, Color = f64>,
) -> Result<impl Fn(f64) -> f64, Box<dyn Error>> {
    let schlick = Schlick::new(exact.reflectance(1.0))?;
    Ok(move |degrees: f64| {
        let cos = degrees.to_radians().cos();
        100.0 * (schlick.reflectance(cos) - exact.reflectance(cos))
    })
}

fn largest(curve: &Curve) -> (f64, f64) {
    let (high, low) = (curve.highest(), curve.lowest());
    if high.1 > -low.1 { high } else { low }
}

fn error_figure(
    name: &'static str,
    what: &str,
    bound: f64,
    step: f64,
    curves: Vec<Curve>,
) -> Figure {
    let mut caption = "Reflectance after Schlick, from the exact value at normal incidence, minus \
        the exact reflectance, in percent of the incident light. Largest differences: "
        .to_owned();
    let list: Vec<String> = curves
        .iter()
        .map(|curve| {
            let (x, y) = largest(curve);
            format!("{}: {y:+.2} % at {x:.0}°", curve.label)
        })
        .collect();
    caption += &list.join("; ");
    caption += ".";
    let plot = Plot {
        heading: "difference of reflectances".into(),
        x: Axis::degrees(ANGLE),
        y: Axis::new("Schlick − exact / %", -bound, bound, step),
        curves,
        marks: vec![Mark::Horizontal { y: 0.0 }],
    };
    Figure {
        name,
        section: SECTION,
        title: format!("Schlick's approximation for {what}"),
        caption,
        height: 400.0,
        columns: 3,
        panels: vec![Panel::Plot(plot)],
    }
}

pub(super) fn schlick_dielectric() -> Result<Figure, Box<dyn Error>> {
    let mut curves = Vec::new();
    for (n, pen) in [1.1, 1.33, 1.5, 2.0, 2.42].into_iter().zip(PENS) {
        let error = schlick_error(Dielectric::new(n)?)?;
        curves.push(Curve::new(format!("n = {n}"), pen, RIGHT_ANGLE, error));
    }
    Ok(error_figure("schlick-dielectric", "transparent media", 25.0, 5.0, curves))
}

pub(super) fn schlick_metal() -> Result<Figure, Box<dyn Error>> {
    let mut curves = Vec::new();
    let lines = [(GOLD, 650.0), (GOLD, 450.0), (COPPER, 550.0), (SILVER, 550.0)];
    for ((metal, wavelength), pen) in lines.into_iter().zip(PENS) {
        let (eta, k) = metal.index(wavelength)?;
        let error = schlick_error(Conductor::new(eta, k)?)?;
        curves.push(Curve::new(format!("{} {wavelength} nm", metal.name), pen, RIGHT_ANGLE, error));
    }
    Ok(error_figure("schlick-metal", "metals", 5.0, 1.0, curves))
}

/// Copper's blue after Hall, driven by copper's own red and by glass, against the exact curve.
pub(super) fn copper() -> Result<Figure, Box<dyn Error>> {
    let (eta, k) = COPPER.index(450.0)?;
    let exact = Conductor::new(eta, k)?;
    let f0 = exact.reflectance(1.0);
    let (eta, k) = COPPER.index(550.0)?;
    let by_copper = Hall::with_reference(f0, Conductor::new(eta, k)?)?;
    let by_glass = Hall::new(f0, 1.5)?;
    let schlick = Schlick::new(f0)?;
    let over_angle = |term: &dyn Fresnel<f64, Color = f64>, label: &str, pen| {
        let value = |degrees: f64| term.reflectance(degrees.to_radians().cos());
        Curve::new(label, pen, RIGHT_ANGLE, value)
    };
    let plot = Plot {
        heading: "450 nm".into(),
        x: Axis::degrees(ANGLE),
        y: Axis::new("reflectance", 0.5, 1.0, 0.1),
        curves: vec![
            over_angle(&exact, "exact", PENS[0]),
            over_angle(&by_copper, "Hall, along copper at 550 nm", PENS[1]),
            over_angle(&by_glass, "Hall, along glass", PENS[2]),
            over_angle(&schlick, "Schlick", PENS[3]),
        ],
        marks: vec![],
    };
    Ok(Figure {
        name: "hall-copper",
        section: SECTION,
        title: "Interpolating the colour of copper".into(),
        caption: "Hall's interpolation (and Cook's, divided by the colour of the light) turns the \
            colour at normal incidence white along an exact curve of reference. The maximum in the \
            formula cuts off the dip that the exact curve has before grazing."
            .into(),
        height: 400.0,
        columns: 2,
        panels: vec![Panel::Plot(plot)],
    })
}

/// Powers of a cosine: cosʰβ against cos⁴ʰ(β/2), and Schlick's rational form.
pub(super) fn powers() -> Result<Figure, Box<dyn Error>> {
    let mut half_angle = Vec::new();
    let mut rational = Vec::new();
    let range = (0.0, 90.0);
    for (index, h) in [2.0, 10.0, 50.0].into_iter().enumerate() {
        let pen = |part: usize| PENS[2 * index + part];
        // At normal incidence the lobes of the models are these functions of the mirror angle.
        let phong = Phong::new(1.0, h)?;
        let power = move |degrees: f64| {
            let w = brdf::from_spherical(degrees.to_radians(), 0.0);
            Brdf::<f64>::eval(&phong, w, DVec3::Z) / Brdf::<f64>::eval(&phong, DVec3::Z, DVec3::Z)
        };
        let schlick = SchlickPower::unnormalized(1.0, h)?;
        let replaced = move |degrees: f64| {
            let w = brdf::from_spherical(degrees.to_radians(), 0.0);
            Brdf::<f64>::eval(&schlick, w, DVec3::Z)
        };
        let half = move |degrees: f64| (degrees.to_radians() / 2.0).cos().powf(4.0 * h);
        half_angle.push(Curve::new(format!("cosʰ β, h = {h}"), pen(0), range, power));
        half_angle.push(Curve::new("cos⁴ʰ(β/2)", pen(1), range, half));
        rational.push(Curve::new(format!("Sʰ, h = {h}"), pen(0), range, power));
        rational.push(Curve::new("S/(h − hS + S)", pen(1), range, replaced));
    }
    let panel = |heading: &str, label, curves| {
        Panel::Plot(Plot {
            heading: heading.into(),
            x: Axis::degrees(label),
            y: Axis::new("relative to the peak", 0.0, 1.0, 0.2),
            curves,
            marks: vec![Mark::Point {
                at: (0.0, 1.0),
                label: String::new(),
                side: (HPos::Left, VPos::Bottom),
            }],
        })
    };
    Ok(Figure {
        name: "powers",
        section: SECTION,
        title: "Two stand-ins for a power of the cosine".into(),
        caption:
            "Left: in the plane of incidence the angle between N and H is half of β, the angle \
            between R and V, so that Phong's lobe of exponent h is nearly Blinn's of exponent 4h. \
            Right: Schlick's rational form, S = cosβ; same value and slope at the peak, a heavier \
            tail."
                .into(),
        height: 420.0,
        columns: 2,
        panels: vec![
            panel("half the angle, four times the exponent", "β / °", half_angle),
            panel("a quotient for the power", "β / °", rational),
        ],
    })
}
