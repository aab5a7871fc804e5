//! Several materials in one figure.

use std::error::Error;

use brdf::materials::{Material, find};
use brdf::{Fresnel, ParameterError};
use plotters::style::RGBColor;

use super::colors::{BLUE, GREEN, GREY, ORANGE, PURPLE, RED};
use super::figure::{Curve, Figure, Panel};

/// Keys and colours of the classic mirror metals and two grey ones.
const METALS: [(&str, RGBColor); 6] =
    [("Ag", GREY), ("Al", BLUE), ("Cu", RED), ("Au", ORANGE), ("Ni", GREEN), ("W", PURPLE)];

const GLASSES: [(&str, RGBColor); 6] = [
    ("diamond_peter", BLUE),
    ("N-SF11", RED),
    ("sapphire_o", PURPLE),
    ("BK7", GREEN),
    ("fused_silica", ORANGE),
    ("water_daimon", GREY),
];

const OPINIONS: [(&str, &str, RGBColor); 4] = [
    ("Ag", "Ag_mcpeak", GREY),
    ("Al", "Al_mcpeak", BLUE),
    ("Cu", "Cu_mcpeak", RED),
    ("Au", "Au_mcpeak", ORANGE),
];

/// A curve between 300 and 1000 nm, as far as the material was measured.
fn shown(
    material: &Material,
    value: impl Fn(f64) -> Result<f64, ParameterError>,
) -> Result<Vec<(f64, f64)>, ParameterError> {
    let inside = |wavelength: &f64| material.range().contains(wavelength);
    let wavelengths = (300..=1000).map(f64::from).filter(inside);
    wavelengths.map(|wavelength| Ok((wavelength, value(wavelength)?))).collect()
}

fn reflectance(material: &Material) -> Result<Vec<(f64, f64)>, ParameterError> {
    shown(material, |wavelength| Ok(material.conductor(wavelength)?.reflectance(1.0)))
}

fn panel(y_name: &'static str, y: std::ops::Range<f64>, curves: Vec<Curve>) -> Panel {
    Panel {
        x_name: "wavelength in nm",
        y_name,
        x: 300.0..1000.0,
        y,
        wavelengths: true,
        curves,
        ..Panel::default()
    }
}

pub fn all() -> Result<Vec<Figure>, Box<dyn Error>> {
    Ok(vec![metals()?, glasses()?, opinions()?])
}

fn metals() -> Result<Figure, Box<dyn Error>> {
    let (mut curves, mut n_curves, mut k_curves) = (Vec::new(), Vec::new(), Vec::new());
    for (key, color) in METALS {
        let metal = find(key)?;
        curves.push(Curve::new(metal.name(), color, reflectance(metal)?));
        let n = shown(metal, |at| Ok(metal.refractive_index(at)?.eta))?;
        let k = shown(metal, |at| Ok(metal.refractive_index(at)?.k))?;
        n_curves.push(Curve::new(metal.name(), color, n));
        k_curves.push(Curve::new(metal.name(), color, k));
    }
    Ok(Figure {
        name: "metals".to_owned(),
        title: "Metals".to_owned(),
        subtitle: "Reflectance at normal incidence, and the index n + ik it comes from.".to_owned(),
        swatch: None,
        panels: vec![
            panel("reflectance", 0.0..1.0, curves),
            panel("n", 0.0..4.0, n_curves),
            panel("k", 0.0..10.0, k_curves),
        ],
    })
}

fn glasses() -> Result<Figure, Box<dyn Error>> {
    let mut curves = Vec::new();
    for (key, color) in GLASSES {
        let glass = find(key)?;
        let name = glass.name().split([' ', ',']).next().unwrap_or_default();
        let name = if key == "fused_silica" { "Fused silica" } else { name };
        curves.push(Curve::new(
            name,
            color,
            shown(glass, |at| Ok(glass.refractive_index(at)?.eta))?,
        ));
    }
    Ok(Figure {
        name: "dispersion".to_owned(),
        title: "Dispersion".to_owned(),
        subtitle: "Refractive index of transparent media. It falls with the wavelength, faster \
                   where it is high and towards the absorption in the ultraviolet."
            .to_owned(),
        swatch: None,
        panels: vec![panel("n", 1.2..2.6, curves)],
    })
}

fn opinions() -> Result<Figure, Box<dyn Error>> {
    let mut curves = Vec::new();
    for (first, second, color) in OPINIONS {
        let (first, second) = (find(first)?, find(second)?);
        curves.push(Curve::new(first.name(), color, reflectance(first)?));
        curves.push(Curve::new("", color, reflectance(second)?).dashed());
    }
    Ok(Figure {
        name: "second_opinions".to_owned(),
        title: "Two measurements of one metal".to_owned(),
        subtitle: "Reflectance at normal incidence. Solid: Johnson and Christy 1972 (silver, \
                   copper, gold), Rakić 1995 (aluminium). Dashed: McPeak 2015."
            .to_owned(),
        swatch: None,
        panels: vec![panel("reflectance", 0.0..1.0, curves)],
    })
}
