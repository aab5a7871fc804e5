//! Measured points and fitted curves in the plane of incidence.

use glam::DVec3;
use plotters::style::RGBColor;

use super::colors::{BLUE, GREEN, GREY, INK, ORANGE, RED};
use super::figure::{Curve, Figure, Panel};
use brdf::Brdf;
use brdf_checks::fits::Row;
use brdf_checks::fits::family::Family;
use brdf_checks::fits::measured::direction;

/// Which of the measured angles of incidence a figure shows: 0°, about 50° and 70°.
const SHOWN: [usize; 3] = [0, 3, 5];

/// Decades below the largest value.
const DEPTH: f64 = 7.0;

pub fn all(rows: &[Row]) -> Vec<Figure> {
    let mut figures: Vec<Figure> = rows.iter().map(figure).collect();
    figures.push(summary(rows));
    figures
}

fn figure(row: &Row) -> Figure {
    let panels = SHOWN.iter().enumerate().map(|(place, &index)| {
        let theta = row.material.incidences()[index];
        panel(row, theta, format!("light at {theta:.1}°"), place == 0)
    });
    Figure {
        name: row.material.key.clone(),
        title: row.material.title.to_owned(),
        subtitle: "Luminance of f_r in the plane of incidence, measured and fitted. Negative \
                   angles are on the side of the light. The scale is logarithmic: measured values \
                   that are not positive have no mark."
            .to_owned(),
        swatch: None,
        panels: panels.collect(),
    }
}

/// A wall paint and a film, light at about 50°.
fn summary(rows: &[Row]) -> Figure {
    let panels = ["colodur_napoli_4f", "cc_ibiza_sunset"].iter().enumerate();
    let panels = panels.filter_map(|(place, key)| {
        let row = rows.iter().find(|row| row.material.key == *key)?;
        let theta = row.material.incidences()[SHOWN[1]];
        let heading = format!("{}, light at {theta:.1}°", row.material.title);
        Some(panel(row, theta, heading, place == 0))
    });
    Figure {
        name: "measured-fits".to_owned(),
        title: "Models fitted to measured materials".to_owned(),
        subtitle: "Luminance of f_r in the plane of incidence. Negative angles are on the side of \
                   the light."
            .to_owned(),
        swatch: None,
        panels: panels.collect(),
    }
}

const fn luminance(color: DVec3) -> f64 {
    0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z
}

const fn pen(family: Family) -> (RGBColor, &'static str) {
    match family {
        Family::Lambert => (GREY, "Lambert"),
        Family::OrenNayar => (ORANGE, "Oren–Nayar"),
        Family::BlinnPhong => (GREEN, "Blinn–Phong"),
        Family::Beckmann => (BLUE, "Beckmann"),
        Family::Ggx => (RED, "GGX"),
    }
}

/// Angles of view in degrees, close together around the mirror direction.
fn angles(mirror: f64) -> Vec<f64> {
    let around = |step: f64| (-30..=30).map(move |index| mirror + step * f64::from(index));
    let coarse = (-80..=80).map(f64::from);
    let all = coarse.chain(around(0.05)).chain(around(0.2));
    let mut angles: Vec<f64> = all.filter(|angle| angle.abs() <= 80.0).collect();
    angles.sort_by(f64::total_cmp);
    angles
}

fn panel(row: &Row, theta: f64, heading: String, named: bool) -> Panel {
    let name = |name: &str| if named { name.to_owned() } else { String::new() };
    let mut curves = Vec::new();
    for fit in &row.fits {
        let (color, label) = pen(fit.family);
        let wi = direction(theta, 0.0);
        let value = |angle: f64| luminance(fit.model.eval(wi, direction(angle, 180.0)));
        let points = angles(theta).into_iter().map(|angle| (angle, value(angle))).collect();
        let curve = Curve::new(name(label), color, points);
        // Where two families agree, the dashes let the other show.
        curves.push(if fit.family == Family::OrenNayar { curve.dashed() } else { curve });
    }
    let in_plane = row.material.points.iter().filter(|point| point.theta_i == theta);
    let measured = in_plane.filter_map(|point| {
        let side = match point.azimuth {
            0.0 => -1.0,
            180.0 => 1.0,
            _ => return None,
        };
        Some((side * point.theta_o, luminance(point.value)))
    });
    curves.push(Curve::new(name("measured"), INK, measured.collect()).dots());
    let y = logarithms(&mut curves);
    Panel {
        heading,
        x_name: "direction of view in degrees from the normal",
        y_name: "f_r in sr⁻¹",
        x: -80.0..80.0,
        y,
        decades: true,
        list: true,
        curves,
        ..Panel::default()
    }
}

/// Turns values into their logarithms, without those off the scale, and finds the decades.
fn logarithms(curves: &mut [Curve]) -> std::ops::Range<f64> {
    let positive = |curve: &Curve| -> Vec<f64> {
        curve.points.iter().map(|point| point.1).filter(|value| *value > 0.0).collect()
    };
    let all = curves.iter().flat_map(positive).fold(0.0, f64::max);
    let measured = curves.last().map(positive).unwrap_or_default();
    let least = measured.into_iter().fold(f64::INFINITY, f64::min);
    let end = all.log10().ceil();
    let start = least.log10().floor().max(end - DEPTH).min(end - 1.0);
    for curve in curves {
        curve.points.iter_mut().for_each(|point| point.1 = point.1.max(0.0).log10());
        curve.points.retain(|point| point.1 >= start);
    }
    start..end
}
