//! Reflected light over the angle of the viewer, in the plane of incidence.

use std::error::Error;

use brdf::{
    Beckmann, BlinnPhong, Brdf, Constant, CookTorrance, Distribution, Gaussian, Ggx, Lambert,
    OrenNayar, Phong, VCavity, from_spherical,
};

use super::figure::{Curve, Figure, Panel};
use super::lobe::{self, Radius};
use super::style::{BLUE, Dash, GREEN, INK, ON_TOP, PENS, Pen, SHORT, VERMILION};

const SECTION: &str = "Lobes";

type Model = Box<dyn Brdf<f64, Color = f64>>;

/// Name, model, angle of the light in degrees, and pen of a lobe.
type Lit = (String, Model, f64, Pen);

/// f over the angle of the viewer in degrees, negative on the side of the light.
fn values(model: &Model, light: f64) -> impl Fn(f64) -> f64 + '_ {
    let wi = from_spherical((-light).to_radians(), 0.0);
    move |degrees: f64| model.eval(wi, from_spherical(degrees.to_radians(), 0.0))
}

/// The lobes of several models.
fn panel(heading: &str, models: &[Lit], radius: Radius) -> Panel {
    let curve = |(name, model, light, pen): &Lit| {
        (Curve::new(name.clone(), *pen, (-89.99, 89.99), values(model, *light)), *light)
    };
    lobe::panel(heading, models.iter().map(curve).collect(), radius)
}

pub(super) fn diffuse() -> Result<Figure, Box<dyn Error>> {
    let mut panels = Vec::new();
    for light in [30.0, 70.0] {
        let mut models: Vec<Lit> = Vec::new();
        for (sigma, pen) in [0.1, 0.3, 0.6].into_iter().zip(&PENS) {
            let model = Box::new(OrenNayar::new(1.0, sigma)?);
            models.push((format!("Oren–Nayar, σ = {sigma}"), model, light, *pen));
        }
        // On top of the others, and broken, so that they show where they coincide.
        models.push(("Lambert".into(), Box::new(Lambert::new(1.0)?), light, ON_TOP));
        panels.push(panel(&format!("light at {light}°"), &models, Radius::Common));
    }
    Ok(Figure {
        name: "lobes-diffuse".into(),
        section: SECTION,
        title: "Rough diffuse surfaces send light back to its source".into(),
        caption: "f for albedo 1. Lambert's is the half circle; roughness takes from the far side \
            and adds on the side of the light (arrow), the more the more the light grazes."
            .into(),
        height: 315.0,
        columns: 2,
        panels,
    })
}

pub(super) fn phong() -> Result<Figure, Box<dyn Error>> {
    let mut panels = Vec::new();
    for exponent in [20.0, 80.0] {
        let mut models: Vec<Lit> = Vec::new();
        for (light, color) in [(30.0, BLUE), (60.0, VERMILION), (80.0, GREEN)] {
            let (phong, blinn) = (Phong::new(1.0, 20.0)?, BlinnPhong::new(1.0, exponent)?);
            let name = if color == GREEN { "Blinn–Phong" } else { "" };
            let pen = Pen { color, dash: Dash::Solid };
            models.push((format!("Phong, {light}°"), Box::new(phong), light, pen));
            let pen = Pen { color: INK, dash: SHORT };
            models.push((name.into(), Box::new(blinn), light, pen));
        }
        let heading = format!("Phong n = 20, Blinn–Phong n = {exponent}");
        panels.push(panel(&heading, &models, Radius::Own));
    }
    Ok(Figure {
        name: "lobes-phong".into(),
        section: SECTION,
        title: "Phong against Blinn–Phong in the plane of incidence".into(),
        caption: "Light at 30°, 60° and 80°, each lobe over its largest value. With the same exponent \
            Blinn's lobe is twice as wide as Phong's; with four times the exponent the two coincide here. \
            Across the plane of incidence Blinn's is narrower, which spheres at grazing show."
            .into(),
        height: 315.0,
        columns: 4,
        panels,
    })
}

/// Cook–Torrance with F = 1 and V-cavities, for three distributions.
fn three_distributions(light: f64) -> Result<Vec<Lit>, Box<dyn Error>> {
    fn mirrors(distribution: impl Distribution<f64> + 'static) -> Result<Model, Box<dyn Error>> {
        Ok(Box::new(CookTorrance::from_parts(distribution, Constant::new(1.0)?, VCavity)))
    }
    let m = 0.3;
    Ok(vec![
        (format!("Gaussian, α = {m}"), mirrors(Gaussian::new(m)?)?, light, PENS[0]),
        (format!("Beckmann, α = {m}"), mirrors(Beckmann::new(m)?)?, light, PENS[1]),
        (format!("GGX, α = {m}"), mirrors(Ggx::new(m)?)?, light, PENS[2]),
    ])
}

pub(super) fn microfacet() -> Result<Figure, Box<dyn Error>> {
    let mut panels = Vec::new();
    for light in [20.0, 50.0] {
        let heading = format!("light at {light}°");
        panels.push(panel(&heading, &three_distributions(light)?, Radius::Common));
    }
    Ok(Figure {
        name: "lobes-microfacet".into(),
        section: SECTION,
        title: "Cook–Torrance lobes of three distributions".into(),
        caption:
            "F = 1, V-cavities. The Gaussian and Beckmann are close; GGX is narrower around the \
            mirror direction and broader at the foot. The corners at grazing are those of the \
            V-cavities' G."
                .into(),
        height: 315.0,
        columns: 3,
        panels,
    })
}

pub(super) fn microfacet_decades() -> Result<Figure, Box<dyn Error>> {
    let light = 30.0;
    Ok(Figure {
        name: "lobes-microfacet-logarithmic".into(),
        section: SECTION,
        title: "Tails of the Cook–Torrance lobes, logarithmic radius".into(),
        caption:
            "The same surfaces; the centre is 10⁻⁴ of the largest value. Towards the light GGX is above the others by orders \
            of magnitude: the halo around its highlights."
                .into(),
        height: 430.0,
        columns: 3,
        panels: vec![panel(&format!("light at {light}°"), &three_distributions(light)?, Radius::Decades)],
    })
}

pub(super) fn off_specular() -> Result<Figure, Box<dyn Error>> {
    let mut models: Vec<Lit> = Vec::new();
    let mut peaks = Vec::new();
    for (light, pen) in [10.0, 30.0, 45.0, 60.0].into_iter().zip(PENS) {
        let rough = CookTorrance::new(Beckmann::new(0.4)?, Constant::new(1.0)?);
        let model: Model = Box::new(rough.with_shadowing(VCavity));
        let (peak, _) = Curve::new("", pen, (-89.99, 89.99), values(&model, light)).highest();
        peaks.push(format!("{light}° → {peak:.0}°"));
        models.push((format!("light at {light}°"), model, light, pen));
    }
    Ok(Figure {
        name: "lobes-off-specular".into(),
        section: SECTION,
        title: "Off-specular peaks of a rough surface".into(),
        caption: format!(
            "Cook–Torrance, Beckmann α = 0.4, F = 1, V-cavities; each lobe over its largest value. The peak lies \
             beyond the mirror direction, as Torrance and Sparrow explained: {}.",
            peaks.join(", ")
        ),
        height: 430.0,
        columns: 4,
        panels: vec![panel("Beckmann, α = 0.4", &models, Radius::Own)],
    })
}
