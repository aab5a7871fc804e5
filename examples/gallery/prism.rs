//! Prisms that part white light, drawn ray by ray.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};
use std::path::Path;

use brdf::colorimetry::{COLOR_MATCHING, WAVELENGTHS, xyz_to_linear_srgb};
use brdf::materials::{Material, N_BK7_GLASS_SCHOTT, SF11_GLASS_SCHOTT_LEADED};
use brdf::{Illuminant, ParameterError, refract};
use glam::{DVec2, DVec3, Vec3};
use image::{Rgb, RgbImage};
use rayon::prelude::*;

use crate::picture::Picture;
use crate::{lettering, screen};

const SECTION: &str = "Glass and films";

/// The angle between the faces.
const EDGE: f64 = FRAC_PI_3;
/// Steps of the wavelength, nm; finer than a spectrum's colours can be told apart.
const STEP: f64 = 2.0;
/// The picture of one prism, in units of which the side of the prism has two.
const SIZE: DVec2 = DVec2::new(6.4, 3.2);
/// Half the width of a beam.
const WIDTH: f64 = 0.016;
/// What the beam is multiplied with: the fan is fainter than the beam that it comes from.
const EXPOSURE: f64 = 1.3;
const LETTERS: f64 = 0.15;
const INK: [u8; 3] = [225; 3];

/// A straight part of a ray.
struct Part {
    from: DVec2,
    to: DVec2,
}

/// One wavelength: its colour and its way.
struct Light {
    color: DVec3,
    parts: [Part; 3],
}

/// Where a ray leaves the left face and the right one, and the deviation.
struct Way {
    entry: DVec2,
    exit: DVec2,
    onwards: DVec2,
    deviation: f64,
}

/// The corners: left, right and top. The centre of the base is the origin.
fn corners() -> [DVec2; 3] {
    [DVec2::new(-1.0, 0.0), DVec2::new(1.0, 0.0), DVec2::new(0.0, 3_f64.sqrt())]
}

/// The way through the prism of light that arrives at the middle of the left face.
fn way(index: f64, towards: DVec2) -> Way {
    let [_, right, top] = corners();
    let flat = |v: DVec3| DVec2::new(v.x, v.y);
    let left_normal = DVec3::new(-EDGE.sin(), EDGE.cos(), 0.0);
    let right_normal = DVec3::new(EDGE.sin(), EDGE.cos(), 0.0);
    let entry = DVec2::new(-0.5, 0.5 * top.y);
    let inside = refract((-towards).extend(0.0), left_normal, 1.0, index).direction;
    // On the right face, whose points are right + t (top − right).
    let side = top - right;
    let t = (entry - right).perp_dot(flat(inside)) / side.perp_dot(flat(inside));
    let onwards = refract(-inside, right_normal, 1.0, index).direction;
    let onwards = flat(onwards);
    let deviation = towards.angle_to(onwards).abs();
    Way { entry, exit: right + side * t, onwards, deviation }
}

/// The direction of light that has the least deviation at 550 nm.
fn towards(glass: &Material) -> Result<DVec2, ParameterError> {
    let green: f64 = glass.refractive_index(550.0)?.eta;
    // The normal of the left face points to the upper left, at 150°.
    Ok(-DVec2::from_angle(FRAC_PI_2 + EDGE + (green * (0.5 * EDGE).sin()).asin()))
}

/// White light in all its wavelengths.
fn lights(glass: &Material) -> Result<Vec<Light>, ParameterError> {
    let towards = towards(glass)?;
    let power = Illuminant::D65.power();
    let white = Illuminant::D65.white();
    let mut lights = Vec::new();
    let mut wavelength = glass.range().start().max(400.0);
    while wavelength <= 700.0 {
        let index = glass.refractive_index(wavelength)?.eta;
        let Way { entry, exit, onwards, .. } = way(index, towards);
        let xyz = at(wavelength, |place| DVec3::from(COLOR_MATCHING[place]) * power[place]);
        lights.push(Light {
            color: xyz_to_linear_srgb(xyz),
            parts: [
                Part { from: entry - towards * 4.0, to: entry },
                Part { from: entry, to: exit },
                Part { from: exit, to: exit + onwards * 6.0 },
            ],
        });
        wavelength += STEP;
    }
    // All together are white.
    let sum: DVec3 = lights.iter().map(|light| light.color).sum();
    let scale = xyz_to_linear_srgb(DVec3::from(white)) * EXPOSURE / sum;
    lights.iter_mut().for_each(|light| light.color *= scale);
    Ok(lights)
}

