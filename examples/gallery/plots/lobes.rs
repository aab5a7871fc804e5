//! Reflected light over the angle of the viewer, in the plane of incidence.

use std::error::Error;

use brdf::{
    Beckmann, BlinnPhong, Brdf, Constant, CookTorrance, Gaussian, Ggx, Lambert, OrenNayar, Phong,
    from_spherical,
};
use plotters::prelude::RGBColor;

use super::figure::{Curve, Figure, Panel};
use super::polar::Lobes;
use super::style::{INK, PENS, Pen};

const SECTION: &str = "Lobes";

type Model = Box<dyn Brdf<f64, Color = f64>>;

/// f over the angle of the viewer in degrees, negative on the side of the light.
fn values(model: &Model, light: f64) -> impl Fn(f64) -> f64 + '_ {
    let wi = from_spherical((-light).to_radians(), 0.0);
    move |degrees: f64| model.eval(wi, from_spherical(degrees.to_radians(), 0.0))
}

/// The lobes of several models, the largest of all filling the circle; each lobe by itself if
/// `alike`.
fn panel(heading: &str, models: &[(String, Model, f64, Pen)], alike: bool) -> Panel {
    let mut curves: Vec<Curve> = models
        .iter()
        .map(|(name, model, light, pen)| {
            Curve::new(name.clone(), *pen, (-89.9, 89.9), values(model, *light))
        })
        .collect();
    let overall = curves.iter().map(|curve| curve.highest().1).fold(0.0, f64::max);
    for curve in &mut curves {
        let largest = if alike { curve.highest().1 } else { overall };
        for point in &mut curve.points {
            point.1 /= largest;
        }
    }
    let mut incidence: Vec<(f64, RGBColor)> = Vec::new();
    for (_, _, light, _) in models {
        if incidence.iter().all(|(known, _)| known != light) {
            incidence.push((*light, INK));
        }
    }
    let circle = |part: f64| {
        let label = if alike { format!("{part}") } else { format!("{:.2}", part * overall) };
        (part, label)
    };
    let radius = if alike { "f over its largest value" } else { "f / sr⁻¹" };
    Panel::Lobes(Lobes {
        heading: heading.into(),
        radius: radius.into(),
        incidence,
        circles: vec![circle(0.5), circle(1.0)],
        curves,
    })
}

pub(super) fn diffuse() -> Result<Figure, Box<dyn Error>> {
    let mut panels = Vec::new();
    for light in [30.0, 70.0] {
        let mut models: Vec<(String, Model, f64, Pen)> =
            vec![("Lambert".into(), Box::new(Lambert::new(1.0)?), light, PENS[0])];
        for (sigma, pen) in [0.1, 0.3, 0.6].into_iter().zip(&PENS[1..]) {
            let model = Box::new(OrenNayar::new(1.0, sigma)?);
            models.push((format!("Oren–Nayar, σ = {sigma}"), model, light, *pen));
        }
        panels.push(panel(&format!("light at {light}°"), &models, false));
    }
    Ok(Figure {
        name: "lobes-diffuse",
        section: SECTION,
        title: "Rough diffuse surfaces send light back to its source".into(),
        caption: "f for albedo 1. Lambert's is the half circle; roughness takes from the far side \
            and adds on the side of the light (arrow), the more the more the light grazes."
            .into(),
        height: 360.0,
        columns: 1,
        panels,
    })
}

pub(super) fn phong() -> Result<Figure, Box<dyn Error>> {
    let mut panels = Vec::new();
    for light in [30.0, 75.0] {
        let models: Vec<(String, Model, f64, Pen)> = vec![
            ("Phong, n = 20".into(), Box::new(Phong::new(1.0, 20.0)?), light, PENS[0]),
            ("Blinn–Phong, n = 80".into(), Box::new(BlinnPhong::new(1.0, 80.0)?), light, PENS[1]),
        ];
        panels.push(panel(&format!("light at {light}°"), &models, true));
    }
    Ok(Figure {
        name: "lobes-phong",
        section: SECTION,
        title: "Phong against Blinn–Phong in the plane of incidence".into(),
        caption: "With four times the exponent Blinn's lobe is Phong's, here; across the plane of \
            incidence it is narrower, which spheres at grazing show."
            .into(),
        height: 360.0,
        columns: 1,
        panels,
    })
}

pub(super) fn microfacet() -> Result<Figure, Box<dyn Error>> {
    let mut panels = Vec::new();
    for light in [20.0, 50.0] {
        let models: Vec<(String, Model, f64, Pen)> = vec![
            (
                "Gaussian, m = 0.3".into(),
                Box::new(CookTorrance::new(Gaussian::new(0.3)?, Constant::new(1.0)?)),
                light,
                PENS[0],
            ),
            (
                "Beckmann, m = 0.3".into(),
                Box::new(CookTorrance::new(Beckmann::new(0.3)?, Constant::new(1.0)?)),
                light,
                PENS[1],
            ),
            (
                "GGX, α = 0.3".into(),
                Box::new(CookTorrance::new(Ggx::new(0.3)?, Constant::new(1.0)?)),
                light,
                PENS[2],
            ),
        ];
        panels.push(panel(&format!("light at {light}°"), &models, false));
    }
    Ok(Figure {
        name: "lobes-microfacet",
        section: SECTION,
        title: "Cook–Torrance lobes of three distributions".into(),
        caption: "F = 1, V-cavities. GGX is lower at the peak and broader at the foot.".into(),
        height: 360.0,
        columns: 1,
        panels,
    })
}

pub(super) fn off_specular() -> Result<Figure, Box<dyn Error>> {
    let mut models: Vec<(String, Model, f64, Pen)> = Vec::new();
    let mut peaks = Vec::new();
    for (light, pen) in [10.0, 30.0, 45.0, 60.0].into_iter().zip(PENS) {
        let model: Model = Box::new(CookTorrance::new(Beckmann::new(0.4)?, Constant::new(1.0)?));
        let (peak, _) = Curve::new("", pen, (-89.9, 89.9), values(&model, light)).highest();
        peaks.push(format!("{light}° → {peak:.0}°"));
        models.push((format!("light at {light}°"), model, light, pen));
    }
    Ok(Figure {
        name: "lobes-off-specular",
        section: SECTION,
        title: "Off-specular peaks of a rough surface".into(),
        caption: format!(
            "Cook–Torrance, Beckmann m = 0.4, F = 1; each lobe over its largest value. The peak lies \
             beyond the mirror direction, as Torrance and Sparrow explained: {}.",
            peaks.join(", ")
        ),
        height: 460.0,
        columns: 2,
        panels: vec![panel("each lobe over its largest value", &models, true)],
    })
}
