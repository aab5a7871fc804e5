//! How far the approximations are from the exact formulas.

use std::error::Error;

use brdf::materials::{COPPER, GOLD, SILVER};
use brdf::{
    BlinnPhong, Brdf, Dielectric, Fresnel, Hall, Phong, Schlick, SchlickPower, from_spherical,
};
use glam::DVec3;
use plotters::style::text_anchor::{HPos, VPos};

use super::cartesian::{Axis, Mark, Plot};
use super::figure::{Curve, Figure, Panel};
use super::style::{BLUE, Dash, GREEN, INK, PENS, Pen, SHORT, VERMILION};

const SECTION: &str = "Approximations";
const ANGLE: &str = "angle of incidence θ / °";
const RIGHT_ANGLE: (f64, f64) = (0.0, 90.0);

/// Schlick's reflectance minus the exact one, over the angle in degrees.
fn schlick_error(
    exact: impl Fresnel<f64, Color = f64>,
) -> Result<impl Fn(f64) -> f64, Box<dyn Error>> {
    let schlick = Schlick::new(exact.reflectance(1.0))?;
    Ok(move |degrees: f64| {
        let cos = degrees.to_radians().cos();
        schlick.reflectance(cos) - exact.reflectance(cos)
    })
}

fn largest(curve: &Curve) -> (f64, f64) {
    let (high, low) = (curve.highest(), curve.lowest());
    if high.1 > -low.1 { high } else { low }
}

fn error_figure(name: &'static str, what: &str, y: Axis, mut curves: Vec<Curve>) -> Figure {
    let marks = curves.iter().map(|curve| Mark::Point {
        at: largest(curve),
        label: String::new(),
        side: (HPos::Center, VPos::Bottom),
    });
    let marks = marks.chain([Mark::Horizontal { y: 0.0 }]).collect();
    for curve in &mut curves {
        let (angle, error) = largest(curve);
        curve.label += &format!(": {error:+.4} at {angle:.1}°");
    }
    let plot = Plot {
        heading: "difference of reflectances".into(),
        x: Axis::degrees(ANGLE),
        y,
        curves,
        marks,
    };
    Figure {
        name: name.into(),
        section: SECTION,
        title: format!("Error of Schlick's approximation for {what}"),
        caption: "Reflectance after Schlick, from the exact value at normal incidence, minus the exact \
            reflectance: a difference of reflectances, not a relative one. Dots and legend give the \
            largest."
            .into(),
        height: 420.0,
        columns: 2,
        panels: vec![Panel::Plot(plot)],
    }
}

pub(super) fn schlick_dielectric() -> Result<Figure, Box<dyn Error>> {
    let mut curves = Vec::new();
    for (n, pen) in [1.1, 1.33, 1.5, 2.0, 2.42].into_iter().zip(PENS) {
        let error = schlick_error(Dielectric::new(n)?)?;
        curves.push(Curve::new(format!("n = {n}"), pen, RIGHT_ANGLE, error));
    }
    let y = Axis::new("Schlick − exact", -0.05, 0.25, 0.05);
    Ok(error_figure("schlick-dielectric", "transparent media", y, curves))
}

pub(super) fn schlick_metal() -> Result<Figure, Box<dyn Error>> {
    let mut curves = Vec::new();
    let lines = [(&GOLD, 650.0), (&GOLD, 450.0), (&COPPER, 550.0), (&SILVER, 550.0)];
    for ((metal, wavelength), pen) in lines.into_iter().zip(PENS) {
        let error = schlick_error(metal.conductor(wavelength)?)?;
        curves.push(Curve::new(
            format!("{} {wavelength} nm", metal.name().to_lowercase()),
            pen,
            RIGHT_ANGLE,
            error,
        ));
    }
    let y = Axis::new("Schlick − exact", -0.02, 0.05, 0.01);
    Ok(error_figure("schlick-metal", "metals", y, curves))
}

/// Copper's blue after Hall, driven by copper's own green and by glass, against the exact curve.
pub(super) fn copper() -> Result<Figure, Box<dyn Error>> {
    let exact = COPPER.conductor(450.0)?;
    let f0 = exact.reflectance(1.0);
    let by_copper = Hall::with_reference(f0, COPPER.conductor(550.0)?)?;
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
        name: "hall-copper".into(),
        section: SECTION,
        title: "Interpolating the colour of copper".into(),
        caption: "Hall's interpolation (and Cook's, divided by the colour of the light) turns the \
            colour at normal incidence white along an exact curve of reference. The maximum in the \
            formula cuts off the dip that the reference, copper at 550 nm, has before grazing."
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
    // At normal incidence the lobes are functions of the angle to the mirror direction.
    let lobe = |model: &dyn Brdf<f64, Color = f64>, label: String, pen| {
        let peak = model.eval(DVec3::Z, DVec3::Z);
        Curve::new(label, pen, RIGHT_ANGLE, |degrees| {
            model.eval(from_spherical(degrees.to_radians(), 0.0), DVec3::Z) / peak
        })
    };
    for (h, color) in [(2.0, BLUE), (10.0, VERMILION), (50.0, GREEN)] {
        // Both broken lines look alike for every exponent: one name is enough.
        let name = |formula: &str| if color == GREEN { formula.into() } else { String::new() };
        let (half, quotient) = (name("cos⁴ʰ(β/2)"), name("S/(h − hS + S)"));
        let (exact, instead) = (Pen { color, dash: Dash::Solid }, Pen { color: INK, dash: SHORT });
        let phong = Phong::new(1.0, h)?;
        let blinn = BlinnPhong::unnormalized(1.0, 4.0 * h)?;
        let schlick = SchlickPower::unnormalized(1.0, h)?;
        let power = format!("cosʰβ, h = {h}");
        half_angle.push(lobe(&phong, power.clone(), exact));
        half_angle.push(lobe(&blinn, half, instead));
        rational.push(lobe(&phong, power, exact));
        rational.push(lobe(&schlick, quotient, instead));
    }
    let panel = |heading: &str, curves| {
        Panel::Plot(Plot {
            heading: heading.into(),
            x: Axis::degrees("angle to the mirror direction β / °"),
            y: Axis::new("value over that at the peak", 0.0, 1.0, 0.2),
            curves,
            marks: vec![],
        })
    };
    Ok(Figure {
        name: "powers".into(),
        section: SECTION,
        title: "Two stand-ins for a power of the cosine".into(),
        caption: "Left: in the plane of incidence the angle between N and H is half of β, the angle \
            between R and V, so that Phong's lobe of exponent h is nearly Blinn's of exponent 4h. \
            Right: Schlick's rational form, S = cosβ, with the same value and slope in S at the peak \
            but a heavier tail."
            .into(),
        height: 420.0,
        columns: 2,
        panels: vec![
            panel("half the angle, four times the exponent", half_angle),
            panel("a quotient for the power", rational),
        ],
    })
}