/// A table of the observer at a wavelength, on a straight line.
fn at(wavelength: f64, table: impl Fn(usize) -> DVec3) -> DVec3 {
    let place = (wavelength - WAVELENGTHS[0]) / (WAVELENGTHS[1] - WAVELENGTHS[0]);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the table")]
    let below = (place as usize).min(WAVELENGTHS.len() - 2);
    table(below).lerp(table(below + 1), place - below as f64)
}

impl Part {
    fn distance(&self, point: DVec2) -> f64 {
        let side = self.to - self.from;
        let along = ((point - self.from).dot(side) / side.length_squared()).clamp(0.0, 1.0);
        point.distance(self.from + side * along)
    }
}

/// Two prisms above each other, each `tile` pixels high.
pub fn draw(out: &Path, tile: u32) -> Result<Picture, Box<dyn Error>> {
    let glasses =
        [(&N_BK7_GLASS_SCHOTT, "crown glass BK7"), (&SF11_GLASS_SCHOTT_LEADED, "dense flint SF11")];
    let scale = f64::from(tile) / SIZE.y;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few pixels")]
    let width = (SIZE.x * scale).round() as u32;
    let mut picture = RgbImage::new(width, tile * 2);
    for (place, (glass, name)) in (0_u32..).zip(glasses) {
        let lights = lights(glass)?;
        let pixel = |index: u32| {
            let corner = DVec2::new(f64::from(index % width), f64::from(index / width)) + 0.5;
            let point =
                DVec2::new(corner.x / scale - 0.42 * SIZE.x, SIZE.y - corner.y / scale - 0.9);
            shade(&lights, point)
        };
        let pixels: Vec<[u8; 3]> = (0..width * tile).into_par_iter().map(pixel).collect();
        for (index, bytes) in (0_u32..).zip(pixels) {
            picture.put_pixel(index % width, place * tile + index / width, Rgb(bytes));
        }
        let towards = towards(glass)?;
        let mut label = format!("{name}, 60°.  Deviation");
        for wavelength in [650.0, 550.0, 450.0] {
            let found = way(glass.refractive_index(wavelength)?.eta, towards);
            let degrees = found.deviation.to_degrees();
            let separator = if wavelength > 600.0 { "" } else { "," };
            label.push_str(&format!("{separator} {degrees:.2}° at {wavelength:.0} nm"));
        }
        #[allow(clippy::cast_possible_truncation, reason = "pixels")]
        let [x, y, size] =
            [0.5 * f64::from(width), (f64::from(place) * SIZE.y + 0.2) * scale, LETTERS * scale]
                .map(|length| length as f32);
        lettering::centered(&mut picture, &label, [x, y], size, INK)?;
    }
    let file = "prisms.png".to_owned();
    picture.save(out.join(&file))?;
    Ok(Picture {
        file,
        title: "Dispersion by a prism".into(),
        caption: "White light, D65, falls from the left on prisms with an edge of 60°, such that green, \
                  550 nm, has the least deviation. Every second nanometre from 400 to 700 is a ray refracted by the \
                  measured index of its wavelength (function refract); their colours are those of the \
                  standard observer, added up where they overlap. What sRGB cannot show is cut."
            .into(),
        section: SECTION,
    })
}

/// A pixel's bytes: light, glass and a dark ground.
fn shade(lights: &[Light], point: DVec2) -> [u8; 3] {
    let [left, right, top] = corners();
    let edges = [(left, right), (right, top), (top, left)];
    let inside = edges.iter().all(|(from, to)| (*to - *from).perp_dot(point - *from) > 0.0);
    let edge = edges
        .iter()
        .map(|(from, to)| Part { from: *from, to: *to }.distance(point))
        .fold(f64::INFINITY, f64::min);
    let glass = if inside { 0.035 } else { 0.012 };
    let outline = 0.25 * (-(edge / 0.008).powi(2)).exp();
    let mut sum = DVec3::splat(glass + outline);
    for light in lights {
        let nearest = light.parts.iter().map(|part| part.distance(point));
        let off = nearest.fold(f64::INFINITY, f64::min) / WIDTH;
        if off < 4.0 {
            sum += light.color * (-off * off).exp();
        }
    }
    screen::bytes(screen::value(Vec3::max(sum.as_vec3(), Vec3::ZERO)))
}
