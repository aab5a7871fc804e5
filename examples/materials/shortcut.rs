//! One index per channel against the exact colour, over the angle of incidence.

use std::error::Error;

use brdf::colorimetry::WAVELENGTHS;
use brdf::materials::{GOLD, Material, find};
use brdf::{Fresnel, Illuminant, Observer, Spectrum};
use glam::DVec3;

use super::colors::{BLUE, GREEN, GREY, ORANGE, PURPLE, RED};
use super::figure::{Curve, Figure, Panel};

const LINES: DVec3 = DVec3::new(650.0, 550.0, 450.0);
const CHANNELS: [(&str, plotters::style::RGBColor); 3] =
    [("red", RED), ("green", GREEN), ("blue", BLUE)];

/// Angle in degrees, exact colour, colour of the shortcut.
type Row = (f64, DVec3, DVec3);

fn rows(material: &Material) -> Result<Vec<Row>, Box<dyn Error>> {
    let observer = Observer::new(Illuminant::D65, WAVELENGTHS)?;
    let (exact, shortcut) =
        (material.conductor(Spectrum(WAVELENGTHS))?, material.conductor(LINES)?);
    let row = |half_degrees: i32| {
        let angle = 0.5 * f64::from(half_degrees);
        let cos = angle.to_radians().cos();
        (angle, observer.linear_srgb(exact.reflectance(cos)), shortcut.reflectance(cos))
    };
    Ok((0..=180).map(row).collect())
}

fn curve(
    name: &str,
    color: plotters::style::RGBColor,
    rows: &[Row],
    y: impl Fn(&Row) -> f64,
) -> Curve {
    Curve::new(name, color, rows.iter().map(|row| (row.0, y(row))).collect())
}

pub fn figure() -> Result<Figure, Box<dyn Error>> {
    let gold = rows(&GOLD)?;
    let lines = ["650 nm", "550 nm", "450 nm"];
    let (mut colors, mut errors) = (Vec::new(), Vec::new());
    for (channel, (name, color)) in CHANNELS.into_iter().enumerate() {
        colors.push(curve(name, color, &gold, |row| row.1[channel]));
        colors.push(curve(lines[channel], color, &gold, |row| row.2[channel]).dashed());
        errors.push(curve(name, color, &gold, |row| row.2[channel] - row.1[channel]));
    }
    let mut metals = Vec::new();
    for (key, name, color) in [
        ("Au", "Gold", ORANGE),
        ("Cu", "Copper", RED),
        ("brass_Cu70Zn30", "Brass", PURPLE),
        ("Al", "Aluminium", BLUE),
        ("Ag", "Silver", GREY),
    ] {
        let rows = rows(find(key)?)?;
        metals.push(curve(name, color, &rows, |row| (row.2 - row.1).abs().max_element()));
    }
    let panel = |y_name, y, curves| Panel {
        x_name: "angle of incidence in degrees",
        y_name,
        x: 0.0..90.0,
        y,
        list: true,
        curves,
        ..Panel::default()
    };
    Ok(Figure {
        name: "shortcut".to_owned(),
        title: "One index per channel".to_owned(),
        subtitle: "Gold in linear sRGB under D65: exact per wavelength and then integrated \
                   (solid), and with the index at 650, 550 and 450 nm as red, green and blue \
                   (dashed). Below: the difference, and the largest of the three channels."
            .to_owned(),
        swatch: None,
        panels: vec![
            panel("reflectance of gold", 0.3..1.1, colors),
            panel("error for gold", -0.1..0.1, errors),
            panel("largest error", 0.0..0.1, metals),
        ],
    })
}
