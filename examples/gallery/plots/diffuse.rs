//! Brightness of rough diffuse spheres.

use std::error::Error;
use std::f64::consts::{FRAC_PI_4, PI};

use brdf::{Brdf, Lambert, OrenNayar, from_spherical};
use glam::DVec3;

use super::cartesian::{Axis, Plot};
use super::figure::{Curve, Figure, Panel};
use super::style::{ON_TOP, PENS, Pen};

type Model = Box<dyn Brdf<f64, Color = f64>>;

/// The disc of a sphere under light from the viewer's direction.
pub(super) fn full_moon() -> Result<Figure, Box<dyn Error>> {
    let mut models: Vec<(String, Model, Pen)> = Vec::new();
    for (sigma, pen) in [0.0, 0.1, 0.3, 0.6].into_iter().zip(PENS) {
        let model = Box::new(OrenNayar::new(1.0, sigma)?);
        models.push((format!("Oren–Nayar, σ = {sigma}"), model, pen));
    }
    models.push(("Lambert".into(), Box::new(Lambert::new(1.0)?), ON_TOP));
    let radiance = |model: &Model, place: f64| {
        let w = from_spherical(place.clamp(-1.0, 1.0).asin(), 0.0);
        model.eval(w, w) * w.z
    };
    let curves = models
        .iter()
        .map(|(name, model, pen)| {
            let center = radiance(model, 0.0);
            Curve::new(name.clone(), *pen, (-1.0, 1.0), |x| radiance(model, x) / center)
        })
        .collect();
    let disc = Plot {
        heading: "light from behind the viewer".into(),
        x: Axis::new("distance from the centre / radius", -1.0, 1.0, 0.5),
        y: Axis::new("radiance over that at the centre", 0.0, 1.0, 0.2),
        curves,
        marks: vec![],
    };
    // With both directions at one angle θ on the same side π f = A + B sinθ tanθ.
    let (mut a, mut b) = (Vec::new(), Vec::new());
    for step in 0..=150_u8 {
        let sigma = f64::from(step) / 100.0;
        let model = OrenNayar::new(1.0, sigma)?;
        let w: DVec3 = from_spherical(FRAC_PI_4, 0.0);
        let constant: f64 = PI * model.eval(DVec3::Z, DVec3::Z);
        let slanted: f64 = PI * model.eval(w, w);
        a.push((sigma, constant));
        b.push((sigma, (slanted - constant) / (FRAC_PI_4.sin() * FRAC_PI_4.tan())));
    }
    let constants = Plot {
        heading: "the two constants".into(),
        x: Axis::new("σ / rad", 0.0, 1.5, 0.5),
        y: Axis::new("A, B", 0.0, 1.0, 0.2),
        curves: vec![
            Curve { label: "A".into(), pen: PENS[0], points: a },
            Curve { label: "B".into(), pen: PENS[1], points: b },
        ],
        marks: vec![],
    };
    Ok(Figure {
        name: "full-moon".into(),
        section: "Diffuse",
        title: "The disc of a full moon: Oren–Nayar against Lambert".into(),
        caption:
            "Left: radiance across a sphere. σ = 0 is Lambert exactly; roughness flattens the disc, \
            as the moon's is flat. Right: A and B of f = ρ/π (A + B max(0, cosΔφ) sinθ₁ tanθ₂)."
                .into(),
        height: 420.0,
        columns: 1,
        panels: vec![Panel::Plot(disc), Panel::Plot(constants)],
    })
}
