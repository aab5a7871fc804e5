//! One material: its index, and what it reflects at normal incidence.

use brdf::materials::{Form, Material, Sample};
use brdf::{Fresnel, ParameterError};

use super::colors::{BLUE, INK, RED, surface};
use super::figure::{Curve, Figure, Panel};

/// An absorption that can be seen beside n.
const VISIBLE_ABSORPTION: f64 = 0.005;

/// Reflectance at normal incidence at the samples of a material.
fn reflectance(material: &Material) -> Result<Vec<(f64, f64)>, ParameterError> {
    let at = |Sample { wavelength, .. }| {
        Ok((wavelength, material.conductor(wavelength)?.reflectance(1.0)))
    };
    material.samples().map(at).collect()
}

/// Both curves of an index over the wavelength.
fn index(material: &Material) -> [Vec<(f64, f64)>; 2] {
    let n = material.samples().map(|sample| (sample.wavelength, sample.index.eta)).collect();
    let k = material.samples().map(|sample| (sample.wavelength, sample.index.k)).collect();
    [n, k]
}

/// The smallest and the largest value of a curve.
fn extent(points: &[(f64, f64)]) -> (f64, f64) {
    let values = points.iter().map(|point| point.1);
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)))
}

pub fn figure(material: &Material) -> Result<Figure, ParameterError> {
    let [n, k] = index(material);
    let reflectance = reflectance(material)?;
    let ((n_low, n_high), (_, k_high), (_, r_high)) =
        (extent(&n), extent(&k), extent(&reflectance));
    let measured = material.form() == Form::Table && n.len() <= 80;
    let mark = |curve: Curve| if measured { curve.marked() } else { curve };

    let absorbs = k_high >= VISIBLE_ABSORPTION;
    let mut curves = vec![mark(Curve::new("n", BLUE, n))];
    let (y_name, y) = if absorbs {
        curves.push(mark(Curve::new("k", RED, k)));
        ("index n + ik", 0.0..1.06 * n_high.max(k_high))
    } else {
        let margin = 0.08 * (n_high - n_low);
        ("index n", n_low - margin..n_high + margin)
    };
    let absorption = match k_high {
        0.0 => ". The source gives no k".to_owned(),
        _ if absorbs => String::new(),
        k => format!(". Here k is at most {k:.0e}"),
    };
    let (lower, upper) = material.range().into_inner();
    let x = lower..upper;
    let r_end = if r_high > 0.5 { 1.0 } else { (1.15 * r_high).max(1e-3) };
    Ok(Figure {
        name: material.key().to_owned(),
        title: material.name().to_owned(),
        subtitle: format!("{}{absorption}", material.citation().trim_end_matches('.')),
        swatch: surface(material)?,
        panels: vec![
            Panel {
                x_name: "wavelength in nm",
                y_name,
                x: x.clone(),
                y,
                wavelengths: true,
                curves,
                ..Panel::default()
            },
            Panel {
                x_name: "wavelength in nm",
                y_name: "reflectance at normal incidence",
                x,
                y: 0.0..r_end,
                wavelengths: true,
                curves: vec![mark(Curve::new("R", INK, reflectance))],
                ..Panel::default()
            },
        ],
    })
}
