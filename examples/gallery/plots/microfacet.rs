//! Distributions of facet normals.

use std::error::Error;

use brdf::{Beckmann, Blinn, Distribution, Gaussian, Ggx, Mixture, from_spherical};

use super::cartesian::{Axis, Plot};
use super::figure::{Curve, Figure, Panel};
use super::style::PENS;

const SECTION: &str = "Microfacets";
const TILT: &str = "tilt of the facet θ_h / °";
const DENSITY: &str = "D / sr⁻¹";
const RIGHT_ANGLE: (f64, f64) = (0.0, 90.0);

/// D over the tilt in degrees.
fn density<'a>(distribution: &'a dyn Distribution<f64>) -> impl Fn(f64) -> f64 + 'a {
    |degrees: f64| distribution.density(from_spherical(degrees.to_radians(), 0.0))
}

fn curves(list: &[(String, Box<dyn Distribution<f64>>)], range: (f64, f64)) -> Vec<Curve> {
    let with_pens = list.iter().zip(PENS);
    with_pens.map(|((name, d), pen)| Curve::new(name.clone(), pen, range, density(&**d))).collect()
}

/// A linear and a logarithmic panel of the same distributions.
fn two_scales(list: &[(String, Box<dyn Distribution<f64>>)], linear: Axis, top: f64) -> Vec<Panel> {
    let near = Plot {
        heading: "linear".into(),
        x: Axis::new(TILT, 0.0, 60.0, 10.0),
        y: linear,
        curves: curves(list, (0.0, 60.0)),
        marks: vec![],
    };
    let far = Plot {
        heading: "logarithmic".into(),
        x: Axis::degrees(TILT),
        y: Axis::decades(DENSITY, -4.0, top, 1.0),
        curves: curves(list, RIGHT_ANGLE),
        marks: vec![],
    };
    vec![Panel::Plot(near), Panel::Plot(far)]
}

pub(super) fn distributions() -> Result<Figure, Box<dyn Error>> {
    let m = 0.3;
    let list: Vec<(String, Box<dyn Distribution<f64>>)> = vec![
        (format!("Gaussian, α = {m}"), Box::new(Gaussian::new(m)?)),
        (format!("Beckmann, α = {m}"), Box::new(Beckmann::new(m)?)),
        (format!("GGX, α = {m}"), Box::new(Ggx::new(m)?)),
        (
            format!("Blinn, n = 2/α² − 2 = {:.1}", Blinn::from_roughness(m)?.exponent()),
            Box::new(Blinn::from_roughness(m)?),
        ),
    ];
    Ok(Figure {
        name: "distributions".into(),
        section: SECTION,
        title: "Four distributions of facet normals".into(),
        caption: "All are normalised to ∫ D cosθ_h dω = 1. Beckmann, Blinn and the Gaussian differ \
            little around the peak; GGX falls sooner from a peak of the same height, and its tail is \
            higher by orders of magnitude."
            .into(),
        height: 420.0,
        columns: 2,
        panels: two_scales(&list, Axis::new(DENSITY, 0.0, 4.0, 0.5), 1.0),
    })
}

pub(super) fn roughness() -> Result<Figure, Box<dyn Error>> {
    let mut list: Vec<(String, Box<dyn Distribution<f64>>)> = Vec::new();
    for m in [0.1, 0.2, 0.4, 0.8] {
        list.push((format!("α = {m}"), Box::new(Beckmann::new(m)?)));
    }
    Ok(Figure {
        name: "roughness".into(),
        section: SECTION,
        title: "Beckmann's distribution from smooth to rough".into(),
        caption: "The peak is 1/(π α²) at the normal; above α = 1/√2 the maximum moves off the \
            normal, to cos²θ_h = 1/(2α²)."
            .into(),
        height: 420.0,
        columns: 4,
        panels: two_scales(&list, Axis::new(DENSITY, 0.0, 35.0, 5.0), 2.0),
    })
}

pub(super) fn mixture() -> Result<Figure, Box<dyn Error>> {
    let (fine, coarse) = (Beckmann::new(0.15)?, Beckmann::new(0.6)?);
    let list: Vec<(String, Box<dyn Distribution<f64>>)> = vec![
        ("0.5 D(0.15) + 0.5 D(0.6)".into(), Box::new(Mixture::new([(0.5, fine), (0.5, coarse)])?)),
        ("D(0.15)".into(), Box::new(fine)),
        ("D(0.6)".into(), Box::new(coarse)),
    ];
    Ok(Figure {
        name: "mixture".into(),
        section: SECTION,
        title: "A surface with two scales of roughness".into(),
        caption: "A weighted sum of Beckmann's distributions: a narrow peak over broad flanks."
            .into(),
        height: 420.0,
        columns: 3,
        panels: two_scales(&list, Axis::new(DENSITY, 0.0, 15.0, 2.5), 2.0),
    })
}
