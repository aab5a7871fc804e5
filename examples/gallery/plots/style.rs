//! Colours, strokes and letters that all plots share.

use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Coordinates per pixel. The SVG backend rounds coordinates to integers; on a canvas this many
/// times as large, shown at its nominal size, curves are smooth.
pub(super) const SCALE: f64 = 8.0;

/// Pixels into coordinates of the canvas.
#[allow(clippy::cast_possible_truncation, reason = "the backend counts in integers")]
pub(super) fn px(pixels: f64) -> i32 {
    (pixels * SCALE).round() as i32
}

/// A length in coordinates of the canvas.
pub(super) fn length(pixels: f64) -> u32 {
    px(pixels).unsigned_abs()
}

/// Okabe and Ito's palette, which stays distinct for colour-blind readers; its yellow is too light
/// for lines.
pub(super) const BLUE: RGBColor = RGBColor(0, 114, 178);
pub(super) const VERMILION: RGBColor = RGBColor(213, 94, 0);
pub(super) const GREEN: RGBColor = RGBColor(0, 158, 115);
pub(super) const PURPLE: RGBColor = RGBColor(204, 121, 167);
pub(super) const SKY: RGBColor = RGBColor(86, 180, 233);
pub(super) const ORANGE: RGBColor = RGBColor(230, 159, 0);
pub(super) const INK: RGBColor = RGBColor(20, 20, 20);
pub(super) const GRID: RGBColor = RGBColor(221, 221, 221);
pub(super) const GUIDE: RGBColor = RGBColor(110, 110, 110);

/// How a line is broken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Dash {
    Solid,
    /// Dash and gap in pixels.
    Broken(f64, f64),
}

pub(super) const LONG: Dash = Dash::Broken(13.0, 5.0);
pub(super) const SHORT: Dash = Dash::Broken(6.0, 4.0);
pub(super) const DOTS: Dash = Dash::Broken(3.2, 3.2);

/// A line's colour and dashes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pen {
    pub(super) color: RGBColor,
    pub(super) dash: Dash,
}

/// Pens that differ in colour and in dashes.
pub(super) const PENS: [Pen; 7] = [
    Pen { color: BLUE, dash: Dash::Solid },
    Pen { color: VERMILION, dash: LONG },
    Pen { color: GREEN, dash: SHORT },
    Pen { color: PURPLE, dash: DOTS },
    Pen { color: ORANGE, dash: Dash::Solid },
    Pen { color: SKY, dash: LONG },
    Pen { color: INK, dash: SHORT },
];

/// A stroke of the given width in pixels.
pub(super) fn stroke(color: RGBColor, width: f64) -> ShapeStyle {
    ShapeStyle { color: color.to_rgba(), filled: false, stroke_width: length(width) }
}

/// Letters of the given size in pixels.
pub(super) fn letters(size: f64, color: RGBColor) -> TextStyle<'static> {
    // The backend divides the size of a font by 1.24.
    ("sans-serif", size * 1.24 * SCALE).into_font().color(&color)
}

/// Where the given point lies on the text.
pub(super) fn anchored(
    style: TextStyle<'static>,
    horizontal: HPos,
    vertical: VPos,
) -> TextStyle<'static> {
    style.pos(Pos::new(horizontal, vertical))
}

/// For a line that others would hide: drawn last, it lets them show.
pub(super) const ON_TOP: Pen = Pen { color: INK, dash: SHORT };

/// Draws a line through points of the canvas.
pub(super) fn draw_line<DB: DrawingBackend>(
    area: &DrawingArea<DB, plotters::coord::Shift>,
    points: Vec<(i32, i32)>,
    pen: Pen,
    width: f64,
) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
    let style = stroke(pen.color, width);
    match pen.dash {
        Dash::Solid => area.draw(&PathElement::new(points, style)),
        Dash::Broken(dash, gap) => {
            let (dash, gap) = (length(dash), length(gap));
            area.draw(&DashedPathElement::new(points, dash, gap, style))
        }
    }
}
