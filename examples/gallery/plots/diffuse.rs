//! Brightness of spheres, and energy.

use std::error::Error;

use brdf::{
    Beckmann, BlinnPhong, Brdf, ClassicPhong, Constant, CookTorrance, CookTorrance1982Printed, Ggx,
    Lambert, OrenNayar, Phong, SchlickPower, SmithCorrelated, from_spherical,
};

use super::cartesian::{Axis, Mark, Plot};
use super::figure::{Curve, Figure, Panel};
use super::style::PENS;

type Model = Box<dyn Brdf<f64, Color = f64>>;

/// The disc of a sphere under light from the viewer's direction.
pub(super) fn full_moon() -> Result<Figure, Box<dyn Error>> {
    let mut models: Vec<(String, Model)> = vec![("Lambert".into(), Box::new(Lambert::new(1.0)?))];
    for sigma in [0.0, 0.1, 0.3, 0.6] {
        models.push((format!("Oren–Nayar, σ = {sigma}"), Box::new(OrenNayar::new(1.0, sigma)?)));
    }
    let radiance = |model: &Model, place: f64| {
        let w = from_spherical(place.clamp(-1.0, 1.0).asin(), 0.0);
        model.eval(w, w) * w.z
    };
    let curves = models
        .iter()
        .zip(PENS)
        .map(|((name, model), pen)| {
            let center = radiance(model, 0.0);
            Curve::new(name.clone(), pen, (-1.0, 1.0), |x| radiance(model, x) / center)
        })
        .collect();
    let plot = Plot {
        heading: "light from behind the viewer".into(),
        x: Axis::new("distance from the centre of the disc / radius", -1.0, 1.0, 0.5),
        y: Axis::new("radiance over that at the centre", 0.0, 1.0, 0.2),
        curves,
        marks: vec![],
    };
    Ok(Figure {
        name: "full-moon",
        section: "Diffuse",
        title: "The disc of a full moon: Oren–Nayar against Lambert".into(),
        caption:
            "Radiance across a sphere. σ = 0 is Lambert exactly; roughness flattens the disc, \
            as the moon's is flat."
                .into(),
        height: 420.0,
        columns: 2,
        panels: vec![Panel::Plot(plot)],
    })
}

/// Which models reflect more than they receive.
pub(super) fn albedo() -> Result<Figure, Box<dyn Error>> {
    let white = || Constant::new(1.0);
    let conserving: Vec<(&str, Model)> = vec![
        ("Lambert", Box::new(Lambert::new(1.0)?)),
        ("Phong, n = 10", Box::new(Phong::new(1.0, 10.0)?)),
        ("Blinn–Phong, n = 10", Box::new(BlinnPhong::new(1.0, 10.0)?)),
        ("Schlick's power, h = 10", Box::new(SchlickPower::new(1.0, 10.0)?)),
        ("Beckmann, m = 0.5, V-cavity", Box::new(CookTorrance::new(Beckmann::new(0.5)?, white()?))),
        (
            "GGX, α = 0.5, Smith",
            Box::new(CookTorrance::new(Ggx::new(0.5)?, white()?).with_shadowing(SmithCorrelated)),
        ),
    ];
    let others: Vec<(&str, Model)> = vec![
        ("Cook–Torrance as printed, m = 0.1", {
            Box::new(CookTorrance1982Printed::new(Beckmann::new(0.1)?, white()?))
        }),
        ("classic Phong, n = 3", Box::new(ClassicPhong::new(1.0, 3.0)?)),
        ("unnormalised Blinn–Phong, n = 5", Box::new(BlinnPhong::unnormalized(1.0, 5.0)?)),
        ("Oren–Nayar, σ = 0.3", Box::new(OrenNayar::new(1.0, 0.3)?)),
    ];
    let over_angle = |list: &[(&str, Model)]| {
        let curve = |((name, model), pen): (&(&str, Model), _)| {
            // Albedos are integrals: a point every two degrees.
            let albedo = |step: u32| {
                let degrees = f64::from(step) * 89.9 / 45.0;
                (degrees, model.albedo(from_spherical(degrees.to_radians(), 0.0)))
            };
            Curve { label: (*name).into(), pen, points: (0..=45).map(albedo).collect() }
        };
        list.iter().zip(PENS).map(curve).collect::<Vec<_>>()
    };
    let panel = |heading: &str, y, curves| {
        Panel::Plot(Plot {
            heading: heading.into(),
            x: Axis::degrees("angle of the viewer / °"),
            y,
            curves,
            marks: vec![Mark::Horizontal { y: 1.0 }],
        })
    };
    Ok(Figure {
        name: "albedo",
        section: "Energy",
        title: "Directional albedo, colour 1".into(),
        caption: "What part of the light leaves. Left: models that never reflect more than they \
            receive; what microfacets lack is light that reflects more than once. Right: models that \
            do reflect more."
            .into(),
        height: 420.0,
        columns: 1,
        panels: vec![
            panel("conserving", Axis::new("albedo", 0.0, 1.2, 0.2), over_angle(&conserving)),
            panel("not conserving", Axis::new("albedo", 0.0, 4.5, 0.5), over_angle(&others)),
        ],
    })
}
