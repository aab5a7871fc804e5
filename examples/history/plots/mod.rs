//! Lobes of the steps.

#[allow(dead_code, reason = "plots that only the gallery needs")]
#[path = "../../gallery/plots/cartesian.rs"]
mod cartesian;
#[allow(dead_code, reason = "panels that only the gallery needs")]
#[path = "../../gallery/plots/figure.rs"]
mod figure;
#[allow(dead_code, reason = "scales that only the gallery needs")]
#[path = "../../gallery/plots/lobe.rs"]
mod lobe;
#[path = "../../gallery/plots/polar.rs"]
mod polar;
#[allow(dead_code, reason = "colours that only the gallery needs")]
#[path = "../../gallery/plots/style.rs"]
mod style;

use std::error::Error;
use std::path::Path;

use brdf::{Bsdf, TransportMode, from_spherical};
use figure::{Curve, Figure};
use glam::Vec3;
use lobe::Radius;
use style::{BLUE, Dash, GUIDE, PENS, Pen, SHORT};

use crate::picture::Picture;
use crate::steps::{Model, Step};

/// Angles of the light, degrees.
const LIGHTS: [f32; 2] = [30.0, 60.0];

/// f at 550 nm over the angle of the viewer, negative on the side of the light.
fn curve(label: &str, model: &Model, light: f32, pen: Pen) -> Curve {
    let wi: Vec3 = from_spherical((-light).to_radians(), 0.0_f32);
    let point = |degree: i8| {
        let wo = from_spherical(f32::from(degree).to_radians(), 0.0_f32);
        (f64::from(degree), f64::from(model.eval(wi, wo, TransportMode::Radiance).y))
    };
    Curve { label: label.into(), pen, points: (-EDGE..=EDGE).map(point).collect() }
}

/// The largest angle of the viewer, degrees.
const EDGE: i8 = 85;

/// The share of the light in the specular lobe, if there is one.
fn mirror(model: &Model, light: f32) -> f32 {
    let wo = from_spherical(light.to_radians(), 0.0_f32);
    model.specular(wo, TransportMode::Radiance).reflected.weight.y
}

/// The lobes of a step, and of the one before.
pub fn step(
    step: &Step,
    before: Option<&Step>,
    section: &'static str,
    folder: &Path,
) -> Result<Picture, Box<dyn Error>> {
    let mut panels = Vec::new();
    for light in LIGHTS {
        let mut lit = Vec::new();
        if let Some(before) = before {
            let pen = Pen { color: GUIDE, dash: SHORT };
            lit.push((curve(before.label, &before.model, light, pen), f64::from(light)));
        }
        let pen = Pen { color: BLUE, dash: Dash::Solid };
        lit.push((curve(step.label, &step.model, light, pen), f64::from(light)));
        panels.push(lobe::panel(&format!("light at {light}°"), lit, Radius::Common));
    }
    let shares = LIGHTS.map(|light| mirror(&step.model, light));
    let caption = match shares {
        [near, grazing] if near > 0.0 || grazing > 0.0 => format!(
            "Beside what is drawn, a mirror reflects {:.1} % of the light at {}° and {:.0} % at {}°.",
            100.0 * near,
            LIGHTS[0],
            100.0 * grazing,
            LIGHTS[1]
        ),
        _ => String::new(),
    };
    let figure = Figure {
        name: format!("{}-lobes", step.file),
        section,
        title: format!("{}: f in the plane of incidence", step.label),
        caption,
        height: 315.0,
        columns: 2,
        panels,
    };
    figure.write(folder)
}

/// The lobes of all steps, in three groups.
pub fn all(steps: &[Step], folder: &Path) -> Result<Picture, Box<dyn Error>> {
    let light = 45.0;
    let groups: [(&str, &[&str]); 3] = [
        ("optics", &["beckmann-kirchhoff", "torrance-sparrow", "cook-torrance", "he-1991"]),
        ("graphics", &["phong", "blinn-phong", "blinn-1977", "schlick-1994", "ggx"]),
        ("matte", &["lambert", "oren-nayar", "eon"]),
    ];
    let mut panels = Vec::new();
    for (heading, files) in groups {
        let mut lit = Vec::new();
        for (step, pen) in steps.iter().filter(|step| files.contains(&step.file)).zip(PENS) {
            lit.push((curve(step.label, &step.model, light, pen), f64::from(light)));
        }
        panels.push(lobe::panel(heading, lit, Radius::Common));
    }
    let figure = Figure {
        name: "history-lobes".into(),
        section: "All",
        title: format!("Rough gold at 550 nm by all models, light at {light}°"),
        caption: String::new(),
        height: 250.0,
        columns: 1,
        panels,
    };
    figure.write(folder)
}
