//! Reflectance of smooth surfaces.

use std::error::Error;

use brdf::fresnel::{conductor_polarized, dielectric_polarized};
use brdf::materials::{COPPER, GOLD, Material, RefractiveIndex, SILVER};
use brdf::{Conductor, Dielectric, Fresnel, brewster_angle, critical_angle};
use plotters::style::text_anchor::{HPos, VPos};

use super::cartesian::{Axis, Mark, Plot};
use super::figure::{Curve, Figure, Panel};
use super::style::{BLUE, Dash, GREEN, INK, LONG, Pen, SHORT, VERMILION};

const SECTION: &str = "Fresnel reflectance";
const ANGLE: &str = "angle of incidence θ / °";
const RIGHT_ANGLE: (f64, f64) = (0.0, 90.0);

/// s, p and unpolarised light on an interface, over the angle in degrees.
fn polarizations(reflectance: impl Fn(f64) -> (f64, f64)) -> Vec<Curve> {
    let pen = |color, dash| Pen { color, dash };
    vec![
        Curve::new("s, perpendicular", pen(BLUE, LONG), RIGHT_ANGLE, |x| reflectance(x).0),
        Curve::new("p, parallel", pen(VERMILION, SHORT), RIGHT_ANGLE, |x| reflectance(x).1),
        Curve::new("unpolarised", pen(INK, Dash::Solid), RIGHT_ANGLE, |x| {
            let (s, p) = reflectance(x);
            f64::midpoint(s, p)
        }),
    ]
}

/// Glass from outside and from inside.
pub(super) fn glass() -> Result<Figure, Box<dyn Error>> {
    let n = 1.5;
    let sided = |side: f64| {
        move |degrees: f64| {
            let reflectance = dielectric_polarized(n, side * degrees.to_radians().cos());
            (reflectance.s, reflectance.p)
        }
    };
    let outer = brewster_angle(1.0, n).to_degrees();
    let inner = brewster_angle(n, 1.0).to_degrees();
    let critical = critical_angle(n, 1.0).to_degrees();
    let normal = Dielectric::new(n)?.reflectance(1.0);
    let outside = Plot {
        heading: "from air into glass".into(),
        x: Axis::degrees(ANGLE),
        y: Axis::new("reflectance", 0.0, 1.0, 0.2),
        curves: polarizations(sided(1.0)),
        marks: vec![
            Mark::Vertical {
                x: outer,
                y: 0.72,
                label: format!("Brewster {outer:.1}°"),
                side: HPos::Right,
            },
            Mark::Point {
                at: (0.0, normal),
                label: format!("{normal:.3}"),
                side: (HPos::Left, VPos::Bottom),
            },
        ],
    };
    let inside = Plot {
        heading: "from glass into air".into(),
        x: Axis::degrees(ANGLE),
        y: Axis::new("reflectance", 0.0, 1.0, 0.2),
        curves: polarizations(sided(-1.0)),
        marks: vec![
            Mark::Columns { from: critical, to: 90.0, label: "total reflection" },
            Mark::Vertical {
                x: inner,
                y: 0.6,
                label: format!("Brewster {inner:.1}°"),
                side: HPos::Right,
            },
            Mark::Vertical {
                x: critical,
                y: 0.72,
                label: format!("critical {critical:.1}°"),
                side: HPos::Left,
            },
        ],
    };
    Ok(Figure {
        name: "fresnel-glass".into(),
        section: SECTION,
        title: format!("Fresnel reflectance of glass, n = {n}"),
        caption: format!(
            "Fresnel's equations for an interface of relative index {n}. At Brewster's angle p-polarised \
             light is not reflected; from inside, beyond the critical angle, all light is."
        ),
        height: 400.0,
        columns: 3,
        panels: vec![Panel::Plot(outside), Panel::Plot(inside)],
    })
}

fn spectral(metal: &Material) -> Result<Vec<Curve>, Box<dyn Error>> {
    let mut curves = Vec::new();
    for (wavelength, color, dash) in
        [(650.0, VERMILION, Dash::Solid), (550.0, GREEN, LONG), (450.0, BLUE, SHORT)]
    {
        let RefractiveIndex { eta, k } = metal.refractive_index(wavelength)?;
        let surface = Conductor::new(eta, k)?;
        let label = format!("{wavelength:.0} nm: {eta:.3} + {k:.3}i");
        curves.push(Curve::new(label, Pen { color, dash }, RIGHT_ANGLE, |x| {
            surface.reflectance(x.to_radians().cos())
        }));
    }
    Ok(curves)
}

/// Three metals at three wavelengths.
pub(super) fn metals() -> Result<Figure, Box<dyn Error>> {
    let panel = |metal: &Material| -> Result<Panel, Box<dyn Error>> {
        Ok(Panel::Plot(Plot {
            heading: metal.name().to_lowercase(),
            x: Axis::new("θ / °", 0.0, 90.0, 30.0),
            y: Axis::new("reflectance", 0.3, 1.0, 0.1),
            curves: spectral(metal)?,
            marks: Vec::new(),
        }))
    };
    Ok(Figure {
        name: "fresnel-metals".into(),
        section: SECTION,
        title: "Unpolarised reflectance of metals at three wavelengths".into(),
        caption: "Fresnel's equations with measured indices (P. B. Johnson, R. W. Christy, 1972), given \
                  below as n + ik. Gold \
                  and copper are coloured at normal incidence and turn white towards grazing; silver \
                  is nearly white throughout."
            .into(),
        height: 400.0,
        columns: 1,
        panels: vec![panel(&GOLD)?, panel(&COPPER)?, panel(&SILVER)?],
    })
}

/// The two polarisations of copper, with the pseudo-Brewster angle.
pub(super) fn copper_polarized() -> Result<Figure, Box<dyn Error>> {
    let mut panels = Vec::new();
    for wavelength in [650.0, 450.0] {
        let RefractiveIndex { eta, k } = COPPER.refractive_index(wavelength)?;
        let curves = polarizations(|degrees| {
            let reflectance = conductor_polarized(eta, k, degrees.to_radians().cos());
            (reflectance.s, reflectance.p)
        });
        let (angle, least) = curves[1].lowest();
        panels.push(Panel::Plot(Plot {
            heading: format!("{wavelength:.0} nm: n = {eta:.3}, k = {k:.3}"),
            x: Axis::degrees(ANGLE),
            y: Axis::new("reflectance", 0.0, 1.0, 0.2),
            curves,
            marks: vec![Mark::Point {
                at: (angle, least),
                label: format!("{angle:.1}°, {least:.3}"),
                side: (HPos::Center, VPos::Top),
            }],
        }));
    }
    Ok(Figure {
        name: "fresnel-copper-polarised".into(),
        section: SECTION,
        title: "Polarised reflectance of copper".into(),
        caption: "A metal has no angle at which p-polarised light vanishes, but a least reflectance at \
                  the pseudo-Brewster angle (dot): faint in the red, where copper is a mirror, deep in the \
                  blue."
            .into(),
        height: 400.0,
        columns: 3,
        panels,
    })
}
