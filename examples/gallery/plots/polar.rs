//! Lobes in the plane of incidence.

use std::error::Error;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::figure::{Area, Curve, LETTERS};
use super::style::{Dash, GRID, GUIDE, INK, Pen, anchored, draw_line, letters, px, stroke};

/// Lobes over half a circle: the normal points up, the light comes from the left.
pub(super) struct Lobes {
    pub(super) heading: String,
    /// What the radius is.
    pub(super) radius: String,
    /// Angles of the light in degrees, each with the colour of its arrow.
    pub(super) incidence: Vec<(f64, RGBColor)>,
    /// Circles: radius as a fraction of the largest, and its label.
    pub(super) circles: Vec<(f64, String)>,
    /// Angle in degrees, negative on the side of the light, and radius in 0 … 1.
    pub(super) curves: Vec<Curve>,
}

/// A half circle on the canvas.
struct Dial {
    center: (i32, i32),
    radius: f64,
}

impl Dial {
    /// The point at an angle from the normal, in degrees, and a fraction of the radius.
    #[allow(clippy::cast_possible_truncation, reason = "the backend counts in integers")]
    fn place(&self, (degrees, fraction): (f64, f64)) -> (i32, i32) {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let r = self.radius * fraction;
        (self.center.0 + (r * sin).round() as i32, self.center.1 - (r * cos).round() as i32)
    }
}

impl Lobes {
    pub(super) fn draw(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let (width, height) = area.dim_in_pixel();
        let (width, height) = (i32::try_from(width)?, i32::try_from(height)?);
        let margin = px(48.0);
        let above = px(58.0);
        let below = px(62.0);
        let radius = f64::from((width / 2 - margin).min(height - above - below));
        let dial = Dial { center: (width / 2, height - below), radius };

        let style = anchored(letters(18.0, INK), HPos::Center, VPos::Center);
        area.draw(&Text::new(self.heading.as_str(), (width / 2, px(13.0)), style))?;
        self.draw_grid(area, &dial)?;
        for curve in &self.curves {
            let points = curve.points.iter().map(|&point| dial.place(point)).collect();
            draw_line(area, points, curve.pen, 2.4)?;
        }
        for &(angle, color) in &self.incidence {
            draw_arrow(area, &dial, angle, color)?;
        }
        let style = anchored(letters(LETTERS, INK), HPos::Center, VPos::Center);
        let at = (width / 2, height - px(14.0));
        area.draw(&Text::new(self.radius.as_str(), at, style))?;
        Ok(())
    }

    fn draw_grid(&self, area: &Area<'_>, dial: &Dial) -> Result<(), Box<dyn Error>> {
        let text = |horizontal, vertical| anchored(letters(LETTERS, INK), horizontal, vertical);
        // Labels that would run into each other are left out, from the outermost one every second.
        let spacing = self.circles.first().map_or(1.0, |(fraction, _)| *fraction);
        let every = if spacing * dial.radius < f64::from(px(34.0)) { 2 } else { 1 };
        for (place, (fraction, label)) in self.circles.iter().rev().enumerate() {
            let circle = (-90..=90).map(|d| dial.place((f64::from(d), *fraction))).collect();
            let pen = Pen { color: GRID, dash: Dash::Solid };
            draw_line(area, circle, pen, 1.0)?;
            let sides: &[f64] = if place % every == 0 { &[-90.0, 90.0] } else { &[] };
            for &degrees in sides {
                let (x, y) = dial.place((degrees, *fraction));
                let style = text(HPos::Center, VPos::Center);
                area.draw(&Text::new(label.as_str(), (x, y + px(17.0)), style))?;
            }
        }
        for step in -6_i32..=6 {
            let degrees = f64::from(step * 15);
            let color = if step == 0 { GUIDE } else { GRID };
            let ray = vec![dial.center, dial.place((degrees, 1.0))];
            area.draw(&PathElement::new(ray, stroke(color, 1.0)))?;
            if step % 2 == 0 {
                let (x, y) = dial.place((degrees, 1.0));
                let (sin, cos) = degrees.to_radians().sin_cos();
                let side = match step.signum() {
                    -1 => HPos::Right,
                    1 => HPos::Left,
                    _ => HPos::Center,
                };
                #[allow(
                    clippy::cast_possible_truncation,
                    reason = "the backend counts in integers"
                )]
                let at =
                    (x + (sin * f64::from(px(7.0))) as i32, y - (cos * f64::from(px(13.0))) as i32);
                let label = format!("{}°", (step * 15).abs());
                area.draw(&Text::new(label, at, text(side, VPos::Center)))?;
            }
        }
        let floor = vec![dial.place((-90.0, 1.0)), dial.place((90.0, 1.0))];
        area.draw(&PathElement::new(floor, stroke(INK, 1.6)))?;
        Ok(())
    }
}

/// The light: an arrow from outside the circle into it.
fn draw_arrow(
    area: &Area<'_>,
    dial: &Dial,
    angle: f64,
    color: RGBColor,
) -> Result<(), Box<dyn Error>> {
    let inward = |pixels: f64| 1.0 - f64::from(px(pixels)) / dial.radius;
    let (tail, tip) = (dial.place((-angle, 1.0)), dial.place((-angle, inward(40.0))));
    area.draw(&PathElement::new(
        vec![tail, dial.place((-angle, inward(30.0)))],
        stroke(color, 2.6),
    ))?;
    let wing = |turn: f64| {
        let across = f64::from(px(6.0)) / (dial.radius * inward(26.0));
        dial.place((-angle + turn * across.to_degrees(), inward(26.0)))
    };
    area.draw(&Polygon::new(vec![tip, wing(-1.0), wing(1.0)], color.filled()))?;
    Ok(())
}
