//! The brightness of the moon over its phase.

use std::error::Error;
use std::f64::consts::FRAC_PI_2;

use brdf::quadrature::integrate;
use brdf::{Brdf, Frame};
use glam::DVec3;
use plotters::style::text_anchor::{HPos, VPos};

use super::cartesian::{Axis, Mark, Plot};
use super::figure::{Curve, Figure, Panel};
use super::style::PENS;
use crate::moon;

/// Phase angle in degrees and reflectance of the whole disc at 549 nm.
const MEASURED: &str = include_str!("../data/moon_549nm.csv");

/// What the measured curve and those of the models are compared at, degrees: the smallest measured phase.
const FULL: f64 = 1.55;

/// ∫ f N·L N·V over the unit sphere: the reflectance of the whole disc, which of a white one that faces the
/// sun is 1.
fn disc(model: &dyn Brdf<f64, Color = f64>, degrees: f64) -> f64 {
    let phase = degrees.to_radians();
    let (sun, viewer) = (DVec3::new(phase.sin(), 0.0, phase.cos()), DVec3::Z);
    let at = |longitude: f64, latitude: f64| {
        let (sin, cos) = latitude.sin_cos();
        let normal = DVec3::new(cos * longitude.sin(), sin, cos * longitude.cos());
        let frame = Frame::from_normal::<f64>(normal);
        let (wi, wo) = (frame.to_local::<f64>(sun), frame.to_local::<f64>(viewer));
        model.eval(wi, wo) * wi.z * wo.z * cos
    };
    // What is lit and seen, and both hemispheres alike.
    let meridian = |longitude| 2.0 * integrate(0.0, FRAC_PI_2, |latitude| at(longitude, latitude));
    integrate(phase - FRAC_PI_2, FRAC_PI_2, meridian)
}

/// The measured curve: degrees and reflectance.
fn measured() -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
    let mut points = Vec::new();
    let lines = MEASURED.lines().filter(|line| !line.starts_with('#'));
    for line in lines.skip(1) {
        let (phase, reflectance) = line.split_once(',').ok_or("two numbers a line")?;
        points.push((phase.parse()?, reflectance.parse()?));
    }
    Ok(points)
}

pub(super) fn phases() -> Result<Figure, Box<dyn Error>> {
    let measured = measured()?;
    let &(_, full) = measured.first().ok_or("no measured phase")?;
    let models = moon::models::<f64, f64>()?;
    let (mut wide, mut narrow, mut worst) = (Vec::new(), Vec::new(), 0.0_f64);
    for ((name, model), pen) in models.iter().zip(PENS) {
        let at_full = disc(&**model, FULL);
        let relative = |degrees: f64| (degrees, disc(&**model, degrees) / at_full);
        let curve = |points| Curve { label: (*name).into(), pen, points };
        wide.push(curve((0..=120_u8).map(|step| relative(f64::from(step))).collect()));
        narrow.push(curve((0..=80_u8).map(|step| relative(f64::from(step) / 4.0)).collect()));
        if *name == "Hapke" {
            let off = measured
                .iter()
                .map(|(phase, value)| (relative(*phase).1 * full / value - 1.0).abs());
            worst = off.fold(0.0, f64::max);
        }
    }
    let dots = |most: f64| -> Vec<Mark> {
        let inside = measured.iter().filter(|(phase, _)| *phase <= most);
        let dot = |(phase, value): &(f64, f64)| Mark::Point {
            at: (*phase, value / full),
            label: String::new(),
            side: (HPos::Center, VPos::Center),
        };
        inside.map(dot).collect()
    };
    let panel = |heading: &str, x: Axis, y: Axis, curves: Vec<Curve>| {
        let marks = dots(x.to);
        Panel::Plot(Plot { heading: heading.into(), x, y, curves, marks })
    };
    Ok(Figure {
        name: "moon-phases".into(),
        section: "The moon",
        title: "The brightness of the moon over its phase".into(),
        caption: format!(
            "The light of the whole disc over that at a phase angle of {FULL}°; dots: the moon, measured from \
             the ground (ROLO, 549 nm, a smoothed fit, Kieffer and Stone 2005). The five parameters of Hapke's \
             model were found on these dots, which it follows to {:.1} %; the other models have no opposition \
             surge and no shadows between grains, and fall too slowly.",
            100.0 * worst
        ),
        height: 440.0,
        columns: 3,
        panels: vec![
            panel(
                "to a crescent",
                Axis::new("phase angle / °", 0.0, 120.0, 30.0),
                Axis::decades("brightness over that of the full moon", -2.0, 0.0, 1.0),
                wide,
            ),
            panel(
                "around full moon",
                Axis::new("phase angle / °", 0.0, 20.0, 5.0),
                Axis::new("brightness over that of the full moon", 0.4, 1.2, 0.2),
                narrow,
            ),
        ],
    })
}
