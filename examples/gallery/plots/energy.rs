//! Directional albedo: which models keep the energy, and which do not.

use std::error::Error;

use brdf::{
    Beckmann, Blinn, Blinn1977, Blinn1977Printed, BlinnPhong, Brdf, ClassicPhong, Constant,
    CookTorrance, CookTorrance1982Printed, Gaussian, Ggx, Lambert, OrenNayar, Phong, SchlickPower,
    SmithCorrelated, SmithSeparable, VCavity, from_spherical,
};

use brdf_checks::models::{self, Entry};

use super::cartesian::{Axis, Mark, Plot};
use super::figure::{Curve, Figure, Panel};
use super::style::PENS;

const SECTION: &str = "Energy";

type Model = Box<dyn Brdf<f64, Color = f64>>;

fn panel(heading: &str, y: Axis, models: &[(&str, Model)]) -> Panel {
    let curve = |((name, model), pen): (&(&str, Model), _)| {
        // Albedos are integrals: a point every degree.
        let albedo = |step: u8| {
            let degrees = f64::from(step).min(89.9);
            (degrees, model.albedo(from_spherical(degrees.to_radians(), 0.0)))
        };
        Curve { label: (*name).into(), pen, points: (0..=90).map(albedo).collect() }
    };
    Panel::Plot(Plot {
        heading: heading.into(),
        x: Axis::degrees("angle of the viewer / °"),
        y,
        curves: models.iter().zip(PENS).map(curve).collect(),
        marks: vec![Mark::Horizontal { y: 1.0 }],
    })
}

/// All lines of the registry of the tests, a figure for each model and as many lines as there are
/// pens.
pub(super) fn registry() -> Vec<Figure> {
    let rows = models::rows().iter().zip(models::double());
    let mut kinds: Vec<(String, Vec<&'static Entry<f64>>)> = Vec::new();
    for (row, entry) in rows {
        let kind = row.type_name();
        match kinds.iter_mut().find(|(known, _)| *known == kind) {
            Some((_, entries)) => entries.push(entry),
            None => kinds.push((kind, vec![entry])),
        }
    }
    let figures = |(kind, entries): &(String, Vec<&'static Entry<f64>>)| {
        let part = |(part, entries): (usize, &[&'static Entry<f64>])| Figure {
            name: format!("albedo-{}-{}", kind.to_lowercase(), part + 1),
            section: "Energy of every model",
            title: format!("Directional albedo of {kind}, sets of parameters of the tests"),
            caption: "The brightest channel, with the parameters that the certificate measures. \
                Above the line a model reflects more than it receives."
                .into(),
            height: 420.0,
            columns: 2,
            panels: vec![known(entries)],
        };
        entries.chunks(PENS.len()).enumerate().map(part).collect::<Vec<_>>()
    };
    kinds.iter().flat_map(figures).collect()
}

fn known(entries: &[&'static Entry<f64>]) -> Panel {
    let curve = |(entry, pen): (&&'static Entry<f64>, _)| {
        let albedo = |step: u8| {
            let degrees = (2.0 * f64::from(step)).min(89.0);
            let wo = from_spherical(degrees.to_radians(), 0.0);
            (degrees, entry.model.albedo(wo).max_element())
        };
        Curve { label: entry.name.into(), pen, points: (0..=45).map(albedo).collect() }
    };
    let curves: Vec<Curve> = entries.iter().zip(PENS).map(curve).collect();
    let highest = curves.iter().map(|curve| curve.highest().1).fold(1.0, f64::max);
    let step = match highest {
        ..2.5 => 0.2,
        ..4.0 => 0.5,
        _ => 1.0,
    };
    let top = (1.1 * highest / step).ceil() * step;
    Panel::Plot(Plot {
        heading: String::new(),
        x: Axis::degrees("angle of the viewer / °"),
        y: Axis::new("directional albedo", 0.0, top, step),
        curves,
        marks: vec![Mark::Horizontal { y: 1.0 }],
    })
}

/// Models that never reflect more than they receive.
pub(super) fn conserving() -> Result<Figure, Box<dyn Error>> {
    let white = || Constant::new(1.0);
    let lobes: [(&str, Model); 4] = [
        ("Lambert", Box::new(Lambert::new(1.0)?)),
        ("Phong, n = 10", Box::new(Phong::new(1.0, 10.0)?)),
        ("Blinn–Phong, n = 10", Box::new(BlinnPhong::new(1.0, 10.0)?)),
        ("Schlick's power, h = 10", Box::new(SchlickPower::new(1.0, 10.0)?)),
    ];
    let m = 0.5;
    let beckmann = || -> Result<_, Box<dyn Error>> {
        Ok(CookTorrance::from_parts(Beckmann::new(m)?, white()?, VCavity))
    };
    let ggx = || -> Result<_, Box<dyn Error>> {
        Ok(CookTorrance::from_parts(Ggx::new(m)?, white()?, VCavity))
    };
    let facets: [(&str, Model); 7] = [
        ("Beckmann, V-cavity", Box::new(beckmann()?.with_shadowing(VCavity))),
        ("Beckmann, Smith correlated", Box::new(beckmann()?.with_shadowing(SmithCorrelated))),
        ("GGX, V-cavity", Box::new(ggx()?.with_shadowing(VCavity))),
        ("GGX, Smith correlated", Box::new(ggx()?.with_shadowing(SmithCorrelated))),
        ("GGX, Smith separable", Box::new(ggx()?.with_shadowing(SmithSeparable))),
        ("Gaussian, V-cavity", Box::new(CookTorrance::new(Gaussian::new(m)?, white()?))),
        ("Blinn, V-cavity", Box::new(CookTorrance::new(Blinn::from_roughness(m)?, white()?))),
    ];
    let albedo = || Axis::new("directional albedo", 0.0, 1.2, 0.2);
    Ok(Figure {
        name: "albedo".into(),
        section: SECTION,
        title: "Directional albedo of conserving models, colour 1".into(),
        caption:
            "The part of the light that leaves, all at most 1. Lobes lose what would go below \
            the horizon; microfacets (roughness 0.5, F = 1) lack the light that reflects more than \
            once."
                .into(),
        height: 420.0,
        columns: 1,
        panels: vec![
            panel("diffuse and glossy", albedo(), &lobes),
            panel("microfacets, roughness 0.5", albedo(), &facets),
        ],
    })
}

/// Models that reflect more than they receive.
pub(super) fn not_conserving() -> Result<Figure, Box<dyn Error>> {
    let white = || Constant::new(1.0);
    let printed: [(&str, Model); 5] = [
        (
            "Cook–Torrance as printed, α = 0.1",
            Box::new(CookTorrance1982Printed::new(Beckmann::new(0.1)?, white()?)),
        ),
        (
            "Blinn 1977 as printed, D₂, β = 0.5",
            Box::new(Blinn1977Printed::d2(Blinn1977::new(0.5)?, white()?)?),
        ),
        ("classic Phong, n = 3", Box::new(ClassicPhong::new(1.0, 3.0)?)),
        ("unnormalised Blinn–Phong, n = 5", Box::new(BlinnPhong::unnormalized(1.0, 5.0)?)),
        ("unnormalised Schlick, h = 2", Box::new(SchlickPower::unnormalized(1.0, 2.0)?)),
    ];
    let rough: [(&str, Model); 5] = [
        ("Oren–Nayar, σ = 0.1", Box::new(OrenNayar::new(1.0, 0.1)?)),
        ("Oren–Nayar, σ = 0.2", Box::new(OrenNayar::new(1.0, 0.2)?)),
        ("Oren–Nayar, σ = 0.3", Box::new(OrenNayar::new(1.0, 0.3)?)),
        ("Oren–Nayar, σ = 0.6", Box::new(OrenNayar::new(1.0, 0.6)?)),
        ("σ = 0.3, interreflection", Box::new(OrenNayar::with_interreflection(1.0, 0.3)?)),
    ];
    Ok(Figure {
        name: "albedo-not-conserving".into(),
        section: SECTION,
        title: "Directional albedo of models that exceed 1".into(),
        caption: "Left: forms without the constant that normalises them; Cook and Torrance's printed \
            one is four times too bright. Right, on its own axis: Oren–Nayar exceeds its albedo by up \
            to a few percent, at grazing."
            .into(),
        height: 420.0,
        columns: 1,
        panels: vec![
            panel("printed and unnormalised", Axis::new("directional albedo", 0.0, 4.5, 0.5), &printed),
            panel("rough diffuse", Axis::new("directional albedo", 0.7, 1.1, 0.05), &rough),
        ],
    })
}
